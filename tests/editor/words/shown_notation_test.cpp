#include <gtest/gtest.h>

#include <cctype>

#include "app/editor/cards/cards.h"
#include "app/editor/command_table.h"
#include "app/editor/editor.h"
#include "app/editor/pointer/canvas_mode.h"
#include "app/editor/pointer/plot_mode.h"
#include "app/editor/words/reading_text.h"
#include "tests/editor/random_session.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

constexpr Notation other{PointLetter::V, ParameterLetter::t, DegreeOrOrder::order, CellNumbering::first,
                         NumberStyle::fractions};

/// The first letter of the program that `text` still has: P, u or U before an index, a sign or a blank, outside quotes.
std::string left_in(const std::string& text) {
    bool is_quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::size_t factor = text.find_last_not_of("0123456789", i == 0 ? 0 : i - 1);
        const char before = i == 0 || factor == std::string::npos ? ' ' : text[factor];
        const char after = i + 1 == text.size() ? ' ' : text[i + 1];
        if (text[i] == '\'' && (is_quoted || before == ' ' || before == '(')) is_quoted = !is_quoted;
        const bool is_letter = text[i] == 'P' || text[i] == 'u' || text[i] == 'U';
        const bool is_word =
            std::isalnum(static_cast<unsigned char>(before)) || std::isalpha(static_cast<unsigned char>(after));
        if (!is_quoted && is_letter && !is_word && before != '\'') return text.substr(i > 10 ? i - 10 : 0, 30);
    }
    return "";
}

std::string shown(const std::string& text) {
    return notated(reading_text(text), other);
}

EditorState sample_state() {
    Editor editor;
    open_text(editor, sample_text);
    EditorState state = editor.state();
    state.view.notation = other;
    return state;
}

std::vector<Hover> hovers() {
    return {HoveredNothing{},   HoveredPoint{2},   HoveredWeightRing{5}, HoveredKnot{5},  HoveredCurve{0.3},
            HoveredParameter{}, HoveredCell{2, 0}, HoveredFarinPoint{4}, HoveredLeg{1},   HoveredBasis{3},
            HoveredSpan{4},     HoveredLifted{},   HoveredOtherCurve{1}, HoveredLifted{2}};
}

}  // namespace

TEST(ShownNotation, finds_what_is_left) {
    EXPECT_NE(left_in("at u = 1"), "");
    EXPECT_NE(left_in("Moved P₃"), "");
    EXPECT_NE(left_in("(u_{3}, v)"), "");
    EXPECT_EQ(left_in("Put 'u' up, t = 1"), "");
}

TEST(ShownNotation, reaches_the_texts_of_all_commands) {
    for (const CommandSpec& spec : command_table()) {
        EXPECT_EQ(left_in(shown(spec.title)), "");
        EXPECT_EQ(left_in(shown(spec.explanation)), "");
        for (const Field& field : spec.fields)
            for (const FieldPart& part : field.parts) EXPECT_EQ(left_in(shown(part.meaning)), "");
    }
}

TEST(ShownNotation, reaches_messages_and_steps) {
    Editor editor;
    open_text(editor, sample_text);
    RandomSession session(7);
    for (int k = 0; k < 600; ++k) {
        editor.perform(session.next(editor.state()));
        EXPECT_EQ(left_in(shown(editor.state().message.text)), "") << editor.state().message.text;
        EXPECT_EQ(left_in(shown(editor.state().history.undo_label())), "");
    }
}

TEST(ShownNotation, reaches_hints) {
    EditorState state = sample_state();
    for (const Hover& hover : hovers()) {
        state.hover = hover;
        EXPECT_EQ(left_in(canvas_hint(CanvasIdle{}, state)), "");
        EXPECT_EQ(left_in(plot_hint(PlotIdle{}, state)), "");
    }
    state.hover = HoveredPoint{2};
    EXPECT_EQ(canvas_hint(CanvasIdle{}, state), "Drag V₂ to move it · hold Alt to change its weight");
    for (const Tool tool : all_tools) {
        state.tool = tool;
        EXPECT_EQ(left_in(canvas_hint(CanvasIdle{}, state)), "");
    }
    EXPECT_EQ(left_in(canvas_hint(DraggingParameter{}, state)), "");
    EXPECT_EQ(left_in(plot_hint(DraggingPlotParameter{}, state)), "");
}

TEST(ShownNotation, reaches_cards) {
    EditorState state = sample_state();
    for (const CardSource& source : card_sources())
        EXPECT_EQ(left_in(notated(card_text(source.make(state)), other)), "") << card_text(source.make(state));
}

}  // namespace batten::editor
