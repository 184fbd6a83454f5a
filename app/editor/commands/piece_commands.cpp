#include <array>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_end_named.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/groups.h"
#include "app/editor/formula.h"
#include "core/measure/arc_length.h"
#include "core/refine/bezier_form.h"
#include "core/refine/extend.h"
#include "core/refine/join.h"
#include "core/refine/reverse.h"
#include "core/refine/split.h"

namespace batten::editor {

namespace {

using Kind = ParameterKind;

Outcome<Edit> with_parts_of_active(const EditorState& state, core::Result<std::vector<core::Curve>> parts) {
    if (!parts) return tl::unexpected(core::describe(parts.error()));
    return with_parts(state, *std::move(parts));
}

Outcome<Edit> split(const EditorState& state, const Arguments& arguments) {
    return with_parts_of_active(state, core::split(active_curve(state), arguments.number(0)));
}

Outcome<Edit> bezier_pieces(const EditorState& state, const Arguments&) {
    return with_parts_of_active(state, core::bezier_curves(active_curve(state)));
}

Outcome<Edit> sub_curve(const EditorState& state, const Arguments& arguments) {
    return edit_active(state, core::sub_curve(active_curve(state), arguments.number(0), arguments.number(1)));
}

Outcome<Edit> reverse(const EditorState& state, const Arguments&) {
    return edit_active(state, core::reverse(active_curve(state)));
}

struct NamedContinuity {
    const char* name;
    core::JoinContinuity continuity;
};

constexpr std::array named_continuities{
    NamedContinuity{"C0", core::JoinContinuity::c0}, NamedContinuity{"C1", core::JoinContinuity::c1},
    NamedContinuity{"C2", core::JoinContinuity::c2}, NamedContinuity{"G1", core::JoinContinuity::g1},
    NamedContinuity{"G2", core::JoinContinuity::g2}};

Outcome<core::JoinContinuity> continuity_named(const std::string& name) {
    for (const NamedContinuity& named : named_continuities)
        if (name == named.name) return named.continuity;
    return tl::unexpected("continuity is '" + name + "'; it must be C0, C1, C2, G1 or G2");
}

// The other curve of a join: an unlocked one, and not the active curve itself.
Outcome<std::size_t> other_curve(const EditorState& state, const std::string& name) {
    Outcome<std::size_t> other = curve_named(state, name);
    if (!other) return other;
    const core::Document& document = state.history.present();
    if (*other == document.active) return tl::unexpected("'" + name + "' is the active curve; name another one");
    if (std::optional<Refusal> refusal = locked(document.curves[*other])) return tl::unexpected(*std::move(refusal));
    return other;
}

Outcome<Edit> join(const EditorState& state, const Arguments& arguments) {
    const Outcome<std::size_t> other = other_curve(state, arguments.text(0));
    if (!other) return tl::unexpected(other.error());
    const Outcome<core::JoinContinuity> continuity = continuity_named(arguments.text(1));
    if (!continuity) return tl::unexpected(continuity.error());
    const core::Curve& second = *state.history.present().curves[*other].curve;
    core::Result<core::JoinedCurve> joined = core::join(active_curve(state), second, *continuity);
    if (!joined) return tl::unexpected(core::describe(joined.error()));
    Edit edit = with_one_for_several(state, std::move(joined->curve), {*other});
    edit.error = joined->error;
    return edit;
}

// All curves of the document, in order, from the active one on.
Outcome<Edit> join_pieces(const EditorState& state, const Arguments& arguments) {
    const core::Document& document = state.history.present();
    std::vector<core::Curve> pieces;
    std::vector<std::size_t> others;
    for (std::size_t i = document.active; i < document.curves.size(); ++i) {
        if (std::optional<Refusal> refusal = locked(document.curves[i])) return tl::unexpected(*std::move(refusal));
        pieces.push_back(*document.curves[i].curve);
        if (i != document.active) others.push_back(i);
    }
    core::Result<core::Approximation> joined = core::join_pieces(pieces, arguments.number(0));
    if (!joined) return tl::unexpected(core::describe(joined.error()));
    Edit edit = with_one_for_several(state, std::move(joined->curve), others);
    edit.error = joined->error;
    return edit;
}

template <core::Result<core::Curve> (*extended)(const core::Curve&, core::CurveEnd, double)>
Outcome<Edit> extend(const EditorState& state, const Arguments& arguments) {
    const Outcome<core::CurveEnd> end = curve_end_named(arguments.text(1));
    if (!end) return tl::unexpected(end.error());
    return edit_active(state, extended(active_curve(state), *end, arguments.number(0)));
}

std::optional<Argument> g1(const EditorState&) {
    return "G1";
}

std::optional<Argument> tenth_of_domain(const EditorState& state) {
    if (state.history.present().active_curve() == nullptr) return std::nullopt;
    return 0.1 * active_curve(state).domain().length();
}

std::optional<Argument> tenth_of_length(const EditorState& state) {
    if (state.history.present().active_curve() == nullptr) return std::nullopt;
    return 0.1 * core::arc_length(active_curve(state)).value;
}

std::optional<Refusal> no_other_curve(const EditorState& state) {
    if (std::optional<Refusal> refusal = no_editable_curve(state)) return refusal;
    if (state.history.present().curves.size() > 1) return std::nullopt;
    return "there is no other curve to join; a second one is needed";
}

void add_cutting(std::vector<CommandSpec>& table) {
    table.push_back({.name = "split",
                     .title = "Split",
                     .explanation = "Cuts the curve in two at u; a periodic one is opened there.",
                     .group = CommandGroup::curve,
                     .submenu = "Pieces",
                     .effect = ShapeEffect::keeps,
                     .parameters = {{"u", Kind::number, "where in the domain", current_parameter}},
                     .refusal = no_editable_curve,
                     .edit = split,
                     .label = [](const EditorState&, const Arguments& arguments) {
                         return "Split at " + number_text(arguments.number(0));
                     }});
    table.push_back(
        {.name = "sub-curve",
         .title = "Keep part only",
         .explanation = "Keeps the part between two parameters, clamped at both ends; on a periodic curve it "
                        "may cross the seam.",
         .group = CommandGroup::curve,
         .submenu = "Pieces",
         .effect = ShapeEffect::none,
         .parameters = {{"a", Kind::number, "where the part begins"}, {"b", Kind::number, "where it ends"}},
         .refusal = no_editable_curve,
         .edit = sub_curve,
         .label = [](const EditorState&, const Arguments& arguments) {
             return "Keep part from " + number_text(arguments.number(0)) + " to " + number_text(arguments.number(1));
         }});
    table.push_back({.name = "bezier-pieces",
                     .title = "Split into Bézier pieces",
                     .explanation = "Makes every span a Bézier curve of its own.",
                     .group = CommandGroup::curve,
                     .submenu = "Pieces",
                     .effect = ShapeEffect::keeps,
                     .refusal = no_editable_curve,
                     .edit = bezier_pieces});
}

void add_joining(std::vector<CommandSpec>& table) {
    table.push_back({.name = "join",
                     .title = "Join",
                     .explanation = "Continues the active curve with another one, whose beginning alone is changed to "
                                    "meet it.",
                     .group = CommandGroup::curve,
                     .submenu = "Pieces",
                     .effect = ShapeEffect::changes,
                     .parameters = {{"other", Kind::text, "name of the other curve", next_curve_name},
                                    {"continuity", Kind::text, "C0, C1, C2, G1 or G2", g1}},
                     .refusal = no_other_curve,
                     .edit = join,
                     .label = [](const EditorState&, const Arguments& arguments) {
                         return "Join with '" + arguments.text(0) + "' " + arguments.text(1);
                     }});
    table.push_back({.name = "join-pieces",
                     .title = "Join pieces",
                     .explanation = "Makes one curve of the active one and all behind it in the list, each beginning "
                                    "where the one before ends, and removes the knots that are not needed.",
                     .group = CommandGroup::curve,
                     .submenu = "Pieces",
                     .effect = ShapeEffect::changes,
                     .parameters = {{"tolerance", Kind::number, "how far the result may be off, above 0", tiny_length}},
                     .refusal = no_other_curve,
                     .edit = join_pieces});
}

void add_direction_and_length(std::vector<CommandSpec>& table) {
    table.push_back({.name = "reverse",
                     .title = "Reverse",
                     .explanation = "Runs through the curve the other way; the domain stays.",
                     .group = CommandGroup::curve,
                     .submenu = "Pieces",
                     .effect = ShapeEffect::keeps,
                     .refusal = no_editable_curve,
                     .edit = reverse,
                     .label = [](const EditorState&, const Arguments&) { return std::string("Reverse direction"); }});
    const ParameterSpec end{"end", Kind::text, "start or end", curve_end};
    table.push_back({.name = "extend",
                     .title = "Extend by arc length",
                     .explanation = "Lets the last piece go on as the polynomial it is; the old part stays.",
                     .group = CommandGroup::curve,
                     .submenu = "Pieces",
                     .effect = ShapeEffect::none,
                     .parameters = {{"length", Kind::number, "along the new part, above 0", tenth_of_length}, end},
                     .refusal = no_editable_curve,
                     .edit = extend<core::extend_length>});
    table.push_back({.name = "extend-parameter",
                     .title = "Extend by parameter",
                     .explanation = "Makes the domain longer; the last piece goes on as the polynomial it is.",
                     .group = CommandGroup::curve,
                     .submenu = "Pieces",
                     .effect = ShapeEffect::none,
                     .parameters = {{"by", Kind::number, "how much longer, above 0", tenth_of_domain}, end},
                     .refusal = no_editable_curve,
                     .edit = extend<core::extend_parameter>});
    table.push_back({.name = "extend-straight",
                     .title = "Extend straight on",
                     .explanation = "Adds a straight piece in the direction of the end.",
                     .group = CommandGroup::curve,
                     .submenu = "Pieces",
                     .effect = ShapeEffect::none,
                     .parameters = {{"length", Kind::number, "of the new part, above 0", tenth_of_length}, end},
                     .refusal = no_editable_curve,
                     .edit = extend<core::extend_straight>});
}

}  // namespace

void add_piece_commands(std::vector<CommandSpec>& table) {
    add_cutting(table);
    add_joining(table);
    add_direction_and_length(table);
}

}  // namespace batten::editor
