#include "app/editor/commands/tear_commands.h"

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/groups.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

using core::sentence;

Edit with_tears(const EditorState& state, core::Tears tears) {
    Edit edit{state.history.present()};
    edit.document.curves[edit.document.active].tears = tears;
    return edit;
}

Outcome<Edit> allow_tears(const EditorState& state, const AllowTears&) {
    return with_tears(state, core::Tears::allow);
}

Outcome<Edit> forbid_tears(const EditorState& state, const ForbidTears&) {
    return with_tears(state, core::Tears::refuse);
}

std::optional<Refusal> cannot_allow(const EditorState& state) {
    if (std::optional<Refusal> refusal = no_editable_curve(state)) return refusal;
    if (active_curve(state).is_periodic()) return "a closed curve cannot tear; open it first";
    if (tears_of_active(state) == core::Tears::allow) return "tears are allowed already";
    return std::nullopt;
}

bool allows_tears(const EditorState& state) {
    return !no_editable_curve(state) && !active_curve(state).is_periodic() &&
           tears_of_active(state) == core::Tears::allow;
}

bool forbids_tears(const EditorState& state) {
    return !no_editable_curve(state) && tears_of_active(state) == core::Tears::refuse;
}

std::optional<Refusal> cannot_forbid(const EditorState& state) {
    if (std::optional<Refusal> refusal = no_editable_curve(state)) return refusal;
    if (tears_of_active(state) == core::Tears::refuse) return "tears are not allowed as it is";
    if (state.derived.of(active_curve(state).knots())->is_torn())
        return "the curve is torn; take a knot away where it is, or undo";
    return std::nullopt;
}

// Whether one equal knot more than the degree is all that was asked for.
bool lacks_leave_to_tear(const core::CurveError& error, const core::Curve& curve) {
    const double degree = curve.degree();
    if (curve.is_periodic() || error.upper != degree) return false;
    return error.code == core::CurveErrorCode::multiplicity_full ||
           (error.code == core::CurveErrorCode::multiplicity_too_high && error.value == degree + 1.0);
}

std::string refusal_of(const core::CurveError& error) {
    if (error.code == core::CurveErrorCode::multiplicity_full)
        return sentence(
            "knot {value} may occur {upper} times, or once more where 'Allow tears' lets the curve come apart",
            {{"value", core::shortest_text(error.value)}, {"upper", core::shortest_text(error.upper)}});
    return sentence(
        "knot number {index} is the first of {value} equal ones; {upper} are allowed, or one more where 'Allow tears' "
        "lets the curve come apart",
        {{"index", error.index},
         {"value", core::shortest_text(error.value)},
         {"upper", core::shortest_text(error.upper)}});
}

}  // namespace

core::Tears tears_of_active(const EditorState& state) {
    const core::DocumentCurve& active = *state.history.present().active_curve();
    return state.derived.of(active.curve->knots())->is_torn() ? core::Tears::allow : active.tears;
}

Outcome<Edit> edit_or_tear(const EditorState& state, core::Result<core::Curve> curve,
                           std::optional<Selection> selection) {
    if (!curve && lacks_leave_to_tear(curve.error(), active_curve(state)))
        return tl::unexpected(refusal_of(curve.error()));
    return edit_active(state, std::move(curve), std::move(selection));
}

const CommandSpec& AllowTears::spec() {
    static const CommandSpec spec{
        .name = "allow-tears",
        .title = "Allow tears",
        .explanation = "Lets a knot reach multiplicity degree + 1, where the curve may come apart.",
        .synonyms = "multiplicity discontinuous jump break gap",
        .group = CommandGroup::curve,
        .submenu = "Knots",
        .refusal = cannot_allow,
        .is_idle = allows_tears,
        .run = body_of<allow_tears>,
        .done = "Allowed tears"};
    return spec;
}

const CommandSpec& ForbidTears::spec() {
    static const CommandSpec spec{.name = "forbid-tears",
                                  .title = "Forbid tears",
                                  .explanation = "Keeps the curve in one piece: knots stop at multiplicity degree.",
                                  .synonyms = "multiplicity continuous",
                                  .group = CommandGroup::curve,
                                  .submenu = "Knots",
                                  .refusal = cannot_forbid,
                                  .is_idle = forbids_tears,
                                  .run = body_of<forbid_tears>,
                                  .done = "Forbade tears"};
    return spec;
}

void add_tear_commands(CommandTable& table) {
    add_all<AllowTears, ForbidTears>(table);
}

}  // namespace batten::editor
