#include "app/editor/commands/other_curve.h"

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/words/refusal.h"
#include "core/base/sentence.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/continuity.h"

namespace batten::editor {

using core::sentence;

Outcome<std::size_t> other_curve_named(const EditorState& state, const std::string& name) {
    Outcome<std::size_t> other = curve_named(state, name);
    if (!other) return other;
    const core::Document& document = state.history.present();
    if (*other == document.active)
        return tl::unexpected(
            sentence("'{name}' is the active curve; name another one", {{"name", document.curves[*other].name}}));
    return other;
}

Outcome<std::size_t> editable_other_curve(const EditorState& state, const std::string& name) {
    Outcome<std::size_t> other = other_curve_named(state, name);
    if (!other) return other;
    if (std::optional<Refusal> refusal = locked(state.history.present().curves[*other]))
        return tl::unexpected(*std::move(refusal));
    return other;
}

Refusal refusal_of_ends(const Units& units, const core::DocumentCurve& active, const core::DocumentCurve& other,
                        const core::CurveError& error) {
    using Code = core::CurveErrorCode;
    if (error.code != Code::curve_periodic && error.code != Code::curve_closed) return refusal_words(units, error);
    const std::string& name = core::is_closed(*active.curve) ? active.name : other.name;
    return sentence("'{name}' is closed and has no end to join; an open curve is needed", {{"name", name}});
}

core::JoinedEnds chosen_ends(const core::Curve& active, const core::Curve& other, std::optional<core::CurveEnd> end,
                             std::optional<core::CurveEnd> other_end) {
    const auto gap = [&](core::JoinedEnds ends) {
        return core::robust_length(core::point_at(other, core::parameter_of(other.domain(), ends.second)) -
                                   core::point_at(active, core::parameter_of(active.domain(), ends.first)));
    };
    std::optional<core::JoinedEnds> nearest;
    for (const core::JoinedEnds& ends : core::all_joined_ends) {
        if ((end && ends.first != *end) || (other_end && ends.second != *other_end)) continue;
        if (!nearest || gap(ends) < gap(*nearest)) nearest = ends;
    }
    return *nearest;
}

std::optional<Refusal> no_second_curve(const EditorState& state) {
    if (std::optional<Refusal> refusal = no_curve(state)) return refusal;
    if (state.history.present().curves.size() > 1) return std::nullopt;
    return "there is no other curve; a second one is needed";
}

std::optional<Refusal> no_second_curve_to_edit(const EditorState& state) {
    if (std::optional<Refusal> refusal = no_editable_curve(state)) return refusal;
    return no_second_curve(state);
}

}  // namespace batten::editor
