#include "app/platform/application.h"

#include <GLFW/glfw3.h>
#include <fmt/core.h>

#include <ctime>
#include <fstream>
#include <functional>
#include <iostream>
#include <utility>

#include "app/editor/commands/dropped_file.h"
#include "app/editor/commands/file_commands.h"
#include "app/editor/commands/help_commands.h"
#include "app/editor/commands/recovery_commands.h"
#include "app/editor/editor.h"
#include "app/editor/recovery/journal_keeper.h"
#include "app/editor/recovery/journal_reader.h"
#include "app/editor/scene/canvas_scene.h"
#include "app/editor/scene/legend.h"
#include "app/editor/scene/plot_scene.h"
#include "app/editor/session.h"
#include "app/editor/state/settings.h"
#include "app/editor/typed_command.h"
#include "app/platform/cursors.h"
#include "app/platform/figure_writer.h"
#include "app/platform/frame_clock.h"
#include "app/platform/imgui_layer.h"
#include "app/platform/picture_viewport.h"
#include "app/platform/state_report.h"
#include "app/platform/window.h"
#include "app/ui/interface.h"
#include "app/ui/style.h"
#include "core/base/sentence.h"
#include "render/gl_painter.h"

namespace batten::platform {

namespace {

constexpr double frames_per_second = 60.0;   ///< of a gesture that is measured
constexpr std::size_t settling_frames = 12;  ///< not measured: in which a gesture begins, and the drivers get ready

int say_failure(const std::string& sentence) {
    std::cerr << "batten: " << sentence << '\n';
    return 1;
}

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

/// Everything that lives as long as the window.
class Application {
  public:
    Application(Window& window, render::GlPainter painter, const editor::Settings& settings, const Options& options,
                std::filesystem::path journals)
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

    int run();

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

