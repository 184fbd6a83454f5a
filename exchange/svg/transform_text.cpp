#include "exchange/svg/transform_text.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "exchange/svg/scanner.h"

namespace batten::exchange {

namespace {

using core::PlaneMap;
using core::Point;

// "(1 2, 3)"
std::optional<std::vector<double>> transform_arguments(Scanner& scanner) {
    constexpr std::size_t most = 6;
    scanner.skip_blanks();
    if (!scanner.skip_if('(')) return std::nullopt;
    scanner.skip_blanks();
    std::vector<double> values;
    while (!scanner.skip_if(')')) {
        const auto value = scanner.number();
        if (!value || values.size() == most) return std::nullopt;
        values.push_back(*value);
        scanner.skip_separator();
    }
    return values;
}

// What follows up to the next comma or bracket, as one length or angle.
std::optional<SvgLength> css_argument(Scanner& scanner) {
    scanner.skip_blanks();
    const auto value = scanner.number();
    if (!value) return std::nullopt;
    const std::string_view unit = scanner.word();
    scanner.skip_blanks();
    return SvgLength{*value, unit};
}

// "(1px, 50%)"
std::optional<std::vector<SvgLength>> css_arguments(Scanner& scanner) {
    constexpr std::size_t most = 6;
    if (!scanner.skip_if('(')) return std::nullopt;
    std::vector<SvgLength> values;
    do {
        const auto value = css_argument(scanner);
        if (!value || values.size() == most) return std::nullopt;
        values.push_back(*value);
    } while (scanner.skip_if(','));
    if (!scanner.skip_if(')')) return std::nullopt;
    return values;
}

std::optional<double> degrees_of(const SvgLength& angle) {
    if (angle.unit == "deg" || (angle.unit.empty() && angle.value == 0.0)) return angle.value;
    if (angle.unit == "rad") return angle.value * (180.0 / std::numbers::pi);
    if (angle.unit == "grad") return angle.value * 0.9;
    if (angle.unit == "turn") return angle.value * 360.0;
    return std::nullopt;
}

std::optional<double> factor_of(const SvgLength& factor) {
    if (factor.unit == "%") return factor.value / 100.0;
    return factor.unit.empty() ? std::optional(factor.value) : std::nullopt;
}

std::optional<double> css_length(const SvgLength& length, double whole) {
    const bool is_length = !length.unit.empty() || length.value == 0.0;
    return is_length ? length.in_px(whole) : std::nullopt;
}

double slope_of(double degrees) {
    return std::tan(degrees * (std::numbers::pi / 180.0));
}

std::optional<PlaneMap> named_transform(std::string_view name, const std::vector<double>& v) {
    const Point origin{0.0, 0.0};
    const std::size_t count = v.size();
    if (name == "matrix" && count == 6)
        return PlaneMap{.rows = {{{v[0], v[2], v[4]}, {v[1], v[3], v[5]}, {0.0, 0.0, 1.0}}}, .pivot = origin};
    if (name == "translate" && (count == 1 || count == 2)) return core::translation({v[0], count == 2 ? v[1] : 0.0});
    if (name == "scale" && (count == 1 || count == 2)) return core::scaling(v[0], v[count - 1], origin);
    if (name == "rotate" && count == 1) return core::rotation(v[0], origin);
    if (name == "rotate" && count == 3) return core::about_origin(core::rotation(v[0], {v[1], v[2]}));
    if (name == "skewX" && count == 1) return core::shearing(slope_of(v[0]), 0.0, origin);
    if (name == "skewY" && count == 1) return core::shearing(0.0, slope_of(v[0]), origin);
    return std::nullopt;
}

// The arguments of a function of CSS as the attribute has them.
std::optional<std::vector<double>> plain_arguments(std::string_view name, const std::vector<SvgLength>& arguments,
                                                   const Viewport& viewport) {
    std::vector<double> values;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const bool is_along_y = i == 1 || name == "translateY";
        const auto value = name.starts_with("translate")
                               ? css_length(arguments[i], is_along_y ? viewport.height : viewport.width)
                           : name.starts_with("rotate") || name.starts_with("skew") ? degrees_of(arguments[i])
                                                                                    : factor_of(arguments[i]);
        if (!value) return std::nullopt;
        values.push_back(*value);
    }
    return values;
}

// The functions that CSS has beside those of the attribute; `v` is not empty.
std::optional<PlaneMap> css_transform(std::string_view name, const std::vector<double>& v) {
    const bool is_one = v.size() == 1;
    if (name == "rotate" && !is_one) return std::nullopt;
    if (name == "translateX" && is_one) return core::translation({v[0], 0.0});
    if (name == "translateY" && is_one) return core::translation({0.0, v[0]});
    if (name == "scaleX" && is_one) return core::scaling(v[0], 1.0, {0.0, 0.0});
    if (name == "scaleY" && is_one) return core::scaling(1.0, v[0], {0.0, 0.0});
    if (name == "skew" && v.size() <= 2)
        return core::shearing(slope_of(v[0]), is_one ? 0.0 : slope_of(v[1]), {0.0, 0.0});
    return named_transform(name, v);
}

// One coordinate of transform-origin.
std::optional<double> origin_length(std::string_view word, double whole) {
    if (word == "left" || word == "top") return 0.0;
    const std::string_view share = word == "center" ? "50%" : word == "right" || word == "bottom" ? "100%" : word;
    const auto length = read_length(share);
    return length ? length->in_px(whole) : std::nullopt;
}

std::optional<Point> origin_of(std::string_view text, const Viewport& viewport) {
    const std::size_t blank = text.find(' ');
    const std::string_view first = text.substr(0, blank);
    const std::string_view second = blank == std::string_view::npos ? "center" : text.substr(blank + 1);
    const auto x = origin_length(first, viewport.width);
    const auto y = origin_length(second, viewport.height);
    const bool is_turned_about = first == "top" || first == "bottom" || second == "left" || second == "right";
    if (!x || !y || is_turned_about) return std::nullopt;
    return Point{*x, *y};
}

}  // namespace

