#include "app/cli/json_output.h"

#include <fmt/core.h>

#include <cmath>
#include <ostream>

#include "core/base/number_text.h"

namespace batten::cli {

Json json_of(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

std::string point_text(core::Point point) {
    return fmt::format("({}, {})", core::shortest_text(point.x), core::shortest_text(point.y));
}

void print(std::ostream& out, const Json& json) {
    constexpr int indent = 2;
    out << json.dump(indent, ' ', false, Json::error_handler_t::replace) << '\n';
}

}  // namespace batten::cli
