/// Curves that are images of each other, and stay so through every edit.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/editor/command_spec.h"
#include "core/curve/curve_end.h"
#include "core/document/document.h"
#include "core/edit/plane_map.h"

namespace batten::editor {

/// The map that takes image 0 to image `symmetry.place`, and the one that takes it back.
core::PlaneMap map_to_image(const core::Symmetry& symmetry);
core::PlaneMap map_from_image(const core::Symmetry& symmetry);

/// The same symmetry seen after all is mapped.
core::Symmetry mapped_symmetry(core::Symmetry symmetry, const core::PlaneMap& map);

/// A number that no group of `document` has.
std::size_t free_group(const core::Document& document);

/// Brings `after`, which an edit made of `before`, back into symmetry: of each group the curve that the edit changed,
/// the active one where several did, leads, and all are made the images of one curve again, bit by bit. Where its end
/// lay on the line of a mirror it stays there, and where it met the line at a right angle, and so was G2 across it, it
/// does that again, from degree 2 on, which sentences that are returned tell where the edit had it otherwise. A
/// curve that is left alone in its group is an ordinary one. The refusal is that of a locked image. Where two curves
/// are the same image, as after one was copied, the later one is an ordinary curve. Cost O(n) for each group that
/// changed.
Outcome<std::vector<std::string>> keep_symmetry(const core::Document& before, core::Document& after);

/// What became of an end that was put onto the line of a mirror.
struct SeatedEnd {
    core::CurveEnd end = core::CurveEnd::start;
    double moved = 0.0;         ///< how far, to lie on the line
    double turned = 0.0;        ///< by how many degrees, to meet it at a right angle; 0 up to but not 90
    bool keeps_corner = false;  ///< where a right angle was asked for, and the end runs along the line, or has degree 1
};

struct SeatedCurve {
    core::Curve curve;
    std::vector<SeatedEnd> ends{};  ///< those near the line
};

/// `curve` with its ends that are nearer than `reach` to the line of the mirror put onto it, so that they meet it at a
/// right angle where `is_smooth`: clamped ends alone.
core::Result<SeatedCurve> with_ends_on_mirror(const core::Curve& curve, const core::Symmetry& mirror, double reach,
                                              bool is_smooth);

}  // namespace batten::editor
