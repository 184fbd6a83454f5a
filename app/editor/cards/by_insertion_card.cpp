#include "app/editor/cards/by_insertion_card.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/editor/cards/card_texts.h"
#include "app/editor/derived/construction_cells.h"
#include "app/editor/derived/insertion_lines.h"
#include "app/editor/state/point_hues.h"
#include "app/editor/state/state.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

// Design pixels.
constexpr double panel_height = 118.0;
constexpr double least_panel = 100.0;
constexpr double panel_gap = 8.0;
constexpr double panel_padding = 12.0;
constexpr double panel_title_height = 22.0;
constexpr double panel_title_size = 12.5;
constexpr double panel_corner_radius = 6.0;
constexpr std::size_t most_panels = 6;  // of a higher degree the first ones and the last

/// Maps what lies in a box of the world into a box of the picture, all by one scale.
class PanelMap {
  public:
    PanelMap(const render::PixelBox& area, const core::Box& world) : center_(0.5 * (area.lower_px + area.upper_px)) {
        const glm::dvec2 room = area.upper_px - area.lower_px;
        const core::Vector half = 0.5 * core::vector_to(world.upper) - 0.5 * core::vector_to(world.lower);
        const double larger = std::max(half.x / room.x, half.y / room.y);
        middle_ = core::middle(world.upper, world.lower);
        scale_ = larger > 0.0 && std::isfinite(1.0 / larger) ? 0.5 / larger : 0.0;
    }

    glm::dvec2 operator()(core::Point point) const {
        return center_ + scale_ * glm::dvec2(point.x - middle_.x, middle_.y - point.y);
    }

  private:
    glm::dvec2 center_;
    core::Point middle_{};
    double scale_ = 0.0;
};

/// How often u is inserted in each panel.
std::vector<std::size_t> insertion_panels(std::size_t last) {
    std::vector<std::size_t> times;
    for (std::size_t r = 1; r <= std::min(last, most_panels); ++r) times.push_back(r);
    if (last > most_panels) times.back() = last;
    return times;
}

/// Panels in rows of equal ones.
struct PanelRows {
    std::size_t count = 0;
    std::size_t columns = 1;

    std::size_t rows() const { return (count + columns - 1) / columns; }
};

PanelRows panel_rows(std::size_t count) {
    return {count, count == 4 ? 2 : std::min<std::size_t>(count, 3)};
}

/// One picture while it is drawn.
class InsertionPainter {
  public:
    InsertionPainter(const EditorState& state, glm::dvec2 size_px, double scale)
        : state_(state),
          theme_(shown_theme(state.view)),
          triangle_(core::de_boor_triangle(*state.active_curve(), state.parameter())),
          pen_(drawing_.list, size_px, scale, state.view.notation) {
        for (const core::DeBoorCell& cell : triangle_.levels[0]) world_.include(cell.point);
    }

    CardDrawing draw() {
        const std::size_t last = core::insertion_count(triangle_);
        const std::vector<std::size_t> panels = insertion_panels(last);
        const PanelRows rows = panel_rows(panels.size());
        const double width = (pen_.size_px().x - pen_.px(panel_gap) * static_cast<double>(rows.columns - 1)) /
                             static_cast<double>(rows.columns);
        for (std::size_t k = 0; k < panels.size(); ++k) {
            const glm::dvec2 corner(static_cast<double>(k % rows.columns) * (width + pen_.px(panel_gap)),
                                    static_cast<double>(k / rows.columns) * pen_.px(panel_height + panel_gap));
            draw_panel({corner, corner + glm::dvec2(width, pen_.px(panel_height))}, panels[k], panels[k] == last);
        }
        return std::move(drawing_);
    }

