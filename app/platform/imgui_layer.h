/// Dear ImGui over the window: its context and its GLFW and OpenGL backends.
#pragma once

#include <cstddef>

#include "app/platform/window.h"

namespace batten::platform {

class ImguiLayer {
  public:
    /// The window's context must be current and its pointer callbacks installed, which are called on. Takes over the
    /// keys.
    explicit ImguiLayer(Window& window);
    ~ImguiLayer();
    ImguiLayer(const ImguiLayer&) = delete;
    ImguiLayer& operator=(const ImguiLayer&) = delete;

    /// Lets go of the window and its context, as long as that is current; nothing is drawn then.
    void leave_window();

    /// Draws in this window from now on, as in the one at the beginning. The fonts are to be renewed.
    void enter_window(Window& window);

    /// Hands the font atlas to OpenGL again after it was filled anew.
    void renew_font_texture();

    /// The pointer is nowhere for it from now on.
    void ignore_pointer();

    void begin_frame();

    /// Returns how many vertices it took.
    std::size_t paint_frame();

  private:
    bool is_in_window_ = false;
    bool has_begun_frame_ = false;  ///< in this window
};

}  // namespace batten::platform
