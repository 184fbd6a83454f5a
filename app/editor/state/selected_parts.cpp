#include "app/editor/state/selected_parts.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <numeric>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>

#include "app/editor/pointer/hint_text.h"
#include "app/editor/state/state.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

using core::sentence;
using Indices = std::vector<std::size_t>;

SelectedParts::iterator place_of(SelectedParts& parts, std::size_t curve) {
    return std::ranges::lower_bound(parts, curve, {}, &SelectedPart::curve);
}

// By name, and where that was changed by what it is.
bool is_same_entry(const core::DocumentCurve& a, const core::DocumentCurve& b) {
    return a.name == b.name || a.curve == b.curve;
}

bool stays_selected(const SelectedPart& part, const core::Document& before, const core::Document& after) {
    if (part.curve >= before.curves.size() || part.curve >= after.curves.size()) return false;
    const core::DocumentCurve& old = before.curves[part.curve];
    const core::DocumentCurve& now = after.curves[part.curve];
    const bool has_other_points = old.curve->control_points().size() != now.curve->control_points().size();
    return is_same_entry(old, now) && can_be_selected(now) && (part.is_whole() || !has_other_points);
}

// The number with which `text` begins, which is taken off it.
std::optional<std::size_t> taken_number(std::string_view& text) {
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc()) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

bool take_sign(std::string_view& text, char sign) {
    if (text.empty() || text.front() != sign) return false;
    text.remove_prefix(1);
    return true;
}

Refusal no_such_form(const std::string& word) {
    return sentence("found '{word}', but a part has the form 3 for curve 3, or 0:1,2,5-9 for points of curve 0",
                    {{"word", word}});
}

Refusal no_such_point(std::size_t index, const core::DocumentCurve& entry) {
    return sentence("there is no control point {index} of '{name}'; the last one is {last}",
                    {{"index", index}, {"name", entry.name}, {"last", entry.curve->control_points().size() - 1}});
}

// "1,2,5-9"
Outcome<Indices> taken_points(std::string_view text, const std::string& word, const core::DocumentCurve& entry) {
    Indices points;
    do {
        const auto first = taken_number(text);
        if (!first) return tl::unexpected(no_such_form(word));
        const auto last = take_sign(text, '-') ? taken_number(text) : first;
        if (!last || *last < *first) return tl::unexpected(no_such_form(word));
        if (*last >= entry.curve->control_points().size()) return tl::unexpected(no_such_point(*last, entry));
        for (std::size_t i = *first; i <= *last; ++i) points.push_back(i);
    } while (take_sign(text, ','));
    if (!text.empty()) return tl::unexpected(no_such_form(word));
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

Outcome<SelectedPart> part_of_word(const std::string& word, const core::Document& document) {
    std::string_view rest = word;
    const auto curve = taken_number(rest);
    if (!curve) return tl::unexpected(no_such_form(word));
    if (*curve >= document.curves.size())
        return tl::unexpected(sentence("there is no curve {index}; the last one is {last}",
                                       {{"index", *curve}, {"last", document.curves.size() - 1}}));
    const core::DocumentCurve& entry = document.curves[*curve];
    if (entry.locked) return tl::unexpected(locked_sentence(entry));
    if (!entry.visible) return tl::unexpected(hidden_sentence(entry));
    if (rest.empty()) return SelectedPart{*curve};
    if (!take_sign(rest, ':')) return tl::unexpected(no_such_form(word));
    auto points = taken_points(rest, word, entry);
    if (!points) return tl::unexpected(points.error());
    return SelectedPart{*curve, *std::move(points)};
}

// "1,2,5-9"; runs of more than two in short.
std::string text_of_points(const Indices& points) {
    std::string text;
    for (std::size_t k = 0; k < points.size();) {
        std::size_t last = k;
        while (last + 1 < points.size() && points[last + 1] == points[last] + 1) ++last;
        if (last == k + 1) last = k;
        text += (k > 0 ? "," : "") + std::to_string(points[k]);
        if (last > k) text += '-' + std::to_string(points[last]);
        k = last + 1;
    }
    return text;
}

}  // namespace

SelectedParts selected_parts(const Selection& selection, std::size_t active) {
    SelectedParts parts = selection.others;
    if (selection.is_whole || !selection.points.empty())
        parts.insert(place_of(parts, active), SelectedPart{active, selection.points});
    return parts;
}

SelectedParts selected_parts(const EditorState& state) {
    return selected_parts(state.selection, state.history.present().active);
}

Selection selection_of(SelectedParts parts, std::size_t active) {
    Selection selection;
    const auto own = place_of(parts, active);
    if (own != parts.end() && own->curve == active) {
        selection.is_whole = own->is_whole();
        selection.points = std::move(own->points);
        parts.erase(own);
    }
    selection.others = std::move(parts);
    return selection;
}

