/// Commands that make the ends of curves meet and leave both curves by themselves.
#pragma once

#include <optional>
#include <string>

#include "app/editor/command.h"
#include "core/curve/curve_end.h"
#include "core/measure/meeting.h"

namespace batten::editor {

/// Changes an end of the active curve so that it meets another one.
struct Match {
    std::string other;  ///< the name of the curve that stays
    core::GeometricContinuity continuity;
    std::optional<core::CurveEnd> end{};  ///< of the active curve; none: the nearest
    std::optional<double> at{};           ///< the parameter on the other curve; none: its nearest end
    static const CommandSpec& spec();
};

/// Adds a curve between an end of the active curve and one of another.
struct Blend {
    std::string other;
    core::GeometricContinuity continuity;        ///< at the active curve
    core::GeometricContinuity other_continuity;  ///< and at the other one
    std::optional<core::CurveEnd> end{};         ///< none: the nearest ones
    std::optional<core::CurveEnd> other_end{};
    double tension;
    double other_tension;
    static const CommandSpec& spec();
};

/// Lists all joints of the document.
struct CheckJoints {
    double tolerance;  ///< how near ends must be to be a joint
    static const CommandSpec& spec();
};

}  // namespace batten::editor
