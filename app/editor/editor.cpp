#include "app/editor/editor.h"

#include <algorithm>
#include <utility>

#include "app/editor/clipboard.h"
#include "app/editor/command_reader.h"
#include "app/editor/command_table.h"
#include "app/editor/commands/file_acts.h"
#include "app/editor/field_text.h"
#include "app/editor/formula.h"
#include "app/editor/upkeep.h"
#include "app/editor/wording.h"
#include "core/base/sentence.h"
#include "core/measure/deviation.h"

namespace batten::editor {

namespace {

bool refuse(EditorState& state, const Refusal& sentence) {
    state.message = {sentence, true};
    return false;
}

bool is_same(const core::DocumentCurve& a, const core::DocumentCurve& b) {
    return (a.curve == b.curve || *a.curve == *b.curve) && a.name == b.name && a.color == b.color &&
           a.visible == b.visible && a.locked == b.locked && a.unknown_members == b.unknown_members;
}

bool is_same(const core::Document& a, const core::Document& b) {
    return a.active == b.active && a.title == b.title && a.description == b.description && a.view == b.view &&
           a.unknown_members == b.unknown_members &&
           std::equal(a.curves.begin(), a.curves.end(), b.curves.begin(), b.curves.end(),
                      [](const core::DocumentCurve& x, const core::DocumentCurve& y) { return is_same(x, y); });
}

// The old active curve, where the edit gave the same entry of the document another shape.
std::optional<Ghost> ghost_of(const core::Document& before, const Edit& edit, ShapeEffect effect) {
    const core::Document& after = edit.document;
    const core::DocumentCurve* old_active = before.active_curve();
    const core::DocumentCurve* active = after.active_curve();
    if (effect != ShapeEffect::changes || old_active == nullptr || active == nullptr ||
        before.curves.size() != after.curves.size())
        return std::nullopt;
    return Ghost{old_active->curve,
                 edit.error ? *edit.error : core::largest_deviation(*old_active->curve, *active->curve)};
}

bool preview_edit(EditorState& state, const CommandSpec& spec, const Arguments& arguments) {
    Outcome<Edit> edit = spec.edit(state, arguments);
    if (!edit) return refuse(state, edit.error());
    state.ghost = ghost_of(state.history.present(), *edit, spec.effect);
    state.preview = std::move(edit->document);
    if (state.message.is_error) state.message = {};
    return true;
}

bool commit_edit(EditorState& state, const CommandSpec& spec, const Arguments& arguments) {
    Outcome<Edit> edit = spec.edit(state, arguments);
    if (!edit) return refuse(state, edit.error());
    if (edit->clipboard) write_clipboard(state, *edit->clipboard);
    state.message = {};
    state.ghost.reset();

    const core::Document before = state.history.present();
    if (!is_same(before, edit->document)) {
        const std::string label = spec.label != nullptr ? spec.label(state, arguments) : spec.title;
        const std::optional<Ghost> ghost = ghost_of(before, *edit, spec.effect);
        state.history.push(label, std::move(edit->document));
        follow_document(state, before);
        state.message = {edit_sentence(label, spec.effect, ghost ? std::optional(ghost->deviation) : std::nullopt),
                         false};
        if (edit->error && !ghost) state.message.text = with_error(state.message.text, *edit->error);
        if (ghost && ghost->deviation != 0.0) state.ghost = ghost;
    }
    if (edit->selection) state.selection = *edit->selection;
    return true;
}

bool cancel(EditorState& state) {
    state.preview.reset();
    state.ghost.reset();
    return true;
}

bool run_edit(EditorState& state, const CommandSpec& spec, const Arguments& arguments, Phase phase) {
    return phase == Phase::preview ? preview_edit(state, spec, arguments) : commit_edit(state, spec, arguments);
}

// A command with a struct, whose fields stand in `command`.
struct TypedRun {
    const CommandSpec& spec;
    const void* command;
    Phase phase;
};

// Places named after the fields, for the texts of a step.
std::vector<core::Place> places_of(const CommandSpec& spec, const EditorState& state, const void* command) {
    std::vector<core::Place> places;
    for (const Field& field : spec.fields) {
        const FieldValue value = field.get(command);
        const std::vector<Argument> parts = arguments_of(field, value);
        for (std::size_t k = 0; k < field.parts.size(); ++k)
            places.emplace_back(field.parts[k].name, field.parts.size() == 1 ? shown_text(field, value, state)
                                                                             : number_text(std::get<double>(parts[k])));
    }
    return places;
}

StepTexts texts_of_step(const TypedRun& run, const EditorState& state) {
    if (run.spec.texts != nullptr) return run.spec.texts(state, run.command);
    const std::vector<core::Place> places = places_of(run.spec, state, run.command);
    const char* step = run.spec.step != nullptr ? run.spec.step : run.spec.title;
    return {core::filled_as_needed(step, places), core::filled_as_needed(run.spec.done, places)};
}

bool preview_typed(EditorState& state, const TypedRun& run) {
    Outcome<Edit> edit = run.spec.run.edit(state, run.command);
    if (!edit) return refuse(state, edit.error());
    state.ghost = ghost_of(state.history.present(), *edit, run.spec.effect);
    state.preview = std::move(edit->document);
    if (state.message.is_error) state.message = {};
    return true;
}

bool commit_typed(EditorState& state, const TypedRun& run) {
    Outcome<Edit> edit = run.spec.run.edit(state, run.command);
    if (!edit) return refuse(state, edit.error());
    if (edit->clipboard) write_clipboard(state, *edit->clipboard);
    state.message = {};
    state.ghost.reset();

    const core::Document before = state.history.present();
    if (!is_same(before, edit->document)) {
        StepTexts texts = texts_of_step(run, state);
        const std::optional<Ghost> ghost = ghost_of(before, *edit, run.spec.effect);
        state.history.push(std::move(texts.step), std::move(edit->document));
        follow_document(state, before);
        const auto deviation = ghost ? std::optional(ghost->deviation) : std::nullopt;
        state.message = {done_sentence(texts.done, run.spec.effect, deviation, edit->error), false};
        if (ghost && ghost->deviation != 0.0) state.ghost = ghost;
    }
    if (edit->selection) state.selection = *edit->selection;
    return true;
}

bool run_typed(EditorState& state, const TypedRun& run) {
    if (run.spec.run.edit != nullptr)
        return run.phase == Phase::preview ? preview_typed(state, run) : commit_typed(state, run);
    if (run.phase == Phase::preview) return true;
    if (run.spec.is_logged) state.message = {};
    const Outcome<void> outcome = run.spec.run.act(state, run.command);
    return outcome ? true : refuse(state, outcome.error());
}

bool run_act(EditorState& state, const CommandSpec& spec, const Arguments& arguments, Phase phase) {
    if (phase == Phase::preview) return true;
    if (spec.is_logged) state.message = {};
    const Outcome<void> outcome = spec.act(state, arguments);
    return outcome ? true : refuse(state, outcome.error());
}

}  // namespace

Editor::Editor(Desktop desktop) {
    state_.desktop = std::move(desktop);
}

Editor::Editor(core::Document document) {
    show_document(state_, std::move(document), {});
}

void Editor::apply(const Settings& settings) {
    apply_settings(state_, settings);
}

bool Editor::run(const Request& request) {
    const bool is_done = request.phase == Phase::cancel ? cancel(state_) : run_command(request);
    follow_shown(state_);
    return is_done;
}

bool Editor::run_command(const Request& request) {
    const CommandSpec* spec = find_command(request.command.name);
    if (spec == nullptr) return refuse(state_, "there is no command called '" + request.command.name + "'");
    // The preview belongs to a gesture that an edit replaces or ends, even where the edit is refused.
    if ((spec->edit != nullptr || spec->run.edit != nullptr) && std::exchange(state_.preview, std::nullopt))
        state_.ghost.reset();
    if (spec->refusal != nullptr)
        if (const std::optional<Refusal> refusal = spec->refusal(state_)) return refuse(state_, *refusal);
    if (spec->run.make != nullptr) {
        const auto command = read_fields(*spec, state_, request.command.arguments);
        if (!command) return refuse(state_, command.error());
        const bool is_done = run_typed(state_, {*spec, command->get(), request.phase});
        if (is_done && request.phase == Phase::commit && spec->is_logged)
            log_.push_back({request.command.name, arguments_of(*spec, command->get())});
        return is_done;
    }
    const Outcome<Arguments> arguments = complete_arguments(*spec, state_, request.command.arguments);
    if (!arguments) return refuse(state_, arguments.error());

    const bool is_done = spec->edit != nullptr ? run_edit(state_, *spec, *arguments, request.phase)
                                               : run_act(state_, *spec, *arguments, request.phase);
    // Suggestions are logged as values, so that a replay does not depend on what is not logged.
    if (is_done && request.phase == Phase::commit && spec->is_logged)
        log_.push_back({request.command.name, arguments->values()});
    return is_done;
}

void Editor::run(CommandQueue& queue) {
    for (const Request& request : queue.take()) run(request);
}

}  // namespace batten::editor
