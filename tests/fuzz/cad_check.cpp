// A text is whole, or has a defect with a sentence.

#include "exchange/cad/iges_check.h"
#include "exchange/cad/step_check.h"
#include "tests/fuzz/target.h"

namespace batten::fuzz {

void run(std::string_view bytes) {
    for (auto* const look_over : {&exchange::iges_defect, &exchange::step_defect}) {
        const auto defect = look_over(bytes);
        require(!defect || !defect->what.empty(), "a defect is told");
    }
}

}  // namespace batten::fuzz
