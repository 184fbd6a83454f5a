#include "app/editor/commands/trim_commands.h"

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/other_curve.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/words/refusal.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

using core::sentence;

// Where the curve crosses itself and every other one that is seen.
std::vector<double> cuts_of(const EditorState& state, std::size_t index) {
    const std::vector<core::DocumentCurve>& curves = state.history.present().curves;
    std::vector<const core::Curve*> others;
    for (std::size_t i = 0; i < curves.size(); ++i)
        if (i != index && curves[i].visible) others.push_back(curves[i].curve.get());
    return core::crossing_parameters(*curves[index].curve, others, state.progress);
}

Outcome<Edit> trim(const EditorState& state, const Trim& command) {
    const Outcome<core::Interval> part = trimmed_part(state, state.history.present().active, command.u);
    if (!part) return tl::unexpected(part.error());
    auto left = core::without_part(active_curve(state), *part);
    if (!left) return refused(state, left.error());
    return with_parts(state, *std::move(left));
}

Outcome<Edit> extend_to_other(const EditorState& state, const ExtendTo& command) {
    const Outcome<std::size_t> other = other_curve_named(state, command.other);
    if (!other) return tl::unexpected(other.error());
    Outcome<Edit> edit =
        edit_active(state, core::extend_to(active_curve(state), command.end,
                                           *state.history.present().curves[*other].curve, command.onward));
    if (edit) edit->only_adds = true;
    return edit;
}

Outcome<Edit> split_at_crossings(const EditorState& state, const SplitAtCrossings& command) {
    const core::Document& before = state.history.present();
    Edit edit{before, Selection{}};
    edit.document.curves.clear();
    core::FreeNames names(before);
    for (std::size_t i = 0; i < before.curves.size(); ++i) {
        const core::DocumentCurve& entry = before.curves[i];
        if (i == before.active) edit.document.active = edit.document.curves.size();
        const bool is_meant =
            i == before.active || (command.scope == SplitScope::all && entry.visible && !entry.locked);
        auto parts = core::split_at(*entry.curve, is_meant ? cuts_of(state, i) : std::vector<double>{});
        if (!parts) return refused(state, parts.error());
        if (parts->size() == 1) {
            edit.document.curves.push_back(entry);
            continue;
        }
        for (core::DocumentCurve& part : entries_of_parts(entry, *std::move(parts), names))
            edit.document.curves.push_back(std::move(part));
    }
    if (edit.document.curves.size() > before.curves.size() || command.scope == SplitScope::all) return edit;
    return tl::unexpected(sentence("nothing crosses '{name}'", {{"name", before.active_curve()->name}}));
}

StepTexts texts_of_trimming(const EditorState& state, const Trim& command) {
    const auto part = trimmed_part(state, state.history.present().active, command.u);
    const core::Interval range = part.value_or(core::Interval{});
    return {Trim::spec().title,
            sentence("Trimmed the part from u = {from} to {to}",
                     {{"from", core::shortest_text(range.lower)}, {"to", core::shortest_text(range.upper)}})};
}

StepTexts texts_of_splitting(const EditorState& state, const void*, const Edit& edit) {
    const std::size_t added = edit.document.curves.size() - state.history.present().curves.size();
    return {SplitAtCrossings::spec().title, sentence({.one = "Split at crossings: there is one curve more",
                                                      .many = "Split at crossings: there are {count} curves more"},
                                                     added)};
}

}  // namespace

Outcome<core::Interval> trimmed_part(const EditorState& state, std::size_t index, double u) {
    const core::Curve& curve = *state.history.present().curves[index].curve;
    auto part = core::part_around(curve, curve.knots().into_domain(u), cuts_of(state, index));
    if (!part) return refused(state, part.error());
    return *part;
}

const CommandSpec& Trim::spec() {
    static const CommandSpec spec{
        .name = "trim",
        .title = "Trim",
        .explanation = "Removes the part around u, up to where other curves or the curve itself cross it.",
        .synonyms = "cut remove scissors",
        .group = CommandGroup::curve,
        .submenu = "Joints",
        .fields =
            {field::parameter<&Trim::u>("u", "a place on the part that goes").suggesting<suggest::current_parameter>()},
        .refusal = no_editable_curve,
        .run = body_of<trim>,
        .texts = texts_of<texts_of_trimming>};
    return spec;
}

const CommandSpec& ExtendTo::spec() {
    static const CommandSpec spec{
        .name = "extend-to",
        .title = "Extend to a curve",
        .explanation = "Makes the active curve longer at an end until it meets another one; the old part stays.",
        .synonyms = "longer meet",
        .group = CommandGroup::curve,
        .submenu = "Joints",
        .fields = {field::curve_name<&ExtendTo::other>("other", "name of the curve to be met")
                       .suggesting<suggest::next_curve_name>(),
                   field::choice<&ExtendTo::end>("end", "at which end").usually(core::CurveEnd::end),
                   field::choice<&ExtendTo::onward>("onward", "how it goes on").usually(core::Onward::natural)},
        .refusal = no_second_curve_to_edit,
        .run = body_of<extend_to_other>,
        .step = "Extend to {other}",
        .done = "Extended to {other}"};
    return spec;
}

const CommandSpec& SplitAtCrossings::spec() {
    static const CommandSpec spec{
        .name = "split-at-crossings",
        .title = "Split at crossings",
        .explanation = "Cuts the active curve, or all, where curves cross or touch each other or themselves.",
        .synonyms = "cut divide intersect",
        .group = CommandGroup::curve,
        .submenu = "Joints",
        .effect = ShapeEffect::keeps,
        .fields = {field::choice<&SplitAtCrossings::scope>("curves", "which are cut").usually(SplitScope::active)},
        .refusal = no_editable_curve,
        .run = body_of<split_at_crossings>,
        .at_work = "Seeking crossings",
        .texts = texts_of_splitting};
    return spec;
}

void add_trim_commands(CommandTable& table) {
    add_all<Trim, ExtendTo, SplitAtCrossings>(table);
}

}  // namespace batten::editor
