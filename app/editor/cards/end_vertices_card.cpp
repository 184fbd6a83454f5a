#include <fmt/core.h>

#include <array>

#include "app/editor/cards/cubic_card_parts.h"
#include "app/editor/cards/cubic_cards.h"
#include "app/editor/commands/closing_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/words/cubic_sentences.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

struct EndKind {
    std::optional<core::EndVertex> vertex;
    const char* title;
};

constexpr std::array<EndKind, 4> end_kinds{{{std::nullopt, "as it is"},
                                            {core::EndVertex::doubled, "double"},
                                            {core::EndVertex::tripled, "triple"},
                                            {core::EndVertex::phantom, "phantom"}}};

/// The three outer control points from the end inward.
std::array<std::string, 3> outer_names(const core::Curve& curve, core::CurveEnd end) {
    const std::size_t last = curve.control_points().size() - 1;
    if (end == core::CurveEnd::start) return {point_name(0), point_name(1), point_name(2)};
    return {point_name(last), point_name(last - 1), point_name(last - 2)};
}

/// Where the curve begins or ends with such a vertex, and its derivative there.
std::array<std::string, 2> formulas_of(std::optional<core::EndVertex> vertex, core::CurveEnd end,
                                       const std::array<std::string, 3>& P) {
    const bool is_start = end == core::CurveEnd::start;
    const auto toward = [&](const std::string& outer, const std::string& inner) {
        return is_start ? fmt::format("{} − {}", inner, outer) : fmt::format("{} − {}", outer, inner);
    };
    if (!vertex)
        return {fmt::format("({} + 4 {} + {})/6", P[0], P[1], P[2]), fmt::format("({})/2", toward(P[0], P[2]))};
    switch (*vertex) {
        case core::EndVertex::doubled:
            return {fmt::format("(5 {} + {})/6", P[0], P[1]), fmt::format("({})/2", toward(P[0], P[1]))};
        case core::EndVertex::tripled:
            return {P[0], "0"};
        case core::EndVertex::phantom:
            break;
    }
    return {P[0], toward(P[0], P[1])};
}

Command adding(core::EndVertex vertex, CurveEnds end) {
    switch (vertex) {
        case core::EndVertex::doubled:
            return DoubleEnd{.end = end};
        case core::EndVertex::tripled:
            return TripleEnd{.end = end};
        case core::EndVertex::phantom:
            break;
    }
    return PhantomEnd{.end = end};
}

void add_end_vertices(Card& card, const core::Curve& curve, core::CurveEnd end) {
    const bool is_start = end == core::CurveEnd::start;
    const std::array<std::string, 3> names = outer_names(curve, end);
    CardTable table{
        .rows = {{{.text = is_start ? "Start" : "End"}, {.text = is_start ? "begins in" : "ends in"}, {.text = "C′"}}},
        .has_heading = true};
    CardButtons buttons;
    for (const auto& [vertex, title] : end_kinds) {
        const auto [place, tangent] = formulas_of(vertex, end, names);
        table.rows.push_back({{.text = title}, {.text = place}, {.text = tangent}});
        if (vertex) buttons.buttons.push_back({title, adding(*vertex, is_start ? CurveEnds::start : CurveEnds::end)});
    }
    card.add(std::move(table));
    card.add(std::move(buttons));
}

/// What the vertices about the joint in focus do, and how to double one or put them on a line.
void add_vertices(Card& card, const EditorState& state, const ShownCubic& cubic) {
    const core::Curve& curve = *state.visible_active_curve();
    const std::size_t n = curve.control_points().size();
    const std::size_t i = cubic.focus.index;
    const std::array<std::size_t, 3> around{(i + n - 1) % n, i, (i + 1) % n};
    const std::array<std::string, 3> names{point_name(around[0]), point_name(around[1]), point_name(around[2])};
    card.add(CardLine{{.text = joint_sentence(cubic.focus, names), .hover = HoveredPoint{i}}});
    if (core::is_straight_segment(curve, cubic.segment))
        card.line("The four control points of the segment at u are on one line: it is straight.", CardTone::accent);
    CardButtons buttons;
    // A knot vector without a kind would gain a knot in the middle of a span.
    if (curve.knots().kind() != core::KnotKind::custom)
        buttons.buttons.push_back({core::sentence("Double {point}", {{"point", names[1]}}),
                                   AddPoint{.index = i + 1, .position = cubic.focus.vertex}});
    if (around[0] < around[2])
        buttons.buttons.push_back(
            {core::sentence("Put {first} to {last} on a line", {{"first", names[0]}, {"last", names[2]}}),
             Straighten{.from = around[0], .to = around[2]}});
    card.add(std::move(buttons));
}

}  // namespace

Card end_vertices_card(const EditorState& state) {
    constexpr const char* title = "End vertices";
    if (std::optional<Card> lack = card_of_lack(state, title)) return *std::move(lack);
    const core::Curve& curve = *state.visible_active_curve();
    Card card{.title = title, .blocks = {}};
    if (curve.is_periodic()) {
        card.line("The curve is periodic and has no ends; inner vertices can be double, triple or on a line, too.");
    } else {
        add_end_vertices(card, curve, core::CurveEnd::start);
        add_end_vertices(card, curve, core::CurveEnd::end);
        card.line(
            "With a double or a phantom vertex the curvature is 0 there; with a triple one the first span is "
            "straight.",
            CardTone::dim);
    }
    add_vertices(card, state, shown_cubic(state));
    return card;
}

}  // namespace batten::editor
