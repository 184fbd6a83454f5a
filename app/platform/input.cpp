#include "app/platform/input.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "app/platform/key_map.h"

namespace batten::platform {

using editor::PointerAction;
using editor::PointerButton;
using editor::PointerEvent;

namespace {

constexpr double double_click_seconds = 0.4;
constexpr double double_click_px = 6.0;

Input& input_of(GLFWwindow* window) {
    return *static_cast<Input*>(glfwGetWindowUserPointer(window));
}

PointerButton button_from_glfw(int button) {
    if (button == GLFW_MOUSE_BUTTON_LEFT) return PointerButton::left;
    if (button == GLFW_MOUSE_BUTTON_MIDDLE) return PointerButton::middle;
    if (button == GLFW_MOUSE_BUTTON_RIGHT) return PointerButton::right;
    return PointerButton::none;
}

bool is_button_action(PointerAction action) {
    return action == PointerAction::press || action == PointerAction::release || action == PointerAction::double_click;
}

/// GLFW reports the modifiers before a modifier key's own change.
editor::Modifiers after_key(editor::Modifiers modifiers, int key, bool is_down) {
    if (key == GLFW_KEY_LEFT_CONTROL || key == GLFW_KEY_RIGHT_CONTROL) modifiers.ctrl = is_down;
    if (key == GLFW_KEY_LEFT_SHIFT || key == GLFW_KEY_RIGHT_SHIFT) modifiers.shift = is_down;
    if (key == GLFW_KEY_LEFT_ALT || key == GLFW_KEY_RIGHT_ALT) modifiers.alt = is_down;
    return modifiers;
}

/// The sign that a key prints; Shift is what it may take to print it.
editor::Shortcut printed_shortcut(unsigned character, editor::Modifiers modifiers) {
    modifiers.shift = false;
    return {key_from_sign(character), modifiers};
}

/// The comma of a number pad is a decimal point, whatever the layout prints.
char32_t typed_character(unsigned character, int key) {
    return key == GLFW_KEY_KP_DECIMAL ? U'.' : static_cast<char32_t>(character);
}

}  // namespace

void Input::listen_to(GLFWwindow* window) {
    glfwSetWindowUserPointer(window, this);
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
        Input& input = input_of(w);
        input.position_px_ = {x, y};
        if (!input.is_near_last_press()) input.last_press_ = {};  // a drag is no click, wherever it ends
        input.add(input.pointer_event(PointerAction::move));
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int modifiers) {
        input_of(w).on_button(button, action, modifiers);
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double sideways_notches, double notches) {
        Input& input = input_of(w);
        PointerEvent event = input.pointer_event(PointerAction::wheel);
        event.wheel = notches;
        event.sideways_wheel = sideways_notches;
        input.add(event);
    });
    glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int has_entered) {
        if (has_entered == GLFW_FALSE) input_of(w).add(input_of(w).pointer_event(PointerAction::leave));
    });
    glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
        Input& input = input_of(w);
        input.dropped_files_.assign(paths, paths + count);
        input.was_active_ = true;
    });
    glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int has_focus) {
        Input& input = input_of(w);
        input.was_active_ = true;
        if (has_focus == GLFW_FALSE) {
            input.modifiers_ = {};
            input.space_is_held_ = false;
        }
    });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { input_of(w).was_active_ = true; });
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { input_of(w).was_active_ = true; });
    glfwSetWindowContentScaleCallback(window, [](GLFWwindow* w, float, float) { input_of(w).was_active_ = true; });
}

void Input::let_go() {
    modifiers_ = {};
    space_is_held_ = false;
    for (; buttons_down_ > 0; --buttons_down_) {
        PointerEvent event = pointer_event(PointerAction::release);
        event.button = last_button_;
        add(event);
    }
}

PointerEvent Input::pointer_event(PointerAction action) const {
    PointerEvent event;
    event.action = action;
    event.position_px = position_px_;
    event.modifiers = modifiers_;
    event.space_is_held = space_is_held_;
    return event;
}

void Input::add(const PointerEvent& event) {
    was_active_ = true;
    if (event.action == PointerAction::move && !events_.empty()) {
        // A burst of moves is one move to where it ended.
        auto* last = std::get_if<PointerEvent>(&events_.back());
        if (last != nullptr && last->action == PointerAction::move && last->modifiers == event.modifiers &&
            last->space_is_held == event.space_is_held) {
            *last = event;
            return;
        }
    }
    events_.emplace_back(event);
}

