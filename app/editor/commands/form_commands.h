/// Commands that tell the active curve in other forms: closing, conics, uniform cubics, blossoms.
#pragma once

#include "app/editor/command.h"

namespace batten::editor {

struct FindClosing {
    static const CommandSpec& spec();
};

struct FindCollinearRuns {
    static const CommandSpec& spec();
};

struct FindConicForm {
    static const CommandSpec& spec();
};

struct FindMatrixForm {
    static const CommandSpec& spec();
};

struct FindFergusonForm {
    static const CommandSpec& spec();
};

struct FindAnticentroids {
    static const CommandSpec& spec();
};

struct FindBlossomLabels {
    double u;
    static const CommandSpec& spec();
};

struct FindBlossom {
    std::vector<double> arguments;  ///< as many as the degree
    double u;                       ///< names the piece
    static const CommandSpec& spec();
};

struct FindGrevillePoints {
    static const CommandSpec& spec();
};

}  // namespace batten::editor
