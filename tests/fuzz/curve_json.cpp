// JSON of other libraries is curves, or has a sentence, whichever it is taken for.

#include "tests/fuzz/foreign_file.h"
#include "tests/fuzz/target.h"

namespace batten::fuzz {

void run(std::string_view bytes) {
    using enum exchange::Format;
    for (const exchange::Format format : {nurbs_python, tinyspline, rhino, opencascade}) run_format(format, bytes);
}

}  // namespace batten::fuzz
