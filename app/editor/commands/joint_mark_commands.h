/// Commands that mark joints, so that edits keep them.
#pragma once

#include "app/editor/command.h"
#include "app/editor/command_spec.h"
#include "core/document/joint_marks.h"

namespace batten::editor {

struct MarkJoint {
    core::JointMark mark;
    double u;  ///< a knot, or an end of the domain that meets another end
    static const CommandSpec& spec();
};

struct UnmarkJoint {
    double u;
    static const CommandSpec& spec();
};

/// Marks the selected knot, or the place of the handlebar.
template <core::JointMark mark>
struct MarkAs {
    static const CommandSpec& spec();
};

template <>
const CommandSpec& MarkAs<core::JointMark::corner>::spec();
template <>
const CommandSpec& MarkAs<core::JointMark::smooth>::spec();
template <>
const CommandSpec& MarkAs<core::JointMark::curvature>::spec();

/// How the joint at u of the committed active curve is marked; none where it is not.
std::optional<core::JointMark> mark_at(const EditorState& state, double u);

}  // namespace batten::editor
