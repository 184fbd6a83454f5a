/// Commands that add shapes: straight ones, circles, ellipses and other conics. Angles are in degrees.
#pragma once

#include "app/editor/command.h"
#include "core/base/geometry.h"
#include "core/make/conics.h"

namespace batten::editor {

struct AddLine {
    core::Point from;
    core::Point to;
    static const CommandSpec& spec();
};

struct AddPolyline {
    std::vector<core::Point> points;
    bool closed;
    static const CommandSpec& spec();
};

struct AddPolygon {
    core::Point center;
    double radius;
    std::size_t sides;
    double start = 90.0;
    static const CommandSpec& spec();
};

struct AddCircle {
    core::Point center;
    double radius;
    core::CirclePolygon polygon;
    static const CommandSpec& spec();
};

struct AddArc {
    core::Point center;
    double radius;
    double start;
    double sweep;  ///< counterclockwise
    static const CommandSpec& spec();
};

struct AddEllipse {
    core::Point center;
    double first_axis;
    double second_axis;
    double rotation;
    static const CommandSpec& spec();
};

struct AddEllipticArc {
    core::Point center;
    double first_axis;
    double second_axis;
    double rotation;
    double start;
    double sweep;
    static const CommandSpec& spec();
};

struct AddParabola {
    core::Point vertex;
    double focal_length;
    double axis;
    double from;  ///< measured across the axis
    double to;
    static const CommandSpec& spec();
};

struct AddHyperbola {
    core::Point center;
    double first_axis;
    double second_axis;
    double rotation;
    double from;  ///< a hyperbolic angle
    double to;
    static const CommandSpec& spec();
};

struct AddConic {
    std::vector<core::Point> points;  ///< first end, corner of the tangents, other end
    double weight;                    ///< of the corner
    static const CommandSpec& spec();
};

struct AddHodograph {
    static const CommandSpec& spec();
};

}  // namespace batten::editor
