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

    /// Hands the font atlas to OpenGL again after it was filled anew.
    void renew_font_texture();

    /// The pointer is nowhere for it from now on.
    void ignore_pointer();

    void begin_frame();

    /// Returns how many vertices it took.
    std::size_t paint_frame();
};

}  // namespace batten::platform
