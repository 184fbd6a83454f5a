/// Parts of the pictures of uniform cubics: arrows, and the construction of a joint from its three vertices.
#pragma once

#include "app/editor/scene/canvas_frame.h"
#include "app/editor/scene/label_side.h"
#include "core/evaluate/uniform_cubic.h"

namespace batten::editor {

/// An arrow by `vector` from `place`, with a label beyond its tip.
void draw_vector(CanvasFrame& frame, core::Point place, core::Vector vector, render::Color color,
                 const std::string& name);

/// A label beside a place, bold in its color.
void wish_label(CanvasFrame& frame, core::Point place, const std::string& text, render::Color color,
                LabelSide first = LabelSide::upper_right);

/// The base of the triangle, dashed, and the median with a mark for each third.
void draw_median(CanvasFrame& frame, const core::Anticentroid& joint, render::Color color);

/// A small ring at the joint.
void draw_joint(CanvasFrame& frame, core::Point place, render::Color color);

/// Whether all places are numbers that a picture can be made of.
bool is_drawable(const core::Anticentroid& joint);

}  // namespace batten::editor
