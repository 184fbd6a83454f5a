#include "tests/fuzz/foreign_file.h"

#include "exchange/curve_file.h"
#include "tests/fuzz/target.h"

namespace batten::fuzz {

namespace {

void require_sound(const exchange::Report& report) {
    require(report.largest_error >= 0.0, "an error is not negative");
    for (const std::string& left_out : report.left_out) require(!left_out.empty(), "what is left out is told");
}

}  // namespace

void run_format(exchange::Format format, std::string_view bytes) {
    const auto imported = exchange::spec_of(format).read(bytes);
    if (!imported) return require(!imported.error().what.empty(), "a refusal says why");
    require(!imported->document.curves.empty(), "what was read has curves");
    require_sound(imported->report);
    const auto written = exchange::write_curves(imported->document, format);
    if (!written) return require(!written.error().what.empty(), "a refusal to write says why");
    require_sound(written->report);
    require(exchange::spec_of(format).read(written->text).has_value(), "what was written can be read");
}

}  // namespace batten::fuzz
