#include "app/platform/window.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <utility>

#include "core/base/sentence.h"

namespace batten::platform {

namespace {

constexpr int least_width = 640;
constexpr int least_height = 400;

std::string last_glfw_error() {
    const char* description = nullptr;
    glfwGetError(&description);
    return description == nullptr ? "no reason given" : description;
}

void set_hints() {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    // That a driver lost the context is an error then, which ends the program with a sentence.
    glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET);
    glfwWindowHint(GLFW_DEPTH_BITS, 24);  // translucent lines that cross themselves are painted with its help
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "batten");
    glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "batten");
}

/// A remembered place is only good while a monitor still shows it.
bool is_on_a_monitor(const editor::WindowGeometry& geometry) {
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    return std::any_of(monitors, monitors + count, [&](GLFWmonitor* monitor) {
        int x = 0;
        int y = 0;
        int width = 0;
        int height = 0;
        glfwGetMonitorWorkarea(monitor, &x, &y, &width, &height);
        return geometry.x >= x - 50 && geometry.y >= y - 50 && geometry.x < x + width - 100 &&
               geometry.y < y + height - 100;
    });
}

/// The first window fits the display, which a projector may make small.
glm::ivec2 first_size() {
    glm::ivec2 size{1440, 900};
    if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) {
        int x = 0;
        int y = 0;
        glm::ivec2 area{};
        glfwGetMonitorWorkarea(monitor, &x, &y, &area.x, &area.y);
        float scale = 1.0F;
        glfwGetMonitorContentScale(monitor, &scale, nullptr);
        size = {static_cast<int>(static_cast<float>(size.x) * scale),
                static_cast<int>(static_cast<float>(size.y) * scale)};
        size = {std::clamp(size.x, least_width, std::max(area.x, least_width)),
                std::clamp(size.y, least_height, std::max(area.y, least_height))};
    }
    return size;
}

/// A window that is not shown yet; null where none can be opened.
GLFWwindow* make_window(const std::optional<editor::WindowGeometry>& geometry) {
    set_hints();
    const glm::ivec2 size = geometry ? glm::ivec2{geometry->width, geometry->height} : first_size();
    GLFWwindow* handle = glfwCreateWindow(size.x, size.y, "Batten", nullptr, nullptr);
    if (handle == nullptr) return nullptr;
    if (geometry && is_on_a_monitor(*geometry)) glfwSetWindowPos(handle, geometry->x, geometry->y);
    if (geometry && geometry->is_maximized) glfwMaximizeWindow(handle);
    glfwSetWindowSizeLimits(handle, least_width, least_height, GLFW_DONT_CARE, GLFW_DONT_CARE);
    return handle;
}

}  // namespace

tl::expected<std::unique_ptr<Window>, std::string> Window::open(const std::optional<editor::WindowGeometry>& geometry) {
    if (glfwInit() == GLFW_FALSE)
        return tl::unexpected(core::sentence("no display can be opened: {reason}", {{"reason", last_glfw_error()}}));
    GLFWwindow* handle = make_window(geometry);
    if (handle == nullptr) {
        const std::string reason = last_glfw_error();
        glfwTerminate();
        return tl::unexpected(
            core::sentence("no window with OpenGL 3.3 can be opened: {reason}", {{"reason", reason}}));
    }
    return std::unique_ptr<Window>(new Window(handle));
}

Window::Window(GLFWwindow* handle) {
    begin(handle);
}

Window::~Window() {
    glfwDestroyWindow(handle_);
    glfwTerminate();
}

void Window::begin(GLFWwindow* handle) {
    handle_ = handle;
    glfwMakeContextCurrent(handle);
    glfwSwapInterval(1);
    reset_status_ = nullptr;
    if (glfwExtensionSupported("GL_ARB_robustness") == GLFW_TRUE)
        reset_status_ = reinterpret_cast<ResetStatus>(glfwGetProcAddress("glGetGraphicsResetStatusARB"));
    glfwShowWindow(handle);
    input_.listen_to(handle);
}

bool Window::has_lost_context() const {
    return reset_status_ != nullptr && reset_status_() != 0;
}

tl::expected<void, std::string> Window::renew() {
    constexpr int most_tries = 20;
    constexpr double seconds_between = 0.25;
    const bool was_full_screen = is_full_screen();
    const editor::WindowGeometry before = geometry();
    windowed_ = before;  // also told of a window that is closed
    input_.let_go();
    glfwDestroyWindow(std::exchange(handle_, nullptr));
    GLFWwindow* handle = make_window(before);
    for (int i = 1; handle == nullptr && i < most_tries; ++i) {
        glfwWaitEventsTimeout(seconds_between);
        handle = make_window(before);
    }
    if (handle == nullptr)
        return tl::unexpected(
            core::sentence("the graphics driver lost the window, and no other can be opened ({reason}); the next start "
                           "offers what is not saved",
                           {{"reason", last_glfw_error()}}));
    begin(handle);
    title_.clear();
    windowed_.reset();
    if (was_full_screen) set_full_screen(true);
    return {};
}

