#include "app/editor/commands/map_selected.h"

#include <algorithm>
#include <map>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/state/fit_curve.h"
#include "app/editor/state/point_hues.h"
#include "app/editor/state/symmetry_links.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/refusal.h"
#include "app/editor/words/wording.h"
#include "core/base/sentence.h"
#include "core/edit/point_edit.h"
#include "core/edit/transform.h"

namespace batten::editor {

namespace {

using core::sentence;

// Whether all of the curve goes along, with what belongs to it; a pinned point stays where points are selected.
bool goes_as_a_whole(const SelectedPart& part, const core::DocumentCurve& entry) {
    return is_all_of(part, entry) && (part.is_whole() || entry.pinned.empty());
}

Refusal naming(const EditorState& state, const core::DocumentCurve& entry, const core::CurveError& error) {
    return sentence("'{name}' cannot be changed so: {problem}",
                    {{"name", entry.name}, {"problem", refusal_words(units_of(state), error)}});
}

core::Result<void> map_points(core::DocumentCurve& entry, const std::vector<std::size_t>& points,
                              const core::PlaneMap& map) {
    return core::transform_points(*entry.curve, points, map).map([&](core::Curve curve) {
        replace_curve(entry, std::make_shared<const core::Curve>(std::move(curve)));
    });
}

// The members of a symmetry that all go along as wholes, by the same map, take it along.
void map_symmetries(core::Document& document, const SelectedParts& parts, const std::vector<core::PlaneMap>& maps) {
    std::map<std::size_t, std::vector<std::size_t>> mapped;  // positions in `parts`, by group
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const core::DocumentCurve& entry = document.curves[parts[k].curve];
        if (entry.symmetry && goes_as_a_whole(parts[k], entry)) mapped[entry.symmetry->group].push_back(k);
    }
    if (mapped.empty()) return;
    std::map<std::size_t, std::size_t> counts;
    for (const core::DocumentCurve& entry : document.curves)
        if (entry.symmetry) ++counts[entry.symmetry->group];
    for (const auto& [group, positions] : mapped) {
        const core::PlaneMap& map = maps[positions.front()];
        const bool is_one = std::ranges::all_of(positions, [&](std::size_t k) { return maps[k] == map; });
        if (!is_one || counts[group] != positions.size()) continue;
        for (const std::size_t k : positions) {
            std::optional<core::Symmetry>& symmetry = document.curves[parts[k].curve].symmetry;
            symmetry = mapped_symmetry(*symmetry, map);
        }
    }
}

// The curves that are left, and the active one of them.
void erase_curves(core::Document& document, const std::vector<std::size_t>& gone) {
    std::vector<core::DocumentCurve> kept;
    std::size_t active = 0;
    for (std::size_t i = 0; i < document.curves.size(); ++i) {
        if (i == document.active) active = kept.size();
        if (!std::ranges::binary_search(gone, i)) kept.push_back(std::move(document.curves[i]));
    }
    document.active = kept.empty() ? 0 : std::min(active, kept.size() - 1);
    document.curves = std::move(kept);
}

std::size_t point_count(const SelectedParts& parts) {
    std::size_t count = 0;
    for (const SelectedPart& part : parts) count += part.points.size();
    return count;
}

std::string points_words(const core::Document& document, const SelectedParts& parts, std::size_t active) {
    if (parts.size() == 1 && parts.front().curve == active) return points_text(parts.front().points);
    const core::Place curve("name", document.curves[parts.front().curve].name);
    if (parts.size() == 1 && parts.front().points.size() == 1)
        return sentence("{point} of '{name}'", {{"point", point_text(parts.front().points.front())}, curve});
    if (parts.size() == 1)
        return sentence("{count} points of '{name}'", {{"count", parts.front().points.size()}, curve});
    return sentence("{count} points of {curves} curves", {{"count", point_count(parts)}, {"curves", parts.size()}});
}

}  // namespace

