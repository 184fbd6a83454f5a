#include "app/editor/commands/shape_view_commands.h"

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/groups.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/pointer/view_handle.h"

namespace batten::editor {

namespace {

Outcome<void> set_comb_scale(EditorState& state, const SetCombScale& command) {
    state.view.shape.comb_factor = comb_factors.clamp(command.factor);
    state.view.overlays.show(Overlay::curvature_comb, true);
    return {};
}

Outcome<void> set_part_count(EditorState& state, const SetPartCount& command) {
    state.view.shape.part_count = command.count;
    Overlays& overlays = state.view.overlays;
    if (!overlays.is_shown(Overlay::equal_steps) && !overlays.is_shown(Overlay::equal_lengths))
        overlays.show(Overlay::equal_lengths, true);
    return {};
}

Outcome<void> put_line(EditorState& state, const PutLine& command) {
    const ProbeLine line{command.first, command.second};
    if (!is_line(line)) return tl::unexpected(std::string("a line needs two different points"));
    state.view.shape.line = line;
    state.view.overlays.show(Overlay::variation, true);
    return {};
}

Outcome<void> level_line(EditorState& state, const LevelLine&) {
    state.view.shape.line = level_line_through(active_curve(state));
    state.view.overlays.show(Overlay::variation, true);
    return {};
}

double shown_comb_factor(const EditorState& state) {
    return state.view.shape.comb_factor;
}

int shown_part_count(const EditorState& state) {
    return state.view.shape.part_count;
}

core::Point first_of_line(const EditorState& state) {
    return start_of(state, ViewHandle::line).line.first;
}

core::Point second_of_line(const EditorState& state) {
    return start_of(state, ViewHandle::line).line.second;
}

}  // namespace

const CommandSpec& SetCombScale::spec() {
    static const CommandSpec spec{
        .name = "set-comb-scale",
        .title = "Set length of comb",
        .explanation = "Makes the curvature comb longer or shorter than it is by itself.",
        .synonyms = "curvature porcupine scale",
        .group = CommandGroup::watch,
        .submenu = "Shape",
        .offered = in_the_window,
        .fields = {field::number<&SetCombScale::factor>("factor", "how many times longer, 1/64 to 64")
                       .at_least(comb_factors.lower)
                       .at_most(comb_factors.upper)
                       .beginning_with<shown_comb_factor>()},
        .run = body_of<set_comb_scale>};
    return spec;
}

const CommandSpec& SetPartCount::spec() {
    static const CommandSpec spec{
        .name = "set-part-count",
        .title = "Set number of parts",
        .explanation = "Sets into how many equal steps and equal lengths dots divide the curve.",
        .synonyms = "dots divide equal steps lengths",
        .group = CommandGroup::watch,
        .submenu = "Shape",
        .offered = in_the_window,
        .fields = {field::count<&SetPartCount::count>("count", "how many parts, 1 to 200")
                       .at_least(least_part_count)
                       .at_most(most_part_count)
                       .beginning_with<shown_part_count>()},
        .run = body_of<set_part_count>};
    return spec;
}

const CommandSpec& PutLine::spec() {
    static const CommandSpec spec{
        .name = "put-line",
        .title = "Put line",
        .explanation = "Puts the line whose crossings are shown through two points.",
        .synonyms = "variation diminishing crossings",
        .group = CommandGroup::watch,
        .submenu = "Shape",
        .offered = in_the_window,
        .fields = {field::position<&PutLine::first>({"x1", "x of the first point"}, {"y1", "y of the first point"})
                       .beginning_with<first_of_line>(),
                   field::position<&PutLine::second>({"x2", "x of the second point"}, {"y2", "y of the second point"})
                       .beginning_with<second_of_line>()},
        .refusal = no_curve,
        .run = body_of<put_line>};
    return spec;
}

const CommandSpec& LevelLine::spec() {
    static const CommandSpec spec{
        .name = "level-line",
        .title = "Level line",
        .explanation = "Puts the line whose crossings are shown level through the middle of the curve.",
        .synonyms = "variation diminishing crossings horizontal reset",
        .group = CommandGroup::watch,
        .submenu = "Shape",
        .offered = in_the_window,
        .refusal = no_curve,
        .run = body_of<level_line>};
    return spec;
}

void add_shape_view_commands(CommandTable& table) {
    add_all<SetCombScale, SetPartCount, PutLine, LevelLine>(table);
}

}  // namespace batten::editor
