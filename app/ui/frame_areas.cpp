#include "app/ui/frame_areas.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "app/editor/pointer/plot_layout.h"

namespace batten::ui {

namespace {

// Design pixels.
constexpr double menu_height = 34.0;
constexpr double status_height = 40.0;
constexpr double caption_height = 26.0;  // in its place for a projector
constexpr double tool_width = 52.0;
constexpr double least_canvas_width = 200.0;
constexpr double least_canvas_height = 130.0;
constexpr double least_canvas_width_beside_cards = 360.0;
constexpr double least_inspector_width = 240.0;
constexpr double least_cards_width = 220.0;
constexpr double least_dock_height = 110.0;

// The parts of the window that panels may take at most.
constexpr double most_inspector_share = 0.55;
constexpr double most_cards_share = 0.5;
constexpr double most_dock_share = 0.5;
constexpr double most_presented_dock_share = 0.36;  // a projector is for the curve, unless plots were asked for

/// `wanted`, but at most `most`; nothing where that is less than `least` or leaves less than `least_canvas` of the
/// room.
double shrunk(double wanted, double room, double most, double least_canvas, double least) {
    const double size = std::floor(std::min({wanted, most, room - least_canvas}));
    return size < least ? 0.0 : size;
}

}  // namespace

FrameAreas arrange(glm::dvec2 size_px, const editor::View& view, double scale, bool has_cards) {
    const auto px = [scale](double design_px) { return std::round(design_px * scale); };
    const bool has_frame = !view.is_presenting;
    const double menu = has_frame ? px(menu_height) : 0.0;
    const double status = px(has_frame ? status_height : caption_height);
    const double tools = has_frame ? px(tool_width) : 0.0;
    const double height = std::max(0.0, size_px.y - menu - status);
    const double width = std::max(0.0, size_px.x - tools);
    const double cards = has_cards && has_frame ? shrunk(px(view.cards_width), width, most_cards_share * width,
                                                         px(least_canvas_width), px(least_cards_width))
                                                : 0.0;
    // Beside cards the inspector folds away before the canvas gets too small to see what they are about.
    const double beside_cards = width - cards;
    const double inspector =
        has_frame && view.inspector_is_open
            ? shrunk(px(view.inspector_width), beside_cards, most_inspector_share * beside_cards,
                     px(has_cards ? least_canvas_width_beside_cards : least_canvas_width), px(least_inspector_width))
            : 0.0;
    const double side = cards + inspector;
    const double plots = editor::height_of_plots(view);
    const double most_dock = view.is_presenting && plots == 0.0 ? most_presented_dock_share : most_dock_share;
    const double dock = editor::shows_dock(view) ? shrunk(px(view.dock_height + plots), height, most_dock * height,
                                                          px(least_canvas_height), px(least_dock_height))
                                                 : 0.0;

    FrameAreas areas;
    areas.window = {{0.0, 0.0}, size_px};
    areas.menu_bar = {{0.0, 0.0}, {size_px.x, menu}};
    areas.tool_bar = {{0.0, menu}, {tools, height}};
    areas.title_line = {{tools, menu}, {width - side, 0.0}};
    areas.canvas = {{tools, menu}, {width - side, height - dock}};
    areas.dock = {{tools, menu + height - dock}, {width - side, dock}};
    areas.cards = {{size_px.x - side, menu}, {cards, height}};
    areas.inspector = {{size_px.x - inspector, menu}, {inspector, height}};
    areas.status_bar = {{0.0, menu + height}, {size_px.x, status}};
    return areas;
}

FrameAreas with_line_over_cards(FrameAreas areas) {
    areas.title_line.size_px.x += areas.cards.size_px.x;
    return areas;
}

FrameAreas with_title_line(FrameAreas areas, double height_px) {
    const double height = std::min(std::ceil(height_px), areas.canvas.size_px.y);
    if (areas.title_line.size_px.x > areas.canvas.size_px.x) {
        areas.cards.origin_px.y += height;
        areas.cards.size_px.y -= height;
    }
    areas.title_line.size_px.y = height;
    areas.canvas.origin_px.y += height;
    areas.canvas.size_px.y -= height;
    return areas;
}

FrameAreas with_rulers(FrameAreas areas, double width_px) {
    areas.rulers = areas.canvas;
    const glm::dvec2 width = glm::min(glm::dvec2(std::ceil(width_px)), areas.canvas.size_px);
    areas.canvas.origin_px += width;
    areas.canvas.size_px -= width;
    return areas;
}

}  // namespace batten::ui
