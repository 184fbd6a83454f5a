// The target as libFuzzer calls it.

#include <cstdint>

#include "tests/fuzz/target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    batten::fuzz::run({reinterpret_cast<const char*>(data), size});
    return 0;
}
