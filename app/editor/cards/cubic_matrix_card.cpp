#include <fmt/core.h>

#include "app/editor/cards/cubic_card_parts.h"
#include "app/editor/cards/cubic_cards.h"
#include "app/editor/cards/formula_picture.h"
#include "app/editor/state/point_hues.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/uniform_cubic_formula.h"

namespace batten::editor {

namespace {

constexpr std::array<std::size_t, 4> four{0, 1, 2, 3};

FormulaPart matrix_part() {
    FormulaPart part;
    for (const auto& row : core::uniform_cubic_matrix) {
        part.rows.emplace_back();
        for (const int entry : row) part.rows.back().push_back({.text = number_text(entry)});
    }
    return part;
}

FormulaPart powers_part(const char* t) {
    return formula_row_vector({"1", t, fmt::format("{}^{{2}}", t), fmt::format("{}^{{3}}", t)});
}

CardPicture symbols(const EditorState& state, const ShownCubic& cubic) {
    const Theme theme = shown_theme(state.view);
    std::vector<CardText> points;
    for (const std::size_t i : cubic.points) {
        points.push_back(point_cell(i));
        points.back().color = theme.point_text(point_hue(*state.shown().active_curve(), i));
    }
    const char* t = local_parameter(state.view.notation);
    return formula_picture(
        {formula_text("C ="), powers_part(t), formula_text("1/6"), matrix_part(), formula_column(std::move(points))},
        theme, state.view.notation, "matrix");
}

FormulaPart coordinates_part(const Notation& notation, const std::array<core::Vector, 4>& rows) {
    FormulaPart part;
    for (const core::Vector& row : rows)
        part.rows.push_back({{.text = exact_coordinate(notation, row.x)}, {.text = exact_coordinate(notation, row.y)}});
    return part;
}

/// The same with the coordinates of the points, which gives those of the coefficients.
CardPicture numbers(const EditorState& state, const core::CubicSegment& segment, const ShownCubic& cubic) {
    const Notation& notation = state.view.notation;
    std::array<core::Vector, 4> points;
    std::array<core::Vector, 4> coefficients;
    std::vector<CardText> names;
    for (const std::size_t j : four) {
        points[j] = core::vector_to(state.active_curve()->control_points()[cubic.points[j]]);
        coefficients[j] = core::plane_part(segment.coefficients[j]);
        names.push_back({.text = fmt::format("a_{{{}}}", j)});
    }
    return formula_picture(
        {formula_column(std::move(names)), formula_text("= 1/6 M"), coordinates_part(notation, points),
         formula_text("="), coordinates_part(notation, coefficients)},
        shown_theme(state.view), notation, "numbers");
}

/// The values of the four polynomials at t, which are the parts that the points have in C(t).
CardTable shares(const EditorState& state, const ShownCubic& cubic) {
    const Notation& notation = state.view.notation;
    CardTable table{.rows = {{}, {}}, .has_heading = true};
    std::array<double, 4> values{};
    for (const std::size_t j : four) values[j] = core::uniform_cubic_value(j, cubic.t);
    const std::vector<std::string> texts = exact_texts(notation, values, 3);
    for (const std::size_t j : four) {
        table.rows[0].push_back({.text = fmt::format("b_{{{}}}", j), .hover = HoveredPoint{cubic.points[j]}});
        table.rows[1].push_back({.text = texts[j], .hover = HoveredPoint{cubic.points[j]}});
    }
    table.rows[0].push_back({.text = "Σ"});
    table.rows[1].push_back({.text = "1"});
    return table;
}

}  // namespace

Card cubic_matrix_card(const EditorState& state) {
    constexpr const char* title = "Matrix";
    if (std::optional<Card> lack = card_of_lack(state, title)) return *std::move(lack);
    const ShownCubic cubic = shown_cubic(state);
    const core::CubicSegment segment = core::cubic_segment(*state.visible_active_curve(), cubic.segment);
    const Notation& notation = state.view.notation;
    const char* t = local_parameter(notation);
    Card card{.title = title, .blocks = {}};
    add_segment_lines(card, state, cubic);
    card.add(symbols(state, cubic));
    card.line("With the points of the segment put in, M being the matrix:", CardTone::dim);
    card.add(numbers(state, segment, cubic));
    card.formula(fmt::format("C({0}) = a_{{0}} + a_{{1}} {0} + a_{{2}} {0}^{{2}} + a_{{3}} {0}^{{3}}", t));
    card.add(shares(state, cubic));
    const auto& a = segment.coefficients;
    const core::Vector point = core::plane_part(a[0] + cubic.t * (a[1] + cubic.t * (a[2] + cubic.t * a[3])));
    card.formula(fmt::format("C({}) = {}", exact_text(notation, cubic.t), exact_place(notation, point)),
                 CardTone::parameter);
    return card;
}

}  // namespace batten::editor
