/// Where the marked knots and ends of a curve are once an edit has made another curve of it.
#pragma once

#include <optional>
#include <vector>

#include "core/document/document.h"

namespace batten::editor {

/// Whether `now` runs through the control points of `old` backwards. Cost O(n) where it does.
bool is_reversed(const core::Curve& old, const core::Curve& now);

/// Takes the marks of `old`, which `entry` still has, along to its present curve: those of knots to the knots of the
/// same number where there are as many, also in a reversed curve, and where a closed one begins elsewhere; else to
/// those of the same value. Of marks whose knots have become one the mark that asks for least stays. Those of ends
/// change sides in a reversed curve.
void follow_knots(const core::Curve& old, core::DocumentCurve& entry);
void follow_ends(const core::Curve& old, core::DocumentCurve& entry);

/// Whether an end of `now` is where that of `old` was, up to rounding.
bool is_at_old_place(const core::Curve& old, core::CurveEnd old_end, const core::Curve& now, core::CurveEnd end);

/// What was added to the domain of `old` at one of its ends; empty where nothing was.
core::Interval added_part(const core::Curve& old, const core::Curve& now);

/// The marks of the knots of `joined` in `now`, of whose domain it became the part `added`, run through as before or
/// backwards; none where its knots cannot be told in it.
std::optional<std::vector<core::KnotMark>> joined_marks(const core::DocumentCurve& joined, const core::Curve& now,
                                                        core::Interval added);

}  // namespace batten::editor
