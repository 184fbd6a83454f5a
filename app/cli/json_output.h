/// The parts that the JSON outputs have in common.
#pragma once

#include <iosfwd>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

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

/// Prints an object whose last member is a list, item by item, as print() would without holding them all.
class ListPrinter {
  public:
    /// Begins with `head`, an object of at least one member, and the list `name`; what it stands in, if anything, is
    /// indented by `columns`.
    ListPrinter(std::ostream& out, const Json& head, std::string_view name, std::size_t columns = 0);

    void add(const Json& item);

    /// Begins an item that is printed by others, and says by how much it is indented.
    std::size_t begin_item();

    /// Ends the list and the object.
    void end();

  private:
    void begin_line(std::size_t columns);

    std::ostream& out_;
    std::size_t columns_;
    bool is_empty_ = true;
};

}  // namespace batten::cli
