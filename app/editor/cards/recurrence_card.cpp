#include "app/editor/cards/recurrence_card.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/editor/cards/card_texts.h"
#include "app/editor/cards/cell_grid.h"
#include "app/editor/derived/shown_function.h"
#include "app/editor/scene/text_size.h"
#include "app/editor/state/point_hues.h"
#include "app/editor/words/basis_formula.h"
#include "app/editor/words/formula.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

// Design pixels.
constexpr double basis_name_size = 12.0;
constexpr double cell_value_size = 12.0;
constexpr double ratio_size = 10.5;
constexpr int formula_lines = 5;

constexpr CellShape basis_cells{.widths = {50.0, 64.0}, .height = 36.0, .row_pitch = 46.0, .column_share = 0.58};

/// The triangle at one size.
class TrianglePicture {
  public:
    TrianglePicture(const EditorState& state, const core::BasisTriangle& triangle, glm::dvec2 size_px, double scale,
                    CardDrawing& drawing)
        : state_(state),
          theme_(shown_theme(state.view)),
          triangle_(triangle),
          pen_(drawing.list, size_px, scale, state.view.notation),
          drawing_(drawing),
          grid_(basis_cells.placed(triangle.levels.size() - 1, size_px.x, scale)),
          shown_(shown_basis_cell(state)) {}

    void draw() {
        for (std::size_t k = 1; k < triangle_.levels.size(); ++k)
            for (std::size_t j = 0; j < triangle_.levels[k].size(); ++j) draw_lines(k, j);
        for (std::size_t k = 0; k < triangle_.levels.size(); ++k)
            for (std::size_t j = 0; j < triangle_.levels[k].size(); ++j) draw_cell(k, j);
    }

  private:
    const core::BasisCell& cell(std::size_t k, std::size_t j) const { return triangle_.levels[k][j]; }

    bool is_pointed_at(std::size_t k, std::size_t j) const {
        return state_.hover == Hover(HoveredBasisCell{cell(k, j).index, k});
    }

    bool is_shown(std::size_t k, std::size_t j) const { return shown_ == HoveredBasisCell{cell(k, j).index, k}; }

    render::Color color(std::size_t k, std::size_t j) const {
        return cell(k, j).value == 0.0 ? theme_.dim : theme_.point(function_color(cell(k, j).index));
    }

    std::size_t function_color(std::size_t i) const {
        return point_hue(*state_.shown().active_curve(), i % state_.active_curve()->control_points().size());
    }

    std::string number(double value) const { return exact_text(state_.view.notation, value, 3); }

    void draw_lines(std::size_t k, std::size_t j) {
        draw_line(k, j, j, cell(k, j).rising);
        draw_line(k, j, j + 1, cell(k, j).falling);
    }

    /// The line from a parent with its ratio.
    void draw_line(std::size_t k, std::size_t j, std::size_t from, const core::BasisRamp& ramp) {
        const glm::dvec2 begin = grid_.right(k - 1, from);
        const glm::dvec2 end = grid_.left(k, j);
        const bool acts = !ramp.is_void && cell(k - 1, from).value != 0.0;
        const bool is_strong = is_shown(k, j);
        pen_.segment(begin, end,
                     {.color = is_strong ? theme_.text
                               : acts    ? theme_.dim
                                         : theme_.line,
                      .width = is_strong ? 2.0 : 1.2,
                      .dash = ramp.is_void ? 3.0 : 0.0,
                      .gap = ramp.is_void ? 3.0 : 0.0});
        write_ratio(0.5 * (begin + end), ramp.is_void ? "0/0" : number(ramp.value),
                    is_strong ? theme_.text : theme_.dim);
    }

    /// On the line, which it interrupts.
    void write_ratio(glm::dvec2 middle, const std::string& text, render::Color color) {
        const glm::dvec2 half = 0.5 * text_size(text, pen_.px(ratio_size)) + glm::dvec2(pen_.px(1.5), -pen_.px(1.5));
        pen_.fill(corners_of({middle - half, middle + half}), theme_.panel);
        pen_.text(middle, text, {.color = color, .size = ratio_size, .anchor = render::Anchor::center});
    }

