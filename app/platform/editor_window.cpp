#include "app/platform/editor_window.h"

#include <GLFW/glfw3.h>
#include <fmt/core.h>

#include <ctime>
#include <utility>

#include "app/editor/commands/dropped_file.h"
#include "app/editor/commands/file_commands.h"
#include "app/editor/commands/help_commands.h"
#include "app/editor/commands/recovery_commands.h"
#include "app/editor/recovery/journal_reader.h"
#include "app/editor/scene/legend.h"
#include "app/editor/scene/plot_scene.h"
#include "app/editor/session.h"
#include "app/platform/figure_writer.h"
#include "app/platform/picture_viewport.h"
#include "app/platform/state_report.h"
#include "app/ui/style.h"
#include "core/base/sentence.h"

namespace batten::platform {

namespace {

editor::Desktop desktop_of(Window& window, const Options& options) {
    editor::Desktop desktop;
    desktop.read_clipboard = [&window] { return window.read_clipboard(); };
    desktop.write_clipboard = [&window](const std::string& text) { window.write_clipboard(text); };
    desktop.wake = &Window::wake;
    desktop.write_figure = write_figure;
    desktop.examples = options.assets / "examples";
    desktop.lessons = options.assets / "lessons";
    return desktop;
}

}  // namespace

tl::expected<render::GlPainter, std::string> make_painter() {
    return render::load_gl(glfwGetProcAddress).and_then(&render::GlPainter::make);
}

EditorWindow::EditorWindow(Window& window, render::GlPainter painter, const editor::Settings& settings,
                           const Options& options, std::filesystem::path journals)
    : window_(window),
      imgui_(window),
      painter_(std::move(painter)),
      editor_(desktop_of(window, options)),
      journals_(std::move(journals)),
      journal_(journals_, &Window::wake),
      clock_(window.frame_seconds()),
      options_(options) {
    editor_.apply(settings);
    if (options.session_log) session_log_.open(*options.session_log);
}

void EditorWindow::open_start_document() {
    if (!options_.files.empty()) {
        open_files(options_.files);
    } else if (options_.example) {
        editor_.run(editor::OpenExample{.name = *options_.example});
    } else {
        editor_.run(editor::ToggleWelcome{});
    }
}

// What sessions before left unsaved; over the document that was opened, once it is.
void EditorWindow::offer_recovery() {
    if (journals_.empty()) return;
    editor::LeftJournals left = editor::left_journals(journals_);
    if (left.unknown_count > 0)
        editor_.change(editor::ShowRefusal{editor::words_of_unknown_journals(left.unknown_count, journals_), false});
    if (left.documents.empty()) return;
    editor_.change(editor::OfferRecovery{std::move(left.documents)});
    editor_.run(editor::ShowRecovery{});
}

void EditorWindow::follow_journal() {
    journal_.follow(editor_.state(), std::time(nullptr));
    if (const auto trouble = journal_.take_trouble()) {
        editor_.change(editor::ShowRefusal{*trouble, false});
        clock_.note_activity();
    }
}

void EditorWindow::open_files(const std::vector<std::filesystem::path>& files) {
    for (const std::filesystem::path& file : files) {
        editor_.run(editor::command_for_file(editor_.state(), file, &file == &files.front()));
    }
}

void EditorWindow::take_window_requests() {
    if (window_.take_close_request()) queue_.run(editor::Quit{});
    const std::vector<std::filesystem::path> dropped = window_.input().take_dropped_files();
    for (const std::filesystem::path& file : dropped)
        queue_.run(editor::command_for_file(editor_.state(), file, file == dropped.front()));
}

void EditorWindow::follow_scale() {
    const editor::View& view = editor_.state().view;
    const double display_scale = options_.display_scale.value_or(window_.display_scale());
    const double scale = display_scale * view.user_scale * (view.is_presenting ? editor::presenting_scale : 1.0);
    if (scale != view.interface_scale) editor_.change(editor::SetInterfaceScale{scale});
    if (scale == fonts_.scale && fonts_.text != nullptr) return;
    fonts_ = ui::load_fonts(scale);
    imgui_.renew_font_texture();
    styled_theme_.reset();
}

void EditorWindow::follow_presenting() {
    const bool is_presenting = editor_.state().view.is_presenting;
    if (is_presenting != window_.is_full_screen()) window_.set_full_screen(is_presenting);
}

void EditorWindow::follow_theme() {
    const editor::View& view = editor_.state().view;
    const editor::Theme theme = editor::shown_theme(view);
    if (styled_theme_ == theme) return;
    styled_theme_ = theme;
    ui::apply_style(theme, view.interface_scale);
}

void EditorWindow::paint(const render::DrawList& picture, const ui::Rectangle& place, render::Color background) {
    const glm::ivec2 window = window_.size_px();
    const glm::ivec2 framebuffer = window_.framebuffer_px();
    const render::Viewport viewport = picture_viewport(place, window, framebuffer);
    if (viewport.size_px.x <= 0 || viewport.size_px.y <= 0) return;
    meter_.enter(FramePart::upload);
    painter_->upload(picture, viewport, static_cast<float>(framebuffer_density(window, framebuffer)));
    meter_.add_vertices(painter_->vertex_count());
    meter_.enter(FramePart::draw);
    painter_->draw(viewport, background);
}

void EditorWindow::deliver_keys() {
    const editor::Dialog dialog = editor_.state().dialog;
    dialog_age_ = dialog == last_dialog_ ? dialog_age_ + 1 : 0;
    last_dialog_ = dialog;
    // A dialog has the keyboard from its second frame on; what is typed meanwhile waits for it.
    if (dialog == editor::Dialog::none || dialog_age_ >= 2) window_.input().deliver_keys();
}

void EditorWindow::draw_frame(ui::FrameInput input, double now) {
    const double elapsed = clock_.begin_frame(now);
    input.frames_per_second = clock_.frames_per_second();
    const editor::EditorState& state = editor_.state();
    if (state.view.playback.is_playing && elapsed > 0.0) editor_.change(editor::Advance{elapsed});
    editor_.change(editor::TellTime{now});
    take_window_requests();
    follow_presenting();
    follow_scale();
    follow_theme();
    imgui_.begin_frame();
    interface_.take_pointer(state, input, fonts_, queue_);
    run_requests();
    meter_.enter(FramePart::scene);
    editor_.change(editor::PlaceLegend{editor::free_corner(state, scene_cache_)});
    meter_.enter(FramePart::panels);
    // What the panels ask for is run once the frame is shown: all of it shows one state.
    layout_ = interface_.draw(state, input, fonts_, queue_);
    show(layout_);
    run_requests();
}

void EditorWindow::run_requests() {
    meter_.enter(FramePart::commands);
    if (!queue_.is_empty()) clock_.note_activity();
    editor_.perform(queue_);
}

void EditorWindow::show(const ui::FrameLayout& layout) {
    const editor::EditorState& state = editor_.state();
    meter_.enter(FramePart::scene);
    const render::DrawList canvas = editor::canvas_scene(state, interface_.canvas_mode(), scene_cache_);
    const render::DrawList plot = editor::plot_scene(state, interface_.plot_mode(), layout.plot.size_px, scene_cache_);
    meter_.enter(FramePart::draw);
    ui::draw_labels(canvas, layout.canvas, fonts_);
    ui::draw_labels(plot, layout.plot, fonts_);
    const editor::Theme theme = editor::shown_theme(state.view);
    cursors_.show(window_.handle(), layout.cursor);
    paint(canvas, layout.canvas, theme.canvas);
    paint(plot, layout.plot, theme.panel);
    meter_.add_vertices(imgui_.paint_frame());
    window_.set_title(fmt::format("{}{} — Batten", state.file_name(), state.is_modified() ? " •" : ""));
    window_.show_frame();
    if (state.view.playback.is_playing || interface_.is_animating()) clock_.note_animation();
    if (options_.state_report) {
        write_state_report({state, layout, canvas, plot, window_.input(), clock_}, *options_.state_report);
    }
}

void EditorWindow::write_log() {
    if (!session_log_.is_open()) return;
    for (; logged_ < editor_.log().size(); ++logged_) {
        session_log_ << editor::format_command(editor_.log()[logged_]) << std::endl;
    }
}

tl::expected<void, std::string> EditorWindow::run(const std::function<bool()>& is_asked_to_end) {
    open_start_document();
    offer_recovery();
    while (!editor_.state().wants_quit) {
        if (is_asked_to_end()) return {};  // what is unsaved stays in the journal
        if (!window_.input().is_pending()) Window::wait(clock_.seconds_to_wait(glfwGetTime()));
        if (editor_.follow_work()) clock_.note_activity();
        follow_journal();
        if (window_.input().take_activity() || window_.input().is_pending()) clock_.note_activity();
        if (clock_.seconds_to_wait(glfwGetTime()).value_or(1.0) > 0.0) continue;
        deliver_keys();
        draw_frame(window_.input().take(), glfwGetTime());
        meter_.take();
        follow_journal();
        write_log();
        if (auto followed = follow_context(); !followed) return followed;
    }
    journal_.end();
    return {};
}

tl::expected<void, std::string> EditorWindow::follow_context() {
    const std::string error = render::pending_gl_error();
    if (error == render::context_lost_error || window_.has_lost_context()) return renew_context();
    if (error.empty()) return {};
    return tl::unexpected(core::sentence("OpenGL reports {error}", {{"error", error}}));
}

// A driver that was reset, or a graphics card that is gone, took with it what was on the old context.
tl::expected<void, std::string> EditorWindow::renew_context() {
    painter_.reset();
    imgui_.leave_window();
    return window_.renew().and_then(&make_painter).map([this](render::GlPainter painter) {
        painter_.emplace(std::move(painter));
        imgui_.enter_window(window_);
        fonts_ = {};
        cursors_.forget();
        clock_.note_activity();
    });
}

editor::Settings EditorWindow::settings() const {
    editor::Settings settings = editor::settings_of(editor_.state());
    settings.window = window_.geometry();
    return settings;
}

}  // namespace batten::platform
