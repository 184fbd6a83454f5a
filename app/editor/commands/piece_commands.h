/// Commands that cut, join, turn and extend curves.
#pragma once

#include <optional>
#include <string>

#include "app/editor/command.h"
#include "core/curve/curve_end.h"
#include "core/refine/join.h"

namespace batten::editor {

struct Split {
    double u;
    static const CommandSpec& spec();
};

/// Keeps the part between two parameters only.
struct SubCurve {
    double begin;
    double end;
    static const CommandSpec& spec();
};

struct BezierPieces {
    static const CommandSpec& spec();
};

struct Join {
    std::string other;  ///< the name of the curve to go on with
    core::JoinContinuity continuity;
    std::optional<core::CurveEnd> end{};        ///< of the active curve; none: the nearest ends
    std::optional<core::CurveEnd> other_end{};  ///< and of the other one
    static const CommandSpec& spec();
};

struct JoinPieces {
    double tolerance;
    static const CommandSpec& spec();
};

struct Reverse {
    static const CommandSpec& spec();
};

struct Extend {
    double length;
    core::CurveEnd end;
    static const CommandSpec& spec();
};

struct ExtendParameter {
    double by;
    core::CurveEnd end;
    static const CommandSpec& spec();
};

struct ExtendStraight {
    double length;
    core::CurveEnd end;
    static const CommandSpec& spec();
};

}  // namespace batten::editor
