#include "app/editor/state/key.h"

#include <fmt/core.h>

#include <array>

namespace batten::editor {

namespace {

std::string name_of(Key key) {
    const auto offset_from = [key](Key first) { return static_cast<int>(key) - static_cast<int>(first); };
    if (key >= Key::a && key <= Key::z) return std::string(1, static_cast<char>('A' + offset_from(Key::a)));
    if (key >= Key::digit_0 && key <= Key::digit_9) return std::to_string(offset_from(Key::digit_0));
    if (key >= Key::f1 && key <= Key::f12) return fmt::format("F{}", 1 + offset_from(Key::f1));
    static constexpr std::array names{"Left",      "Right", "Up",  "Down",  "Home",      "End",    "Page Up",
                                      "Page Down", "Tab",   "Esc", "Enter", "Backspace", "Delete", "Space",
                                      "+",         "−",     ",",   ".",     "[",         "]"};
    return names[static_cast<std::size_t>(offset_from(Key::left))];
}

}  // namespace

std::string text_of(const Shortcut& shortcut) {
    if (shortcut.key == Key::none) return {};
    const auto& [ctrl, shift, alt] = shortcut.modifiers;
    return fmt::format("{}{}{}{}", ctrl ? "Ctrl+" : "", shift ? "Shift+" : "", alt ? "Alt+" : "",
                       name_of(shortcut.key));
}

}  // namespace batten::editor
