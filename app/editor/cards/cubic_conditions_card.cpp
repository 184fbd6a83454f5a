#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "app/editor/cards/card_texts.h"
#include "app/editor/cards/cubic_card_parts.h"
#include "app/editor/cards/cubic_cards.h"
#include "app/editor/state/point_hues.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/uniform_cubic_formula.h"

namespace batten::editor {

namespace {

// Design pixels.
constexpr double pieces_height = 118.0;
constexpr double pieces_side_margin = 14.0;
constexpr double pieces_top_margin = 16.0;
constexpr double bottom_margin = 20.0;
constexpr int steps = 24;  // of a piece
constexpr double highest = 2.0 / 3.0;

/// The four points that count by b_0 to b_3, the places of their colors in the palette, and the t that is shown.
struct PieceLook {
    Theme theme;
    Notation notation;
    std::array<std::size_t, 4> points{0, 1, 2, 3};
    std::array<std::size_t, 4> hues{0, 1, 2, 3};
    std::optional<double> t{};
};

PieceLook look_of(const EditorState& state) {
    PieceLook look{.theme = shown_theme(state.view), .notation = state.view.notation};
    if (cubic_lack(state)) return look;
    const ShownCubic cubic = shown_cubic(state);
    look.points = cubic.points;
    for (std::size_t j = 0; j < 4; ++j) look.hues[j] = point_hue(*state.shown().active_curve(), cubic.points[j]);
    look.t = cubic.t;
    return look;
}

/// The basis function over its support of four spans, each piece in its color.
class PiecesPainter {
  public:
    PiecesPainter(const PieceLook& look, glm::dvec2 size_px, double scale)
        : look_(look), pen_(drawing_.list, size_px, scale, look.notation), size_(size_px / scale) {}

    CardDrawing draw() {
        pen_.segment(place(0.0, 0.0), place(4.0, 0.0), {.color = look_.theme.line});
        for (std::size_t q = 0; q <= 4; ++q) draw_joint(q);
        for (std::size_t j = 0; j < 4; ++j) draw_piece(j);
        return std::move(drawing_);
    }

  private:
    glm::dvec2 place(double along, double value) const {
        const double x = pieces_side_margin + (size_.x - 2.0 * pieces_side_margin) * along / 4.0;
        const double room = size_.y - pieces_top_margin - bottom_margin;
        return {pen_.px(x), pen_.px(size_.y - bottom_margin - room * value / highest)};
    }

    void draw_joint(std::size_t q) {
        const auto along = static_cast<double>(q);
        pen_.segment(place(along, 0.0), place(along, highest), {.color = look_.theme.line, .dash = 3.0, .gap = 4.0});
        pen_.text(place(along, 0.0) + glm::dvec2(0.0, pen_.px(11.0)), fmt::format("{}", q),
                  {.color = look_.theme.dim, .size = 12.0, .anchor = render::Anchor::center});
    }

    void draw_piece(std::size_t j) {
        const double start = 3.0 - static_cast<double>(j);
        std::vector<glm::dvec2> places;
        for (int k = 0; k <= steps; ++k) {
            const double t = static_cast<double>(k) / steps;
            places.push_back(place(start + t, core::uniform_cubic_value(j, t)));
        }
        pen_.line(places, {.color = look_.theme.point(look_.hues[j]), .width = 2.5});
        const double height = j == 0 || j == 3 ? 0.25 : highest + 0.1;
        pen_.text(place(start + 0.5, height), fmt::format("b_{{{}}}", j),
                  {.color = look_.theme.point_text(look_.hues[j]),
                   .size = 14.0,
                   .anchor = render::Anchor::center,
                   .font = render::LabelFont::bold});
        if (!look_.t) return;
        drawing_.places.push_back({.name = fmt::format("piece {}", j),
                                   .box = {{place(start, 0.0).x, 0.0}, place(start + 1.0, 0.0)},
                                   .hover = HoveredPoint{look_.points[j]},
                                   .value = plain_text(fmt::format("b_{{{}}}", j))});
        pen_.symbol(place(start + *look_.t, core::uniform_cubic_value(j, *look_.t)),
                    {.radius = 4.0, .fill = look_.theme.parameter, .outline = look_.theme.panel, .outline_width = 1.0});
    }

    PieceLook look_;
    CardDrawing drawing_;
    Pen pen_;
    glm::dvec2 size_;
};

CardTable condition_table(const Notation& notation) {
    CardTable table{.rows = {{{.text = "Joint"}, {.text = "Condition"}, {.text = "Numbers"}, {.text = ""}}},
                    .has_heading = true};
    for (const core::UniformCubicCondition& condition : core::uniform_cubic_conditions()) {
        const ConditionFormula formula = condition_formula(notation, condition);
        const std::string joint = condition.order == 0 ? fmt::format("{}", condition.joint) : "";
        table.rows.push_back({{.text = joint, .tone = CardTone::dim},
                              {.text = formula.symbols},
                              {.text = formula.numbers},
                              tick(condition.holds())});
    }
    return table;
}

}  // namespace

Card cubic_conditions_card(const EditorState& state) {
    const PieceLook look = look_of(state);
    const Notation& notation = look.notation;
    Card card{.title = "Fifteen conditions", .blocks = {}};
    card.line(
        "The basis function of the uniform cubic is made of four polynomials, zero outside of them. At each joint "
        "both sides have the same value, first and second derivative.");
    card.add(CardPicture{.height = pieces_height, .draw = [look](glm::dvec2 size_px, double scale) {
                             return PiecesPainter(look, size_px, scale).draw();
                         }});
    card.add(condition_table(notation));
    card.line(
        "These fifteen equations leave the sixteen coefficients one common factor. It follows from the sum, which "
        "must be 1:");
    const ConditionFormula sum = sum_formula(notation);
    card.add(CardTable{.rows = {{{.text = sum.symbols}}, {{.text = sum.numbers}, tick(true)}}});
    card.line("So the four polynomials are:", CardTone::dim);
    for (std::size_t j = 4; j-- > 0;)
        card.add(CardLine{
            {.text = piece_formula(notation, j), .hover = look.t ? Hover(HoveredPoint{look.points[j]}) : Hover()},
            true});
    return card;
}

}  // namespace batten::editor
