#include "app/ui/curve_rows.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

namespace batten::ui {

namespace {

using Members = std::map<std::string_view, std::vector<std::size_t>>;

Members members_of_groups(const core::Document& document) {
    Members members;
    for (std::size_t i = 0; i < document.curves.size(); ++i)
        if (!document.curves[i].group.empty()) members[document.curves[i].group].push_back(i);
    return members;
}

/// The group into which a curve comes that is dropped between these rows, either of which may be missing.
std::string group_between(const core::Document& document, const CurveRow* above, const CurveRow* below,
                          const std::string& own) {
    if (below != nullptr && below->is_member) return document.curves[below->curve].group;
    const bool is_behind_own = above != nullptr && above->is_member && document.curves[above->curve].group == own;
    return is_behind_own ? own : std::string();
}

}  // namespace

std::vector<CurveRow> curve_rows(const core::Document& document, const std::set<std::string>& folded) {
    const Members members = members_of_groups(document);
    std::vector<CurveRow> rows;
    for (std::size_t i = 0; i < document.curves.size(); ++i) {
        const std::string& group = document.curves[i].group;
        if (group.empty()) {
            rows.push_back({i});
            continue;
        }
        const std::vector<std::size_t>& own = members.at(group);
        if (own.front() != i) continue;
        rows.push_back({i, true});
        if (folded.contains(group)) continue;
        for (const std::size_t member : own) rows.push_back({member, false, true});
    }
    return rows;
}

std::vector<std::size_t> curves_between(const std::vector<CurveRow>& rows, std::size_t first, std::size_t last) {
    const auto row_of = [&](std::size_t curve) {
        return std::ranges::find_if(rows, [=](const CurveRow& row) { return !row.is_heading && row.curve == curve; });
    };
    auto from = row_of(first);
    auto to = row_of(last);
    if (from == rows.end() || to == rows.end()) return {last};
    if (to < from) std::swap(from, to);
    std::vector<std::size_t> curves;
    for (auto row = from; row <= to; ++row)
        if (!row->is_heading) curves.push_back(row->curve);
    return curves;
}

std::optional<editor::MoveCurve> dropped_curve(const core::Document& document, const std::vector<CurveRow>& rows,
                                               std::size_t from, std::size_t slot) {
    const CurveRow* above = slot > 0 ? &rows[slot - 1] : nullptr;
    const CurveRow* below = slot < rows.size() ? &rows[slot] : nullptr;
    const std::string& own = document.curves[from].group;
    const std::string group = group_between(document, above, below, own);
    std::size_t to = below != nullptr ? below->curve : document.curves.size();
    if (to > from) --to;
    if (to == from && group == own) return std::nullopt;
    editor::MoveCurve command{.from = from, .to = to};
    if (group != own) command.group = group;
    return command;
}

std::optional<editor::MoveGroup> dropped_group(const core::Document& document, const std::vector<CurveRow>& rows,
                                               const CurveRow& heading, std::size_t slot) {
    const std::string& group = document.curves[heading.curve].group;
    const auto is_own = [&](std::size_t r) { return r < rows.size() && document.curves[rows[r].curve].group == group; };
    if (is_own(slot) || (slot > 0 && is_own(slot - 1))) return std::nullopt;
    editor::MoveGroup command{.group = group};
    if (slot < rows.size()) command.before = rows[slot].curve;
    return command;
}

bool can_be_dropped(const std::vector<CurveRow>& rows, const CurveRow& row, std::size_t slot) {
    return !row.is_heading || slot == rows.size() || !rows[slot].is_member;
}

}  // namespace batten::ui
