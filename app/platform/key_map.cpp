#include "app/platform/key_map.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <utility>

namespace batten::platform {

namespace {

using editor::Key;

struct MappedKey {
    int code;
    Key key;
};

constexpr std::array special_keys{
    MappedKey{GLFW_KEY_LEFT, Key::left},
    MappedKey{GLFW_KEY_RIGHT, Key::right},
    MappedKey{GLFW_KEY_UP, Key::up},
    MappedKey{GLFW_KEY_DOWN, Key::down},
    MappedKey{GLFW_KEY_HOME, Key::home},
    MappedKey{GLFW_KEY_END, Key::end},
    MappedKey{GLFW_KEY_PAGE_UP, Key::page_up},
    MappedKey{GLFW_KEY_PAGE_DOWN, Key::page_down},
    MappedKey{GLFW_KEY_TAB, Key::tab},
    MappedKey{GLFW_KEY_ESCAPE, Key::escape},
    MappedKey{GLFW_KEY_ENTER, Key::enter},
    MappedKey{GLFW_KEY_KP_ENTER, Key::enter},
    MappedKey{GLFW_KEY_BACKSPACE, Key::backspace},
    MappedKey{GLFW_KEY_DELETE, Key::delete_key},
    MappedKey{GLFW_KEY_SPACE, Key::space},
    MappedKey{GLFW_KEY_KP_ADD, Key::plus},
    MappedKey{GLFW_KEY_KP_SUBTRACT, Key::minus},
    MappedKey{GLFW_KEY_KP_DECIMAL, Key::period},
};

constexpr std::array american_signs{
    MappedKey{GLFW_KEY_EQUAL, Key::plus},
    MappedKey{GLFW_KEY_MINUS, Key::minus},
    MappedKey{GLFW_KEY_COMMA, Key::comma},
    MappedKey{GLFW_KEY_PERIOD, Key::period},
};

/// Meant by their place where the layout prints letters there that are not Latin; elsewhere what is printed counts.
constexpr std::array american_brackets{
    MappedKey{GLFW_KEY_LEFT_BRACKET, Key::left_bracket},
    MappedKey{GLFW_KEY_RIGHT_BRACKET, Key::right_bracket},
};

Key offset_key(Key first, int offset) {
    return static_cast<Key>(static_cast<int>(first) + offset);
}

template <std::size_t n>
Key key_in(const std::array<MappedKey, n>& table, int code) {
    const auto found =
        std::find_if(table.begin(), table.end(), [code](MappedKey mapped) { return mapped.code == code; });
    return found == table.end() ? Key::none : found->key;
}

/// What does not depend on the layout.
Key fixed_key(int key) {
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return offset_key(Key::f1, key - GLFW_KEY_F1);
    if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) return offset_key(Key::digit_0, key - GLFW_KEY_0);
    if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) return offset_key(Key::digit_0, key - GLFW_KEY_KP_0);
    return key_in(special_keys, key);
}

Key american_place(int key) {
    if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z) return offset_key(Key::a, key - GLFW_KEY_A);
    return key_in(american_signs, key);
}

Key printed_key(const std::string& name) {
    if (name.size() != 1) return Key::none;
    const char character = name.front();
    if (character >= 'a' && character <= 'z') return offset_key(Key::a, character - 'a');
    if (character >= '0' && character <= '9') return offset_key(Key::digit_0, character - '0');
    if (character == '=') return Key::plus;
    return key_from_sign(static_cast<unsigned char>(character));
}

/// Whether a key name is a letter beyond the Latin ones with their accents: in UTF-8 those begin before 0xC9, and
/// typographic signs with 0xE2.
bool is_of_another_script(const std::string& name) {
    const unsigned char first = name.empty() ? 0 : static_cast<unsigned char>(name.front());
    return first >= 0xC9 && first != 0xE2;
}

bool prints_anywhere(const Layout& layout, Key wanted) {
    for (int key = GLFW_KEY_APOSTROPHE; key <= GLFW_KEY_WORLD_2; ++key)
        if (printed_key(layout(key, 0)) == wanted) return true;
    return false;
}

}  // namespace

std::string name_in_layout(int key, int scancode) {
    const bool is_absent = key != GLFW_KEY_UNKNOWN && glfwGetKeyScancode(key) < 0;
    const char* name = is_absent ? nullptr : glfwGetKeyName(key, scancode);
    return name == nullptr ? "" : name;
}

Key key_from_glfw(int key, int scancode, const Layout& layout) {
    if (const Key fixed = fixed_key(key); fixed != Key::none) return fixed;
    const std::string name = layout(key, scancode);
    if (const Key printed = printed_key(name); printed != Key::none) return printed;
    const Key place = american_place(key);
    if (is_of_another_script(name)) return place != Key::none ? place : key_in(american_brackets, key);
    if (place == Key::none) return place;
    return prints_anywhere(layout, place) ? Key::none : place;
}

Key key_from_sign(unsigned character) {
    if (character == '+') return Key::plus;
    if (character == '-') return Key::minus;
    if (character == ',') return Key::comma;
    if (character == '.') return Key::period;
    return Key::none;
}

int american_key(Key key, int otherwise) {
    if (key < Key::a || key > Key::z) return otherwise;
    return GLFW_KEY_A + static_cast<int>(key) - static_cast<int>(Key::a);
}

editor::Modifiers modifiers_from_glfw(int bits) {
    return {(bits & GLFW_MOD_CONTROL) != 0 || (bits & GLFW_MOD_SUPER) != 0, (bits & GLFW_MOD_SHIFT) != 0,
            (bits & GLFW_MOD_ALT) != 0};
}

}  // namespace batten::platform
