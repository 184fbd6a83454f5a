/// Edits of the list of curves that several commands make.
#pragma once

#include "app/editor/command_spec.h"
#include "app/editor/state/state.h"

namespace batten::editor {

/// The committed document with `curve` added under a free name like `wish`; it is active.
Edit with_curve(const EditorState& state, const std::string& wish, core::Curve curve);

/// The same with several curves, at least one, of which the first is active.
Edit with_curves(const EditorState& state, const std::string& wish, std::vector<core::Curve> curves);

/// Refusal: no active curve, a locked one, or no other one beside it.
std::optional<Refusal> no_other_curve(const EditorState& state);

/// The index of the committed document's curve that is meant by `name`, which may be its number; the refusal lists the
/// names there are.
Outcome<std::size_t> curve_named(const EditorState& state, const std::string& name);

/// What stands for `entry` where it is cut into these parts: the first under its name, the others under free ones, all
/// without pins, links and fit points, which were those of the whole.
std::vector<core::DocumentCurve> entries_of_parts(const core::DocumentCurve& entry, std::vector<core::Curve> parts,
                                                  core::FreeNames& names);

/// The committed document with the active curve replaced by its parts, at least one: the first keeps its place and
/// name, the others follow it under free names and look like it.
Edit with_parts(const EditorState& state, std::vector<core::Curve> parts);

/// The committed document with `curve` in place of the active one and without `others`, which are ascending. One of
/// several images of a link is no image any more.
Edit with_one_for_several(const EditorState& state, core::Curve curve, const std::vector<std::size_t>& others);

/// The committed document without curve `index`, which there must be; a locked one is refused.
Outcome<Edit> without_curve(const EditorState& state, std::size_t index);

/// The committed document without these control points of the active curve, which there must be; without the curve
/// where they are all of its points.
Outcome<Edit> without_points(const EditorState& state, const std::vector<std::size_t>& points);

/// What the step of without_points() is called and says.
StepTexts texts_of_deleting(const EditorState& state, const std::vector<std::size_t>& points);

/// Whether `points`, ascending, are all control points of the active curve, which there must be.
bool are_all_points(const EditorState& state, const std::vector<std::size_t>& points);

/// Moves the entry's curve by `shift` to the right and down.
[[nodiscard]] core::Result<void> shift_entry(core::DocumentCurve& entry, double shift);

/// Why there cannot be each of `curves` `count` times: they would have more control points than can be drawn.
std::optional<Refusal> too_many_copies(const EditorState& state, const std::vector<std::size_t>& curves,
                                       std::size_t count);

/// The committed document with a copy of curve `index`, which there must be, moved by `shift` to the right and down;
/// the copy is active, visible and not locked.
Outcome<Edit> with_duplicate(const EditorState& state, std::size_t index, double shift);

/// The same of several curves, at least one; the copies are selected as wholes, and the last one is active.
Outcome<Edit> with_duplicates(const EditorState& state, const std::vector<std::size_t>& curves, double shift);

}  // namespace batten::editor
