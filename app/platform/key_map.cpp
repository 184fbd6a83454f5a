#include "app/platform/key_map.h"

#include <GLFW/glfw3.h>

#include <array>
#include <utility>

namespace batten::platform {

namespace {

using editor::Key;

constexpr std::array<std::pair<int, Key>, 22> special_keys{{
    {GLFW_KEY_LEFT, Key::left},           {GLFW_KEY_RIGHT, Key::right},         {GLFW_KEY_UP, Key::up},
    {GLFW_KEY_DOWN, Key::down},           {GLFW_KEY_HOME, Key::home},           {GLFW_KEY_END, Key::end},
    {GLFW_KEY_PAGE_UP, Key::page_up},     {GLFW_KEY_PAGE_DOWN, Key::page_down}, {GLFW_KEY_TAB, Key::tab},
    {GLFW_KEY_ESCAPE, Key::escape},       {GLFW_KEY_ENTER, Key::enter},         {GLFW_KEY_KP_ENTER, Key::enter},
    {GLFW_KEY_BACKSPACE, Key::backspace}, {GLFW_KEY_DELETE, Key::delete_key},   {GLFW_KEY_SPACE, Key::space},
    {GLFW_KEY_EQUAL, Key::plus},          {GLFW_KEY_KP_ADD, Key::plus},         {GLFW_KEY_MINUS, Key::minus},
    {GLFW_KEY_KP_SUBTRACT, Key::minus},   {GLFW_KEY_COMMA, Key::comma},         {GLFW_KEY_PERIOD, Key::period},
    {GLFW_KEY_KP_DECIMAL, Key::period},
}};

Key offset_key(Key first, int offset) {
    return static_cast<Key>(static_cast<int>(first) + offset);
}

Key key_from_character(char character) {
    if (character >= 'a' && character <= 'z') return offset_key(Key::a, character - 'a');
    if (character >= '0' && character <= '9') return offset_key(Key::digit_0, character - '0');
    if (character == '+' || character == '=') return Key::plus;
    if (character == '-') return Key::minus;
    if (character == ',') return Key::comma;
    if (character == '.') return Key::period;
    return Key::none;
}

}  // namespace

Key key_from_glfw(int key, int scancode) {
    for (const auto& [code, result] : special_keys) {
        if (code == key) return result;
    }
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return offset_key(Key::f1, key - GLFW_KEY_F1);
    const char* name = glfwGetKeyName(key, scancode);
    return name != nullptr && name[0] != '\0' && name[1] == '\0' ? key_from_character(name[0]) : Key::none;
}

editor::Modifiers modifiers_from_glfw(int bits) {
    return {(bits & GLFW_MOD_CONTROL) != 0 || (bits & GLFW_MOD_SUPER) != 0, (bits & GLFW_MOD_SHIFT) != 0,
            (bits & GLFW_MOD_ALT) != 0};
}

}  // namespace batten::platform
