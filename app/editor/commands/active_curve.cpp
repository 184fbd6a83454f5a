#include "app/editor/commands/active_curve.h"

#include <algorithm>
#include <functional>
#include <iterator>

#include "app/editor/pointer/hint_text.h"
#include "app/editor/state/fit_curve.h"
#include "app/editor/state/point_hues.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/refusal.h"
#include "core/base/sentence.h"
#include "core/evaluate/rational_basis.h"

namespace batten::editor {

std::optional<Refusal> no_curve(const EditorState& state) {
    if (state.history.present().active_curve() != nullptr) return std::nullopt;
    return "there is no curve; draw one or open a file";
}

std::optional<Refusal> locked(const core::DocumentCurve& curve) {
    if (!curve.locked) return std::nullopt;
    return locked_sentence(curve);
}

std::optional<Refusal> no_editable_curve(const EditorState& state) {
    const core::DocumentCurve* active = state.history.present().active_curve();
    return active == nullptr ? no_curve(state) : locked(*active);
}

std::optional<Refusal> locked_or_hidden(const core::DocumentCurve& curve) {
    if (std::optional<Refusal> refusal = locked(curve)) return refusal;
    if (curve.visible) return std::nullopt;
    return hidden_sentence(curve);
}

std::optional<Refusal> no_curve_at_hand(const EditorState& state) {
    const core::DocumentCurve* active = state.history.present().active_curve();
    return active == nullptr ? no_curve(state) : locked_or_hidden(*active);
}

std::optional<Refusal> no_editable_points(const EditorState& state) {
    if (std::optional<Refusal> refusal = no_curve_at_hand(state)) return refusal;
    if (state.selection.points.empty()) return "no control point is selected";
    return std::nullopt;
}

const core::Curve& active_curve(const EditorState& state) {
    return *state.history.present().active_curve()->curve;
}

const std::vector<std::size_t>& pinned_points(const EditorState& state) {
    return state.history.present().active_curve()->pinned;
}

std::vector<std::size_t> held_points(const core::DocumentCurve& entry) {
    std::vector<std::size_t> held = entry.pinned;
    const core::FitPoints* fit = entry.fit.get();
    if (fit == nullptr) return held;
    const core::Curve& curve = *entry.curve;
    for (std::size_t k = 0; k < fit->points.size(); ++k) {
        if (fit->points[k].joint != core::FitJoint::tangent) continue;
        const core::RationalBasis basis = core::rational_basis(curve, fit->parameters[k], 1);
        for (std::size_t j = 0; j < basis.derivatives[1].size(); ++j)
            if (basis.derivatives[1][j] != 0.0) held.push_back((basis.first + j) % curve.control_points().size());
    }
    return ascending(std::move(held));
}

Outcome<std::vector<std::size_t>> free_points(const EditorState& state, const std::vector<std::size_t>& points) {
    return free_points(*state.history.present().active_curve(), points);
}

Outcome<std::vector<std::size_t>> free_points(const core::DocumentCurve& entry,
                                              const std::vector<std::size_t>& points) {
    const std::vector<std::size_t> wanted = ascending(points);
    std::vector<std::size_t> found;
    std::ranges::set_difference(wanted, entry.pinned, std::back_inserter(found));
    if (!found.empty() || wanted.empty()) return found;
    const core::Place place("points", points_text(wanted));
    return tl::unexpected(wanted.size() == 1 ? core::sentence("{points} is pinned; unpin it first", {place})
                                             : core::sentence("{points} are pinned; unpin them first", {place}));
}

bool is_made_of_points(const EditorState& state) {
    const core::DocumentCurve* entry = state.history.present().active_curve();
    return entry != nullptr && entry->fit != nullptr;
}

std::vector<std::size_t> ascending(std::vector<std::size_t> indices) {
    if (std::ranges::adjacent_find(indices, std::ranges::greater_equal()) == indices.end()) return indices;
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    return indices;
}

Outcome<Edit> edit_active(const EditorState& state, core::Result<core::Curve> curve,
                          std::optional<Selection> selection) {
    if (!curve) return refused(state, curve.error());
    Edit edit{state.history.present(), std::move(selection)};
    replace_curve(edit.document.curves[edit.document.active], std::make_shared<const core::Curve>(*std::move(curve)));
    return edit;
}

Outcome<Edit> edit_active(const EditorState& state, core::Result<core::Approximation> found,
                          std::optional<Selection> selection) {
    if (!found) return refused(state, found.error());
    Outcome<Edit> edit = edit_active(state, core::Result<core::Curve>(std::move(found->curve)), std::move(selection));
    if (edit) edit->error = found->error;
    return edit;
}

Outcome<Edit> map_active(const EditorState& state, const core::PlaneMap& map) {
    Edit edit{state.history.present()};
    const auto mapped = map_entry(edit.document.curves[edit.document.active], map);
    if (!mapped) return refused(state, mapped.error());
    return edit;
}

}  // namespace batten::editor
