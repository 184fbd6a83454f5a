/// The parameter as pictures tell it.
#pragma once

#include <string>

#include "app/editor/state/view.h"
#include "core/curve/curve.h"

namespace batten::editor {

/// With the decimals that it has everywhere on screen; in a figure, where it does not run, as a fraction where no
/// decimals tell all of it.
std::string shown_parameter(const View& view, const core::Curve& curve, double u);

}  // namespace batten::editor
