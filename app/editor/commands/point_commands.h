/// Commands on the control points of the active curve.
#pragma once

#include "app/editor/command.h"
#include "core/base/geometry.h"

namespace batten::editor {

struct MovePoints {
    std::vector<std::size_t> points;
    core::Vector offset;
    static const CommandSpec& spec();
};

struct SoftMove {
    core::Point center;
    core::Vector offset;  ///< of a point at the center
    double radius;
    static const CommandSpec& spec();
};

struct SetPoint {
    std::size_t index;
    core::Point position;
    static const CommandSpec& spec();
};

struct SetWeight {
    std::size_t index;
    double weight;
    static const CommandSpec& spec();
};

struct AddPoint {
    std::size_t index;  ///< that the new point will have
    core::Point position;
    static const CommandSpec& spec();
};

struct DeletePoints {
    std::vector<std::size_t> points;
    static const CommandSpec& spec();
};

/// Moves the selected points, as the ones below do in one direction. Those are made by arrow keys: what follows at once
/// belongs to the step before.
struct Nudge {
    core::Vector offset;
    static const CommandSpec& spec();
};

struct NudgeLeft {
    double distance;
    bool continues;  ///< the step before
    static const CommandSpec& spec();
};
struct NudgeRight {
    double distance;
    bool continues;  ///< the step before
    static const CommandSpec& spec();
};
struct NudgeUp {
    double distance;
    bool continues;  ///< the step before
    static const CommandSpec& spec();
};
struct NudgeDown {
    double distance;
    bool continues;  ///< the step before
    static const CommandSpec& spec();
};
struct NudgeLeftFar {
    double distance;
    bool continues;  ///< the step before
    static const CommandSpec& spec();
};
struct NudgeRightFar {
    double distance;
    bool continues;  ///< the step before
    static const CommandSpec& spec();
};
struct NudgeUpFar {
    double distance;
    bool continues;  ///< the step before
    static const CommandSpec& spec();
};
struct NudgeDownFar {
    double distance;
    bool continues;  ///< the step before
    static const CommandSpec& spec();
};

}  // namespace batten::editor
