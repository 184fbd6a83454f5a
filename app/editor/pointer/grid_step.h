/// How far apart the lines of the grid are.
#pragma once

namespace batten::editor {

/// The distance of the major lines in world units: the least of 1, 2 or 5 times a power of ten that is at least 80
/// design pixels wide, and so less than 200. `scale` (> 0) is in design pixels per world unit: the camera's divided by
/// the interface's.
double major_grid_step(double scale);

/// The distance of the minor lines, again 1, 2 or 5 times a power of ten: a fifth or a quarter of the major, 16 to 40
/// design pixels.
double minor_grid_step(double scale);

}  // namespace batten::editor