std::optional<Refusal> no_selected_curve(const EditorState& state) {
    if (std::optional<Refusal> refusal = no_curve(state)) return refusal;
    if (state.selection.points.empty() && !state.selection.is_over_curves()) return "no curve is selected";
    return std::nullopt;
}

std::optional<Refusal> nothing_to_map(const EditorState& state) {
    if (!state.selection.is_over_curves()) return no_editable_points(state);
    const auto selected = selected_box(state);
    for (const SelectedPart& part : selected->parts)
        if (auto refusal = locked_or_hidden(state.history.present().curves[part.curve])) return refusal;
    return std::nullopt;
}

Outcome<Edit> map_parts(const EditorState& state, const SelectedParts& parts, const std::vector<core::PlaneMap>& maps) {
    Edit edit{state.history.present()};
    std::optional<Refusal> all_pinned;
    std::size_t moved = 0;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        core::DocumentCurve& entry = edit.document.curves[parts[k].curve];
        if (std::optional<Refusal> refusal = locked(entry)) return tl::unexpected(*std::move(refusal));
        const bool is_whole = goes_as_a_whole(parts[k], entry);
        const auto points = is_whole ? parts[k].points : free_points(entry, parts[k].points);
        if (!points) {
            all_pinned = points.error();
            continue;
        }
        const auto mapped = is_whole ? map_entry(entry, maps[k]) : map_points(entry, *points, maps[k]);
        if (!mapped && parts.size() == 1) return refused(state, mapped.error());
        if (!mapped) return tl::unexpected(naming(state, entry, mapped.error()));
        ++moved;
    }
    if (moved == 0 && all_pinned) return tl::unexpected(*std::move(all_pinned));
    map_symmetries(edit.document, parts, maps);
    return edit;
}

Outcome<Edit> map_selected(const EditorState& state, const core::PlaneMap& map) {
    if (std::optional<Refusal> refusal = nothing_to_map(state)) return tl::unexpected(*std::move(refusal));
    const auto selected = selected_box(state);
    return map_parts(state, selected->parts, std::vector<core::PlaneMap>(selected->parts.size(), map));
}

Outcome<Edit> without_parts(const EditorState& state, const SelectedParts& parts) {
    Edit edit{state.history.present(), Selection{}};
    std::vector<std::size_t> gone;
    for (const SelectedPart& part : parts) {
        core::DocumentCurve& entry = edit.document.curves[part.curve];
        if (std::optional<Refusal> refusal = locked(entry)) return tl::unexpected(*std::move(refusal));
        if (is_all_of(part, entry)) {
            gone.push_back(part.curve);
            continue;
        }
        auto rest = core::delete_control_points(*entry.curve, part.points);
        if (!rest) return tl::unexpected(naming(state, entry, rest.error()));
        replace_curve(entry, std::make_shared<const core::Curve>(*std::move(rest)));
    }
    if (!gone.empty()) erase_curves(edit.document, gone);
    return edit;
}

std::vector<std::size_t> curves_meant(const EditorState& state) {
    return suggest::curves_meant(state).value();
}

core::Place names_of_meant(const EditorState& state) {
    return {"curves", curves_text(state.history.present(), curves_meant(state))};
}

std::string parts_words(const core::Document& document, const SelectedParts& parts, std::size_t active) {
    SelectedParts points;
    std::vector<std::size_t> curves;
    for (const SelectedPart& part : parts)
        if (part.is_whole())
            curves.push_back(part.curve);
        else
            points.push_back(part);
    if (points.empty()) return curves_text(document, curves);
    if (curves.empty()) return points_words(document, points, active);
    return sentence("{points} and {curves}",
                    {{"points", points_words(document, points, active)}, {"curves", curves_text(document, curves)}});
}

std::string selected_words(const EditorState& state) {
    const core::Document& document = state.history.present();
    return parts_words(document, selected_parts(state), document.active);
}

}  // namespace batten::editor
