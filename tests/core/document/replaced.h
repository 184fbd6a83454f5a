/// Texts with one part changed.
#pragma once

#include <gtest/gtest.h>

#include <string>

namespace batten::core {

/// With `to` for the first `from`, which must be there.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from << " in " << text;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

}  // namespace batten::core
