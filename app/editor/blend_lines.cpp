#include "app/editor/blend_lines.h"

#include <fmt/core.h>

#include <cmath>

#include "app/editor/formula.h"
#include "core/base/fraction.h"

namespace batten::editor {

namespace {

constexpr int decimals = 3;
constexpr double least_in_decimals = 1e-3;

std::string minus_signed(std::string text) {
    if (text.starts_with('-')) text.replace(0, 1, true_minus);
    return text;
}

/// `lower_share lower + upper_share upper`, without what is nothing.
std::string combination(const BlendedCell& blended, double upper_share, const std::string& lower,
                        const std::string& upper) {
    if (blended.cell().alpha == 0.0) return lower;
    if (blended.cell().alpha == 1.0) return upper;
    const ShareTexts shares = share_texts(upper_share);
    return fmt::format("{} {} + {} {}", shares.lower, lower, shares.upper, upper);
}

std::string point_name(const BlendedCell& blended, core::CellPlace place) {
    return cell_text(blended.triangle, place.level, place.index, blended.curve.control_points().size());
}

std::string weight_name(const BlendedCell& blended, core::CellPlace place) {
    const std::size_t i = blended.triangle.levels[place.level][place.index].index;
    if (place.level == 0) return fmt::format("w_{{{}}}", i % blended.curve.control_points().size());
    if (place.level + 1 == blended.triangle.levels.size()) return "w(u)";
    return fmt::format("w_{{{}}}^{{{}}}", i, place.level);
}

core::CellPlace lower_place(const BlendedCell& blended) {
    return {blended.place.level - 1, blended.place.index};
}
core::CellPlace upper_place(const BlendedCell& blended) {
    return {blended.place.level - 1, blended.place.index + 1};
}

std::string weighted_name(const BlendedCell& blended, core::CellPlace place) {
    return fmt::format("{} {}", weight_name(blended, place), point_name(blended, place));
}

std::string weighted_combination(const BlendedCell& blended) {
    return combination(blended, blended.cell().alpha, weighted_name(blended, lower_place(blended)),
                       weighted_name(blended, upper_place(blended)));
}

std::string times(const std::string& weight) {
    return fmt::format("· {}", weight);
}

}  // namespace

ShareTexts share_texts(double upper) {
    const double lower = 1.0 - upper;
    const auto lower_fraction = core::small_fraction(lower);
    const auto upper_fraction = core::small_fraction(upper);
    if (lower_fraction && upper_fraction)
        return {core::fraction_text(*lower_fraction), core::fraction_text(*upper_fraction)};
    if (lower < least_in_decimals || upper < least_in_decimals)
        return {number_text(lower, decimals), number_text(upper, decimals)};
    const double thousand = std::pow(10.0, decimals);
    const double rounded = std::round(upper * thousand) / thousand;
    return {fixed_text(1.0 - rounded, decimals), fixed_text(rounded, decimals)};
}

std::string quantity_text(double value) {
    if (const auto fraction = core::small_fraction(value)) return minus_signed(core::fraction_text(*fraction));
    return number_text(value, decimals);
}

double BlendedCell::euclidean_share() const {
    const double lower = lower_parent().weight;
    const double upper = upper_parent().weight;
    if (lower == upper) return cell().alpha;
    return cell().alpha * (upper / cell().weight);
}

ShareTexts blend_terms(const BlendedCell& blended) {
    const auto name = blended.curve.is_rational() ? weighted_name : point_name;
    const ShareTexts shares = share_texts(blended.cell().alpha);
    return {fmt::format("{} {}", shares.lower, name(blended, lower_place(blended))),
            fmt::format("{} {}", shares.upper, name(blended, upper_place(blended)))};
}

std::string blend_line(const BlendedCell& blended) {
    return fmt::format("{} = {}", point_name(blended, blended.place),
                       combination(blended, blended.euclidean_share(), point_name(blended, lower_place(blended)),
                                   point_name(blended, upper_place(blended))));
}

std::string homogeneous_line(const BlendedCell& blended) {
    return fmt::format("{} = {}", weighted_name(blended, blended.place), weighted_combination(blended));
}

WeightFormula weight_formula(const BlendedCell& blended) {
    const double alpha = blended.cell().alpha;
    const std::string names = combination(blended, alpha, weight_name(blended, lower_place(blended)),
                                          weight_name(blended, upper_place(blended)));
    WeightFormula formula{.symbols = fmt::format("{} = {}", weight_name(blended, blended.place), names), .numbers = {}};
    const std::string value = quantity_text(blended.cell().weight);
    if (alpha == 0.0 || alpha == 1.0) {
        formula.numbers = fmt::format("= {}", value);
        return formula;
    }
    const std::string numbers = combination(blended, alpha, times(quantity_text(blended.lower_parent().weight)),
                                            times(quantity_text(blended.upper_parent().weight)));
    formula.numbers = fmt::format("= {} = {}", numbers, value);
    return formula;
}

std::string projected_line(const BlendedCell& blended) {
    return fmt::format("{} = ({}) / {}", point_name(blended, blended.place), weighted_combination(blended),
                       weight_name(blended, blended.place));
}

}  // namespace batten::editor
