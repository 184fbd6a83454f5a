#include "app/editor/derived/blend_lines.h"

#include <fmt/core.h>

#include <array>
#include <cmath>

#include "app/editor/words/formula.h"
#include "core/base/fraction.h"

namespace batten::editor {

namespace {

constexpr int share_decimals = 3;
constexpr double least_in_decimals = 1e-3;

/// `lower_share lower + upper_share upper`, without what is nothing.
std::string combination(const BlendedCell& blended, double upper_share, const std::string& lower,
                        const std::string& upper) {
    if (blended.alpha() == 0.0) return lower;
    if (blended.alpha() == 1.0) return upper;
    const ShareTexts shares = share_texts(blended.named.notation, upper_share);
    return fmt::format("{} {} + {} {}", shares.lower, lower, shares.upper, upper);
}

std::string weighted_name(const NamedTriangle& named, core::CellPlace place) {
    return fmt::format("{} {}", named.weight(place), named.point(place));
}

std::string weighted_combination(const BlendedCell& blended) {
    return combination(blended, blended.alpha(), weighted_name(blended.named, blended.lower()),
                       weighted_name(blended.named, blended.upper()));
}

std::string weight_value(const BlendedCell& blended, core::CellPlace place) {
    return exact_text(blended.named.notation, blended.named.cell(place).weight);
}

}  // namespace

ShareTexts share_texts(const Notation& notation, double upper) {
    const double lower = 1.0 - upper;
    const bool is_exact = core::small_fraction(lower) && core::small_fraction(upper);
    const bool is_extreme = lower < least_in_decimals || upper < least_in_decimals;
    if (is_extreme || (is_exact && notation.numbers == NumberStyle::fractions)) {
        const std::vector<std::string> texts = exact_texts(notation, std::array{lower, upper}, share_decimals);
        return {texts[0], texts[1]};
    }
    const double thousand = std::pow(10.0, share_decimals);
    const double rounded = std::round(upper * thousand) / thousand;
    return {fixed_text(1.0 - rounded, share_decimals), fixed_text(rounded, share_decimals)};
}

double BlendedCell::euclidean_share() const {
    const double upper_weight = named.cell(upper()).weight;
    if (named.cell(lower()).weight == upper_weight) return alpha();
    return alpha() * (upper_weight / named.cell(place).weight);
}

ShareTexts blend_terms(const BlendedCell& blended) {
    const NamedTriangle& named = blended.named;
    const ShareTexts shares = share_texts(named.notation, blended.alpha());
    const auto name = [&](core::CellPlace place) {
        return named.curve.is_rational() ? weighted_name(named, place) : named.point(place);
    };
    return {fmt::format("{} {}", shares.lower, name(blended.lower())),
            fmt::format("{} {}", shares.upper, name(blended.upper()))};
}

std::string blend_line(const BlendedCell& blended) {
    const NamedTriangle& named = blended.named;
    return fmt::format(
        "{} = {}", named.point(blended.place),
        combination(blended, blended.euclidean_share(), named.point(blended.lower()), named.point(blended.upper())));
}

std::string homogeneous_line(const BlendedCell& blended) {
    return fmt::format("{} = {}", weighted_name(blended.named, blended.place), weighted_combination(blended));
}

WeightFormula weight_formula(const BlendedCell& blended) {
    const NamedTriangle& named = blended.named;
    const double alpha = blended.alpha();
    const std::string names = combination(blended, alpha, named.weight(blended.lower()), named.weight(blended.upper()));
    WeightFormula formula{.symbols = fmt::format("{} = {}", named.weight(blended.place), names), .numbers = {}};
    const std::string value = weight_value(blended, blended.place);
    if (alpha == 0.0 || alpha == 1.0) {
        formula.numbers = fmt::format("= {}", value);
        return formula;
    }
    const std::string numbers = combination(blended, alpha, fmt::format("· {}", weight_value(blended, blended.lower())),
                                            fmt::format("· {}", weight_value(blended, blended.upper())));
    formula.numbers = fmt::format("= {} = {}", numbers, value);
    return formula;
}

std::string projected_line(const BlendedCell& blended) {
    return fmt::format("{} = ({}) / {}", blended.named.point(blended.place), weighted_combination(blended),
                       blended.named.weight(blended.place));
}

}  // namespace batten::editor
