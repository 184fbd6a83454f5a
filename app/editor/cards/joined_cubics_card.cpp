#include <fmt/core.h>

#include <array>
#include <utility>

#include "app/editor/cards/card_texts.h"
#include "app/editor/cards/cubic_card_parts.h"
#include "app/editor/cards/cubic_cards.h"
#include "app/editor/commands/closing_commands.h"
#include "app/editor/commands/file_commands.h"
#include "app/editor/words/cubic_sentences.h"
#include "app/editor/words/uniform_cubic_formula.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

std::string vertex_names(std::size_t middle) {
    return fmt::format("{} {} {}", point_name(middle - 1), point_name(middle), point_name(middle + 1));
}

/// The vertices on both sides, and the three conditions.
CardTable joint_conditions(const Notation& notation, const core::CubicMeeting& meeting) {
    const auto& [first, second, continuity, has_equal_steps] = meeting;
    const auto row = [](const char* name, std::string left, std::string right, bool holds) -> std::vector<CardText> {
        return {{.text = name}, {.text = std::move(left)}, {.text = std::move(right)}, tick(holds)};
    };
    return {.rows = {{{.text = ""}, {.text = "end of the first"}, {.text = "start of the second"}, {.text = ""}},
                     {{.text = ""}, {.text = vertex_names(first.index)}, {.text = vertex_names(second.index)}},
                     row("C", exact_place(notation, first.anticentroid), exact_place(notation, second.anticentroid),
                         continuity >= 0),
                     row("C′", exact_place(notation, first.tangent), exact_place(notation, second.tangent),
                         continuity >= 1),
                     row("C″", exact_place(notation, first.second_derivative),
                         exact_place(notation, second.second_derivative), continuity >= 2)},
            .has_heading = true};
}

/// Inside one curve segments join by themselves.
void add_own_joint(Card& card, const EditorState& state) {
    const ShownCubic cubic = shown_cubic(state);
    if (cubic.segment_count < 2) {
        card.line("The curve has one segment. A second one would share three of its vertices.");
        return;
    }
    const bool is_last = cubic.segment + 1 == cubic.segment_count && !state.active_curve()->is_periodic();
    const std::size_t first = is_last ? 0 : 1;
    const core::Place a("a", point_name(cubic.points[first]));
    const core::Place b("b", point_name(cubic.points[first + 1]));
    const core::Place c("c", point_name(cubic.points[first + 2]));
    card.line(is_last
                  ? core::sentence("The segment at u and the one before it share {a}, {b} and {c}, which alone make "
                                   "their joint and its first two derivatives. So they join with C².",
                                   {a, b, c})
                  : core::sentence("The segment at u and the next one share {a}, {b} and {c}, which alone make "
                                   "their joint and its first two derivatives. So they join with C².",
                                   {a, b, c}));
}

}  // namespace

Card joined_cubics_card(const EditorState& state) {
    constexpr const char* title = "Joined cubics";
    if (std::optional<Card> lack = card_of_lack(state, title)) return *std::move(lack);
    Card card{.title = title, .blocks = {}};
    const std::optional<JoinedCubic> joined = joined_cubic(state);
    if (!joined) {
        add_own_joint(card, state);
        card.line("To see two curves join, have another open uniform cubic after this one in the list of curves.",
                  CardTone::dim);
        card.add(CardButtons{{{"Open an example of two", OpenExample{.name = "coons-joined"}}}});
        return card;
    }
    const core::Document& document = state.shown();
    const std::string& active = document.curves[document.active].name;
    const std::string& other = document.curves[joined->index].name;
    const bool is_first = joined->end == core::CurveEnd::end;
    card.line(core::sentence("'{first}' ends, '{second}' begins:",
                             {{"first", is_first ? active : other}, {"second", is_first ? other : active}}),
              CardTone::strong);
    card.add(joint_conditions(state.view.notation, joined->meeting));
    card.line(meeting_sentence(joined->meeting), joined->meeting.continuity == 2 ? CardTone::good : CardTone::plain);
    card.add(CardButtons{{{"Share three vertices", ShareVertices{.other = other, .end = joined->end}}}});
    return card;
}

}  // namespace batten::editor
