#include "tests/render/offscreen.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <glad/gl.h>

#include <fstream>
#include <stdexcept>

namespace batten::test {

double Image::red_of_column(int x) const {
    double sum = 0.0;
    for (int y = 0; y < height; ++y) sum += red(x, y);
    return sum;
}

double Image::red_of_all() const {
    double sum = 0.0;
    for (int x = 0; x < width; ++x) sum += red_of_column(x);
    return sum;
}

void write_ppm(const Image& image, const std::string& path) {
    std::ofstream file(path, std::ios::binary);
    file << "P6\n" << image.width << ' ' << image.height << "\n255\n";
    for (const render::Color& pixel : image.pixels) {
        file.put(static_cast<char>(pixel.red)).put(static_cast<char>(pixel.green)).put(static_cast<char>(pixel.blue));
    }
}

OffscreenContext::OffscreenContext() {
    if (glfwInit() != GLFW_TRUE) throw std::runtime_error("There is no display.");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    GLFWwindow* window = glfwCreateWindow(64, 64, "offscreen", nullptr, nullptr);
    if (window == nullptr) throw std::runtime_error("There is no OpenGL 3.3.");
    window_ = window;
    glfwMakeContextCurrent(window);
    glfwSwapInterval(0);
    const auto loaded = render::load_gl(glfwGetProcAddress);
    if (!loaded) throw std::runtime_error(loaded.error());
}

OffscreenContext::~OffscreenContext() {
    glfwDestroyWindow(static_cast<GLFWwindow*>(window_));
    glfwTerminate();
}

OffscreenTarget::OffscreenTarget(glm::ivec2 size_px) : size_px_(size_px) {
    glGenFramebuffers(1, &framebuffer_);
    glGenRenderbuffers(1, &color_);
    glGenRenderbuffers(1, &depth_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glBindRenderbuffer(GL_RENDERBUFFER, color_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size_px.x, size_px.y);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_);
    glBindRenderbuffer(GL_RENDERBUFFER, depth_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, size_px.x, size_px.y);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw std::runtime_error("The framebuffer is not complete.");
    }
}

OffscreenTarget::~OffscreenTarget() {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteRenderbuffers(1, &color_);
    glDeleteRenderbuffers(1, &depth_);
}

Image OffscreenTarget::read() const {
    const auto count = static_cast<std::size_t>(size_px_.x) * static_cast<std::size_t>(size_px_.y);
    std::vector<render::Color> rows(count);
    glReadPixels(0, 0, size_px_.x, size_px_.y, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
    Image image{size_px_.x, size_px_.y, {}};
    image.pixels.reserve(count);
    for (int y = size_px_.y - 1; y >= 0; --y) {
        const auto row = rows.begin() + static_cast<std::ptrdiff_t>(y) * size_px_.x;
        image.pixels.insert(image.pixels.end(), row, row + size_px_.x);
    }
    return image;
}

}  // namespace batten::test
