/// From GLFW's key codes to the editor's keys.
#pragma once

#include <functional>
#include <string>

#include "app/editor/state/key.h"

namespace batten::platform {

/// What a key prints without modifiers in the user's layout, as UTF-8; empty where it prints nothing. The scancode
/// counts where the key is GLFW_KEY_UNKNOWN.
using Layout = std::function<std::string(int key, int scancode)>;

/// The layout that the user has now.
std::string name_in_layout(int key, int scancode);

/// The editor's key for a GLFW key. Digits are where they are on an American keyboard, since many layouts print them
/// only with Shift. Letters and signs are what `layout` prints; where that is of another script than Latin, or a sign
/// while no key prints the letter, they are where they are on an American keyboard. Key::none for all others.
editor::Key key_from_glfw(int key, int scancode, const Layout& layout = name_in_layout);

/// The sign among the editor's keys that a typed character is; Key::none for all others.
editor::Key key_from_sign(unsigned character);

/// The GLFW key that is `key` on an American keyboard; `otherwise` where `key` is no letter.
int american_key(editor::Key key, int otherwise);

/// The editor's modifiers for GLFW's modifier bits.
editor::Modifiers modifiers_from_glfw(int bits);

}  // namespace batten::platform
