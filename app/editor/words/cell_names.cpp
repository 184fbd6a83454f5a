#include "app/editor/words/cell_names.h"

#include <fmt/core.h>

#include <array>

#include "app/editor/derived/blend_lines.h"
#include "app/editor/words/formula.h"

namespace batten::editor {

namespace {

std::string indexed_text(const char* symbol, std::size_t index) {
    return fmt::format("{}_{{{}}}", symbol, index);
}

std::size_t index_of(const NamedTriangle& named, core::CellPlace place) {
    const std::size_t i = named.cell(place).index;
    if (place.level == 0) return i % named.curve.control_points().size();
    return named.notation.triangles == CellNumbering::last ? i : i - place.level;
}

std::string cell_text(const char* symbol, const NamedTriangle& named, core::CellPlace place) {
    return fmt::format("{}_{{{}}}^{{{}}}", symbol, index_of(named, place), place.level);
}

/// "(a − b)", or "(a − (−b))".
std::string difference(const std::string& a, const std::string& b) {
    return fmt::format("({} − {})", a, parenthesized_if_negative(b));
}

}  // namespace

std::string NamedTriangle::point(core::CellPlace place) const {
    if (place.level == 0) return indexed_text("P", index_of(*this, place));
    if (place.level + 1 == triangle.levels.size()) return "C(u)";
    return cell_text("P", *this, place);
}

std::string NamedTriangle::weight(core::CellPlace place) const {
    if (place.level == 0) return indexed_text("w", index_of(*this, place));
    if (place.level + 1 == triangle.levels.size()) return "w(u)";
    return cell_text("w", *this, place);
}

std::string NamedTriangle::alpha(core::CellPlace place) const {
    return cell_text("α", *this, place);
}

AlphaFormula alpha_formula(const NamedTriangle& named, core::CellPlace place) {
    const core::DeBoorCell& cell = named.cell(place);
    const double u = named.triangle.u;
    const double lower = named.curve.knots()[cell.lower_knot];
    const double upper = named.curve.knots()[cell.upper_knot];
    const std::string lower_name = indexed_text("u", cell.lower_knot);
    const std::vector<std::string> numbers =
        exact_texts(named.notation, std::array{u, lower, upper}, digits_that_tell_apart(u, lower, upper));
    return {.symbols = fmt::format("{} = (u − {})/({} − {})", named.alpha(place), lower_name,
                                   indexed_text("u", cell.upper_knot), lower_name),
            .numbers = fmt::format("= {}/{} = {}", difference(numbers[0], numbers[1]),
                                   difference(numbers[2], numbers[1]), share_texts(named.notation, cell.alpha).upper)};
}

}  // namespace batten::editor
