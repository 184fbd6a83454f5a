#include "exchange/svg/viewport.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "core/document/unit_scale.h"
#include "exchange/svg/scanner.h"

namespace batten::exchange {

namespace {

using core::PlaneMap;

struct AbsoluteUnit {
    std::string_view name;
    double px;
    core::LengthUnit unit;  // which stands for it in a document
    double factor;          // and how many of that it is
};

constexpr double inch_px = 96.0;
constexpr double inch_mm = 25.4;

constexpr std::array absolute_units{
    AbsoluteUnit{"", 1.0, core::LengthUnit::px, 1.0},
    AbsoluteUnit{"px", 1.0, core::LengthUnit::px, 1.0},
    AbsoluteUnit{"mm", inch_px / inch_mm, core::LengthUnit::mm, 1.0},
    AbsoluteUnit{"cm", 10.0 * inch_px / inch_mm, core::LengthUnit::mm, 10.0},
    AbsoluteUnit{"Q", 0.25 * inch_px / inch_mm, core::LengthUnit::mm, 0.25},
    AbsoluteUnit{"in", inch_px, core::LengthUnit::inch, 1.0},
    AbsoluteUnit{"pt", inch_px / 72.0, core::LengthUnit::inch, 1.0 / 72.0},
    AbsoluteUnit{"pc", inch_px / 6.0, core::LengthUnit::inch, 1.0 / 6.0},
};

const AbsoluteUnit* absolute_unit(std::string_view name) {
    const auto* const found = std::find_if(absolute_units.begin(), absolute_units.end(),
                                           [&](const AbsoluteUnit& unit) { return unit.name == name; });
    return found == absolute_units.end() ? nullptr : found;
}

// Of positive width and height.
std::optional<Viewport> view_box(const pugi::xml_node& element) {
    Scanner scanner(element.attribute("viewBox").value());
    std::array<double, 4> values{};
    scanner.skip_blanks();
    for (double& value : values) {
        const auto number = scanner.number();
        if (!number) return std::nullopt;
        value = *number;
        scanner.skip_separator();
    }
    if (!(values[2] > 0.0 && values[3] > 0.0)) return std::nullopt;
    return Viewport{values[0], values[1], values[2], values[3]};
}

// How a viewBox is fitted into a box of `width` by `height`.
struct BoxScale {
    double x = 1.0;
    double y = 1.0;
};

BoxScale box_scale(const pugi::xml_node& element, const Viewport& box, double width, double height) {
    const std::string_view wish = element.attribute("preserveAspectRatio").value();
    const BoxScale scale{width / box.width, height / box.height};
    if (wish.find("none") != std::string_view::npos) return scale;
    const bool is_slice = wish.find("slice") != std::string_view::npos;
    const double both = is_slice ? std::max(scale.x, scale.y) : std::min(scale.x, scale.y);
    return {both, both};
}

// How far a box of this leftover room is moved: "xMinYMid".
double alignment_share(std::string_view wish, std::string_view least, std::string_view most) {
    if (wish.find("none") != std::string_view::npos || wish.find(least) != std::string_view::npos) return 0.0;
    return wish.find(most) != std::string_view::npos ? 1.0 : 0.5;
}

PlaneMap scaled_and_moved(BoxScale scale, double x, double y) {
    return {.rows = {{{scale.x, 0.0, x}, {0.0, scale.y, y}, {0.0, 0.0, 1.0}}}, .pivot = {0.0, 0.0}};
}

// One unit of the document in the coordinates of a viewBox of `size` that is written `length` long.
std::optional<core::DocumentUnits> units_of(const SvgLength& length, double size) {
    const AbsoluteUnit* const unit = absolute_unit(length.unit);
    if (unit == nullptr) return std::nullopt;
    const double scale = size / (length.value * unit->factor);
    if (!core::allowed_unit_scales.contains(scale)) return std::nullopt;
    return core::DocumentUnits{.unit = unit->unit, .scale = scale};
}

// What the width is in coordinates where the viewBox does not fill it; that of the viewBox but for rounding.
double shown_length(double of_box, double shown) {
    constexpr double rounding = 1e-9;
    return std::abs(shown - of_box) <= rounding * of_box ? of_box : shown;
}

// Of `use`, where it has such a length, else of `element`.
bool is_zero_length(const pugi::xml_node& use, const pugi::xml_node& element, const char* name) {
    const auto length = read_length((use.attribute(name) ? use : element).attribute(name).value());
    return length && length->value == 0.0;
}

// Also of units of the font.
std::optional<double> in_px(const SvgLength& length, std::optional<double> whole, const FontSizes& font) {
    const auto times = [&](std::optional<double> size) {
        return size ? std::optional(length.value * *size) : std::nullopt;
    };
    if (length.unit == "em") return times(font.own);
    if (length.unit == "rem") return times(font.root);
    return length.in_px(whole.value_or(0.0));
}

// In px where it is written in sizes of the font; none where these are not known.
std::optional<SvgLength> positive_length(const pugi::xml_node& element, const char* name, const FontSizes& font) {
    const auto length = read_length(element.attribute(name).value());
    if (!length || !(length->value > 0.0)) return std::nullopt;
    if (length->unit != "em" && length->unit != "rem") return length;
    const auto px = in_px(*length, std::nullopt, font);
    return px ? std::optional(SvgLength{*px, "px"}) : std::nullopt;
}

// The room of a viewport along one axis, where the file says it.
std::optional<double> known_size(double size) {
    return size > 0.0 ? std::optional(size) : std::nullopt;
}

}  // namespace

std::optional<double> SvgLength::in_px(double whole) const {
    if (value == 0.0) return 0.0;
    if (unit == "%") return whole > 0.0 ? std::optional(value / 100.0 * whole) : std::nullopt;
    const AbsoluteUnit* const known = absolute_unit(unit);
    return known == nullptr ? std::nullopt : std::optional(value * known->px);
}

std::optional<SvgLength> read_length(std::string_view text) {
    Scanner scanner(text);
    scanner.skip_blanks();
    const auto value = scanner.number();
    if (!value) return std::nullopt;
    const std::string_view unit = scanner.word();
    scanner.skip_blanks();
    if (!scanner.is_at_end()) return std::nullopt;
    return SvgLength{*value, unit};
}

FontSizes FontSizes::within(const SvgProperties& properties) const {
    const std::string_view size = properties[SvgProperty::font_size];
    const std::string_view font = properties.in_style(SvgProperty::font);  // which no attribute says
    if (!font.empty() && font != "inherit") return {.own = std::nullopt, .root = root};
    if (size.empty() || size == "inherit") return *this;
    if (size == "medium") return {.own = medium, .root = root};
    const auto length = read_length(size);
    return {.own = length ? in_px(*length, own, *this) : std::nullopt, .root = root};
}

std::optional<double> Viewport::length(const pugi::xml_node& element, const char* name,
                                       std::optional<double> missing) const {
    const std::string_view text = element.attribute(name).value();
    const auto found = read_length(text);
    if (!found) return text.find('(') == std::string_view::npos ? missing : std::nullopt;
    const std::string_view along = name;
    const bool is_along_x = along.find('x') != std::string_view::npos || along == "width";
    const bool is_along_y = along.find('y') != std::string_view::npos || along == "height";
    const double diagonal = width > 0.0 && height > 0.0 ? std::hypot(width, height) / std::numbers::sqrt2 : 0.0;
    return in_px(*found, is_along_x ? width : is_along_y ? height : diagonal, font);
}

Page page_of(const pugi::xml_node& svg, const FontSizes& font) {
    const auto box = view_box(svg);
    const auto width = positive_length(svg, "width", font);
    const auto height = positive_length(svg, "height", font);
    Page page;
    page.viewport = box.value_or(Viewport{.width = width ? width->in_px(0.0).value_or(0.0) : 0.0,
                                          .height = height ? height->in_px(0.0).value_or(0.0) : 0.0});
    page.viewport.font = font;
    const Viewport& view = page.viewport;
    const double width_px = width ? width->in_px(0.0).value_or(0.0) : 0.0;
    const double height_px = height ? height->in_px(0.0).value_or(0.0) : 0.0;
    BoxScale scale;
    if (box && width_px > 0.0 && height_px > 0.0) scale = box_scale(svg, *box, width_px, height_px);
    if (width_px > 0.0)
        page.units =
            units_of(*width, shown_length(view.width, box && height_px > 0.0 ? width_px / scale.x : view.width));
    else if (height_px > 0.0)
        page.units = units_of(*height, view.height);
    // Only where an aspect ratio is not kept is y of another size than x.
    const double ratio = scale.y / scale.x;
    const double stretch = ratio > 0.0 && std::isfinite(ratio) ? ratio : 1.0;
    const auto baseline = read_length(svg.attribute("batten:baseline").value());
    const double zero = baseline ? baseline->value : view.top + view.height;
    page.map = {.rows = {{{1.0, 0.0, 0.0}, {0.0, -stretch, zero * stretch}, {0.0, 0.0, 1.0}}}, .pivot = {0.0, 0.0}};
    return page;
}

InnerViewport inner_viewport(const pugi::xml_node& element, const Viewport& outer) {
    return inner_viewport(element, {}, outer);
}

InnerViewport inner_viewport(const pugi::xml_node& element, const pugi::xml_node& use, const Viewport& outer) {
    if (is_zero_length(use, element, "width") || is_zero_length(use, element, "height")) return {.is_empty = true};
    const auto x = outer.length(element, "x");
    const auto y = outer.length(element, "y");
    const auto width = outer.length(use, "width", outer.length(element, "width", known_size(outer.width)));
    const auto height = outer.length(use, "height", outer.length(element, "height", known_size(outer.height)));
    const auto box = view_box(element);
    if (!x || !y || (box && !(width && height))) return {.is_unknown = true};
    const Viewport plain{.width = width.value_or(0.0), .height = height.value_or(0.0), .font = outer.font};
    const core::Box frame = width && height ? core::Box{{*x, *y}, {*x + *width, *y + *height}} : core::Box();
    if (!box) return {.viewport = plain, .map = scaled_and_moved({}, *x, *y), .box = frame};
    Viewport viewport = *box;
    viewport.font = outer.font;
    if (!(plain.width > 0.0 && plain.height > 0.0)) return {.viewport = viewport, .map = scaled_and_moved({}, *x, *y)};
    const std::string_view wish = element.attribute("preserveAspectRatio").value();
    const BoxScale scale = box_scale(element, *box, plain.width, plain.height);
    const double room_x = (plain.width - scale.x * box->width) * alignment_share(wish, "xMin", "xMax");
    const double room_y = (plain.height - scale.y * box->height) * alignment_share(wish, "YMin", "YMax");
    return {.viewport = viewport,
            .map = scaled_and_moved(scale, *x + room_x - scale.x * box->left, *y + room_y - scale.y * box->top),
            .box = frame};
}

}  // namespace batten::exchange
