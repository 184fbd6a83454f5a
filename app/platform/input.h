/// Collects what GLFW reports and hands it out in portions that one frame can answer.
#pragma once

#include <deque>
#include <filesystem>
#include <utility>
#include <variant>
#include <vector>

#include "app/ui/frame.h"

struct GLFWwindow;

namespace batten::platform {

class Input {
  public:
    /// Installs the callbacks; the object must stay where it is while the window lives, and uses the window's user
    /// pointer.
    void listen_to(GLFWwindow* window);

    /// Whether anything happened since the last call.
    bool take_activity() { return std::exchange(was_active_, false); }

    /// Whether more than one portion is waiting.
    bool is_pending() const { return !events_.empty(); }

    /// The next events: up to and including one press or release, so that each meets the state that its predecessors
    /// made.
    ui::FrameInput take();

    // What was handed out so far.
    glm::dvec2 handled_position_px() const { return handled_.position_px; }
    int handled_buttons_down() const { return handled_.buttons_down; }
    std::size_t handled_press_count() const { return handled_.press_count; }

    /// Files dropped on the window since the last call.
    std::vector<std::filesystem::path> take_dropped_files() { return std::exchange(dropped_files_, {}); }

  private:
    using Event = std::variant<editor::PointerEvent, ui::KeyPress>;

    struct Press {
        double time = -1.0;
        glm::dvec2 position_px{};
        editor::PointerButton button = editor::PointerButton::none;
    };

    struct Handled {
        glm::dvec2 position_px{};
        int buttons_down = 0;
        std::size_t press_count = 0;
    };

    editor::PointerEvent pointer_event(editor::PointerAction action) const;
    void add(const editor::PointerEvent& event);
    void on_key(GLFWwindow* window, int key, int scancode, int action, int modifiers);
    void on_button(int button, int action, int modifiers);
    void note_handled(const editor::PointerEvent& event);
    bool completes_double_click(editor::PointerButton button);

    std::deque<Event> events_;
    std::vector<std::filesystem::path> dropped_files_;
    glm::dvec2 position_px_{};
    editor::Modifiers modifiers_;
    bool space_is_held_ = false;
    bool was_active_ = true;
    Press last_press_;
    Handled handled_;
};

}  // namespace batten::platform
