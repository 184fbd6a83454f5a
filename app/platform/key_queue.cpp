#include "app/platform/key_queue.h"

#include <GLFW/glfw3.h>

#include <algorithm>

namespace batten::platform {

namespace {

bool is_text(const KeyEvent& event) {
    return event.character != 0;
}

bool is_press(const KeyEvent& event) {
    return !is_text(event) && event.action != GLFW_RELEASE;
}

bool is_modifier(const KeyEvent& event) {
    return !is_text(event) && event.key >= GLFW_KEY_LEFT_SHIFT && event.key <= GLFW_KEY_RIGHT_SUPER;
}

/// Whether a press does something other than printing.
bool acts(const KeyEvent& event) {
    constexpr int acting_modifiers = GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER;
    const bool is_function = event.key >= GLFW_KEY_ESCAPE && event.key < GLFW_KEY_KP_0;
    return is_press(event) && !is_modifier(event) &&
           (is_function || event.key == GLFW_KEY_KP_ENTER || (event.modifiers & acting_modifiers) != 0);
}

/// Whether `event` must wait for the frame after the one that has `portion`.
bool must_wait(const KeyEvent& event, const std::vector<KeyEvent>& portion) {
    const auto has = [&](auto predicate) { return std::any_of(portion.begin(), portion.end(), predicate); };
    if (is_modifier(event) && has([](const KeyEvent& e) { return is_text(e) || (is_press(e) && !is_modifier(e)); }))
        return true;
    if ((is_text(event) || is_press(event)) && has(acts)) return true;
    return !is_text(event) && has([&](const KeyEvent& e) { return !is_text(e) && e.key == event.key; });
}

}  // namespace

void KeyQueue::push(const KeyEvent& event) {
    const auto is_same = [&](const KeyEvent& e) { return !is_text(e) && e.key == event.key; };
    const bool is_repeat = !is_text(event) && event.action == GLFW_REPEAT;
    if (is_repeat && std::any_of(waiting_.begin(), waiting_.end(), is_same)) return;
    waiting_.push_back(event);
}

void KeyQueue::note_printed(unsigned character) {
    if (!waiting_.empty() && is_press(waiting_.back())) waiting_.back().printed = character;
}

std::vector<KeyEvent> KeyQueue::take_portion() {
    std::vector<KeyEvent> portion;
    while (!waiting_.empty() && !must_wait(waiting_.front(), portion)) {
        portion.push_back(waiting_.front());
        waiting_.pop_front();
    }
    return portion;
}

}  // namespace batten::platform
