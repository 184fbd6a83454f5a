/// Collects what GLFW reports and hands it out in portions that one frame can answer.
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <utility>
#include <variant>
#include <vector>

#include "app/platform/key_queue.h"
#include "app/ui/frame.h"

struct GLFWwindow;

namespace batten::platform {

class Input {
  public:
    using KeySink = std::function<void(const KeyEvent&)>;

    /// Installs the callbacks of everything but keys; the object must stay where it is while the window lives, and uses
    /// the window's user pointer.
    void listen_to(GLFWwindow* window);

    /// The window is gone: what it had held down is released.
    void let_go();

    /// Installs the callbacks of keys, which are also handed to `sink`. When it `looks_once_a_frame`, keys wait so that
    /// each frame sees what happened in order, however long the frame before took.
    void listen_to_keys(GLFWwindow* window, KeySink sink, bool looks_once_a_frame);

    /// Hands out the keys that the coming frame may see; call once before each.
    void deliver_keys();

    /// Whether anything happened since the last call.
    bool take_activity() { return std::exchange(was_active_, false); }

    /// Whether more than one portion is waiting.
    bool is_pending() const { return !events_.empty() || !waiting_keys_.is_empty(); }

    /// The next events: up to and including one press or release, so that each meets the state that its predecessors
    /// made.
    ui::FrameInput take();

    // What was handed out so far.
    glm::dvec2 handled_position_px() const { return handled_.position_px; }
    int handled_buttons_down() const { return handled_.buttons_down; }
    std::size_t handled_press_count() const { return handled_.press_count; }
    std::size_t handled_key_count() const { return handled_.key_count; }

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
        std::size_t key_count = 0;
    };

    editor::PointerEvent pointer_event(editor::PointerAction action) const;
    void add(const editor::PointerEvent& event);
    void on_key(const KeyEvent& event);
    void on_printed(unsigned character);
    void deliver(const KeyEvent& event);
    void on_button(int button, int action, int modifiers);
    void note_handled(const editor::PointerEvent& event);
    bool is_near_last_press() const;
    bool completes_double_click(editor::PointerButton button);

    std::deque<Event> events_;
    KeyQueue waiting_keys_;
    KeySink key_sink_;
    bool sink_looks_once_a_frame_ = false;
    std::vector<std::filesystem::path> dropped_files_;
    glm::dvec2 position_px_{};
    editor::Modifiers modifiers_;
    bool space_is_held_ = false;
    int last_key_ = 0;  ///< that went down
    bool was_active_ = true;
    Press last_press_;
    int buttons_down_ = 0;
    editor::PointerButton last_button_ = editor::PointerButton::none;  ///< that went down
    Handled handled_;
};

}  // namespace batten::platform
