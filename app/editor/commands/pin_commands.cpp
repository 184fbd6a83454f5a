#include "app/editor/commands/pin_commands.h"

#include <algorithm>
#include <iterator>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/words/formula.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

constexpr const char* which_points = "which control points, counted from 0";

Edit with_pinned(const EditorState& state, std::vector<std::size_t> pinned) {
    Edit edit{state.history.present()};
    edit.document.curves[edit.document.active].pinned = std::move(pinned);
    return edit;
}

Outcome<Edit> pin_points(const EditorState& state, const PinPoints& command) {
    std::vector<std::size_t> pinned = pinned_points(state);
    pinned.insert(pinned.end(), command.points.begin(), command.points.end());
    return with_pinned(state, ascending(std::move(pinned)));
}

Outcome<Edit> unpin_points(const EditorState& state, const UnpinPoints& command) {
    std::vector<std::size_t> pinned;
    std::ranges::set_difference(pinned_points(state), ascending(command.points), std::back_inserter(pinned));
    return with_pinned(state, std::move(pinned));
}

}  // namespace

const CommandSpec& PinPoints::spec() {
    static const CommandSpec spec{
        .name = "pin-points",
        .title = "Pin points",
        .explanation = "Pins control points: drags, nudges and fairing leave them where they are.",
        .synonyms = "fix hold lock",
        .group = CommandGroup::edit,
        .submenu = "Points",
        .fields =
            {field::point_indices<&PinPoints::points>("indices", which_points).suggesting<suggest::selected_points>()},
        .refusal = no_editable_curve,
        .run = body_of<pin_points>,
        .step = "Pin {indices}",
        .done = "Pinned {indices}"};
    return spec;
}

const CommandSpec& UnpinPoints::spec() {
    static const CommandSpec spec{.name = "unpin-points",
                                  .title = "Unpin points",
                                  .explanation = "Lets pinned control points move again.",
                                  .synonyms = "free release",
                                  .group = CommandGroup::edit,
                                  .submenu = "Points",
                                  .fields = {field::point_indices<&UnpinPoints::points>("indices", which_points)
                                                 .suggesting<suggest::selected_points>()},
                                  .refusal = no_editable_curve,
                                  .run = body_of<unpin_points>,
                                  .step = "Unpin {indices}",
                                  .done = "Unpinned {indices}"};
    return spec;
}

void add_pin_commands(CommandTable& table) {
    add_all<PinPoints, UnpinPoints>(table);
}

}  // namespace batten::editor
