#include "app/editor/derived/shown_cutting.h"

#include "app/editor/state/point_hues.h"
#include "app/editor/words/refusal.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

/// The new point that has no partner among the corners that go; the others go with the nearer one, as
/// replace_curve() has it.
std::size_t added_cut(const core::CornerCutting& cutting) {
    const auto& cuts = cutting.cuts;
    std::size_t j = 0;
    while (j + 1 < cuts.size() && cuts[j].knots.upper - cutting.u <= cutting.u - cuts[j + 1].knots.lower) ++j;
    return j;
}

/// The colors of what is shown where the insertion has not happened.
void color_before(ShownCutting& shown, const core::DocumentCurve& entry) {
    const std::size_t added = added_cut(shown.cutting);
    for (const core::OldCorner& corner : shown.cutting.corners)
        shown.corner_hues.push_back(point_hue(entry, corner.index));
    const std::size_t count = shown.cutting.cuts.size();
    for (std::size_t j = 0; j < count; ++j) shown.cut_hues.push_back(shown.corner_hues[j < added ? j + 1 : j]);
    std::vector<std::uint8_t> near;
    const auto add_near = [&](std::size_t hue) { near.push_back(static_cast<std::uint8_t>(hue)); };
    const std::size_t first = shown.cutting.corners.front().index;
    const std::size_t last = shown.cutting.corners.back().index;
    const std::size_t point_count = entry.curve->control_points().size();
    for (std::size_t k = 1; k <= hue_neighbors; ++k) {
        // Beyond the new points are the first and the last corner, and what is beyond them.
        if (k <= added) add_near(shown.cut_hues[added - k]);
        if (k > added && first + added + 1 >= k) add_near(point_hue(entry, first + added + 1 - k));
        if (added + k < count) add_near(shown.cut_hues[added + k]);
        if (added + k >= count && last + added + k - count < point_count)
            add_near(point_hue(entry, last + added + k - count));
    }
    shown.cut_hues[added] = free_hue(near, point_count);
}

/// Where it has: the points have them, and corners that went had those of their partners.
void color_after(ShownCutting& shown, const core::DocumentCurve& entry) {
    const std::size_t added = added_cut(shown.cutting);
    const std::size_t count = entry.curve->control_points().size();
    const auto& cuts = shown.cutting.cuts;
    for (const core::LegCut& cut : cuts) shown.cut_hues.push_back(point_hue(entry, cut.new_index));
    for (std::size_t j = 0; j <= cuts.size(); ++j) {
        const bool is_first = j == 0;
        if (is_first || j == cuts.size())
            shown.corner_hues.push_back(point_hue(
                entry, is_first ? (cuts.front().new_index + count - 1) % count : (cuts.back().new_index + 1) % count));
        else
            shown.corner_hues.push_back(shown.cut_hues[j <= added ? j - 1 : j]);
    }
}

/// A knot that came in, if its place is still shown.
std::optional<core::UndoneCutting> last_cutting(const EditorState& state, const core::Curve& curve) {
    if (!state.inserted || state.inserted->parameter != state.view.parameter) return std::nullopt;
    auto undone = core::corner_cutting_undone(curve, state.inserted->u);
    return undone ? std::optional(*std::move(undone)) : std::nullopt;
}

Refusal reason_for_none(const EditorState& state, const core::Curve& curve, double u, const core::CurveError& error) {
    if (error.code == core::CurveErrorCode::multiplicity_full)
        return core::sentence("{u} has multiplicity {multiplicity} already",
                              {{"u", core::shortest_text(u)}, {"multiplicity", curve.knots().multiplicity(u)}});
    if (error.code == core::CurveErrorCode::too_few_points)
        return "the period is so short that it winds round itself, and each leg is cut more than once";
    return refusal_words(state.shown().units, error);
}

}  // namespace

Outcome<ShownCutting> shown_cutting(const EditorState& state) {
    const core::DocumentCurve* entry = state.shown().active_curve();
    if (entry == nullptr) return tl::unexpected(Refusal("there is no curve"));
    ShownCutting shown;
    if (auto last = last_cutting(state, *entry->curve)) {
        shown = {.cutting = std::move(last->cutting), .has_happened = true, .deviation = last->deviation};
        color_after(shown, *entry);
        return shown;
    }
    const double u = state.parameter();
    auto cutting = core::corner_cutting(*entry->curve, u);
    if (!cutting) return tl::unexpected(reason_for_none(state, *entry->curve, u, cutting.error()));
    shown.cutting = *std::move(cutting);
    color_before(shown, *entry);
    return shown;
}

}  // namespace batten::editor
