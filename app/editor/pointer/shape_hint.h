/// What the next click of the shape tool does.
#pragma once

#include <string>

#include "app/editor/state/shape_kind.h"

namespace batten::editor {

/// Where `count` places of the shape are there already.
std::string shape_hint(ShapeKind kind, std::size_t count);

}  // namespace batten::editor
