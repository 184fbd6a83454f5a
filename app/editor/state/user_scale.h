/// The user's own factor on the size of the interface.
#pragma once

#include "app/editor/state/view.h"

namespace batten::editor {

/// Sets the user's scale, brought into user_scales, and the interface's scale with it.
void set_user_scale(View& view, double scale);

}  // namespace batten::editor
