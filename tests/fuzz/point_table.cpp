// A table is so many finite points, or has a sentence.

#include "core/document/point_table.h"

#include "tests/fuzz/target.h"

namespace batten::fuzz {

void run(std::string_view bytes) {
    const auto table = core::read_point_table(bytes);
    if (!table) return require(!table.error().what.empty(), "a refusal says why");
    require(!table->points.empty(), "a table has points");
    for (const core::Point& point : table->points) require(core::is_finite(point), "points are finite");
    (void)core::read_point_table(bytes, core::TableColumns{.x = 2, .y = 1});
}

}  // namespace batten::fuzz