PlaneMap chained(const PlaneMap& outer, const PlaneMap& inner) {
    PlaneMap map;
    map.pivot = {0.0, 0.0};
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            map.rows[i][j] = outer.rows[i][0] * inner.rows[0][j] + outer.rows[i][1] * inner.rows[1][j] +
                             (j == 2 ? outer.rows[i][2] : 0.0);
    return map;
}

std::optional<PlaneMap> read_transform(std::string_view text) {
    Scanner scanner(text);
    PlaneMap map;
    for (scanner.skip_separator(); !scanner.is_at_end(); scanner.skip_separator()) {
        const std::string_view name = scanner.word();
        const auto values = transform_arguments(scanner);
        const auto next = values ? named_transform(name, *values) : std::nullopt;
        if (!next) return std::nullopt;
        map = chained(map, *next);
    }
    return map;
}

std::optional<PlaneMap> read_css_transform(std::string_view text, const Viewport& viewport) {
    Scanner scanner(text);
    PlaneMap map;
    if (text == "none") return map;
    for (scanner.skip_blanks(); !scanner.is_at_end(); scanner.skip_blanks()) {
        const std::string_view name = scanner.word();
        const auto arguments = css_arguments(scanner);
        const auto values = arguments ? plain_arguments(name, *arguments, viewport) : std::nullopt;
        const auto next = values ? css_transform(name, *values) : std::nullopt;
        if (!next) return std::nullopt;
        map = chained(map, *next);
    }
    return map;
}

std::optional<PlaneMap> transform_of(const SvgProperties& properties, const Viewport& viewport) {
    using enum SvgProperty;
    for (const SvgProperty beside : {translate, rotate, scale})
        if (!properties.in_style(beside).empty() && properties.in_style(beside) != "none") return std::nullopt;
    const std::string_view styled = properties.in_style(transform);
    const std::string_view plain = properties.in_attribute(transform);
    if (styled.empty() && plain.empty()) return PlaneMap();
    const auto map = styled.empty() ? read_transform(plain) : read_css_transform(styled, viewport);
    const std::string_view origin = properties[transform_origin];
    const std::string_view box = properties[transform_box];
    if (!box.empty() && box != "view-box") return std::nullopt;
    if (!map || origin.empty()) return map;
    const auto center = origin_of(origin, viewport);
    if (!center) return std::nullopt;
    const core::Vector offset = *center - Point(0.0, 0.0);
    return chained(core::translation(offset), chained(*map, core::translation(-offset)));
}

}  // namespace batten::exchange
