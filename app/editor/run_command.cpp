#include "app/editor/run_command.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "app/editor/clipboard.h"
#include "app/editor/command_reader.h"
#include "app/editor/commands/joint_report.h"
#include "app/editor/state/kept_joints.h"
#include "app/editor/state/same_document.h"
#include "app/editor/state/symmetry_links.h"
#include "app/editor/upkeep.h"
#include "app/editor/words/wording.h"
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

// Whether the edit changed other curves, and not the active one.
bool is_of_others(const core::Document& before, const core::Document& after) {
    if (before.active_curve()->curve != after.active_curve()->curve) return false;
    return !std::ranges::equal(before.curves, after.curves, {}, &core::DocumentCurve::curve,
                               &core::DocumentCurve::curve);
}

// A preview does not look for its deviation in more spans than these, lest the pointer wait; it is not a number then.
constexpr std::size_t most_spans_previewed = 1000;

double deviation_of(const core::Curve& before, const core::Curve& after, Phase phase) {
    if (phase == Phase::commit) return core::largest_deviation(before, after);
    return core::quick_deviation(before, after, most_spans_previewed)
        .value_or(std::numeric_limits<double>::quiet_NaN());
}

// The old active curve, where the edit gave the same entry of the document another shape.
std::optional<Ghost> ghost_of(const core::Document& before, const Edit& edit, ShapeEffect effect, Phase phase) {
    const core::Document& after = edit.document;
    const core::DocumentCurve* old_active = before.active_curve();
    const core::DocumentCurve* active = after.active_curve();
    if (effect != ShapeEffect::changes || old_active == nullptr || active == nullptr ||
        before.curves.size() != after.curves.size() || edit.only_adds || is_of_others(before, after))
        return std::nullopt;
    return Ghost{old_active->curve, edit.error ? *edit.error : deviation_of(*old_active->curve, *active->curve, phase)};
}

StepTexts texts_of_step(const Command& command, const EditorState& state, const Edit& edit) {
    const CommandSpec& spec = command.spec();
    if (spec.texts != nullptr) return spec.texts(state, command.fields(), edit);
    const std::vector<core::Place> places = places_of(command, state);
    return {core::filled_as_needed(spec.step != nullptr ? spec.step : spec.title, places),
            core::filled_as_needed(spec.done, places)};
}

void add_remarks(Edit& edit, std::vector<std::string> told) {
    if (edit.remark) told.insert(told.begin(), *edit.remark);
    edit.remark = told_in_turn(told);
}

// What the command makes of the committed document, with all that must follow from it. What marked joints ask for may
// move the curve further than the edit knows.
Outcome<Edit> edit_by(const EditorState& state, const Command& command) {
    Outcome<Edit> edit = command.spec().run.edit(state, command.fields());
    if (!edit) return edit;
    const core::Document& before = state.history.present();
    core::Document& after = edit->document;
    const auto edited = after.active_curve() == nullptr ? nullptr : after.active_curve()->curve;
    add_remarks(*edit, keep_marked_joints(before, after));
    auto kept = keep_symmetry(before, after);
    if (!kept) return tl::unexpected(kept.error());
    add_remarks(*edit, *kept);
    add_remarks(*edit, keep_joints_of_images(before, after));
    if (after.active_curve() != nullptr && *after.active_curve()->curve != *edited) edit->error.reset();
    return edit;
}

void take_back_refusal(EditorState& state) {
    if (state.message.is_error) state.message = {};
}

bool preview_edit(EditorState& state, const Command& command) {
    Outcome<Edit> edit = edit_by(state, command);
    if (!edit) return show_refusal(state, edit.error());
    state.ghost = ghost_of(state.history.present(), *edit, command.spec().effect, Phase::preview);
    state.preview = std::move(edit->document);
    if (edit->remark)
        state.message = {*edit->remark, false};
    else
        take_back_refusal(state);
    return true;
}

// How far the step went. An edit that tells its own error compares other parameters, or shapes.
Distances distances_of(const EditorState& state, const std::optional<Ghost>& ghost, const Edit& edit) {
    Distances distances{.error = edit.error, .units = units_of(state)};
    if (!ghost) return distances;
    distances.deviation = ghost->deviation;
    distances.is_rounding = is_within_tolerance(*ghost->curve, ghost->deviation, rounding_of_size);
    if (edit.error || distances.is_rounding) return distances;
    const core::Curve& after = *state.history.present().active_curve()->curve;
    const double of_shapes = core::geometric_distance(*ghost->curve, after);
    if (of_shapes < much_less * ghost->deviation) distances.of_shapes = of_shapes;
    return distances;
}