    void draw_cell(std::size_t k, std::size_t j) {
        const render::PixelBox box = grid_.box(k, j);
        const render::Color edge = color(k, j);
        const render::Color fill = render::blended(edge,
                                                   is_pointed_at(k, j) ? 0.3
                                                   : is_shown(k, j)    ? 0.16
                                                                       : 0.0,
                                                   theme_.field);
        std::vector<glm::dvec2> outline = rounded_rectangle(box, pen_.px(6.0));
        pen_.fill(outline, fill);
        pen_.outline(std::move(outline), {.color = edge, .width = is_shown(k, j) ? 2.0 : 1.2});
        const glm::dvec2 middle = 0.5 * (box.lower_px + box.upper_px);
        const std::string name = basis_name(cell(k, j).index, k);
        const std::string value = number(cell(k, j).value);
        const render::Color ink = cell(k, j).value == 0.0 ? theme_.dim : theme_.text;
        pen_.text(middle - glm::dvec2(0.0, pen_.px(9.0)), name,
                  {.color = ink, .size = basis_name_size, .anchor = render::Anchor::center});
        pen_.text(
            middle + glm::dvec2(0.0, pen_.px(8.0)), value,
            {.color = ink, .size = cell_value_size, .anchor = render::Anchor::center, .font = render::LabelFont::bold});
        drawing_.places.push_back({.name = fmt::format("cell {} {}", k, j),
                                   .box = box,
                                   .hover = HoveredBasisCell{cell(k, j).index, k},
                                   .value = fmt::format("{} = {}", plain_text(name), value)});
    }

    const EditorState& state_;
    Theme theme_;
    const core::BasisTriangle& triangle_;
    Pen pen_;
    CardDrawing& drawing_;
    CellGrid grid_;
    std::optional<HoveredBasisCell> shown_;
};

CardPicture triangle_picture(const EditorState& state, const core::BasisTriangle& triangle) {
    const std::size_t degree = triangle.levels.size() - 1;
    return {.height = basis_cells.height_of_all(degree),
            .draw =
                [&state, triangle](glm::dvec2 size_px, double scale) {
                    CardDrawing drawing;
                    TrianglePicture(state, triangle, size_px, scale, drawing).draw();
                    return drawing;
                },
            .least_width = basis_cells.least_width_of_all(degree)};
}

/// As many lines whatever the cell, so that nothing jumps.
void add_recurrence_formula(Card& card, const EditorState& state, const core::BasisTriangle& triangle) {
    const core::KnotVector& knots = state.active_curve()->knots();
    HoveredBasisCell shown = shown_basis_cell(state).value();
    const std::size_t first = triangle.levels[0].front().index;
    const auto is_inside = [&] {
        return shown.degree < triangle.levels.size() && shown.function >= first &&
               shown.function - first < triangle.levels[shown.degree].size();
    };
    if (!is_inside()) shown = {first, triangle.levels.size() - 1};
    const std::size_t j = shown.function - first;
    if (shown.degree == 0) {
        card.formula(step_formula(knots, triangle, j, state.view.notation), CardTone::accent);
        for (int line = 1; line < formula_lines; ++line) card.formula(blank_line);
        card.line(blank_line);
        return;
    }
    const RecurrenceFormula formula = recurrence_formula(knots, triangle, shown.degree, j, state.view.notation);
    for (const std::string& line : formula.symbols) card.formula(line, CardTone::accent);
    for (const std::string& line : formula.knots) card.formula(line);
    card.formula(formula.numbers);
    card.line(formula.note.empty() ? blank_line : formula.note, CardTone::parameter);
}

}  // namespace

Card recurrence_card(const EditorState& state) {
    const std::optional<ShownFunction> function = shown_function(state);
    Card card{.title = "Recurrence", .blocks = {}};
    if (!function) return card_without_curve(std::move(card));
    const core::Curve& curve = *state.active_curve();
    const auto p = static_cast<std::size_t>(curve.degree());
    const core::BasisTriangle triangle = core::basis_triangle(curve.knots(), function->number, state.parameter());
    const bool is_bezier = state.derived.of(curve.knots())->is_bezier;
    const char* pattern = is_bezier ? "{bernstein}(u) = {function}(u) at u = {u}" : "{function}(u) at u = {u}";
    card.line(core::filled_as_needed(pattern, {{"function", basis_name(function->number, p)},
                                               {"bernstein", function_name(state, curve.knots(), function->number)},
                                               {"u", knot_value_text(curve.knots(), triangle.u, state.view.notation)}}),
              CardTone::strong);
    if (is_bezier && curve.domain() == core::Interval{0.0, 1.0})
        card.formula(bernstein_recurrence(function->number, p), CardTone::parameter);
    card.add(triangle_picture(state, triangle));
    add_recurrence_formula(card, state, triangle);
    card.line(
        "Point at a cell to see its two functions and ratios in the plot; select a control point for its function.",
        CardTone::dim);
    return card;
}

}  // namespace batten::editor
