#include "app/editor/cards/polygon_distance_card.h"

#include <cmath>

#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/file_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/scene/polygon_distance_scene.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/wording.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

CardTable table_of_rounds(const EditorState& state, const std::vector<PolygonRound>& rounds) {
    const Theme theme = shown_theme(state.view);
    CardTable table{.rows = {{{.text = "round"}, {.text = "points"}, {.text = "distance"}, {.text = "ratio"}}},
                    .has_heading = true};
    for (std::size_t r = 0; r < rounds.size(); ++r) {
        const double before = r == 0 ? 0.0 : rounds[r - 1].distance;
        const bool has_ratio = before > 0.0 && std::isfinite(before) && std::isfinite(rounds[r].distance);
        // In the color in which its polygon is drawn.
        const render::Color color = round_color(theme, r);
        table.rows.push_back(
            {{.text = r == 0 ? "now" : core::sentence("{round}", {{"round", r}}), .color = color},
             {.text = core::sentence("{count}", {{"count", rounds[r].curve->control_points().size()}})},
             {.text = bound_words(state.shown().units, rounds[r].distance), .tone = CardTone::strong},
             {.text = has_ratio ? number_text(rounds[r].distance / before, 2) : ""}});
    }
    return table;
}

}  // namespace

Card polygon_distance_card(const EditorState& state) {
    Card card{.title = "Polygon and curve", .blocks = {}};
    const core::Curve* curve = state.active_curve();
    if (curve == nullptr) {
        card.line("There is no curve.");
        card.add(CardButtons{{{"Open an example", OpenExample{.name = "knot-insertion"}}}});
        return card;
    }
    if (curve->degree() == 1) {
        card.line("A curve of degree 1 is its control polygon.");
        return card;
    }
    const auto rounds = state.derived.polygon_rounds(*curve);
    if (rounds->empty()) {
        card.line("The distance is measured for curves of up to 1,000 control points.");
        return card;
    }
    card.line(core::sentence("The control polygon is at most {distance} from the curve.",
                             {{"distance", bound_words(state.shown().units, rounds->front().distance)}}),
              CardTone::strong);
    card.line(
        "A knot in the middle of every span brings it nearer; round by round the ratio of the distances tends to 1/4.");
    card.add(table_of_rounds(state, *rounds));
    card.line("Red lines join each corner to the point of the curve at its Greville abscissa.", CardTone::dim);
    card.add(CardButtons{{{"Insert midpoint knots", InsertMidpoints{}}, {"Undo", Undo{}}}});
    return card;
}

}  // namespace batten::editor
