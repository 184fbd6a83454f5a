/// The window of the desktop with its OpenGL 3.3 context.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "app/editor/state/settings.h"
#include "app/platform/input.h"

struct GLFWwindow;

namespace batten::platform {

class Window {
  public:
    /// Opens the window and makes its context current. The error is one sentence: no display, or no OpenGL 3.3.
    [[nodiscard]] static tl::expected<std::unique_ptr<Window>, std::string> open(
        const std::optional<editor::WindowGeometry>& geometry);

    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Whether the driver gave up the context, as after a reset; nothing more is drawn on it.
    bool has_lost_context() const;

    /// Puts a new window with a new context in its place, and tries so for a few seconds, as a driver may take them.
    /// What was made on the old context must be gone. The error is one sentence; the window is closed then.
    [[nodiscard]] tl::expected<void, std::string> renew();

    GLFWwindow* handle() const { return handle_; }
    Input& input() { return input_; }

    glm::ivec2 size_px() const;         ///< in window pixels, as pointer positions are
    glm::ivec2 framebuffer_px() const;  ///< in pixels of the framebuffer

    /// Window pixels for one design pixel, from the display alone.
    double display_scale() const;

    /// Seconds between two frames of the display.
    double frame_seconds() const;

    editor::WindowGeometry geometry() const;
    /// Whether the window covers the screen.
    bool is_full_screen() const;

    /// Covers the screen on which most of the window is, or goes back to where the window was.
    void set_full_screen(bool is_full);

    void set_title(const std::string& title);

    /// Whether the user asked to close the window since the last call.
    bool take_close_request();

    std::string read_clipboard() const;
    void write_clipboard(const std::string& text);

    void show_frame();

    /// Sleeps until something happens, at most `seconds`; without a limit until it does.
    static void wait(std::optional<double> seconds);

    /// Ends the sleep; may be called from other threads.
    static void wake();

  private:
    using ResetStatus = unsigned (*)();

    explicit Window(GLFWwindow* handle);
    void begin(GLFWwindow* handle);

    GLFWwindow* handle_ = nullptr;        // null: closed
    ResetStatus reset_status_ = nullptr;  // null: the driver does not tell
    Input input_;
    std::string title_;
    std::optional<editor::WindowGeometry> windowed_;  ///< where it was before it covered the screen
};

}  // namespace batten::platform
