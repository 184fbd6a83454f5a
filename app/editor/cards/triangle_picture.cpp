#include "app/editor/cards/triangle_picture.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/editor/cards/cell_grid.h"
#include "app/editor/derived/construction_cells.h"
#include "app/editor/scene/text_size.h"
#include "app/editor/state/point_hues.h"
#include "app/editor/words/formula.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

// Design pixels.
constexpr std::size_t most_drawn_degree = 8;
constexpr double cell_name_size = 14.0;
constexpr double least_cell_text = 9.0;
constexpr double below_cell_size = 12.0;
constexpr double below_cell_distance = 10.0;
constexpr double cell_corner_radius = 6.0;
constexpr double faded_cell_opacity = 0.3;
constexpr double cell_text_margin = 3.0;
constexpr double cell_width_error = 1.12;  // of a text that is not measured with its font

CellShape shape_for(const CellTexts& texts) {
    return {.widths = {texts.least_width, 2.0 * texts.least_width},
            .height = 26.0,
            .row_pitch = 48.0,
            .column_share = texts.column_share};
}

/// One picture while it is drawn.
class TrianglePainter {
  public:
    TrianglePainter(const EditorState& state, const CellTexts& texts, glm::dvec2 size_px, double scale)
        : state_(state),
          texts_(texts),
          theme_(shown_theme(state.view)),
          triangle_(core::de_boor_triangle(*state.active_curve(), state.parameter())),
          pen_(drawing_.list, size_px, scale, state.view.notation),
          degree_(triangle_.levels.size() - 1),
          last_level_(shown_level(state.view, static_cast<int>(degree_))),
          grid_(shape_for(texts).placed(degree_, size_px.x, scale)) {}

    CardDrawing draw() {
        for (std::size_t r = 1; r <= degree_; ++r)
            for (std::size_t j = 0; j <= degree_ - r; ++j) draw_lines({r, j});
        for (std::size_t r = 0; r <= degree_; ++r)
            for (std::size_t j = 0; j <= degree_ - r; ++j) draw_cell({r, j});
        return std::move(drawing_);
    }

  private:
    NamedTriangle named() const { return {*state_.active_curve(), triangle_, state_.view.notation}; }

    bool is_lit(core::CellPlace place) const { return is_lit_cell(state_, triangle_, place); }
    double opacity(core::CellPlace place) const { return place.level > last_level_ ? faded_cell_opacity : 1.0; }

    render::Color color_of(core::CellPlace place) const {
        if (place.level > 0) return theme_.level(place.level);
        return theme_.point(
            point_hue(*state_.shown().active_curve(),
                      triangle_.levels[0][place.index].index % state_.active_curve()->control_points().size()));
    }

    void draw_lines(core::CellPlace place) {
        const double alpha = triangle_.levels[place.level][place.index].alpha;
        draw_line(place, place.index, 1.0 - alpha);
        draw_line(place, place.index + 1, alpha);
    }

    void draw_line(core::CellPlace place, std::size_t from, double share) {
        const double strength = is_lit(place) ? 1.0 : 0.3 + 0.7 * share;
        pen_.segment(grid_.right(place.level - 1, from), grid_.left(place.level, place.index),
                     {.color = render::blended(color_of(place), opacity(place) * strength, theme_.panel),
                      .width = (is_lit(place) ? 1.6 : 0.8) + 1.4 * share});
    }

    void draw_cell(core::CellPlace place) {
        const render::PixelBox box = grid_.box(place.level, place.index);
        const render::Color color = color_of(place);
        const std::vector<glm::dvec2> outline = rounded_rectangle(box, pen_.px(cell_corner_radius));
        pen_.fill(outline, is_lit(place) ? render::blended(color, 0.3, theme_.field) : theme_.field);
        pen_.outline(outline, {.color = render::blended(color, opacity(place), theme_.field),
                               .width = is_lit(place) ? 2.5 : 1.5});
        write_inside(place, box);
        write_below(place, box);
    }

    void write_inside(core::CellPlace place, const render::PixelBox& box) {
        const std::string text = texts_.inside(named(), place);
        const render::Color color = place.level == degree_ ? theme_.parameter : theme_.text;
        const double room = box.upper_px.x - box.lower_px.x - 2.0 * pen_.px(cell_text_margin);
        const double width = cell_width_error * text_size(text, pen_.px(cell_name_size)).x;
        pen_.text(0.5 * (box.lower_px + box.upper_px), text,
                  {.color = render::blended(color, opacity(place), theme_.field),
                   .size = std::max(least_cell_text, cell_name_size * std::min(1.0, room / width)),
                   .anchor = render::Anchor::center});
        drawing_.places.push_back({.name = fmt::format("cell {} {}", place.level, place.index),
                                   .box = box,
                                   .hover = HoveredCell{place.level, place.index},
                                   .value = plain_text(notated(text, state_.view.notation))});
    }

    void write_below(core::CellPlace place, const render::PixelBox& box) {
        if (place.level == 0) return;
        const std::string text = texts_.below(named(), place);
        if (text.empty()) return;
        pen_.text({0.5 * (box.lower_px.x + box.upper_px.x), box.upper_px.y + pen_.px(below_cell_distance)}, text,
                  {.color = render::blended(theme_.dim, opacity(place), theme_.panel),
                   .size = below_cell_size,
                   .anchor = render::Anchor::center});
    }

    const EditorState& state_;
    const CellTexts& texts_;
    Theme theme_;
    core::DeBoorTriangle triangle_;
    CardDrawing drawing_;
    Pen pen_;
    std::size_t degree_;
    std::size_t last_level_;
    CellGrid grid_;
};

}  // namespace

CardBlock triangle_picture(const EditorState& state, CellTexts texts) {
    const auto degree = static_cast<std::size_t>(state.active_curve()->degree());
    if (degree > most_drawn_degree)
        return CardLine{{.text = core::sentence("A triangle of {count} points is too large here; the inspector has it.",
                                                {{"count", (degree + 1) * (degree + 2) / 2}}),
                         .tone = CardTone::dim}};
    const CellShape shape = shape_for(texts);
    return CardPicture{
        .height = shape.height_of_all(degree),
        .draw = [&state, texts = std::move(texts)](
                    glm::dvec2 size_px, double scale) { return TrianglePainter(state, texts, size_px, scale).draw(); },
        .least_width = shape.least_width_of_all(degree)};
}

}  // namespace batten::editor
