#include "exchange/dxf/dxf_tables.h"

#include <algorithm>
#include <array>

#include "core/base/ascii.h"

namespace batten::exchange {

namespace {

using core::LengthUnit;

// The scale is how much of the drawing one unit of the document is.
struct CodedUnit {
    std::string_view code;
    LengthUnit unit;
    double scale;
};
constexpr std::array coded_units{CodedUnit{"1", LengthUnit::inch, 1.0}, CodedUnit{"2", LengthUnit::inch, 1.0 / 12.0},
                                 CodedUnit{"4", LengthUnit::mm, 1.0},   CodedUnit{"5", LengthUnit::mm, 0.1},
                                 CodedUnit{"6", LengthUnit::mm, 0.001}, CodedUnit{"7", LengthUnit::mm, 1e-6},
                                 CodedUnit{"13", LengthUnit::mm, 1e3},  CodedUnit{"14", LengthUnit::mm, 0.01}};

}  // namespace

std::string layer_key(std::string_view name) {
    return core::in_small_letters(name);
}

std::optional<core::DocumentUnits> units_of_code(std::string_view code) {
    const auto* const found = std::ranges::find(coded_units, code, &CodedUnit::code);
    if (found == coded_units.end()) return std::nullopt;
    return core::DocumentUnits{found->unit, found->scale};
}

std::optional<std::string_view> code_of_units(const core::DocumentUnits& units) {
    const auto* const found = std::ranges::find_if(
        coded_units, [&](const CodedUnit& coded) { return coded.unit == units.unit && coded.scale == units.scale; });
    if (found == coded_units.end()) return std::nullopt;
    return found->code;
}

}  // namespace batten::exchange