void Input::listen_to_keys(GLFWwindow* window, KeySink sink, bool looks_once_a_frame) {
    key_sink_ = std::move(sink);
    sink_looks_once_a_frame_ = looks_once_a_frame;
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int modifiers) {
        input_of(w).on_key({key, scancode, action, modifiers});
    });
    // Comes after the key and before its text, also while Ctrl is held, which keeps a key from being text.
    glfwSetCharModsCallback(window, [](GLFWwindow* w, unsigned character, int) { input_of(w).on_printed(character); });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned character) {
        KeyEvent text;
        text.character = character;
        input_of(w).on_key(text);
    });
}

void Input::on_key(const KeyEvent& event) {
    was_active_ = true;
    if (sink_looks_once_a_frame_) {
        waiting_keys_.push(event);
    } else {
        deliver(event);
    }
}

void Input::on_printed(unsigned character) {
    waiting_keys_.note_printed(character);
    if (sink_looks_once_a_frame_ || events_.empty()) return;
    if (auto* press = std::get_if<ui::KeyPress>(&events_.back()))
        press->printed = printed_shortcut(character, press->shortcut.modifiers);
}

void Input::deliver_keys() {
    for (const KeyEvent& event : waiting_keys_.take_portion()) deliver(event);
}

void Input::deliver(const KeyEvent& event) {
    key_sink_(event);
    if (event.character != 0) {
        ui::KeyPress text;
        text.character = typed_character(event.character, last_key_);
        events_.emplace_back(text);
        return;
    }
    const bool is_down = event.action != GLFW_RELEASE;
    const editor::Modifiers before = modifiers_;
    modifiers_ = after_key(modifiers_from_glfw(event.modifiers), event.key, is_down);
    const bool held_space = space_is_held_;
    if (event.key == GLFW_KEY_SPACE) space_is_held_ = is_down;
    if (modifiers_ != before || space_is_held_ != held_space) add(pointer_event(PointerAction::move));
    if (!is_down) return;
    last_key_ = event.key;
    const ui::KeyPress press{{key_from_glfw(event.key, event.scancode), modifiers_},
                             printed_shortcut(event.printed, modifiers_)};
    if (press.shortcut.key != editor::Key::none || press.printed.key != editor::Key::none) events_.emplace_back(press);
}

void Input::on_button(int button, int action, int modifiers) {
    modifiers_ = modifiers_from_glfw(modifiers);
    const PointerButton mapped = button_from_glfw(button);
    // One that is let go may have gone down over a window that is gone.
    if (mapped == PointerButton::none || (action == GLFW_RELEASE && buttons_down_ == 0)) return;
    buttons_down_ += action == GLFW_PRESS ? 1 : -1;
    PointerEvent event = pointer_event(PointerAction::release);
    event.button = mapped;
    if (action == GLFW_PRESS) {
        last_button_ = mapped;
        event.action = completes_double_click(mapped) ? PointerAction::double_click : PointerAction::press;
    }
    add(event);
}

bool Input::is_near_last_press() const {
    return glm::distance(position_px_, last_press_.position_px) < double_click_px;
}

bool Input::completes_double_click(PointerButton button) {
    const Press press{glfwGetTime(), position_px_, button};
    const bool is_second =
        last_press_.button == button && press.time - last_press_.time < double_click_seconds && is_near_last_press();
    // A third press begins anew.
    last_press_ = is_second ? Press{} : press;
    return is_second;
}

void Input::note_handled(const PointerEvent& event) {
    handled_.position_px = event.position_px;
    if (event.action == PointerAction::release) {
        --handled_.buttons_down;
    } else if (is_button_action(event.action)) {
        ++handled_.buttons_down;
        ++handled_.press_count;
    }
}

ui::FrameInput Input::take() {
    ui::FrameInput result;
    while (!events_.empty()) {
        if (const auto* key = std::get_if<ui::KeyPress>(&events_.front())) {
            result.key_presses.push_back(*key);
            const bool is_text = key->character != 0;
            events_.pop_front();
            // Each character meets what the one before has made.
            if (is_text) break;
            ++handled_.key_count;
            continue;
        }
        if (!result.key_presses.empty()) break;
        const PointerEvent event = std::get<PointerEvent>(events_.front());
        events_.pop_front();
        result.pointer_events.push_back(event);
        note_handled(event);
        if (is_button_action(event.action)) break;
    }
    return result;
}

}  // namespace batten::platform
