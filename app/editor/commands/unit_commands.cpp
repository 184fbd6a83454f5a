#include "app/editor/commands/unit_commands.h"

#include "app/editor/commands/groups.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/state/state.h"
#include "app/editor/words/length.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/document/unit_scale.h"

namespace batten::editor {

namespace {

using core::sentence;

UnitChoice choice_of(const Units& units) {
    return units ? *core::value_named<UnitChoice>(core::name_of(units->unit)) : UnitChoice::none;
}

Outcome<Edit> set_units(const EditorState& state, const SetUnits& command) {
    Edit edit{state.history.present()};
    Units& units = edit.document.units;
    if (command.unit == UnitChoice::none) {
        units.reset();
        return edit;
    }
    if (!units) units.emplace();
    units->unit = *core::value_named<core::LengthUnit>(core::name_of(command.unit));
    units->scale = command.scale;
    return edit;
}

StepTexts texts_of_units(const EditorState&, const SetUnits& command) {
    if (command.unit == UnitChoice::none) return {"Set units", "Lengths are plain numbers now"};
    const core::Place unit("unit", core::title_of(command.unit));
    if (command.scale == 1.0) return {"Set units", sentence("Lengths are in {unit} now", {unit})};
    return {"Set units", sentence("Lengths are in {unit} now, one of which is {scale} of the curves' coordinates",
                                  {unit, {"scale", core::shortest_text(command.scale)}})};
}

UnitChoice unit_now(const EditorState& state) {
    return choice_of(units_of(state));
}

double scale_now(const EditorState& state) {
    return world_per_length(units_of(state));
}

}  // namespace

const CommandSpec& SetUnits::spec() {
    static const CommandSpec spec{
        .name = "set-units",
        .title = "Set units",
        .explanation = "Chooses what the document's lengths are measured in; its curves stay as they are.",
        .synonyms = "mm inch px millimeters dimension rulers scale",
        .group = CommandGroup::file,
        .fields = {field::choice<&SetUnits::unit>("unit", "what lengths are measured in").beginning_with<unit_now>(),
                   field::number<&SetUnits::scale>("scale", "how much of the coordinates is one unit")
                       .suggesting<scale_now>()
                       .at_least(core::allowed_unit_scales.lower)
                       .at_most(core::allowed_unit_scales.upper)},
        .run = body_of<set_units>,
        .texts = texts_of<texts_of_units>};
    return spec;
}

void add_unit_commands(CommandTable& table) {
    add_all<SetUnits>(table);
}

}  // namespace batten::editor
