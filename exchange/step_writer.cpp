#include "exchange/step_writer.h"

#include "exchange/occt_process.h"

namespace batten::exchange {

core::FileResult<Exported> write_step(const core::Document& document, const WriteOptions&) {
    return write_through_occt("step", document);
}

}  // namespace batten::exchange
