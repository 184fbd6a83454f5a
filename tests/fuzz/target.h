/// One target of fuzzing: a source with one function, which takes whatever bytes there are.
#pragma once

#include <string_view>

namespace batten::fuzz {

/// Does with `bytes` what the target is for, and stops the program where it is done wrong.
void run(std::string_view bytes);

/// Stops the program, saying `what` is not so, unless `is_so`.
void require(bool is_so, const char* what);

}  // namespace batten::fuzz
