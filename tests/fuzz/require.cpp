#include <cstdlib>
#include <iostream>

#include "tests/fuzz/target.h"

namespace batten::fuzz {

void require(bool is_so, const char* what) {
    if (is_so) return;
    std::cerr << "this is not so: " << what << '\n';
    std::abort();
}

}  // namespace batten::fuzz
