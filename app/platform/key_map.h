/// From GLFW's key codes to the editor's keys.
#pragma once

#include "app/editor/key.h"

namespace batten::platform {

/// The editor's key for a GLFW key; letters and digits by what the user's layout prints. Key::none for all others.
editor::Key key_from_glfw(int key, int scancode);

/// The editor's modifiers for GLFW's modifier bits.
editor::Modifiers modifiers_from_glfw(int bits);

}  // namespace batten::platform
