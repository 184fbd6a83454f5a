#include "app/editor/commands/symmetry_commands.h"

#include <algorithm>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/joint_report.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/state/point_hues.h"
#include "app/editor/state/symmetry_links.h"
#include "app/editor/words/length.h"
#include "app/editor/words/refusal.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/curve/control_box.h"

namespace batten::editor {

namespace {

// Ends of a curve that lie within this part of its size beside the mirror are meant to lie on it.
constexpr double meant_on_mirror = 1e-3;

// And what of that size an end may be moved without a word.
constexpr double rounding_of_seat = 1e-12;

double size_of_curve(const core::Curve& curve) {
    return core::length(core::control_box(curve).size());
}

bool is_linked(const EditorState& state) {
    return state.history.present().active_curve()->symmetry.has_value();
}

std::optional<Refusal> not_linkable(const EditorState& state) {
    if (std::optional<Refusal> refusal = no_editable_curve(state)) return refusal;
    if (is_linked(state)) return "the curve is an image already; unlink it first";
    return std::nullopt;
}

std::optional<Refusal> not_linked(const EditorState& state) {
    if (std::optional<Refusal> refusal = no_curve(state)) return refusal;
    if (!is_linked(state)) return "the curve is linked to no image";
    return std::nullopt;
}

// The committed document with `curve` as image 0 in place of the active one, and `count` - 1 more curves for the
// others, which come of it where edits end (state/symmetry_links.h).
Edit with_images(const EditorState& state, core::Symmetry symmetry, const core::Curve& curve, std::size_t count) {
    Edit edit{state.history.present()};
    core::FreeNames names(edit.document);
    symmetry.group = free_group(edit.document);
    core::DocumentCurve& original = edit.document.curves[edit.document.active];
    if (curve != *original.curve) replace_curve(original, std::make_shared<const core::Curve>(curve));
    original.symmetry = symmetry;
    core::DocumentCurve image = original;
    const std::string name = original.name;
    for (std::size_t place = 1; place < count; ++place) {
        image.symmetry->place = place;
        image.name = names.take(name);
        edit.document.curves.push_back(image);
    }
    return edit;
}

// "its start was turned by 12.5° ...", for each end that is not as it was.
std::vector<std::string> told_of_end(const EditorState& state, const SeatedEnd& seated) {
    const bool is_start = seated.end == core::CurveEnd::start;
    const core::Place moved("distance", length_words(units_of(state), seated.moved));
    const core::Place turned("angle", core::shortest_text(seated.turned));
    std::vector<std::string> told;
    if (seated.moved > rounding_of_seat * size_of_curve(active_curve(state)))
        told.push_back(is_start ? core::sentence("its start was moved by {distance} onto the line", {moved})
                                : core::sentence("its end was moved by {distance} onto the line", {moved}));
    if (seated.turned > 0.0)
        told.push_back(
            is_start ? core::sentence("its start was turned by {angle}° to meet its image smoothly (G2)", {turned})
                     : core::sentence("its end was turned by {angle}° to meet its image smoothly (G2)", {turned}));
    if (seated.keeps_corner)
        told.emplace_back(is_start ? "its start cannot be turned to meet its image smoothly and keeps a corner"
                                   : "its end cannot be turned to meet its image smoothly and keeps a corner");
    return told;
}

std::optional<std::string> told_of_ends(const EditorState& state, const std::vector<SeatedEnd>& ends) {
    std::vector<std::string> told;
    for (const SeatedEnd& seated : ends)
        for (std::string& sentence : told_of_end(state, seated)) told.push_back(std::move(sentence));
    if (std::ranges::any_of(ends, [](const SeatedEnd& seated) { return seated.turned > 0.0; }))
        told.emplace_back("linked with 'smooth' off, it would keep its corners");
    return told_in_turn(told);
}

Outcome<Edit> link_mirror(const EditorState& state, const LinkMirror& command) {
    const core::Symmetry mirror{.turns = std::nullopt, .center = command.center, .angle = command.angle};
    const core::Curve& curve = active_curve(state);
    const double reach = meant_on_mirror * size_of_curve(curve);
    const auto seamed = with_ends_on_mirror(curve, mirror, reach, command.is_smooth);
    if (!seamed) return refused(state, seamed.error());
    Edit edit = with_images(state, mirror, seamed->curve, 2);
    edit.remark = told_of_ends(state, seamed->ends);
    return edit;
}

Outcome<Edit> link_rotation(const EditorState& state, const LinkRotation& command) {
    if (auto refusal = too_many_copies(state, {state.history.present().active}, command.turns))
        return tl::unexpected(*std::move(refusal));
    return with_images(state, {.turns = command.turns, .center = command.center}, active_curve(state), command.turns);
}

Outcome<Edit> unlink(const EditorState& state, const Unlink&) {
    Edit edit{state.history.present()};
    const std::size_t group = edit.document.active_curve()->symmetry->group;
    for (core::DocumentCurve& entry : edit.document.curves)
        if (entry.symmetry && entry.symmetry->group == group) entry.symmetry.reset();
    return edit;
}

}  // namespace

const CommandSpec& LinkMirror::spec() {
    static const CommandSpec spec{
        .name = "link-mirror",
        .title = "Link to a mirror image",
        .explanation = "Adds the mirror image of the active curve; whatever is done to one of them is done to both.",
        .synonyms = "symmetry reflect live half",
        .group = CommandGroup::edit,
        .submenu = "Symmetry",
        .effect = ShapeEffect::changes,
        .fields = {field::position<&LinkMirror::center>({"x", "x of a point of the line"}, {"y", "y of it"}),
                   field::angle<&LinkMirror::angle>("angle", "of the line, 90 where it is upright").usually(90.0),
                   field::flag<&LinkMirror::is_smooth>("smooth", smooth_seam_meaning).usually(true)},
        .refusal = not_linkable,
        .run = body_of<link_mirror>,
        .done = "Linked the curve to its mirror image"};
    return spec;
}

const CommandSpec& LinkRotation::spec() {
    static const CommandSpec spec{
        .name = "link-rotation",
        .title = "Link to rotated images",
        .explanation = "Adds images of the active curve around a center; whatever is done to one is done to all.",
        .synonyms = "symmetry rosette live radial",
        .group = CommandGroup::edit,
        .submenu = "Symmetry",
        .fields = {field::count<&LinkRotation::turns>("count", "how many there shall be, with the curve itself")
                       .usually(5)
                       .at_least(2.0)
                       .at_most(static_cast<double>(core::Symmetry::most_turns)),
                   field::position<&LinkRotation::center>({"x", "x of the center"}, {"y", "y of it"})},
        .refusal = not_linkable,
        .run = body_of<link_rotation>,
        .done = "Linked {count} curves around ({x}, {y})"};
    return spec;
}

const CommandSpec& Unlink::spec() {
    static const CommandSpec spec{.name = "unlink",
                                  .title = "Unlink images",
                                  .explanation = "Makes the active curve and its images ordinary curves.",
                                  .synonyms = "symmetry break free",
                                  .group = CommandGroup::edit,
                                  .submenu = "Symmetry",
                                  .refusal = not_linked,
                                  .run = body_of<unlink>,
                                  .done = "Unlinked the curve from its images"};
    return spec;
}

void add_symmetry_commands(CommandTable& table) {
    add_all<LinkMirror, LinkRotation, Unlink>(table);
}

}  // namespace batten::editor
