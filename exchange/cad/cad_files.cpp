#include "exchange/cad/cad_files.h"

#include "exchange/cad/iges_check.h"
#include "exchange/cad/occt_process.h"
#include "exchange/cad/step_check.h"

namespace batten::exchange {

core::FileResult<Imported> read_iges(std::string_view text) {
    if (auto defect = iges_defect(text)) return tl::unexpected(*std::move(defect));
    return read_through_occt("iges", text);
}

core::FileResult<Imported> read_step(std::string_view text) {
    if (auto defect = step_defect(text)) return tl::unexpected(*std::move(defect));
    return read_through_occt("step", text);
}

core::FileResult<Exported> write_iges(const core::Document& document, const WriteOptions& /*options*/) {
    return write_through_occt("iges", document);
}

core::FileResult<Exported> write_step(const core::Document& document, const WriteOptions& /*options*/) {
    return write_through_occt("step", document);
}

}  // namespace batten::exchange