  private:
    void draw_panel(const render::PixelBox& box, std::size_t times, bool is_last) {
        pen_.fill(rounded_rectangle(box, pen_.px(panel_corner_radius)), theme_.canvas);
        pen_.outline(rounded_rectangle(box, pen_.px(panel_corner_radius)),
                     {.color = is_last ? theme_.parameter : theme_.line, .width = is_last ? 2.0 : 1.0});
        const glm::dvec2 inset(pen_.px(panel_padding));
        const PanelMap map(
            {box.lower_px + inset + glm::dvec2(0.0, pen_.px(panel_title_height - 8.0)), box.upper_px - inset}, world_);
        pen_.text({box.lower_px.x + pen_.px(8.0), box.lower_px.y + pen_.px(12.0)}, title_of(times, is_last),
                  {.color = is_last ? theme_.parameter : theme_.text,
                   .size = panel_title_size,
                   .font = render::LabelFont::bold});
        draw_polygon(core::inserted_polygon(triangle_, 0), map,
                     {.color = theme_.polygon, .width = 1.25, .dash = 4.0, .gap = 3.0});
        draw_polygon(core::inserted_polygon(triangle_, times), map, {.color = theme_.level(times), .width = 2.0});
        draw_points(times, map);
        drawing_.places.push_back({.name = fmt::format("inserted {}", times),
                                   .box = box,
                                   .hover = {},
                                   .value = times == 1 ? "once" : core::sentence("{count} times", {{"count", times}})});
    }

    static std::string title_of(std::size_t times, bool is_last) {
        if (is_last) return core::sentence("{count}× u: C(u)", {{"count", times}});
        return core::sentence("{count}× u", {{"count", times}});
    }

    void draw_polygon(const std::vector<core::CellPlace>& cells, const PanelMap& map, const Stroke& stroke) {
        std::vector<glm::dvec2> places;
        for (const core::CellPlace cell : cells) places.push_back(place_of(cell, map));
        pen_.line(places, stroke);
    }

    void draw_points(std::size_t times, const PanelMap& map) {
        for (const core::CellPlace cell : core::inserted_polygon(triangle_, times)) {
            const bool is_new = cell.level == times;
            const bool is_curve_point = is_new && times == core::insertion_count(triangle_);
            pen_.symbol(place_of(cell, map), {.radius = is_curve_point ? 5.5
                                                        : is_new       ? 4.5
                                                                       : 3.0,
                                              .fill = is_curve_point ? theme_.parameter : color_of(cell),
                                              .outline = theme_.canvas,
                                              .outline_width = 1.0});
        }
    }

    glm::dvec2 place_of(core::CellPlace cell, const PanelMap& map) const {
        return map(triangle_.levels[cell.level][cell.index].point);
    }

    render::Color color_of(core::CellPlace cell) const {
        if (cell.level > 0) return theme_.level(cell.level);
        return theme_.point(
            point_hue(*state_.shown().active_curve(),
                      triangle_.levels[0][cell.index].index % state_.active_curve()->control_points().size()));
    }

    const EditorState& state_;
    Theme theme_;
    core::DeBoorTriangle triangle_;
    core::Box world_;
    CardDrawing drawing_;
    Pen pen_;
};

CardPicture insertion_picture(const EditorState& state, std::size_t last) {
    const PanelRows rows = panel_rows(insertion_panels(last).size());
    const auto count = static_cast<double>(rows.rows());
    return {
        .height = count * panel_height + (count - 1.0) * panel_gap,
        .draw = [&state](glm::dvec2 size_px, double scale) { return InsertionPainter(state, size_px, scale).draw(); },
        .least_width = static_cast<double>(rows.columns) * (least_panel + panel_gap) - panel_gap};
}

}  // namespace

Card by_insertion_card(const EditorState& state) {
    if (state.active_curve() == nullptr) return card_without_curve({}, "cubic-de-boor");
    const core::Curve& curve = *state.active_curve();
    const core::DeBoorTriangle triangle = core::de_boor_triangle(curve, state.parameter());
    const Theme theme = shown_theme(state.view);
    const std::size_t last = core::insertion_count(triangle);
    Card card;
    if (last > 0) {
        card.line("Inserting u as a knot makes the points of one level after the other into control points.");
        card.add(insertion_picture(state, last));
    }
    const std::vector<std::string> lines = insertion_lines({curve, triangle, state.view.notation});
    for (std::size_t k = 0; k < lines.size(); ++k) {
        CardLine line{{.text = lines[k], .tone = CardTone::parameter}};
        if (k + 1 < lines.size()) line.text.color = theme.level(k + 1);
        card.add(std::move(line));
    }
    return card;
}

}  // namespace batten::editor
