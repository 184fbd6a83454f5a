/// Commands on many knots at once, on the domain and on the ends of the knot vector.
#pragma once

#include "app/editor/command.h"
#include "app/editor/commands/curve_ends.h"

namespace batten::editor {

struct InsertKnots {
    std::vector<double> knots;
    static const CommandSpec& spec();
};

struct RemoveKnot {
    double u;
    int times;
    double tolerance;
    static const CommandSpec& spec();
};

struct RemoveKnots {
    double tolerance;
    static const CommandSpec& spec();
};

struct MergeKnots {
    double tolerance;  ///< as a part of the domain
    static const CommandSpec& spec();
};

struct ToBezier {
    static const CommandSpec& spec();
};

struct Reparametrize {
    double begin;
    double end;
    static const CommandSpec& spec();
};

struct Normalize {
    static const CommandSpec& spec();
};

struct MakeUniform {
    static const CommandSpec& spec();
};

struct Clamp {
    CurveEnds end;
    static const CommandSpec& spec();
};

struct Unclamp {
    CurveEnds end;
    static const CommandSpec& spec();
};

}  // namespace batten::editor
