/// The shapes of the pointer, of the desktop's theme.
#pragma once

#include <array>

#include "app/editor/pointer/cursor.h"

struct GLFWcursor;
struct GLFWwindow;

namespace batten::platform {

/// Lives as long as GLFW does; shapes that the desktop does not have are shown as the arrow.
class Cursors {
  public:
    Cursors();
    ~Cursors();
    Cursors(const Cursors&) = delete;
    Cursors& operator=(const Cursors&) = delete;

    /// Gives the pointer this shape over `window`.
    void show(GLFWwindow* window, editor::Cursor cursor);

    /// The window is a new one, over which the pointer is an arrow.
    void forget() { shown_ = editor::Cursor::arrow; }

  private:
    std::array<GLFWcursor*, core::Names<editor::Cursor>::table.size()> cursors_{};
    editor::Cursor shown_ = editor::Cursor::arrow;
};

}  // namespace batten::platform
