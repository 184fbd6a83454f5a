/// Commands that put control points and curves into line, at even distances, and to a given length or distance.
#pragma once

#include <optional>

#include "app/editor/command.h"
#include "core/base/geometry.h"

namespace batten::editor {

/// Where things are put in line: at an edge of the box around them all, or at its middle.
enum class Alignment { left, center, right, top, middle, bottom };

enum class Direction { horizontal, vertical };

/// The selected control points and curves, or all curves that are visible; curves by their boxes.
enum class Arranged { points, curves };

struct Align {
    Alignment at;
    Arranged what;
    static const CommandSpec& spec();
};

struct Distribute {
    Direction direction;
    Arranged what;
    static const CommandSpec& spec();
};

struct SetLength {
    double length;
    static const CommandSpec& spec();
};

struct SetDistance {
    std::size_t from;
    std::size_t to;
    double distance;
    static const CommandSpec& spec();
};

}  // namespace batten::editor

namespace batten::core {

template <>
struct Names<editor::Alignment> {
    using enum editor::Alignment;
    static constexpr std::array table{Named{left, "left", "left"},       Named{center, "center", "center"},
                                      Named{right, "right", "right"},    Named{top, "top", "top"},
                                      Named{middle, "middle", "middle"}, Named{bottom, "bottom", "bottom"}};
};

template <>
struct Names<editor::Direction> {
    using enum editor::Direction;
    static constexpr std::array table{Named{horizontal, "horizontal", "horizontally"},
                                      Named{vertical, "vertical", "vertically"}};
};

template <>
struct Names<editor::Arranged> {
    using enum editor::Arranged;
    static constexpr std::array table{Named{points, "points", "what is selected"},
                                      Named{curves, "curves", "the visible curves"}};
};

}  // namespace batten::core
