/// Commands that find what is special along the whole active curve.
#pragma once

#include "app/editor/command.h"

namespace batten::editor {

struct FindContinuity {
    static const CommandSpec& spec();
};

struct FindInflections {
    static const CommandSpec& spec();
};

struct FindCurvatureExtrema {
    static const CommandSpec& spec();
};

struct FindCusps {
    static const CommandSpec& spec();
};

struct FindSelfIntersections {
    static const CommandSpec& spec();
};

struct FindBounds {
    static const CommandSpec& spec();
};

struct FindSpanHulls {
    static const CommandSpec& spec();
};

}  // namespace batten::editor
