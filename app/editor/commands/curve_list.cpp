#include "app/editor/commands/curve_list.h"

#include <numeric>

#include "app/editor/commands/active_curve.h"
#include "core/edit/point_edit.h"

namespace batten::editor {

Edit with_curve(const EditorState& state, const std::string& wish, core::Curve curve) {
    Edit edit{state.history.present(), Selection{}};
    core::DocumentCurve added;
    added.name = core::unused_name(edit.document, wish);
    added.curve = std::make_shared<const core::Curve>(std::move(curve));
    edit.document.curves.push_back(std::move(added));
    edit.document.active = edit.document.curves.size() - 1;
    return edit;
}

Outcome<std::size_t> curve_named(const EditorState& state, const std::string& name) {
    const core::Document& document = state.history.present();
    if (const auto index = core::index_of_curve(document, name)) return *index;
    return tl::unexpected("there is no curve '" + name + "'; there are " + core::quoted_names(document));
}

std::optional<Argument> next_curve_name(const EditorState& state) {
    const core::Document& document = state.history.present();
    if (document.curves.size() < 2) return std::nullopt;
    return document.curves[(document.active + 1) % document.curves.size()].name;
}

Outcome<std::vector<core::Point>> points_of(const std::vector<double>& coordinates, std::size_t least,
                                            const std::string& what) {
    if (coordinates.size() < 2 * least || coordinates.size() % 2 != 0)
        return tl::unexpected(what + " needs x and y of " + std::to_string(least) + " points or more; " +
                              std::to_string(coordinates.size()) + " coordinates were given");
    std::vector<core::Point> points;
    points.reserve(coordinates.size() / 2);
    for (std::size_t i = 0; i < coordinates.size(); i += 2) points.emplace_back(coordinates[i], coordinates[i + 1]);
    return points;
}

Edit with_parts(const EditorState& state, std::vector<core::Curve> parts) {
    Edit edit{state.history.present(), Selection{}};
    const std::size_t active = edit.document.active;
    edit.document.curves[active].curve = std::make_shared<const core::Curve>(std::move(parts.front()));
    for (std::size_t i = 1; i < parts.size(); ++i) {
        core::DocumentCurve part = edit.document.curves[active];
        part.name = core::unused_name(edit.document, part.name);
        part.curve = std::make_shared<const core::Curve>(std::move(parts[i]));
        edit.document.curves.insert(edit.document.curves.begin() + static_cast<std::ptrdiff_t>(active + i),
                                    std::move(part));
    }
    return edit;
}

Edit with_one_for_several(const EditorState& state, core::Curve curve, const std::vector<std::size_t>& others) {
    Edit edit{state.history.present(), Selection{}};
    core::Document& document = edit.document;
    document.curves[document.active].curve = std::make_shared<const core::Curve>(std::move(curve));
    for (auto other = others.rbegin(); other != others.rend(); ++other) {
        document.curves.erase(document.curves.begin() + static_cast<std::ptrdiff_t>(*other));
        if (*other < document.active) --document.active;
    }
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