std::vector<std::size_t> selected_curves(const EditorState& state) {
    // Without the points, which may be very many.
    Indices curves;
    for (const SelectedPart& part : state.selection.others) curves.push_back(part.curve);
    const std::size_t active = state.history.present().active;
    if (state.selection.is_whole || !state.selection.points.empty())
        curves.insert(std::ranges::lower_bound(curves, active), active);
    return curves;
}

std::shared_ptr<const SelectedBox> selected_box(const EditorState& state) {
    return state.derived.selected(state.selection, state.history.present());
}

bool is_all_of(const SelectedPart& part, const core::DocumentCurve& entry) {
    return part.is_whole() || part.points.size() == entry.curve->control_points().size();
}

const SelectedPart* part_of(std::span<const SelectedPart> parts, std::size_t curve) {
    const auto found = std::ranges::lower_bound(parts, curve, {}, &SelectedPart::curve);
    return found != parts.end() && found->curve == curve ? &*found : nullptr;
}

SelectedParts with_part(SelectedParts parts, const SelectedPart& part) {
    const auto own = place_of(parts, part.curve);
    if (own == parts.end() || own->curve != part.curve) {
        parts.insert(own, part);
    } else if (part.is_whole()) {
        own->points.clear();
    } else if (!own->is_whole()) {
        Indices points;
        std::ranges::set_union(own->points, part.points, std::back_inserter(points));
        own->points = std::move(points);
    }
    return parts;
}

SelectedParts without_part(SelectedParts parts, const SelectedPart& part) {
    const auto own = place_of(parts, part.curve);
    if (own == parts.end() || own->curve != part.curve) return parts;
    Indices points;
    if (!part.is_whole()) std::ranges::set_difference(own->points, part.points, std::back_inserter(points));
    if (points.empty())
        parts.erase(own);
    else
        own->points = std::move(points);
    return parts;
}

bool can_be_selected(const core::DocumentCurve& entry) {
    return entry.visible && !entry.locked;
}

std::vector<std::size_t> selectable(const core::Document& document, const std::vector<std::size_t>& curves) {
    Indices found;
    for (const std::size_t i : curves)
        if (can_be_selected(document.curves[i])) found.push_back(i);
    return found;
}

std::size_t control_point_count(const core::Document& document, const std::vector<std::size_t>& curves) {
    std::size_t count = 0;
    for (const std::size_t i : curves) count += document.curves[i].curve->control_points().size();
    return count;
}

std::vector<std::size_t> curves_showing_points(const EditorState& state) {
    const core::Document& document = state.shown();
    const auto is_shown = [&](std::size_t i) {
        return i < document.curves.size() && document.curves[i].visible && document.curves[i].fit == nullptr;
    };
    Indices shown;
    if (state.view.overlays.is_shown(Overlay::other_polygons)) {
        for (std::size_t i = 0; i < document.curves.size(); ++i)
            if (i != document.active && is_shown(i) && !document.curves[i].locked) shown.push_back(i);
        return shown;
    }
    for (const SelectedPart& part : state.selection.others)
        if (!part.is_whole() && is_shown(part.curve)) shown.push_back(part.curve);
    return shown;
}

std::vector<std::size_t> with_groups(const core::Document& document, const std::vector<std::size_t>& curves) {
    std::set<std::string_view> groups;
    for (const std::size_t i : curves)
        if (!document.curves[i].group.empty()) groups.insert(document.curves[i].group);
    Indices all;
    for (std::size_t i = 0; i < document.curves.size(); ++i)
        if (std::ranges::binary_search(curves, i) || groups.contains(document.curves[i].group)) all.push_back(i);
    return all;
}

void keep_parts(Selection& selection, const core::Document& before, const core::Document& after) {
    if (selection.is_whole && !stays_selected({before.active}, before, after)) selection.is_whole = false;
    std::erase_if(selection.others, [&](const SelectedPart& part) { return !stays_selected(part, before, after); });
}

std::string text_of_parts(const SelectedParts& parts) {
    std::string text;
    for (const SelectedPart& part : parts) {
        text += (text.empty() ? "" : " ") + std::to_string(part.curve);
        if (!part.is_whole()) text += ':' + text_of_points(part.points);
    }
    return text;
}

Outcome<SelectedParts> parts_of_text(const std::string& text, const core::Document& document) {
    SelectedParts parts;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        auto part = part_of_word(word, document);
        if (!part) return tl::unexpected(part.error());
        parts = with_part(std::move(parts), *part);
    }
    return parts;
}

}  // namespace batten::editor
