#include "app/editor/commands/curve_list.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "app/editor/commands/active_curve.h"
#include "app/editor/state/fit_curve.h"
#include "app/editor/state/point_hues.h"
#include "app/editor/state/selected_parts.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/refusal.h"
#include "app/editor/words/unknown_curve.h"
#include "core/base/sentence.h"
#include "core/edit/point_edit.h"

namespace batten::editor {

Edit with_curves(const EditorState& state, const std::string& wish, std::vector<core::Curve> curves) {
    Edit edit{state.history.present(), Selection{}};
    edit.document.active = edit.document.curves.size();
    core::FreeNames names(edit.document);
    for (core::Curve& curve : curves) {
        core::DocumentCurve added;
        added.name = names.take(wish);
        added.curve = std::make_shared<const core::Curve>(std::move(curve));
        edit.document.curves.push_back(std::move(added));
    }
    return edit;
}

Edit with_curve(const EditorState& state, const std::string& wish, core::Curve curve) {
    return with_curves(state, wish, {std::move(curve)});
}

std::optional<Refusal> no_other_curve(const EditorState& state) {
    if (std::optional<Refusal> refusal = no_editable_curve(state)) return refusal;
    if (state.history.present().curves.size() > 1) return std::nullopt;
    return "there is no other curve to join; a second one is needed";
}

Outcome<std::size_t> curve_named(const EditorState& state, const std::string& name) {
    const core::Document& document = state.history.present();
    if (const auto index = core::curve_meant_by(document, name)) return *index;
    return tl::unexpected(unknown_curve(document, name));
}

std::vector<core::DocumentCurve> entries_of_parts(const core::DocumentCurve& entry, std::vector<core::Curve> parts,
                                                  core::FreeNames& names) {
    std::vector<core::DocumentCurve> entries(parts.size(), entry);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        entries[i].curve = std::make_shared<const core::Curve>(std::move(parts[i]));
        entries[i].point_hues.reset();
        entries[i].pinned.clear();
        entries[i].symmetry.reset();
        entries[i].fit.reset();
        entries[i].unknown_fit_members.clear();
        if (i > 0) entries[i].name = names.take(entry.name);
    }
    return entries;
}

Edit with_parts(const EditorState& state, std::vector<core::Curve> parts) {
    Edit edit{state.history.present(), Selection{}};
    std::vector<core::DocumentCurve>& curves = edit.document.curves;
    const auto active = static_cast<std::ptrdiff_t>(edit.document.active);
    core::FreeNames names(edit.document);
    std::vector<core::DocumentCurve> entries = entries_of_parts(curves[edit.document.active], std::move(parts), names);
    curves.erase(curves.begin() + active);
    curves.insert(curves.begin() + active, std::move_iterator(entries.begin()), std::move_iterator(entries.end()));
    return edit;
}

Edit with_one_for_several(const EditorState& state, core::Curve curve, const std::vector<std::size_t>& others) {
    Edit edit{state.history.present(), Selection{}};
    std::vector<core::DocumentCurve>& curves = edit.document.curves;
    std::optional<core::Symmetry>& link = curves[edit.document.active].symmetry;
    const auto is_image_too = [&](std::size_t i) {
        return link && curves[i].symmetry && curves[i].symmetry->group == link->group;
    };
    // One of several images is none of them.
    if (std::ranges::any_of(others, is_image_too)) link.reset();
    replace_curve(curves[edit.document.active], std::make_shared<const core::Curve>(std::move(curve)));
    std::vector<core::DocumentCurve> kept;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        if (std::ranges::binary_search(others, i)) continue;
        if (i == state.history.present().active) edit.document.active = kept.size();
        kept.push_back(std::move(curves[i]));
    }
    curves = std::move(kept);
    return edit;
}

Outcome<Edit> without_curve(const EditorState& state, std::size_t index) {
    Edit edit{state.history.present(), Selection{}};
    std::vector<core::DocumentCurve>& curves = edit.document.curves;
    if (std::optional<Refusal> refusal = locked(curves[index])) return tl::unexpected(*std::move(refusal));
    curves.erase(curves.begin() + static_cast<std::ptrdiff_t>(index));
    std::size_t& active = edit.document.active;
    if (active > index || (active == curves.size() && active > 0)) --active;
    return edit;
}

Outcome<Edit> without_points(const EditorState& state, const std::vector<std::size_t>& points) {
    if (are_all_points(state, points)) return without_curve(state, state.history.present().active);
    return edit_active(state, core::delete_control_points(active_curve(state), points), Selection{});
}

StepTexts texts_of_deleting(const EditorState& state, const std::vector<std::size_t>& points) {
    if (are_all_points(state, points)) {
        const core::Place name("name", state.history.present().active_curve()->name);
        return {core::sentence("Delete curve '{name}'", {name}), core::sentence("Deleted curve '{name}'", {name})};
    }
    const core::Place place("points", points_text(points));
    return {core::sentence("Delete {points}", {place}), core::sentence("Deleted {points}", {place})};
}

bool are_all_points(const EditorState& state, const std::vector<std::size_t>& points) {
    return points.size() == active_curve(state).control_points().size();
}

core::Result<void> shift_entry(core::DocumentCurve& entry, double shift) {
    if (shift == 0.0) return {};
    return map_entry(entry, core::translation({shift, -shift}));
}

std::optional<Refusal> too_many_copies(const EditorState& state, const std::vector<std::size_t>& curves,
                                       std::size_t count) {
    constexpr std::size_t most = 5'000'000;
    const std::size_t points = control_point_count(state.history.present(), curves);
    if (count <= most / points) return std::nullopt;
    return core::sentence("{count} times {points} control points are too many; at most {most} in all are allowed",
                          {{"count", count}, {"points", points}, {"most", most}});
}

Outcome<Edit> with_duplicate(const EditorState& state, std::size_t index, double shift) {
    Outcome<Edit> edit = with_duplicates(state, {index}, shift);
    if (edit) edit->selection.reset();
    return edit;
}

Outcome<Edit> with_duplicates(const EditorState& state, const std::vector<std::size_t>& curves, double shift) {
    Edit edit{state.history.present()};
    core::FreeNames names(edit.document);
    SelectedParts copies;
    for (const std::size_t i : curves) {
        core::DocumentCurve copy = edit.document.curves[i];
        if (const auto shifted = shift_entry(copy, shift); !shifted) return refused(state, shifted.error());
        copy.name = names.take(copy.name);
        copy.visible = true;
        copy.locked = false;
        copies.push_back({edit.document.curves.size()});
        edit.document.curves.push_back(std::move(copy));
    }
    edit.document.active = edit.document.curves.size() - 1;
    edit.selection = selection_of(std::move(copies), edit.document.active);
    return edit;
}

}  // namespace batten::editor
