#include "app/editor/commands/transform_commands.h"

#include <algorithm>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/map_selected.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/state/fit_curve.h"
#include "app/editor/state/symmetry_links.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/refusal.h"
#include "app/editor/words/wording.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/curve/control_box.h"
#include "core/edit/transform.h"

namespace batten::editor {

namespace {

using core::sentence;

// The box around the control points that are mapped; empty where there are none.
core::Box box_of_target(const EditorState& state, MapTarget what) {
    if (what == MapTarget::curve) return core::control_box(active_curve(state));
    if (what == MapTarget::selection) return selected_box(state)->box;
    core::Box box;
    if (what == MapTarget::all)
        for (const core::DocumentCurve& item : state.history.present().curves) {
            const core::Box one = core::control_box(*item.curve);
            box.include(one.lower);
            box.include(one.upper);
        }
    return box;
}

template <class Command>
core::Point pivot_of(const EditorState& state, const Command& command) {
    if (command.pivot) return *command.pivot;
    const core::Box box = box_of_target(state, command.what);
    return box.is_empty() ? core::Point(0.0, 0.0) : core::middle(box.lower, box.upper);
}

core::PlaneMap map_of(const EditorState&, const Move& command) {
    return core::translation(command.offset);
}
core::PlaneMap map_of(const EditorState& state, const Rotate& command) {
    return core::rotation(command.angle, pivot_of(state, command));
}
core::PlaneMap map_of(const EditorState& state, const Scale& command) {
    return core::scaling(command.factor, command.factor, pivot_of(state, command));
}
core::PlaneMap map_of(const EditorState& state, const Stretch& command) {
    return core::scaling(command.along_x, command.along_y, pivot_of(state, command));
}
core::PlaneMap map_of(const EditorState& state, const Shear& command) {
    const bool is_along_x = command.axis == ShearAxis::x;
    return core::shearing(is_along_x ? command.factor : 0.0, is_along_x ? 0.0 : command.factor,
                          pivot_of(state, command));
}
core::PlaneMap map_of(const EditorState& state, const Mirror& command) {
    return core::reflection(command.angle, pivot_of(state, command));
}
core::PlaneMap map_of(const EditorState&, const MapAffinely& command) {
    const auto& [x, y, what] = command;
    return {.rows = {{{x[0], x[1], x[2]}, {y[0], y[1], y[2]}, {0.0, 0.0, 1.0}}}};
}
core::PlaneMap map_of(const EditorState&, const MapProjectively& command) {
    const auto& [x, y, w, what] = command;
    return {.rows = {{{x[0], x[1], x[2]}, {y[0], y[1], y[2]}, {w[0], w[1], w[2]}}}};
}

bool are_whole_curves(const EditorState& state, MapTarget what) {
    const core::Document& document = state.history.present();
    return what != MapTarget::selection ||
           std::ranges::all_of(selected_box(state)->parts,
                               [&](const SelectedPart& part) { return is_all_of(part, document.curves[part.curve]); });
}

// What the map did to the shape of the curves.
std::string shape_remark(const EditorState& state, MapTarget what, const core::PlaneMap& map,
                         const core::Curve& after) {
    const bool are_several = what == MapTarget::selection && state.selection.is_over_curves();
    const bool are_whole = are_whole_curves(state, what);
    if (!are_whole && are_several) return "the other control points stayed, so the curves have other shapes";
    if (!are_whole) return "the other control points stayed, so the curve has another shape";
    if (are_several) return "every point of the curves is mapped with the control points";
    if (!active_curve(state).is_rational() && after.is_rational())
        return "every point of the curve is mapped with the control points and their weights, and it is rational now";
    if (!map.is_affine()) return "every point of the curve is mapped with the control points and their weights";
    return "every point of the curve is mapped with the control points";
}

Outcome<Edit> map_all(const EditorState& state, const core::PlaneMap& map) {
    Edit edit{state.history.present()};
    for (core::DocumentCurve& item : edit.document.curves) {
        if (std::optional<Refusal> refusal = locked(item)) return tl::unexpected(*std::move(refusal));
        if (const auto mapped = map_entry(item, map); !mapped)
            return tl::unexpected(
                sentence("'{name}' cannot be mapped: {problem}",
                         {{"name", item.name}, {"problem", refusal_words(edit.document.units, mapped.error())}}));
        if (item.symmetry) item.symmetry = mapped_symmetry(*item.symmetry, map);
    }
    return edit;
}

Outcome<Edit> map_target(const EditorState& state, MapTarget what, const core::PlaneMap& map) {
    if (what == MapTarget::all) return map_all(state, map);
    if (what == MapTarget::curve)
        if (std::optional<Refusal> refusal = no_editable_curve(state)) return tl::unexpected(*std::move(refusal));
    return what == MapTarget::curve ? map_active(state, map) : map_selected(state, map);
}

template <class Command>
Outcome<Edit> map_by(const EditorState& state, const Command& command) {
    const core::PlaneMap map = map_of(state, command);
    Outcome<Edit> edit = map_target(state, command.what, map);
    if (edit) edit->remark = shape_remark(state, command.what, map, *edit->document.active_curve()->curve);
    return edit;
}

// What is mapped, as sentences name it.
core::Place what_place(const EditorState& state, MapTarget what) {
    return {"what", what == MapTarget::selection ? selected_words(state) : core::title_of(what)};
}

core::Place number_place(const char* name, double value) {
    return {name, core::shortest_text(value)};
}

StepTexts texts_of_moving(const EditorState& state, const Move& command) {
    const core::Place what = what_place(state, command.what);
    return {sentence("Move {what}", {what}),
            sentence("Moved {what} by {offset}",
                     {what, {"offset", place_words(units_of(state), core::tip_of(command.offset))}})};
}

StepTexts texts_of_rotate(const EditorState& state, const Rotate& command) {
    const core::Place what = what_place(state, command.what);
    return {sentence("Rotate {what}", {what}),
            sentence("Rotated {what} by {angle}° about {pivot}",
                     {what,
                      number_place("angle", command.angle),
                      {"pivot", place_words(units_of(state), pivot_of(state, command))}})};
}

StepTexts texts_of_scale(const EditorState& state, const Scale& command) {
    const core::Place what = what_place(state, command.what);
    return {sentence("Scale {what}", {what}),
            sentence("Scaled {what} by {factor} from {pivot}",
                     {what,
                      number_place("factor", command.factor),
                      {"pivot", place_words(units_of(state), pivot_of(state, command))}})};
}

StepTexts texts_of_stretch(const EditorState& state, const Stretch& command) {
    const core::Place what = what_place(state, command.what);
    return {sentence("Stretch {what}", {what}),
            sentence("Stretched {what} by {along_x} along x and {along_y} along y from {pivot}",
                     {what,
                      number_place("along_x", command.along_x),
                      number_place("along_y", command.along_y),
                      {"pivot", place_words(units_of(state), pivot_of(state, command))}})};
}

StepTexts texts_of_shear(const EditorState& state, const Shear& command) {
    const core::Place what = what_place(state, command.what);
    return {sentence("Shear {what}", {what}),
            sentence("Sheared {what} {axis} by {factor}",
                     {what, {"axis", core::title_of(command.axis)}, number_place("factor", command.factor)})};
}

StepTexts texts_of_mirror(const EditorState& state, const Mirror& command) {
    const core::Place what = what_place(state, command.what);
    return {sentence("Mirror {what}", {what}),
            sentence("Mirrored {what} in the line through {pivot} in the direction {angle}°",
                     {what,
                      {"pivot", place_words(units_of(state), pivot_of(state, command))},
                      number_place("angle", command.angle)})};
}

StepTexts texts_of_affine(const EditorState& state, const MapAffinely& command) {
    const core::Place what = what_place(state, command.what);
    return {sentence("Map {what} affinely", {what}), sentence("Mapped {what} affinely", {what})};
}

StepTexts texts_of_projective(const EditorState& state, const MapProjectively& command) {
    const core::Place what = what_place(state, command.what);
    return {sentence("Map {what} projectively", {what}), sentence("Mapped {what} projectively", {what})};
}

// What is selected is meant, where there is anything.
MapTarget likely_target(const EditorState& state) {
    return no_selected_curve(state) ? MapTarget::curve : MapTarget::selection;
}

double quarter_turn(const EditorState&) {
    return 90.0;
}
double twice(const EditorState&) {
    return 2.0;
}
double half(const EditorState&) {
    return 0.5;
}
std::vector<double> keep_x(const EditorState&) {
    return {1.0, 0.0, 0.0};
}
std::vector<double> keep_y(const EditorState&) {
    return {0.0, 1.0, 0.0};
}
std::vector<double> keep_w(const EditorState&) {
    return {0.0, 0.0, 1.0};
}

template <auto member>
Field what_field() {
    return field::choice<member>("what", "what is mapped").template suggesting<likely_target>();
}

template <auto member>
Field pivot_field() {
    return field::position<member>({"pivot x", "x of the point that stays; the middle of the box where it is left out"},
                                   {"pivot y", "y of that point"})
        .absent_as("center");
}

template <auto member>
Field row_field(const char* name, const char* meaning) {
    return field::parameters<member>(name, meaning).at_least(3.0).at_most(3.0);
}

// The selection need not be of the active curve.
std::optional<Refusal> no_curve_to_map(const EditorState& state) {
    return state.selection.is_over_curves() ? no_curve(state) : no_editable_curve(state);
}

// What the commands have in common.
template <class Command>
CommandSpec transform_spec(const char* name, const char* title, const char* explanation, const char* synonyms,
                           const std::vector<Field>& fields) {
    return {.name = name,
            .title = title,
            .explanation = explanation,
            .synonyms = synonyms,
            .group = CommandGroup::curve,
            .submenu = "Transform",
            .effect = ShapeEffect::changes,
            .fields = fields,
            .refusal = no_curve_to_map,
            .run = body_of<map_by<Command>>};
}

}  // namespace

const CommandSpec& Move::spec() {
    static const CommandSpec spec = [] {
        CommandSpec made = transform_spec<Move>(
            "move", "Move", "Moves selected points, the curve or all curves; a whole curve keeps its form and size.",
            "translate shift transform",
            {field::vector<&Move::offset>({"dx", "to the right"}, {"dy", "upwards"}), what_field<&Move::what>()});
        made.texts = texts_of<texts_of_moving>;
        return made;
    }();
    return spec;
}

const CommandSpec& Rotate::spec() {
    static const CommandSpec spec = [] {
        CommandSpec made = transform_spec<Rotate>(
            "rotate", "Rotate",
            "Turns selected points, the curve or all curves; a whole curve keeps its form and size.", "turn transform",
            {field::angle<&Rotate::angle>("angle", "in degrees, counterclockwise").beginning_with<quarter_turn>(),
             what_field<&Rotate::what>(), pivot_field<&Rotate::pivot>()});
        made.texts = texts_of<texts_of_rotate>;
        return made;
    }();
    return spec;
}

const CommandSpec& Scale::spec() {
    static const CommandSpec spec = [] {
        CommandSpec made = transform_spec<Scale>(
            "scale", "Scale", "Scales selected points, the curve or all curves; a whole curve keeps its form.",
            "size larger smaller zoom transform",
            {field::number<&Scale::factor>("factor", "2 for twice as large, not 0").beginning_with<twice>(),
             what_field<&Scale::what>(), pivot_field<&Scale::pivot>()});
        made.texts = texts_of<texts_of_scale>;
        return made;
    }();
    return spec;
}

const CommandSpec& Stretch::spec() {
    static const CommandSpec spec = [] {
        CommandSpec made = transform_spec<Stretch>(
            "stretch", "Stretch",
            "Scales by one factor along x and another along y; a whole curve is mapped with its control points.",
            "scale nonuniform affine transform",
            {field::number<&Stretch::along_x>("x factor", "along x, not 0").beginning_with<twice>(),
             field::number<&Stretch::along_y>("y factor", "along y, not 0").beginning_with<half>(),
             what_field<&Stretch::what>(), pivot_field<&Stretch::pivot>()});
        made.texts = texts_of<texts_of_stretch>;
        return made;
    }();
    return spec;
}

const CommandSpec& Shear::spec() {
    static const CommandSpec spec = [] {
        CommandSpec made = transform_spec<Shear>(
            "shear", "Shear",
            "Slants selected points, the curve or all curves; a whole curve is mapped with its control points.",
            "slant skew affine transform",
            {field::choice<&Shear::axis>("axis", "the direction in which points move"),
             field::number<&Shear::factor>("factor", "how far for each unit across it").beginning_with<half>(),
             what_field<&Shear::what>(), pivot_field<&Shear::pivot>()});
        made.texts = texts_of<texts_of_shear>;
        return made;
    }();
    return spec;
}

const CommandSpec& Mirror::spec() {
    static const CommandSpec spec = [] {
        CommandSpec made = transform_spec<Mirror>(
            "mirror", "Mirror", "Mirrors selected points, the curve or all curves in a line through the pivot.",
            "reflect flip transform",
            {field::angle<&Mirror::angle>("angle", "of the line in degrees; 0 turns upside down, 90 left to right")
                 .beginning_with<quarter_turn>(),
             what_field<&Mirror::what>(), pivot_field<&Mirror::pivot>()});
        made.texts = texts_of<texts_of_mirror>;
        return made;
    }();
    return spec;
}

const CommandSpec& MapAffinely::spec() {
    static const CommandSpec spec = [] {
        CommandSpec made = transform_spec<MapAffinely>(
            "affine", "Affine map",
            "Maps to x' = a x + b y + c and y' = d x + e y + f; a whole curve is mapped with its control points.",
            "matrix linear transform",
            {row_field<&MapAffinely::x_row>("x row", "a, b, c of x' = a x + b y + c").beginning_with<keep_x>(),
             row_field<&MapAffinely::y_row>("y row", "d, e, f of y' = d x + e y + f").beginning_with<keep_y>(),
             what_field<&MapAffinely::what>()});
        made.texts = texts_of<texts_of_affine>;
        return made;
    }();
    return spec;
}

const CommandSpec& MapProjectively::spec() {
    static const CommandSpec spec = [] {
        CommandSpec made = transform_spec<MapProjectively>(
            "project", "Projective map",
            "Maps control points and weights by a matrix of three rows, as a photograph does; a polynomial curve "
            "becomes rational.",
            "perspective homography matrix transform",
            {row_field<&MapProjectively::x_row>("x row", "the three numbers of x' w").beginning_with<keep_x>(),
             row_field<&MapProjectively::y_row>("y row", "the three numbers of y' w").beginning_with<keep_y>(),
             row_field<&MapProjectively::w_row>("w row", "the three numbers of w, by which both are divided")
                 .beginning_with<keep_w>(),
             what_field<&MapProjectively::what>()});
        made.texts = texts_of<texts_of_projective>;
        return made;
    }();
    return spec;
}

void add_transform_commands(CommandTable& table) {
    add_all<Move, Rotate, Scale, Stretch, Shear, Mirror, MapAffinely, MapProjectively>(table);
}

}  // namespace batten::editor