    Window& window_;
    ImguiLayer imgui_;
    render::GlPainter painter_;
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

void Application::open_start_document() {
    if (!options_.files.empty()) {
        open_files(options_.files);
    } else if (options_.example) {
        editor_.run(editor::OpenExample{.name = *options_.example});
    } else {
        editor_.run(editor::ToggleWelcome{});
    }
}

// What sessions before left unsaved; over the document that was opened, once it is.
void Application::offer_recovery() {
    if (journals_.empty()) return;
    std::vector<editor::Recoverable> found = editor::find_recoverable(journals_);
    if (found.empty()) return;
    editor_.change(editor::OfferRecovery{std::move(found)});
    editor_.run(editor::ShowRecovery{});
}

void Application::follow_journal() {
    journal_.follow(editor_.state(), std::time(nullptr));
    if (const auto trouble = journal_.take_trouble()) {
        editor_.change(editor::ShowRefusal{*trouble, false});
        clock_.note_activity();
    }
}

void Application::open_files(const std::vector<std::filesystem::path>& files) {
    for (const std::filesystem::path& file : files) {
        editor_.run(editor::command_for_file(editor_.state(), file, &file == &files.front()));
    }
}

void Application::take_window_requests() {
    if (window_.take_close_request()) queue_.run(editor::Quit{});
    const std::vector<std::filesystem::path> dropped = window_.input().take_dropped_files();
    for (const std::filesystem::path& file : dropped)
        queue_.run(editor::command_for_file(editor_.state(), file, file == dropped.front()));
}

void Application::follow_scale() {
    const editor::View& view = editor_.state().view;
    const double display_scale = options_.display_scale.value_or(window_.display_scale());
    const double scale = display_scale * view.user_scale * (view.is_presenting ? editor::presenting_scale : 1.0);
    if (scale != view.interface_scale) editor_.change(editor::SetInterfaceScale{scale});
    if (scale == fonts_.scale && fonts_.text != nullptr) return;
    fonts_ = ui::load_fonts(scale);
    imgui_.renew_font_texture();
    styled_theme_.reset();
}

void Application::follow_presenting() {
    const bool is_presenting = editor_.state().view.is_presenting;
    if (is_presenting != window_.is_full_screen()) window_.set_full_screen(is_presenting);
}

void Application::follow_theme() {
    const editor::View& view = editor_.state().view;
    const editor::Theme theme = editor::shown_theme(view);
    if (styled_theme_ == theme) return;
    styled_theme_ = theme;
    ui::apply_style(theme, view.interface_scale);
}

void Application::paint(const render::DrawList& picture, const ui::Rectangle& place, render::Color background) {
    const glm::ivec2 window = window_.size_px();
    const glm::ivec2 framebuffer = window_.framebuffer_px();
    const render::Viewport viewport = picture_viewport(place, window, framebuffer);
    if (viewport.size_px.x <= 0 || viewport.size_px.y <= 0) return;
    meter_.enter(FramePart::upload);
    painter_.upload(picture, viewport, static_cast<float>(framebuffer_density(window, framebuffer)));
    meter_.add_vertices(painter_.vertex_count());
    meter_.enter(FramePart::draw);
    painter_.draw(viewport, background);
}

void Application::deliver_keys() {
    const editor::Dialog dialog = editor_.state().dialog;
    dialog_age_ = dialog == last_dialog_ ? dialog_age_ + 1 : 0;
    last_dialog_ = dialog;
    // A dialog has the keyboard from its second frame on; what is typed meanwhile waits for it.
    if (dialog == editor::Dialog::none || dialog_age_ >= 2) window_.input().deliver_keys();
}

void Application::draw_frame(ui::FrameInput input, double now) {
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

void Application::run_requests() {
    meter_.enter(FramePart::commands);
    if (!queue_.is_empty()) clock_.note_activity();
    editor_.perform(queue_);
}

void Application::show(const ui::FrameLayout& layout) {
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

void Application::write_log() {
    if (!session_log_.is_open()) return;
    for (; logged_ < editor_.log().size(); ++logged_) {
        session_log_ << editor::format_command(editor_.log()[logged_]) << std::endl;
    }
}

int Application::run() {
    open_start_document();
    offer_recovery();
    while (!editor_.state().wants_quit) {
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
        const std::string error = render::pending_gl_error();
        if (!error.empty()) return say_failure(core::sentence("OpenGL reports {error}", {{"error", error}}));
    }
    journal_.end();
    return 0;
}

void Application::draw_scripted(editor::ScriptedFrame frame) {
    Window::wait(0.0);
    for (editor::Command& command : frame.commands) queue_.run(std::move(command));
    // The clock runs as evenly as that of a display that never waits for a frame.
    draw_frame({std::move(frame.pointer_events), {}}, static_cast<double>(clock_.frame_count()) / frames_per_second);
}

tl::expected<std::vector<FrameCost>, std::string> Application::measure(const ProfileOptions& options) {
    const editor::EditorState& state = editor_.state();
    for (std::size_t i = 0; i < settling_frames; ++i) draw_scripted({});
    const glm::dvec2 start_px =
        start_of(options.gesture, state, {layout_.canvas.origin_px, layout_.plot.origin_px, layout_.plot.size_px});
    std::vector<FrameCost> costs;
    for (std::size_t i = 0; i < settling_frames + options.frame_count && !state.wants_quit; ++i) {
        draw_scripted(scripted_frame(options.gesture, i, start_px, state));
        const FrameCost cost = meter_.take();
        if (i >= settling_frames) costs.push_back(cost);
    }
    if (state.wants_quit) return tl::unexpected(std::string("the window was closed before all frames were drawn"));
    if (state.active_curve() != nullptr && !is_under_way(options.gesture, state))
        return tl::unexpected(core::sentence("the gesture '{gesture}' does nothing to the active curve",
                                             {{"gesture", core::name_of(options.gesture)}}));
    draw_scripted(last_frame(options.gesture, start_px));
    return costs;
}

// Waits for what works beside the frames.
editor::Outcome<void> Application::run_whole(const editor::Command& command) {
    constexpr double seconds_between = 0.01;
    editor_.run(command);
    for (; editor_.state().at_work; editor_.follow_work()) Window::wait(seconds_between);
    if (editor_.state().message.is_error) return tl::unexpected(editor_.state().message.text);
    return {};
}

// Opens the file and does what is asked for before the gesture.
editor::Outcome<void> Application::prepare(const ProfileOptions& options) {
    auto prepared = run_whole(editor::Open{.path = options.file});
    for (const std::string& typed : options.commands) {
        if (!prepared) break;
        draw_scripted({});
        prepared = editor::parse_typed_command(typed, editor_.state()).and_then([this](const editor::Command& command) {
            return run_whole(command);
        });
    }
    return prepared;
}

tl::expected<Profile, std::string> Application::profile(const ProfileOptions& options) {
    imgui_.ignore_pointer();
    draw_scripted({});
    const double start_ms = processor_ms();
    auto empty = measure(options);
    if (!empty) return tl::unexpected(empty.error());
    if (const auto prepared = prepare(options); !prepared) return tl::unexpected(prepared.error());
    return measure(options).map([&](std::vector<FrameCost> frames) {
        return Profile{options, std::move(frames), *std::move(empty), start_ms};
    });
}

editor::Settings Application::settings() const {
    editor::Settings settings = editor::settings_of(editor_.state());
    settings.window = window_.geometry();
    return settings;
}

/// Says why the window cannot be opened, or gives it with its painter to `use`, whose exit status it returns.
int with_window(const std::optional<editor::WindowGeometry>& geometry,
                const std::function<int(Window&, render::GlPainter)>& use) {
    const auto window = Window::open(geometry);
    if (!window) return say_failure(window.error());
    const auto loaded = render::load_gl(glfwGetProcAddress);
    if (!loaded) return say_failure(loaded.error());
    auto painter = render::GlPainter::make();
    if (!painter) return say_failure(painter.error());
    return use(**window, std::move(*painter));
}

}  // namespace

int run(const Options& options) {
    const std::filesystem::path settings_path = editor::settings_path();
    const editor::Settings settings = editor::load_settings(settings_path);
    return with_window(settings.window, [&](Window& window, render::GlPainter painter) {
        Application application(window, std::move(painter), settings, options, editor::recovery_folder());
        const int status = application.run();
        editor::save_settings(application.settings(), settings_path);
        return status;
    });
}

int profile(const ProfileOptions& options, bool as_json, std::ostream& results) {
    return with_window(std::nullopt, [&](Window& window, render::GlPainter painter) {
        const Options no_options;
        Application application(window, std::move(painter), {}, no_options, {});
        const auto found = application.profile(options);
        if (!found) return say_failure(found.error());
        if (as_json)
            print_json(results, *found);
        else
            print_text(results, *found);
        return 0;
    });
}

}  // namespace batten::platform
