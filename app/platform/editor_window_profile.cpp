#include <utility>

#include "app/editor/commands/file_commands.h"
#include "app/editor/typed_command.h"
#include "app/platform/editor_window.h"
#include "core/base/sentence.h"

namespace batten::platform {

namespace {

constexpr double frames_per_second = 60.0;   ///< of a gesture that is measured
constexpr std::size_t settling_frames = 12;  ///< not measured: in which a gesture begins, and the drivers get ready

}  // namespace

void EditorWindow::draw_scripted(editor::ScriptedFrame frame) {
    Window::wait(0.0);
    for (editor::Command& command : frame.commands) queue_.run(std::move(command));
    // The clock runs as evenly as that of a display that never waits for a frame.
    draw_frame({std::move(frame.pointer_events), {}}, static_cast<double>(clock_.frame_count()) / frames_per_second);
}

tl::expected<std::vector<FrameCost>, std::string> EditorWindow::measure(const ProfileOptions& options) {
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
editor::Outcome<void> EditorWindow::run_whole(const editor::Command& command) {
    constexpr double seconds_between = 0.01;
    editor_.run(command);
    for (; editor_.state().at_work; editor_.follow_work()) Window::wait(seconds_between);
    if (editor_.state().message.is_error) return tl::unexpected(editor_.state().message.text);
    return {};
}

// Opens the file and does what is asked for before the gesture.
editor::Outcome<void> EditorWindow::prepare(const ProfileOptions& options) {
    auto prepared = run_whole(editor::Open{.path = options.file});
    for (const std::string& typed : options.commands) {
        if (!prepared) break;
        draw_scripted({});
        prepared =
            editor::parse_typed_command(typed, editor_.state())
                .and_then([this](const editor::Command& command) { return run_whole(command); })
                .map_error([&](const editor::Refusal& refusal) {
                    return core::sentence("--do '{command}': {refusal}", {{"command", typed}, {"refusal", refusal}});
                });
    }
    return prepared;
}

tl::expected<Profile, std::string> EditorWindow::profile(const ProfileOptions& options) {
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

}  // namespace batten::platform
