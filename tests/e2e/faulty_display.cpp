// Stands between the editor and GLFW (LD_PRELOAD), and has the display do what a real one seldom does: what the files
// in the folder BATTEN_FAULTS ask for. "reset": the driver loses the context once. "no-window": no new one can be
// opened. "scale": the window is on a monitor of the scale that stands in the file. "unplug": the monitor that the
// window covers is taken away. "drop": the files that it names, one in each line, are dropped on the window.
// "count-textures": how many textures the context has is written to "textures". "give-back": what is free goes back to
// the system.
#include <GLFW/glfw3.h>
#include <dlfcn.h>
#include <malloc.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

namespace {

template <class Function>
Function real(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

std::string fault_path(const char* name) {
    const char* folder = std::getenv("BATTEN_FAULTS");
    return std::string(folder == nullptr ? "/nonexistent" : folder) + "/" + name;
}

bool is_asked(const char* name) {
    return std::ifstream(fault_path(name)).good();
}

// Whether it is asked for; it is not any more then.
bool take(const char* name) {
    return std::remove(fault_path(name).c_str()) == 0;
}

float asked_scale() {
    float scale = 0.0F;
    std::ifstream(fault_path("scale")) >> scale;
    return scale;
}

constexpr unsigned innocent_context_reset = 0x8254;

unsigned reset_status() {
    return take("reset") ? innocent_context_reset : 0;
}

void count_textures() {
    constexpr unsigned most = 1000;  // names are given in order
    const auto is_texture = reinterpret_cast<unsigned char (*)(unsigned)>(glfwGetProcAddress("glIsTexture"));
    int count = 0;
    for (unsigned name = 1; name < most; ++name) count += is_texture(name) != 0 ? 1 : 0;
    std::ofstream(fault_path("textures")) << count;
}

void give_back() {
    if (const auto purge = reinterpret_cast<void (*)()>(dlsym(RTLD_DEFAULT, "__sanitizer_purge_allocator"))) purge();
    malloc_trim(0);
}

struct Faults {
    GLFWwindow* window = nullptr;
    GLFWwindowcontentscalefun scale_changed = nullptr;
    GLFWdropfun dropped = nullptr;
    float told_scale = 0.0F;

    // What a desktop does on its own while the program waits.
    void happen() {
        if (is_asked("give-back")) {
            give_back();
            take("give-back");
        }
        if (const float scale = asked_scale(); scale != told_scale) {
            told_scale = scale;
            if (scale_changed != nullptr) scale_changed(window, scale, scale);
        }
        if (window != nullptr && take("unplug")) glfwSetWindowMonitor(window, nullptr, 0, 0, 800, 600, 0);
        if (window != nullptr && dropped != nullptr && is_asked("drop")) drop();
    }

    void drop() const {
        std::ifstream file(fault_path("drop"));
        std::vector<std::string> lines;
        for (std::string line; std::getline(file, line);) lines.push_back(line);
        std::vector<const char*> names;
        for (const std::string& line : lines) names.push_back(line.c_str());
        if (take("drop")) dropped(window, static_cast<int>(names.size()), names.data());
    }
};
Faults faults;

}  // namespace

extern "C" {

GLFWglproc glfwGetProcAddress(const char* name) {
    if (std::strcmp(name, "glGetGraphicsResetStatusARB") == 0) return reinterpret_cast<GLFWglproc>(&reset_status);
    return real<GLFWglproc (*)(const char*)>("glfwGetProcAddress")(name);
}

int glfwExtensionSupported(const char* name) {
    if (std::strcmp(name, "GL_ARB_robustness") == 0) return GLFW_TRUE;
    return real<int (*)(const char*)>("glfwExtensionSupported")(name);
}

GLFWwindow* glfwCreateWindow(int width, int height, const char* title, GLFWmonitor* monitor, GLFWwindow* share) {
    if (is_asked("no-window")) return nullptr;
    faults.window = real<GLFWwindow* (*)(int, int, const char*, GLFWmonitor*, GLFWwindow*)>("glfwCreateWindow")(
        width, height, title, monitor, share);
    return faults.window;
}

void glfwGetWindowContentScale(GLFWwindow* window, float* x, float* y) {
    real<void (*)(GLFWwindow*, float*, float*)>("glfwGetWindowContentScale")(window, x, y);
    const float scale = asked_scale();
    if (scale > 0.0F && x != nullptr) *x = scale;
    if (scale > 0.0F && y != nullptr) *y = scale;
}

GLFWwindowcontentscalefun glfwSetWindowContentScaleCallback(GLFWwindow*, GLFWwindowcontentscalefun changed) {
    faults.scale_changed = changed;
    return nullptr;
}

GLFWdropfun glfwSetDropCallback(GLFWwindow*, GLFWdropfun dropped) {
    faults.dropped = dropped;
    return nullptr;
}

void glfwSwapBuffers(GLFWwindow* window) {
    real<void (*)(GLFWwindow*)>("glfwSwapBuffers")(window);
    if (!is_asked("count-textures")) return;
    count_textures();
    take("count-textures");
}

void glfwWaitEventsTimeout(double seconds) {
    constexpr double look_seconds = 0.02;
    real<void (*)(double)>("glfwWaitEventsTimeout")(seconds < look_seconds ? seconds : look_seconds);
    faults.happen();
}

void glfwWaitEvents() {
    glfwWaitEventsTimeout(1.0);
}

}  // extern "C"
