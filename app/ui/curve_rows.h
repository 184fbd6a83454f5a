/// The list of curves as it is shown: groups under headings, and what a dragged entry comes to.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/editor/commands/group_commands.h"
#include "core/document/document.h"

namespace batten::ui {

struct CurveRow {
    std::size_t curve = 0;    ///< of a heading the first one of its group
    bool is_heading = false;  ///< of the group of the curve
    bool is_member = false;   ///< it stands under a heading

    bool operator==(const CurveRow&) const = default;
};

/// The rows in order: the curves of a group follow its heading, which stands where the first of them does; those of a
/// folded group are left out. Cost O(n log n) in the number of curves.
std::vector<CurveRow> curve_rows(const core::Document& document, const std::set<std::string>& folded);

/// The curves in the rows from that of one to that of the other, both included; `last` alone where no row shows
/// `first`.
std::vector<std::size_t> curves_between(const std::vector<CurveRow>& rows, std::size_t first, std::size_t last);

/// What happens to curve `from` when it is dropped before row `slot` (the number of rows: behind the last): between
/// members of a group it becomes one, beside one it stays in its own. None where it is there already.
std::optional<editor::MoveCurve> dropped_curve(const core::Document& document, const std::vector<CurveRow>& rows,
                                               std::size_t from, std::size_t slot);

/// What happens to the group of `heading` when it is dropped before row `slot`, which must not be a member's. None
/// where it is there already.
std::optional<editor::MoveGroup> dropped_group(const core::Document& document, const std::vector<CurveRow>& rows,
                                               const CurveRow& heading, std::size_t slot);

/// Whether the row can be dropped before row `slot`: a group between the members of another one cannot.
bool can_be_dropped(const std::vector<CurveRow>& rows, const CurveRow& row, std::size_t slot);

}  // namespace batten::ui
