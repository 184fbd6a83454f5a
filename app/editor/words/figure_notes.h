/// What is told about a figure that lacks something.
#pragma once

#include <string>
#include <vector>

#include "render/figure.h"

namespace batten::editor {

/// A sentence for each kind of things that are missing; none where nothing is.
std::vector<std::string> figure_notes(const render::FigureLosses& losses);

}  // namespace batten::editor
