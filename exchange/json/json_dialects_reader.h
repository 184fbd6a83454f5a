/// Reads curves as other libraries keep them in JSON. Which of them a text is of, its reader says; nothing is guessed.
#pragma once

#include "exchange/report.h"

namespace batten::exchange {

/// What geomdl (NURBS-Python) writes: {"shape": {"data": [{"degree", "knotvector", "control_points": {"points",
/// "weights"}}]}}. Points are not multiplied by their weights. See FORMATS.md for all four.
[[nodiscard]] core::FileResult<Imported> read_nurbs_python(std::string_view text);

/// What tinyspline writes, or a list of such objects: {"degree", "dimension", "control_points", "knots"}. The points
/// are homogeneous, the last coordinate of each its weight, where "homogeneous" is true, and else in space.
[[nodiscard]] core::FileResult<Imported> read_tinyspline(std::string_view text);

/// {"curves": [{"degree", "points", "weights", "knots"}]} with points + degree - 1 knots, without the first and the
/// last.
[[nodiscard]] core::FileResult<Imported> read_rhino(std::string_view text);

/// {"curves": [{"degree", "poles", "weights", "knots", "multiplicities", "periodic"}]} with distinct knots.
[[nodiscard]] core::FileResult<Imported> read_opencascade(std::string_view text);

}  // namespace batten::exchange
