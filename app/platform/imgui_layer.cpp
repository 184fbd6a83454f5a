#include "app/platform/imgui_layer.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "app/platform/key_map.h"

namespace batten::platform {

namespace {

#if IMGUI_VERSION_NUM < 18700
constexpr bool looks_at_keys_once_a_frame = true;

/// Ctrl+A in a text field is the key that prints an a.
int key_for_imgui(const KeyEvent& event) {
    return american_key(key_from_glfw(event.key, event.scancode), event.key);
}
#else
constexpr bool looks_at_keys_once_a_frame = false;

/// The backend goes by the layout itself.
int key_for_imgui(const KeyEvent& event) {
    return event.key;
}
#endif

void forward_key(GLFWwindow* window, const KeyEvent& event) {
    if (event.character != 0) {
        ImGui_ImplGlfw_CharCallback(window, event.character);
    } else {
        ImGui_ImplGlfw_KeyCallback(window, key_for_imgui(event), event.scancode, event.action, event.modifiers);
    }
}

}  // namespace

ImguiLayer::ImguiLayer(Window& window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange;  // the window shows the one of the frame
    // A blinking cursor would need frames while nothing happens.
    io.ConfigInputTextCursorBlink = false;
    enter_window(window);
}

ImguiLayer::~ImguiLayer() {
    if (is_in_window_) leave_window();
    ImGui::DestroyContext();
}

void ImguiLayer::enter_window(Window& window) {
    ImGui_ImplGlfw_InitForOpenGL(window.handle(), true);
    ImGui_ImplOpenGL3_Init("#version 330 core");
    window.input().listen_to_keys(
        window.handle(), [handle = window.handle()](const KeyEvent& event) { forward_key(handle, event); },
        looks_at_keys_once_a_frame);
    is_in_window_ = true;
}

void ImguiLayer::leave_window() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    is_in_window_ = false;
    has_begun_frame_ = false;
}

void ImguiLayer::renew_font_texture() {
#if IMGUI_VERSION_NUM < 19200
    // Later versions watch the atlas themselves. The first frame in a window makes the texture, and would not let go of
    // an earlier one.
    if (!has_begun_frame_) return;
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
#endif
}

void ImguiLayer::ignore_pointer() {
    ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NoMouse;
}

void ImguiLayer::begin_frame() {
    has_begun_frame_ = true;
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

std::size_t ImguiLayer::paint_frame() {
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    return static_cast<std::size_t>(ImGui::GetDrawData()->TotalVtxCount);
}

}  // namespace batten::platform
