/// Commands on curves that are made of fit points.
#pragma once

#include <optional>

#include "app/editor/command.h"
#include "app/editor/command_spec.h"
#include "core/base/geometry.h"
#include "core/make/fit_points.h"

namespace batten::editor {

struct MoveFitPoint {
    std::size_t index;
    core::Point position;
    static const CommandSpec& spec();
};

struct InsertFitPoint {
    std::size_t index;  ///< that the new point will have
    core::Point position;
    static const CommandSpec& spec();
};

struct DeleteFitPoint {
    std::size_t index;
    static const CommandSpec& spec();
};

struct SetFitJoint {
    std::size_t index;
    core::FitJoint joint;
    std::optional<core::Vector> handle{};  ///< of a given tangent; none keeps the direction that there is
    static const CommandSpec& spec();
};

/// Gives the selected fit point a joint.
template <core::FitJoint joint>
struct JoinAt {
    static const CommandSpec& spec();
};

template <>
const CommandSpec& JoinAt<core::FitJoint::smooth>::spec();
template <>
const CommandSpec& JoinAt<core::FitJoint::tangent>::spec();
template <>
const CommandSpec& JoinAt<core::FitJoint::corner>::spec();
template <>
const CommandSpec& JoinAt<core::FitJoint::straight>::spec();
template <>
const CommandSpec& JoinAt<core::FitJoint::corner_straight>::spec();

struct SetFitKind {
    core::FitKind kind;
    core::Parametrization parametrization;
    bool closed;
    static const CommandSpec& spec();
};

struct MakeOrdinary {
    static const CommandSpec& spec();
};

struct SelectFitPoint {
    std::optional<std::size_t> index;  ///< none: no fit point
    static const CommandSpec& spec();
};

/// The edit that moves fit point `index` of the active curve, which has such.
Outcome<Edit> with_fit_point_at(const EditorState& state, std::size_t index, core::Point position);

/// The edit that deletes fit point `index` of the active curve, which has such, and what it says.
Outcome<Edit> without_fit_point(const EditorState& state, std::size_t index);
StepTexts texts_of_deleted_fit_point(std::size_t index);

}  // namespace batten::editor
