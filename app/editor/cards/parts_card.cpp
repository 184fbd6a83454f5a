#include "app/editor/cards/parts_card.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "app/editor/cards/card_texts.h"
#include "app/editor/commands/shape_view_commands.h"
#include "app/editor/state/state.h"
#include "app/editor/words/formula.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

CardButtons count_buttons(int count) {
    CardButtons buttons;
    const auto add = [&](const char* text, int wanted) {
        buttons.buttons.push_back(
            {.text = text, .command = SetPartCount{std::clamp(wanted, least_part_count, most_part_count)}});
    };
    add("Fewer", count - 1);
    add("More", count + 1);
    add("Half", count / 2);
    add("Twice", 2 * count);
    return buttons;
}

/// The shortest and the longest chord of the parts.
core::Interval chords_of(const EqualParts& parts) {
    core::Interval chords{std::numeric_limits<double>::infinity(), 0.0};
    for (std::size_t k = 0; k + 1 < parts.ends.size(); ++k) {
        const double chord = core::distance(parts.ends[k].point, parts.ends[k + 1].point);
        chords = {std::min(chords.lower, chord), std::max(chords.upper, chord)};
    }
    return chords;
}

}  // namespace

Card equal_steps_card(const EditorState& state) {
    Card card{.title = "Equal steps of u", .blocks = {}};
    const core::Curve* curve = state.visible_active_curve();
    if (curve == nullptr) return card_without_curve(std::move(card));
    const Notation& notation = state.view.notation;
    const int count = state.view.shape.part_count;
    card.formula(core::sentence("{count} steps of Δu = {step}",
                                {{"count", count}, {"step", exact_text(notation, curve->domain().length() / count)}}),
                 CardTone::strong);
    const core::Interval chords = chords_of(*state.measured.equal_steps(*curve, count));
    card.line(
        core::sentence("The full dots are {least} to {most} apart: dense where the curve is slow.",
                       {{"least", short_text(notation, chords.lower)}, {"most", short_text(notation, chords.upper)}}));
    card.add(count_buttons(count));
    return card;
}

Card equal_lengths_card(const EditorState& state) {
    Card card{.title = "Equal lengths", .blocks = {}};
    const core::Curve* curve = state.visible_active_curve();
    if (curve == nullptr) return card_without_curve(std::move(card));
    const int count = state.view.shape.part_count;
    if (curve->control_points().size() > most_measured_spans) {
        card.line(core::sentence("Equal lengths are shown of curves of up to {count} points.",
                                 {{"count", most_measured_spans}}));
        return card;
    }
    const auto parts = state.measured.equal_lengths(*curve, count);
    if (parts->ends.empty()) return card.line("This curve has no length that can be told.", CardTone::bad), card;
    const Units& units = state.shown().units;
    const auto words = [&](double length) { return with_unit(units, number_text(in_units(units, length), 6)); };
    card.line("The rings divide the curve into parts of one length.");
    card.formula("s = ∫ |C′(u)| du");
    card.formula(
        core::sentence("length {length} = {count} × {part}",
                       {{"length", words(count * parts->length)}, {"count", count}, {"part", words(parts->length)}}),
        CardTone::strong);
    card.add(count_buttons(count));
    return card;
}

}  // namespace batten::editor
