// A drawing is curves, or has a sentence; what was read is written and read again.

#include "tests/fuzz/foreign_file.h"
#include "tests/fuzz/target.h"

namespace batten::fuzz {

void run(std::string_view bytes) {
    run_format(exchange::Format::svg, bytes);
}

}  // namespace batten::fuzz
