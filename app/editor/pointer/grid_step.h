/// How far apart the lines of the grid and the ticks of the rulers are.
#pragma once

namespace batten::editor {

struct EditorState;

/// The distance of the major lines in world units: the least of 1, 2 or 5 times a power of ten that is at least 80
/// design pixels wide, and so less than 200. `scale` (> 0) is in design pixels per world unit: the camera's divided by
/// the interface's.
double major_grid_step(double scale);

/// The distance of the minor lines, again 1, 2 or 5 times a power of ten: a fifth or a quarter of the major, 16 to 40
/// design pixels.
double minor_grid_step(double scale);

/// The steps of a grid and its ruler, each a whole part of the one before.
struct GridSteps {
    double major = 1.0;
    double minor = 0.25;
    double fine = 0.125;  ///< of a ruler's least ticks, at least 3 design pixels
    bool operator==(const GridSteps&) const = default;
};

/// The steps as above, the fine one a half or a fifth of the minor.
GridSteps decimal_grid_steps(double scale);

/// The same with powers of a half from 1 down to a 128th, as inches are divided: minor lines are a quarter of the
/// major, fine ticks an eighth.
GridSteps inch_grid_steps(double scale);

/// Those of the canvas in the document's unit: round numbers, and binary fractions of inches.
GridSteps unit_grid_steps(const EditorState& state);

/// The same in world units.
GridSteps canvas_grid_steps(const EditorState& state);

}  // namespace batten::editor