// Said of an edit that changed a curve which was made of fit points, and left it without them.
std::optional<std::string> lost_fit_points(const core::Document& before, const core::Document& after) {
    const core::DocumentCurve* old_active = before.active_curve();
    const core::DocumentCurve* active = after.active_curve();
    const bool is_same_entry =
        old_active != nullptr && active != nullptr && before.active == after.active && old_active->name == active->name;
    if (!is_same_entry || old_active->fit == nullptr || active->fit != nullptr || old_active->curve == active->curve)
        return std::nullopt;
    return "the curve is an ordinary one now, without fit points";
}

void note_stroke(EditorState& state, std::optional<DrawnStroke> stroke) {
    state.stroke = std::move(stroke);
    if (!state.stroke) return;
    state.stroke->step = state.history.undo_count();
    state.view.smoothness = state.stroke->smoothness;
}

void note_faired(EditorState& state, const Edit& edit) {
    state.faired = edit.faired;
    if (!state.faired) return;
    state.faired->step = state.history.undo_count();
    if (edit.extends) state.view.brush.distance = state.faired->distance;
}

// The edit as a step of the history, with what is said and shown about it.
void push_step(EditorState& state, const Command& command, Edit& edit) {
    const core::Document before = state.history.present();
    const ShapeEffect effect = command.spec().effect;
    StepTexts texts = texts_of_step(command, state, edit);
    const bool extends = edit.extends || (edit.burst && edit.burst->count > 1);
    const std::optional<Ghost> ghost =
        ghost_of(extends ? state.history.previous() : before, edit, effect, Phase::commit);
    if (extends)
        state.history.extend(std::move(texts.step), std::move(edit.document));
    else
        state.history.push(std::move(texts.step), std::move(edit.document));
    state.burst = std::move(edit.burst);
    note_stroke(state, std::move(edit.stroke));
    note_faired(state, edit);
    follow_document(state, before);
    if (effect == ShapeEffect::keeps) note_insertion(state, before);
    std::vector<std::string> told{done_sentence(texts.done, effect, distances_of(state, ghost, edit))};
    if (edit.remark) told.push_back(*edit.remark);
    if (const auto lost = lost_fit_points(before, state.history.present())) told.push_back(*lost);
    if (ghost && command.spec().tells_smoothness)
        if (const auto lost =
                lost_smoothness(units_of(state),
                                core::smoothness_losses(*ghost->curve, *state.history.present().active_curve()->curve)))
            told.push_back(*lost);
    state.message = {*told_in_turn(told), false};
    if (ghost && ghost->deviation != 0.0) state.ghost = ghost;
}

bool commit_edit(EditorState& state, const Command& command) {
    Outcome<Edit> edit = edit_by(state, command);
    if (!edit) return show_refusal(state, edit.error());
    if (edit->clipboard) write_clipboard(state, *edit->clipboard);
    state.message = {};
    state.ghost.reset();
    if (!is_same_document(state.history.present(), edit->document)) {
        push_step(state, command, *edit);
    } else {
        state.burst.reset();
        // Another smoothness or distance is what was asked for, although the same curve came of it.
        if (edit->stroke) note_stroke(state, std::move(edit->stroke));
        if (edit->faired) note_faired(state, *edit);
        if (!edit->clipboard && !edit->selection)
            state.message = {edit->remark ? *edit->remark : nothing_changed_sentence(), false};
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

}  // namespace

std::vector<core::Place> places_of(const Command& command, const EditorState& state) {
    std::vector<core::Place> places;
    for (const Field& field : command.spec().fields) {
        const FieldValue value = field.get(command.fields());
        if (field.parts.size() == 1) {
            places.emplace_back(field.parts.front().name, shown_text(field, value, state));
            continue;
        }
        const core::Point pair = std::get<core::Point>(value);
        places.emplace_back(field.parts[0].name, length_words(units_of(state), pair.x));
        places.emplace_back(field.parts[1].name, length_words(units_of(state), pair.y));
    }
    return places;
}

bool run_checked(EditorState& state, const Command& command, Phase phase) {
    const CommandSpec& spec = command.spec();
    // The preview belongs to a gesture that an edit replaces or ends, even where the edit is refused.
    if (spec.run.edit != nullptr && std::exchange(state.preview, std::nullopt)) state.ghost.reset();
    if (const std::optional<Refusal> refusal = refusal_of(state, command))
        return show_refusal(state, *refusal, !is_idle(spec, state));
    if (phase == Phase::preview && spec.run.edit != nullptr) return preview_edit(state, command);
    if (phase == Phase::preview) {
        take_back_refusal(state);
        return true;
    }
    return spec.run.edit != nullptr ? commit_edit(state, command) : commit_act(state, command);
}

}  // namespace batten::editor
