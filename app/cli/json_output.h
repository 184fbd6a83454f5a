/// The parts that the JSON outputs have in common.
#pragma once

#include <iosfwd>
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/geometry.h"

namespace batten::cli {

/// Members stay in the order in which they are set.
using Json = nlohmann::ordered_json;

/// null where the number is too large for a double, or could not be computed.
Json json_of(double value);

/// [x, y]
inline Json json_of(core::Vector v) {
    return Json::array({v.x, v.y});
}
inline Json json_of(core::Point point) {
    return json_of(core::vector_to(point));
}

/// "(0.5, 1)", as results are printed for people.
std::string point_text(core::Point point);

/// Prints `json` with one member a line. Texts that are not UTF-8 are mended.
void print(std::ostream& out, const Json& json);

}  // namespace batten::cli
