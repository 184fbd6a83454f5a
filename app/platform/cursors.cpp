#include "app/platform/cursors.h"

#include <GLFW/glfw3.h>

#include <utility>

namespace batten::platform {

namespace {

// GLFW 3.3 has none for all directions.
#ifdef GLFW_RESIZE_ALL_CURSOR
constexpr int move_shape = GLFW_RESIZE_ALL_CURSOR;
#else
constexpr int move_shape = GLFW_HAND_CURSOR;
#endif

int shape_of(editor::Cursor cursor) {
    switch (cursor) {
        case editor::Cursor::hand:
            return GLFW_HAND_CURSOR;
        case editor::Cursor::move:
            return move_shape;
        case editor::Cursor::crosshair:
            return GLFW_CROSSHAIR_CURSOR;
        case editor::Cursor::horizontal:
            return GLFW_HRESIZE_CURSOR;
        case editor::Cursor::vertical:
            return GLFW_VRESIZE_CURSOR;
        case editor::Cursor::text:
            return GLFW_IBEAM_CURSOR;
        case editor::Cursor::arrow:
            break;
    }
    return GLFW_ARROW_CURSOR;
}

}  // namespace

Cursors::Cursors() {
    for (const auto& entry : core::Names<editor::Cursor>::table)
        cursors_[static_cast<std::size_t>(entry.value)] = glfwCreateStandardCursor(shape_of(entry.value));
}

Cursors::~Cursors() {
    for (GLFWcursor* cursor : cursors_) glfwDestroyCursor(cursor);
}

void Cursors::show(GLFWwindow* window, editor::Cursor cursor) {
    if (std::exchange(shown_, cursor) != cursor) glfwSetCursor(window, cursors_[static_cast<std::size_t>(cursor)]);
}

}  // namespace batten::platform
