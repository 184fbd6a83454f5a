#include "exchange/step_reader.h"

#include "exchange/occt_process.h"

namespace batten::exchange {

core::FileResult<Imported> read_step(std::string_view text) {
    return read_through_occt("step", text);
}

}  // namespace batten::exchange
