/// Finds what is missing or damaged in the text of an IGES file, which OpenCASCADE takes for zeros.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/document/file_text.h"

namespace batten::exchange {

/// The first defect, with its line; none where the file is whole. Looked at are the sections S, G, D, P and T in this
/// order, whose lines are numbered from 1 on and counted in the line T; of every entity that its two lines in the
/// directory and its parameters belong together and each parameter is a number or a text; of a B-spline curve (entity
/// 126) that it has as many knots, weights and coordinates as its first two numbers say; and of arcs, conics and lines
/// (100, 104, 110) that all of their numbers are there. Cost O(n).
std::optional<core::FileError> iges_defect(std::string_view text);

/// The numbers, from 0 on in the order of the directory, of the entities whose parameters are missing or damaged; none
/// where more than that is. Cost O(n).
std::vector<std::size_t> damaged_iges_entities(std::string_view text);

}  // namespace batten::exchange
