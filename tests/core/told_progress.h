/// What a long operation tells of its progress.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/base/progress.h"

namespace batten::core {

/// Checks the shares that `run` tells, which must not become less, and that it can be stopped.
template <class Run>
void expect_progress(const Run& run) {
    std::vector<double> shares;
    run([&](double share) { shares.push_back(share); });
    EXPECT_GT(shares.size(), 3U);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_GE(shares.front(), 0.0);
    EXPECT_LT(shares.back(), 1.0);
    struct Stopped {};
    EXPECT_THROW(run([](double share) {
                     if (share > 0.4) throw Stopped{};
                 }),
                 Stopped);
}

}  // namespace batten::core
