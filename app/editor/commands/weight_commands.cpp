#include "app/editor/commands/weight_commands.h"

#include <cmath>
#include <numbers>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/words/formula.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/edit/circular.h"
#include "core/edit/point_edit.h"
#include "core/evaluate/farin_points.h"

namespace batten::editor {

namespace {

using core::sentence;

Outcome<Edit> move_farin_point(const EditorState& state, const MoveFarinPoint& command) {
    return edit_active(state, core::set_farin_share(active_curve(state), command.leg, command.share));
}

StepTexts texts_of_farin_point(const EditorState&, const MoveFarinPoint& command, const core::Curve& after) {
    const std::size_t next = (command.leg + 1) % after.weights().size();
    const core::Place from("from", point_text(command.leg));
    const core::Place to("to", point_text(next));
    const core::Place ratio("ratio", number_text(after.weights()[next] / after.weights()[command.leg]));
    return {
        sentence("Move Farin point between {from} and {to}", {from, to}),
        sentence("Moved the Farin point between {from} and {to}: the weight of {to} is {ratio} times that of {from}",
                 {from, to, ratio})};
}

Outcome<Edit> make_circular(const EditorState& state, const MakeCircular& command) {
    return edit_active(state, core::make_circular(active_curve(state), command.u));
}

constexpr double degrees_per_radian = 180.0 / std::numbers::pi;

Outcome<void> set_orbit(EditorState& state, const SetOrbit& command) {
    state.view.orbit = {std::remainder(command.yaw, 360.0) / degrees_per_radian, command.pitch / degrees_per_radian,
                        orbit_zooms.clamp(command.zoom)};
    return {};
}

double present_yaw(const EditorState& state) {
    return state.view.orbit.yaw * degrees_per_radian;
}

double present_pitch(const EditorState& state) {
    return state.view.orbit.pitch * degrees_per_radian;
}

double present_zoom(const EditorState& state) {
    return state.view.orbit.zoom;
}

}  // namespace

const CommandSpec& MoveFarinPoint::spec() {
    static const CommandSpec spec{
        .name = "move-farin-point",
        .title = "Move Farin point",
        .explanation =
            "Moves the point of a leg that shows the ratio of the weights at its ends, and keeps those of "
            "the other legs where the curve is open.",
        .synonyms = "weight ratio shape factor rational",
        .group = CommandGroup::edit,
        .submenu = "Points",
        .effect = ShapeEffect::changes,
        .fields = {field::point_index<&MoveFarinPoint::leg>("index", "the control point where its leg begins")
                       .beginning_with<suggest::first_selected_point>(),
                   field::number<&MoveFarinPoint::share>("share", "how much of the leg lies before it, from 0 to 1")
                       .above(0.0)
                       .at_most(1.0)},
        .refusal = no_editable_curve,
        .run = body_of<move_farin_point>,
        .texts = texts_of<texts_of_farin_point>};
    return spec;
}

const CommandSpec& MakeCircular::spec() {
    static const CommandSpec spec{
        .name = "make-circular",
        .title = "Make piece circular",
        .explanation =
            "Sets the weight with which a quadratic piece is an arc of a circle: the sine of half the angle "
            "between its end tangents.",
        .synonyms = "circle arc conic weight sine",
        .group = CommandGroup::edit,
        .submenu = "Points",
        .effect = ShapeEffect::changes,
        .fields = {field::parameter<&MakeCircular::u>("u", "where in the domain the piece is")
                       .suggesting<suggest::current_parameter>()},
        .refusal = no_editable_curve,
        .run = body_of<make_circular>,
        .done = "Made the piece at {u} circular"};
    return spec;
}

const CommandSpec& SetOrbit::spec() {
    static const CommandSpec spec{
        .name = "set-orbit",
        .title = "Turn homogeneous view",
        .explanation = "Sets from where the lifted curve is seen.",
        .synonyms = "orbit camera rotate 3D projection",
        .group = CommandGroup::view,
        .offered = {.menu = false},
        .fields = {field::angle<&SetOrbit::yaw>("yaw", "how far around, in degrees").suggesting<present_yaw>(),
                   field::angle<&SetOrbit::pitch>("pitch", "how high, from -90 to 90 degrees")
                       .at_least(-90.0)
                       .at_most(90.0)
                       .suggesting<present_pitch>(),
                   field::number<&SetOrbit::zoom>("zoom", "how much enlarged, 1 where all is seen")
                       .above(0.0)
                       .suggesting<present_zoom>()},
        .run = body_of<set_orbit>};
    return spec;
}

void add_weight_commands(CommandTable& table) {
    add_all<MoveFarinPoint, MakeCircular, SetOrbit>(table);
}

}  // namespace batten::editor
