/// The window with the editor in it, frame after frame.
#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "app/editor/editor.h"
#include "app/editor/recovery/journal_keeper.h"
#include "app/editor/scene/canvas_scene.h"
#include "app/editor/state/settings.h"
#include "app/platform/application.h"
#include "app/platform/cursors.h"
#include "app/platform/frame_clock.h"
#include "app/platform/frame_meter.h"
#include "app/platform/imgui_layer.h"
#include "app/platform/profile.h"
#include "app/platform/window.h"
#include "app/ui/interface.h"
#include "render/gl_painter.h"

namespace batten::platform {

/// A painter for the context that is current, which may be a new one. The error is one sentence.
[[nodiscard]] tl::expected<render::GlPainter, std::string> make_painter();

/// Everything that lives as long as the window.
class EditorWindow {
  public:
    /// Journals stand in the folder `journals`; where that is empty none are kept.
    EditorWindow(Window& window, render::GlPainter painter, const editor::Settings& settings, const Options& options,
                 std::filesystem::path journals);

    /// Draws frames until the user quits, or `is_asked_to_end` holds, which is looked at whenever the window wakes. The
    /// error is one sentence.
    tl::expected<void, std::string> run(const std::function<bool()>& is_asked_to_end);

    /// The error is one sentence.
    tl::expected<Profile, std::string> profile(const ProfileOptions& options);

    editor::Settings settings() const;

  private:
    void open_start_document();
    void offer_recovery();
    void follow_journal();
    void open_files(const std::vector<std::filesystem::path>& files);
    editor::Outcome<void> run_whole(const editor::Command& command);
    editor::Outcome<void> prepare(const ProfileOptions& options);
    void take_window_requests();
    void follow_presenting();
    void follow_scale();
    void follow_theme();
    void deliver_keys();
    void draw_frame(ui::FrameInput input, double now);
    void draw_scripted(editor::ScriptedFrame frame);
    tl::expected<std::vector<FrameCost>, std::string> measure(const ProfileOptions& options);
    void run_requests();
    void show(const ui::FrameLayout& layout);
    void paint(const render::DrawList& picture, const ui::Rectangle& place, render::Color background);
    void write_log();
    tl::expected<void, std::string> follow_context();
    tl::expected<void, std::string> renew_context();

    Window& window_;
    ImguiLayer imgui_;
    std::optional<render::GlPainter> painter_;  ///< none only while the context is renewed
    editor::Editor editor_;
    std::filesystem::path journals_;  ///< the folder of recovery journals; empty: none are kept
    editor::JournalKeeper journal_;
    ui::Interface interface_;
    editor::SceneCache scene_cache_;
    ui::Fonts fonts_;
    std::optional<editor::Theme> styled_theme_;
    editor::CommandQueue queue_;
    FrameClock clock_;
    Cursors cursors_;
    editor::Dialog last_dialog_ = editor::Dialog::none;
    int dialog_age_ = 0;  ///< frames since the dialog changed
    const Options& options_;
    std::ofstream session_log_;
    std::size_t logged_ = 0;
    FrameMeter meter_;
    ui::FrameLayout layout_;  ///< of the last frame
};

}  // namespace batten::platform
