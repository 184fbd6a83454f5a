#include "app/editor/editor.h"

#include <algorithm>
#include <utility>

#include "app/editor/clipboard.h"
#include "app/editor/command_reader.h"
#include "app/editor/commands/file_acts.h"
#include "app/editor/commands/joint_report.h"
#include "app/editor/same_document.h"
#include "app/editor/upkeep.h"
#include "app/editor/wording.h"
#include "app/editor/work.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/measure/deviation.h"
#include "core/measure/geometric_distance.h"
#include "core/measure/smoothness.h"

namespace batten::editor {

namespace {

// Of the size of a curve, what rounding alone may move it.
constexpr double rounding_of_size = 1e-14;

// The distance of shapes is said where it is below this part of the deviation.
constexpr double much_less = 0.8;

bool show_refusal(EditorState& state, const Refusal& sentence, bool is_alarm = true) {
    state.message = {sentence, is_alarm};
    return false;
}

// The old active curve, where the edit gave the same entry of the document another shape.
std::optional<Ghost> ghost_of(const core::Document& before, const Edit& edit, ShapeEffect effect) {
    const core::Document& after = edit.document;
    const core::DocumentCurve* old_active = before.active_curve();
    const core::DocumentCurve* active = after.active_curve();
    if (effect != ShapeEffect::changes || old_active == nullptr || active == nullptr ||
        before.curves.size() != after.curves.size() || edit.only_adds)
        return std::nullopt;
    return Ghost{old_active->curve,
                 edit.error ? *edit.error : core::largest_deviation(*old_active->curve, *active->curve)};
}

// Places named after the fields, for the texts of a step.
std::vector<core::Place> places_of(const Command& command, const EditorState& state) {
    std::vector<core::Place> places;
    for (const Field& field : command.spec().fields) {
        const FieldValue value = field.get(command.fields());
        if (field.parts.size() == 1) {
            places.emplace_back(field.parts.front().name, shown_text(field, value, state));
            continue;
        }
        const core::Point pair = std::get<core::Point>(value);
        places.emplace_back(field.parts[0].name, core::shortest_text(pair.x));
        places.emplace_back(field.parts[1].name, core::shortest_text(pair.y));
    }
    return places;
}

StepTexts texts_of_step(const Command& command, const EditorState& state, const Edit& edit) {
    const CommandSpec& spec = command.spec();
    if (spec.texts != nullptr) return spec.texts(state, command.fields(), edit);
    const std::vector<core::Place> places = places_of(command, state);
    return {core::filled_as_needed(spec.step != nullptr ? spec.step : spec.title, places),
            core::filled_as_needed(spec.done, places)};
}

bool preview_edit(EditorState& state, const Command& command) {
    Outcome<Edit> edit = command.spec().run.edit(state, command.fields());
    if (!edit) return show_refusal(state, edit.error());
    state.ghost = ghost_of(state.history.present(), *edit, command.spec().effect);
    state.preview = std::move(edit->document);
    if (state.message.is_error) state.message = {};
    return true;
}

// How far the step went. An edit that tells its own error compares other parameters, or shapes.
Distances distances_of(const EditorState& state, const std::optional<Ghost>& ghost, const Edit& edit) {
    Distances distances{.error = edit.error};
    if (!ghost) return distances;
    distances.deviation = ghost->deviation;
    distances.is_rounding = is_within_tolerance(*ghost->curve, ghost->deviation, rounding_of_size);
    if (edit.error || distances.is_rounding) return distances;
    const core::Curve& after = *state.history.present().active_curve()->curve;
    const double of_shapes = core::geometric_distance(*ghost->curve, after);
    if (of_shapes < much_less * ghost->deviation) distances.of_shapes = of_shapes;
    return distances;
}

// The edit as a step of the history, with what is said and shown about it.
void push_step(EditorState& state, const Command& command, Edit& edit) {
    const core::Document before = state.history.present();
    const ShapeEffect effect = command.spec().effect;
    StepTexts texts = texts_of_step(command, state, edit);
    const bool extends = edit.burst && edit.burst->count > 1;
    const std::optional<Ghost> ghost = ghost_of(extends ? state.history.previous() : before, edit, effect);
    if (extends)
        state.history.extend(std::move(texts.step), std::move(edit.document));
    else
        state.history.push(std::move(texts.step), std::move(edit.document));
    state.burst = std::move(edit.burst);
    follow_document(state, before);
    std::vector<std::string> told{done_sentence(texts.done, effect, distances_of(state, ghost, edit))};
    if (edit.remark) told.push_back(*edit.remark);
    if (ghost && command.spec().tells_smoothness)
        if (const auto lost =
                lost_smoothness(core::smoothness_losses(*ghost->curve, *state.history.present().active_curve()->curve)))
            told.push_back(*lost);
    state.message = {*told_in_turn(told), false};
    if (ghost && ghost->deviation != 0.0) state.ghost = ghost;
}

bool commit_edit(EditorState& state, const Command& command) {
    Outcome<Edit> edit = command.spec().run.edit(state, command.fields());
    if (!edit) return show_refusal(state, edit.error());
    if (edit->clipboard) write_clipboard(state, *edit->clipboard);
    state.message = {};
    state.ghost.reset();
    if (!is_same_document(state.history.present(), edit->document)) {
        push_step(state, command, *edit);
    } else {
        state.burst.reset();
        if (!edit->clipboard && !edit->selection) state.message = {nothing_changed_sentence(), false};
    }
    if (edit->selection) state.selection = *edit->selection;
    return true;
}

bool commit_act(EditorState& state, const Command& command) {
    state.message = {};
    state.burst.reset();
    const Outcome<void> outcome = command.spec().run.act(state, command.fields());
    return outcome ? true : show_refusal(state, outcome.error());
}

// Why the command cannot be run now, or not with these fields.
std::optional<Refusal> refusal_of(const EditorState& state, const Command& command) {
    const CommandSpec& spec = command.spec();
    if (spec.refusal != nullptr)
        if (std::optional<Refusal> refusal = spec.refusal(state)) return refusal;
    return check_fields(command, state);
}

bool run_checked(EditorState& state, const Command& command, Phase phase) {
    const CommandSpec& spec = command.spec();
    // The preview belongs to a gesture that an edit replaces or ends, even where the edit is refused.
    if (spec.run.edit != nullptr && std::exchange(state.preview, std::nullopt)) state.ghost.reset();
    if (const std::optional<Refusal> refusal = refusal_of(state, command))
        return show_refusal(state, *refusal, !is_idle(spec, state));
    if (phase == Phase::preview) return spec.run.edit == nullptr || preview_edit(state, command);
    return spec.run.edit != nullptr ? commit_edit(state, command) : commit_act(state, command);
}

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
