/// The result of reading or writing a file that is refused.
#pragma once

#include <string>
#include <utility>

#include "core/document/file_text.h"

namespace batten::exchange {

/// `what` was found, and what is allowed; `where` is empty for the file as a whole.
inline tl::unexpected<core::FileError> refused_file(std::string what, std::string where = {}) {
    return tl::unexpected(core::FileError{std::move(where), std::move(what)});
}

}  // namespace batten::exchange
