/// The row of the inspector in which knots are inserted.
#pragma once

#include "app/ui/panels.h"

namespace batten::ui {

/// Draws a field for the parameter and buttons that insert a knot there or at all midpoints. Stands above the list of
/// knots, and stays where it is while the pointer is on it.
void draw_insert_row(const PanelContext& context, const core::Curve& curve);

}  // namespace batten::ui
