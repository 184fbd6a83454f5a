#include "app/editor/commands/invariance_commands.h"

#include "app/editor/commands/groups.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/state/state.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

Outcome<void> show_map(EditorState& state, const ShowMap& command) {
    const double amount = command.amount.value_or(usual_amount(command.kind));
    const core::Interval range = amounts_of(command.kind);
    if (!range.contains(amount))
        return tl::unexpected(core::sentence("the amount is {amount}; it must be from {lower} to {upper} here",
                                             {{"amount", core::shortest_text(amount)},
                                              {"lower", core::shortest_text(range.lower)},
                                              {"upper", core::shortest_text(range.upper)}}));
    state.view.shown_map = {command.kind, amount};
    state.view.overlays.show(Overlay::invariance, true);
    return {};
}

ShownMapKind present_kind(const EditorState& state) {
    return state.view.shown_map.kind;
}

}  // namespace

const CommandSpec& ShowMap::spec() {
    static const CommandSpec spec{
        .name = "show-map",
        .title = "Map of the view of invariance",
        .explanation = "Chooses the map by which polygon and curve are mapped side by side; the curve itself stays.",
        .synonyms = "affine projective rotate scale shear mirror",
        .group = CommandGroup::watch,
        .submenu = "Questions",
        .offered = in_the_window,
        .fields = {field::choice<&ShowMap::kind>("kind", "which map").suggesting<present_kind>(),
                   field::number<&ShowMap::amount>("amount",
                                                   "degrees or a factor; the usual one where it is left out")},
        .run = body_of<show_map>};
    return spec;
}

void add_invariance_commands(CommandTable& table) {
    add_all<ShowMap>(table);
}

}  // namespace batten::editor
