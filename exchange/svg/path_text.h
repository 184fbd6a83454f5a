/// A path of SVG as text.
#pragma once

#include <string>

#include "exchange/path_pieces.h"

namespace batten::exchange {

/// The attribute d of a path that draws `pieces`, with y turned over: "M 0 0 C 1 -2 3 -2 4 1". Runs that close end with
/// Z.
std::string path_text(const PathPieces& pieces);

}  // namespace batten::exchange
