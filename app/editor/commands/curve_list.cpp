#include "app/editor/commands/curve_list.h"

#include <numeric>

#include "app/editor/commands/active_curve.h"
#include "core/point_edit.h"

namespace batten::editor {

Outcome<Edit> without_curve(const EditorState& state, std::size_t index) {
    Edit edit{state.history.present(), Selection{}};
    std::vector<core::DocumentCurve>& curves = edit.document.curves;
    if (std::optional<Refusal> refusal = locked(curves[index])) return tl::unexpected(*std::move(refusal));
    curves.erase(curves.begin() + static_cast<std::ptrdiff_t>(index));
    std::size_t& active = edit.document.active;
    if (active > index || (active == curves.size() && active > 0)) --active;
    return edit;
}

Outcome<Edit> with_duplicate(const EditorState& state, std::size_t index, double shift) {
    Edit edit{state.history.present(), Selection{}};
    core::DocumentCurve copy = edit.document.curves[index];
    std::vector<std::size_t> all_points(copy.curve->control_points().size());
    std::iota(all_points.begin(), all_points.end(), std::size_t{0});
    core::Result<core::Curve> curve = core::move_control_points(*copy.curve, all_points, {shift, -shift});
    if (!curve) return tl::unexpected(core::describe(curve.error()));

    copy.curve = std::make_shared<const core::Curve>(*std::move(curve));
    copy.name = core::unused_name(edit.document, copy.name);
    copy.visible = true;
    copy.locked = false;
    edit.document.curves.push_back(std::move(copy));
    edit.document.active = edit.document.curves.size() - 1;
    return edit;
}

}  // namespace batten::editor