glm::ivec2 Window::size_px() const {
    glm::ivec2 size{};
    glfwGetWindowSize(handle_, &size.x, &size.y);
    return size;
}

glm::ivec2 Window::framebuffer_px() const {
    glm::ivec2 size{};
    glfwGetFramebufferSize(handle_, &size.x, &size.y);
    return size;
}

double Window::display_scale() const {
    float content_scale = 1.0F;
    glfwGetWindowContentScale(handle_, &content_scale, nullptr);
    glm::ivec2 window = size_px();
    glm::ivec2 framebuffer = framebuffer_px();
    // Sizes before and after a change of the window do not belong together.
    constexpr int most_tries = 10;
    for (int i = 0; i < most_tries && window != size_px(); ++i) {
        window = size_px();
        framebuffer = framebuffer_px();
    }
    if (window.x <= 0 || framebuffer.x <= 0) return 1.0;
    // Where the framebuffer is denser than the window, the desktop has applied that part of the scale already.
    return static_cast<double>(content_scale) * window.x / framebuffer.x;
}

double Window::frame_seconds() const {
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
    const int rate = mode == nullptr || mode->refreshRate <= 0 ? 60 : mode->refreshRate;
    return 1.0 / rate;
}

namespace {

/// The screen on which the middle of the window is; else the first one.
GLFWmonitor* monitor_of(const editor::WindowGeometry& window) {
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    const int x = window.x + window.width / 2;
    const int y = window.y + window.height / 2;
    for (int i = 0; i < count; ++i) {
        glm::ivec2 corner{};
        glfwGetMonitorPos(monitors[i], &corner.x, &corner.y);
        const GLFWvidmode* mode = glfwGetVideoMode(monitors[i]);
        if (mode != nullptr && corner.x <= x && x < corner.x + mode->width && corner.y <= y &&
            y < corner.y + mode->height)
            return monitors[i];
    }
    return glfwGetPrimaryMonitor();
}

}  // namespace

bool Window::is_full_screen() const {
    return handle_ != nullptr && glfwGetWindowMonitor(handle_) != nullptr;
}

void Window::set_full_screen(bool is_full) {
    if (is_full == is_full_screen()) return;
    if (!is_full) {
        glfwSetWindowMonitor(handle_, nullptr, windowed_->x, windowed_->y, windowed_->width, windowed_->height,
                             GLFW_DONT_CARE);
        windowed_.reset();
        return;
    }
    const editor::WindowGeometry before = geometry();
    GLFWmonitor* monitor = monitor_of(before);
    const GLFWvidmode* mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
    if (mode == nullptr) return;
    windowed_ = before;
    glfwSetWindowMonitor(handle_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

editor::WindowGeometry Window::geometry() const {
    if (windowed_) return *windowed_;
    editor::WindowGeometry geometry;
    glfwGetWindowPos(handle_, &geometry.x, &geometry.y);
    glfwGetWindowSize(handle_, &geometry.width, &geometry.height);
    geometry.is_maximized = glfwGetWindowAttrib(handle_, GLFW_MAXIMIZED) == GLFW_TRUE;
    return geometry;
}

void Window::set_title(const std::string& title) {
    if (title == title_) return;
    title_ = title;
    glfwSetWindowTitle(handle_, title.c_str());
}

bool Window::take_close_request() {
    const bool is_asked = glfwWindowShouldClose(handle_) == GLFW_TRUE;
    if (is_asked) glfwSetWindowShouldClose(handle_, GLFW_FALSE);
    return is_asked;
}

std::string Window::read_clipboard() const {
    const char* text = glfwGetClipboardString(handle_);
    return text == nullptr ? std::string() : text;
}

void Window::write_clipboard(const std::string& text) {
    glfwSetClipboardString(handle_, text.c_str());
}

void Window::show_frame() {
    glfwSwapBuffers(handle_);
}

void Window::wait(std::optional<double> seconds) {
    if (!seconds) {
        glfwWaitEvents();
    } else if (*seconds > 0.0) {
        glfwWaitEventsTimeout(*seconds);
    } else {
        glfwPollEvents();
    }
}

void Window::wake() {
    glfwPostEmptyEvent();
}

}  // namespace batten::platform
