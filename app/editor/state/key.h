/// Keys, modifiers and shortcuts, named independently of any windowing library.
#pragma once

#include <string>

namespace batten::editor {

/// Keys that a shortcut can use. Letters are those that the user's layout prints.
enum class Key {
    none,
    a,
    b,
    c,
    d,
    e,
    f,
    g,
    h,
    i,
    j,
    k,
    l,
    m,
    n,
    o,
    p,
    q,
    r,
    s,
    t,
    u,
    v,
    w,
    x,
    y,
    z,
    digit_0,
    digit_1,
    digit_2,
    digit_3,
    digit_4,
    digit_5,
    digit_6,
    digit_7,
    digit_8,
    digit_9,
    left,
    right,
    up,
    down,
    home,
    end,
    page_up,
    page_down,
    tab,
    escape,
    enter,
    backspace,
    delete_key,
    space,
    plus,
    minus,
    comma,
    period,
    left_bracket,
    right_bracket,
    f1,
    f2,
    f3,
    f4,
    f5,
    f6,
    f7,
    f8,
    f9,
    f10,
    f11,
    f12
};

struct Modifiers {
    bool ctrl = false;
    bool shift = false;
    bool alt = false;
    bool operator==(const Modifiers&) const = default;
};

inline constexpr Modifiers with_ctrl{true, false, false};
inline constexpr Modifiers with_ctrl_shift{true, true, false};

/// A key with the modifiers that must be held exactly.
struct Shortcut {
    Key key = Key::none;
    Modifiers modifiers;
    bool operator==(const Shortcut&) const = default;
};

/// "Ctrl+Shift+Z"; empty for Key::none.
std::string text_of(const Shortcut& shortcut);

}  // namespace batten::editor
