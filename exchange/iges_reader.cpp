#include "exchange/iges_reader.h"

#include "exchange/occt_process.h"

namespace batten::exchange {

core::FileResult<Imported> read_iges(std::string_view text) {
    return read_through_occt("iges", text);
}

}  // namespace batten::exchange
