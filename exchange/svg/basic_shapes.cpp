#include "exchange/svg/basic_shapes.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <utility>

#include "exchange/svg/scanner.h"

namespace batten::exchange {

namespace {

using core::PlaneMap;
using core::Point;

// The attributes of a shape that are lengths.
struct ShapeLengths {
    std::string_view shape;
    std::array<const char*, 6> names;
};

constexpr std::array shape_lengths{
    ShapeLengths{"rect", {"x", "y", "width", "height", "rx", "ry"}}, ShapeLengths{"circle", {"cx", "cy", "r"}},
    ShapeLengths{"ellipse", {"cx", "cy", "rx", "ry"}}, ShapeLengths{"line", {"x1", "y1", "x2", "y2"}}};

// An outline of which points are given before they are mapped.
class MappedOutline {
  public:
    MappedOutline(const PlaneMap& map, Point start) : map_(&map), outline_(core::mapped(map, start)) {}

    void line_to(Point end) { outline_.line_to(core::mapped(*map_, end)); }

    // A quarter of an ellipse whose axes are those of the coordinates.
    void quarter_to(Point corner, Point end) {
        constexpr double weight = std::numbers::sqrt2 / 2.0;
        outline_.conic_to(core::mapped(*map_, corner), weight, core::mapped(*map_, end));
    }

    void close() { outline_.close(); }

    void hand_to(const OutlineSink& sink) && {
        if (!outline_.is_empty()) sink(std::move(outline_));
    }

  private:
    const PlaneMap* map_;
    Outline outline_;
};

void hand_ellipse(Point center, double rx, double ry, const PlaneMap& map, const OutlineSink& sink) {
    if (!(rx > 0.0 && ry > 0.0)) return;
    const auto at = [&](double x, double y) { return Point(center.x + x * rx, center.y + y * ry); };
    MappedOutline outline(map, at(1, 0));
    outline.quarter_to(at(1, 1), at(0, 1));
    outline.quarter_to(at(-1, 1), at(-1, 0));
    outline.quarter_to(at(-1, -1), at(0, -1));
    outline.quarter_to(at(1, -1), at(1, 0));
    outline.close();
    std::move(outline).hand_to(sink);
}

// Of a shape of which all lengths are known.
double known_length(const pugi::xml_node& element, const Viewport& viewport, const char* name, double missing = 0.0) {
    return viewport.length(element, name, missing).value_or(missing);
}

// The radii of a rect's corners: the one that is missing is the other, and none is more than half a side.
core::Vector corner_radii(const pugi::xml_node& element, const Viewport& viewport, double width, double height) {
    const auto radius = [&](const char* name) {
        const double length = known_length(element, viewport, name, -1.0);
        return length < 0.0 ? std::nullopt : std::optional(length);
    };
    const auto rx = radius("rx");
    const auto ry = radius("ry");
    const double x = std::min(rx ? *rx : ry.value_or(0.0), width / 2.0);
    const double y = std::min(ry ? *ry : rx.value_or(0.0), height / 2.0);
    return x > 0.0 && y > 0.0 ? core::Vector(x, y) : core::Vector(0.0, 0.0);
}

void hand_rect(const pugi::xml_node& element, const Viewport& viewport, const PlaneMap& map, const OutlineSink& sink) {
    const double width = known_length(element, viewport, "width");
    const double height = known_length(element, viewport, "height");
    if (!(width > 0.0 && height > 0.0)) return;
    const double left = known_length(element, viewport, "x");
    const double top = known_length(element, viewport, "y");
    const double right = left + width;
    const double bottom = top + height;
    const auto [rx, ry] = corner_radii(element, viewport, width, height);
    MappedOutline outline(map, {left + rx, top});
    outline.line_to({right - rx, top});
    if (rx > 0.0) outline.quarter_to({right, top}, {right, top + ry});
    outline.line_to({right, bottom - ry});
    if (rx > 0.0) outline.quarter_to({right, bottom}, {right - rx, bottom});
    outline.line_to({left + rx, bottom});
    if (rx > 0.0) outline.quarter_to({left, bottom}, {left, bottom - ry});
    outline.line_to({left, top + ry});
    if (rx > 0.0) outline.quarter_to({left, top}, {left + rx, top});
    outline.close();
    std::move(outline).hand_to(sink);
}

void hand_line(const pugi::xml_node& element, const Viewport& viewport, const PlaneMap& map, const OutlineSink& sink) {
    MappedOutline outline(map, {known_length(element, viewport, "x1"), known_length(element, viewport, "y1")});
    outline.line_to({known_length(element, viewport, "x2"), known_length(element, viewport, "y2")});
    std::move(outline).hand_to(sink);
}

std::optional<std::size_t> hand_polyline(const pugi::xml_node& element, bool is_closed, const PlaneMap& map,
                                         const OutlineSink& sink) {
    Scanner scanner(element.attribute("points").value());
    std::optional<MappedOutline> outline;
    std::optional<std::size_t> fault;
    scanner.skip_blanks();
    while (!scanner.is_at_end()) {
        const auto x = scanner.number();
        scanner.skip_separator();
        const auto y = x ? scanner.number() : std::nullopt;
        if (!y) {
            fault = scanner.place();
            break;
        }
        scanner.skip_separator();
        if (outline)
            outline->line_to({*x, *y});
        else
            outline.emplace(map, Point(*x, *y));
    }
    if (!outline) return fault;
    if (is_closed) outline->close();
    std::move(*outline).hand_to(sink);
    return fault;
}

}  // namespace

bool is_basic_shape(std::string_view name) {
    constexpr std::array<std::string_view, 6> names{"rect", "circle", "ellipse", "line", "polyline", "polygon"};
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool has_unknown_length(const pugi::xml_node& element, std::string_view name, const Viewport& viewport) {
    const auto* const shape = std::ranges::find(shape_lengths, name, &ShapeLengths::shape);
    return shape != shape_lengths.end() && std::ranges::any_of(shape->names, [&](const char* length) {
               return length != nullptr && !viewport.length(element, length).has_value();
           });
}

std::optional<std::size_t> read_basic_shape(const pugi::xml_node& element, std::string_view name,
                                            const Viewport& viewport, const PlaneMap& map, const OutlineSink& sink) {
    if (name == "polyline" || name == "polygon") return hand_polyline(element, name == "polygon", map, sink);
    if (name == "rect") hand_rect(element, viewport, map, sink);
    if (name == "line") hand_line(element, viewport, map, sink);
    const Point center{known_length(element, viewport, "cx"), known_length(element, viewport, "cy")};
    if (name == "circle") {
        const double r = known_length(element, viewport, "r");
        hand_ellipse(center, r, r, map, sink);
    } else if (name == "ellipse") {
        hand_ellipse(center, known_length(element, viewport, "rx"), known_length(element, viewport, "ry"), map, sink);
    }
    return std::nullopt;
}

}  // namespace batten::exchange
