/// Commands that close curves, convert between the ways of being closed, and shape the ends of uniform cubics.
#pragma once

#include <string>

#include "app/editor/command.h"
#include "app/editor/commands/curve_ends.h"
#include "core/curve/curve_end.h"

namespace batten::editor {

/// Where the ends meet the curve becomes periodic as it is; else its control points do, or it is opened.
struct CloseOrOpen {
    static const CommandSpec& spec();
};

struct ToPeriodic {
    double tolerance;
    static const CommandSpec& spec();
};

struct ToWrapped {
    double tolerance;
    static const CommandSpec& spec();
};

struct ToClamped {
    static const CommandSpec& spec();
};

struct MoveSeam {
    double u;
    double tolerance;
    static const CommandSpec& spec();
};

struct DoubleEnd {
    CurveEnds end;
    static const CommandSpec& spec();
};

struct TripleEnd {
    CurveEnds end;
    static const CommandSpec& spec();
};

struct PhantomEnd {
    CurveEnds end;
    static const CommandSpec& spec();
};

/// Begins the active curve where another one ends, or ends it where that one begins, by three common vertices.
struct ShareVertices {
    std::string other;  ///< the name of the other curve
    core::CurveEnd end;
    static const CommandSpec& spec();
};

struct Straighten {
    std::size_t from;
    std::size_t to;
    static const CommandSpec& spec();
};

}  // namespace batten::editor
