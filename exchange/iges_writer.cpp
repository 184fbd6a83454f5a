#include "exchange/iges_writer.h"

#include "exchange/occt_process.h"

namespace batten::exchange {

core::FileResult<Exported> write_iges(const core::Document& document, const WriteOptions&) {
    return write_through_occt("iges", document);
}

}  // namespace batten::exchange
