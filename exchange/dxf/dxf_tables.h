/// What names of layers and codes of units mean in DXF, for reading and writing.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/document/units.h"

namespace batten::exchange {

/// The same for names of one layer: those that differ in small and capital letters of ASCII alone.
std::string layer_key(std::string_view name);

/// The unit that a value of $INSUNITS stands for, and the other way; none where there is none of that length.
std::optional<core::DocumentUnits> units_of_code(std::string_view code);
std::optional<std::string_view> code_of_units(const core::DocumentUnits& units);

}  // namespace batten::exchange
