#include "app/editor/commands/insert_at.h"

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/tear_commands.h"
#include "core/refine/knot_insertion.h"

namespace batten::editor {

namespace {

// Selects the last of the knots that equal `u`.
Selection selection_of_value(const core::Curve& curve, double u) {
    const std::span<const double> knots = curve.knots().stored();
    for (std::size_t i = knots.size(); i-- > 0;)
        if (knots[i] == u) return {{}, i};
    return {};
}

}  // namespace

Outcome<Edit> insert_knot_at(const EditorState& state, double u) {
    core::Result<core::Curve> curve = core::insert_knot(active_curve(state), u, 1, tears_of_active(state));
    const Selection selection = curve ? selection_of_value(*curve, u) : state.selection;
    return edit_or_tear(state, std::move(curve), selection);
}

}  // namespace batten::editor
