#include "app/editor/words/cell_names.h"

#include <fmt/core.h>

#include "app/editor/derived/blend_lines.h"
#include "app/editor/words/formula.h"
#include "core/base/fraction.h"

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

std::string level_text(const char* symbol, const NamedTriangle& named, core::CellPlace place) {
    return fmt::format("{}_{{{}}}^{{{}}}", symbol, index_of(named, place), place.level);
}

/// Four digits, or as many more as tell the three apart where they differ.
int digits_that_tell_apart(double a, double b, double c) {
    const auto same = [](double x, double y, int digits) {
        return x != y && number_text(x, digits) == number_text(y, digits);
    };
    int digits = 4;
    while (digits < 17 && (same(a, b, digits) || same(b, c, digits) || same(a, c, digits))) ++digits;
    return digits;
}

/// u and two knots, alike.
class ThreeNumbers {
  public:
    ThreeNumbers(const Notation& notation, double u, double lower, double upper)
        : digits_(digits_that_tell_apart(u, lower, upper)) {
        const bool has_fractions =
            core::small_fraction(u) && core::small_fraction(lower) && core::small_fraction(upper);
        if (has_fractions) notation_ = notation;
    }

    std::string difference(double a, double b) const {
        const std::string from = exact_text(notation_, a, digits_);
        const std::string taken = exact_text(notation_, b, digits_);
        return b < 0.0 ? fmt::format("({} − ({}))", from, taken) : fmt::format("({} − {})", from, taken);
    }

  private:
    int digits_;
    Notation notation_{.numbers = NumberStyle::decimals};
};

}  // namespace

std::string NamedTriangle::point(core::CellPlace place) const {
    if (place.level == 0) return indexed_text("P", index_of(*this, place));
    if (place.level + 1 == triangle.levels.size()) return "C(u)";
    return level_text("P", *this, place);
}

std::string NamedTriangle::weight(core::CellPlace place) const {
    if (place.level == 0) return indexed_text("w", index_of(*this, place));
    if (place.level + 1 == triangle.levels.size()) return "w(u)";
    return level_text("w", *this, place);
}

std::string NamedTriangle::alpha(core::CellPlace place) const {
    return level_text("α", *this, place);
}

AlphaFormula alpha_formula(const NamedTriangle& named, core::CellPlace place) {
    const core::DeBoorCell& cell = named.cell(place);
    const double u = named.triangle.u;
    const double lower = named.curve.knots()[cell.lower_knot];
    const double upper = named.curve.knots()[cell.upper_knot];
    const std::string lower_name = indexed_text("u", cell.lower_knot);
    const ThreeNumbers numbers(named.notation, u, lower, upper);
    return {.symbols = fmt::format("{} = (u − {})/({} − {})", named.alpha(place), lower_name,
                                   indexed_text("u", cell.upper_knot), lower_name),
            .numbers = fmt::format("= {}/{} = {}", numbers.difference(u, lower), numbers.difference(upper, lower),
                                   share_texts(named.notation, cell.alpha).upper)};
}

}  // namespace batten::editor
