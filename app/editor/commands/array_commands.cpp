#include "app/editor/commands/array_commands.h"

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/map_selected.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/state/fit_curve.h"
#include "app/editor/words/refusal.h"
#include "core/base/sentence.h"
#include "core/measure/bounds.h"

namespace batten::editor {

namespace {

constexpr double most_copies = 10'000.0;

// Copies of the curves that are meant, numbers k mapped by `map_of(k)`, at the end of the list; what is active stays
// so.
template <class MapOf>
Outcome<Edit> with_copies(const EditorState& state, std::size_t count, MapOf map_of) {
    Edit edit{state.history.present()};
    const std::vector<std::size_t> originals = curves_meant(state);
    if (auto refusal = too_many_copies(state, originals, count)) return tl::unexpected(*std::move(refusal));
    core::FreeNames names(edit.document);
    for (std::size_t k = 1; k < count; ++k) {
        core::tell(state.progress, k, count);
        for (const std::size_t i : originals) {
            core::DocumentCurve copy = edit.document.curves[i];
            if (const auto mapped = map_entry(copy, map_of(static_cast<double>(k))); !mapped)
                return refused(state, mapped.error());
            copy.name = names.take(copy.name);
            copy.locked = false;
            edit.document.curves.push_back(std::move(copy));
        }
    }
    return edit;
}

// `of_one` has the place {count}, `of_each` also {curves}.
template <class Command>
StepTexts texts_of_copies(const EditorState& state, const Command& command, const char* of_one, const char* of_each) {
    return {Command::spec().title, core::filled_as_needed(curves_meant(state).size() == 1 ? of_one : of_each,
                                                          {{"count", command.count}, names_of_meant(state)})};
}

StepTexts texts_of_row(const EditorState& state, const LinearArray& command) {
    return texts_of_copies(state, command, "Made a row of {count} curves", "Made a row of {count} of each of {curves}");
}

StepTexts texts_of_ring(const EditorState& state, const PolarArray& command) {
    return texts_of_copies(state, command, "Made a ring of {count} curves",
                           "Made a ring of {count} of each of {curves}");
}

Outcome<Edit> linear_array(const EditorState& state, const LinearArray& command) {
    return with_copies(state, command.count, [&](double k) { return core::translation(k * command.step); });
}

Outcome<Edit> polar_array(const EditorState& state, const PolarArray& command) {
    return with_copies(state, command.count,
                       [&](double k) { return core::rotation(k * command.step, command.center); });
}

template <auto member>
Field copy_count_field() {
    return field::count<member>("count", "how many there shall be, with the curve itself")
        .at_least(2.0)
        .at_most(most_copies);
}

std::optional<core::Point> box_middle(const EditorState& state) {
    if (no_curve(state)) return std::nullopt;
    core::Box box;
    for (const std::size_t i : curves_meant(state)) {
        const core::Box of_curve = core::tight_box(*state.history.present().curves[i].curve);
        if (of_curve.is_empty()) return std::nullopt;
        box.include(of_curve.lower);
        box.include(of_curve.upper);
    }
    return core::middle(box.lower, box.upper);
}

}  // namespace

const CommandSpec& LinearArray::spec() {
    static const CommandSpec spec{
        .name = "array",
        .title = "Array along a line",
        .explanation = "Adds copies of the active curve, or of all that are selected, each one step further.",
        .synonyms = "copies repeat pattern row",
        .group = CommandGroup::edit,
        .submenu = "Arrange",
        .fields = {copy_count_field<&LinearArray::count>(),
                   field::vector<&LinearArray::step>({"dx", "each one to the right"}, {"dy", "each one upwards"})},
        .refusal = no_curve,
        .run = body_of<linear_array>,
        .at_work = "Copying curves",
        .texts = texts_of<texts_of_row>};
    return spec;
}

const CommandSpec& PolarArray::spec() {
    static const CommandSpec spec{
        .name = "array-polar",
        .title = "Array around a point",
        .explanation =
            "Adds copies of the active curve, or of all that are selected, each turned one step further around a "
            "point.",
        .synonyms = "copies repeat pattern ring rotate",
        .group = CommandGroup::edit,
        .submenu = "Arrange",
        .fields = {copy_count_field<&PolarArray::count>(),
                   field::position<&PolarArray::center>({"x", "x of the center"}, {"y", "y of the center"})
                       .beginning_with<box_middle>(),
                   field::angle<&PolarArray::step>("step", "from one to the next, counterclockwise")},
        .refusal = no_curve,
        .run = body_of<polar_array>,
        .at_work = "Copying curves",
        .texts = texts_of<texts_of_ring>};
    return spec;
}

}  // namespace batten::editor
