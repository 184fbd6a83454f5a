#include "app/editor/editor.h"

#include <utility>

#include "app/editor/commands/file_acts.h"
#include "app/editor/lesson/recording.h"
#include "app/editor/run_command.h"
#include "app/editor/upkeep.h"
#include "app/editor/work.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

// What is seen and said of a command at work.
void show_work(EditorState& state, const Command& command) {
    const std::string text = core::filled_as_needed(command.spec().at_work, places_of(command, state));
    state.at_work = AtWork{text, std::nullopt};
    state.dialog = Dialog::at_work;
}

// One case for each thing that a queue may hold.
struct Perform {
    Editor& editor;

    void operator()(const CommandRequest& request) const { editor.run(request.command, request.phase); }
    void operator()(const CancelPreview&) const { editor.cancel_preview(); }
    void operator()(const CancelWork&) const { editor.cancel_work(); }
    void operator()(const ViewChange& change) const { editor.change(change); }
};

}  // namespace

// What is asked for while a command is at work, and what it interrupts.
struct Editor::AtWorkNow {
    AtWorkNow(const Command& begun, const EditorState& state)
        : command(begun),
          work(
              state, [begun](EditorState& copy) { return run_checked(copy, begun, Phase::commit); },
              state.desktop.wake),
          dialog(state.dialog) {}

    Command command;
    Work work;
    Dialog dialog;                           // that it hides
    std::vector<ViewChange> changes{};       // made meanwhile, to be made to its result as well
    std::vector<CommandRequest> requests{};  // that wait for its end
};

Editor::Editor(Desktop desktop) {
    state_.desktop = std::move(desktop);
}

Editor::Editor(core::Document document) {
    show_document(state_, std::move(document), {});
}

Editor::~Editor() = default;
Editor::Editor(Editor&& other) noexcept = default;
Editor& Editor::operator=(Editor&& other) noexcept = default;

void Editor::apply(const Settings& settings) {
    apply_settings(state_, settings);
}

bool Editor::run(const Command& command, Phase phase) {
    if (at_work_ == nullptr) return run_here(command, phase);
    if (command.as<Quit>() != nullptr) cancel_work();
    at_work_->requests.push_back({command, phase});
    return false;
}

bool Editor::run_here(const Command& command, Phase phase) {
    const bool may_take_long = command.spec().at_work != nullptr && phase == Phase::commit && state_.desktop.wake;
    if (may_take_long && is_large(state_, command)) return begin_work(command);
    const bool is_done = run_checked(state_, command, phase);
    if (is_done && phase == Phase::commit) note(command);
    follow_shown(state_);
    return is_done;
}

void Editor::note(const Command& command) {
    if (command.spec().is_logged) log_.push_back(command);
    record(state_, command);
}

bool Editor::begin_work(const Command& command) {
    constexpr std::chrono::milliseconds moment(100);
    at_work_ = std::make_unique<AtWorkNow>(command, state_);
    if (at_work_->work.wait_for(moment)) return finish_work();
    show_work(state_, command);
    return false;
}

// Takes what the work has come to, and goes on with what has waited for it.
bool Editor::finish_work() {
    const std::unique_ptr<AtWorkNow> ended = std::move(at_work_);
    Outcome<WorkResult> result = ended->work.take();
    const bool is_done = result && result->is_done;
    if (result) {
        result->state.desktop = std::move(state_.desktop);
        state_ = std::move(result->state);
        for (const ViewChange& change : ended->changes) editor::apply(state_, change);
        follow_shown(state_);
    } else {
        const std::string text =
            core::filled_as_needed(ended->command.spec().at_work, places_of(ended->command, state_));
        state_.at_work.reset();
        state_.dialog = ended->dialog;
        state_.message = {core::sentence("{work}: {outcome}", {{"work", text}, {"outcome", result.error()}}),
                          !ended->work.is_canceled()};
    }
    if (is_done) note(ended->command);
    for (const CommandRequest& request : ended->requests) run(request.command, request.phase);
    return is_done;
}

bool Editor::follow_work() {
    if (at_work_ == nullptr || !state_.at_work) return false;
    if (at_work_->work.is_finished()) {
        finish_work();
        return true;
    }
    const auto before = std::exchange(state_.at_work->share, at_work_->work.share());
    if (before == state_.at_work->share) return false;
    state_.at_work->sketch = at_work_->work.sketch();
    return true;
}

void Editor::cancel_work() {
    if (at_work_ == nullptr || !state_.at_work) return;
    at_work_->work.cancel();
    at_work_->requests.clear();
    state_.at_work->is_canceled = true;
}

void Editor::cancel_preview() {
    state_.preview.reset();
    state_.ghost.reset();
    follow_shown(state_);
}

void Editor::change(const ViewChange& change) {
    if (at_work_ != nullptr) at_work_->changes.push_back(change);
    editor::apply(state_, change);
}

void Editor::perform(const Request& request) {
    std::visit(Perform{*this}, request);
}

void Editor::perform(CommandQueue& queue) {
    for (const Request& request : queue.take()) perform(request);
}

}  // namespace batten::editor
