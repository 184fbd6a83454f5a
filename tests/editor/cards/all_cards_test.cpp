#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "app/editor/cards/cards.h"
#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "tests/editor/sample_editor.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

/// A curve over these knots through a wave of this size.
core::CurveDefinition wave(int degree, std::vector<double> knots, double size = 1.0, bool periodic = false) {
    core::CurveDefinition definition;
    definition.degree = degree;
    const std::size_t count = periodic ? knots.size() - 1 : knots.size() - static_cast<std::size_t>(degree) - 1;
    definition.knots = std::move(knots);
    definition.periodic = periodic;
    for (std::size_t i = 0; i < count; ++i)
        definition.points.push_back({static_cast<double>(i) * size, (i % 3 == 1   ? 2.0
                                                                     : i % 3 == 2 ? -1.0
                                                                                  : 0.5) *
                                                                        size});
    return definition;
}

std::vector<double> clamped(int degree, int spans, double begin = 0.0, double step = 1.0) {
    std::vector<double> knots(static_cast<std::size_t>(degree), begin);
    for (int k = 0; k <= spans; ++k) knots.push_back(begin + k * step);
    knots.insert(knots.end(), static_cast<std::size_t>(degree), begin + spans * step);
    return knots;
}

std::vector<double> even(int count) {
    std::vector<double> knots;
    for (int k = 0; k < count; ++k) knots.push_back(k);
    return knots;
}

core::CurveDefinition moved(core::CurveDefinition definition, core::Vector by) {
    for (core::Point& point : definition.points) point = point + by;
    return definition;
}

core::CurveDefinition weighted(core::CurveDefinition definition, double least, double most) {
    for (std::size_t i = 0; i < definition.points.size(); ++i) definition.weights.push_back(i % 2 == 0 ? least : most);
    return definition;
}

core::CurveDefinition at_one_place(core::CurveDefinition definition) {
    for (core::Point& point : definition.points) point = {1.0, 2.0};
    return definition;
}

core::CurveDefinition on_a_line(core::CurveDefinition definition) {
    for (core::Point& point : definition.points) point.y = 0.1 * point.x;
    return definition;
}

std::vector<core::CurveDefinition> hard_curves() {
    return {wave(1, {0, 0, 1, 1}),
            wave(1, clamped(1, 4)),
            wave(25, clamped(25, 1)),
            wave(25, even(60)),
            wave(2, {0, 1, 2, 3}, 1.0, true),
            wave(3, even(5), 1.0, true),
            wave(3, even(9), 1.0, true),
            weighted(wave(2, even(6), 1.0, true), 1.0, 0.25),
            weighted(wave(3, clamped(3, 3)), 1e-9, 1e9),
            weighted(wave(2, clamped(2, 1)), 1.0, std::sqrt(0.5)),
            wave(3, even(10)),
            wave(3, clamped(3, 9997)),
            moved(wave(3, clamped(3, 3)), {1e6, -1e6}),
            wave(3, clamped(3, 3), 1e-150),
            wave(3, clamped(3, 3), 1e150),
            wave(2, clamped(2, 4, -1e6, 1e-3)),
            wave(3, clamped(3, 4, 0.0, 1e9)),
            wave(2, {0, 0, 0, 1e-300, 1, 1, 1}),
            wave(3, {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2}),
            wave(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 3}),
            at_one_place(wave(3, clamped(3, 3))),
            on_a_line(wave(3, even(10)))};
}

void expect_readable(const EditorState& state) {
    for (const CardSource& source : card_sources()) {
        const Card card = source.make(state);
        const std::string text = card_text(card);
        for (const char* bad : {"nan", "= ∞", "(∞,", ", ∞)", "−0 ", "{", "}"})
            EXPECT_EQ(text.find(bad), std::string::npos) << bad << " in\n" << text;
        for (const CardBlock& block : card.blocks) {
            const auto* picture = std::get_if<CardPicture>(&block);
            if (picture == nullptr) continue;
            const glm::dvec2 size{std::max(320.0, picture->least_width), picture->height};
            const auto faults = test::faults_of(picture->draw(size, 1.0).list, size, 200.0);
            EXPECT_TRUE(faults.empty()) << core::name_of(source.overlay) << ": " << faults.front();
        }
    }
}

}  // namespace

TEST(AllCards, can_be_read_whatever_the_curve) {
    std::size_t number = 0;
    for (const core::CurveDefinition& definition : hard_curves()) {
        SCOPED_TRACE("curve " + std::to_string(number++));
        EditorState state = test::scene_state(definition);
        const core::Interval domain = state.active_curve()->domain();
        for (const double share : {0.0, 0.4, 1.0}) {
            state.view.parameter = domain.lower + share * domain.length();
            state.selection.points.clear();
            expect_readable(state);
            state.selection.points = {state.active_curve()->control_points().size() - 1};
            state.view.notation.numbers = NumberStyle::decimals;
            expect_readable(state);
            state.view.notation.numbers = NumberStyle::fractions;
        }
    }
}

TEST(AllCards, can_be_read_whatever_is_pointed_at) {
    EditorState state = test::sample_state();
    for (const Hover& hover : std::initializer_list<Hover>{
             HoveredPoint{6}, HoveredKnot{5}, HoveredSpan{4}, HoveredCell{2, 1}, HoveredCell{0, 3}, HoveredLeg{5},
             HoveredBasis{0}, HoveredBasisCell{9, 0}, HoveredBasisCell{2, 2}, HoveredFarinPoint{5}}) {
        state.hover = hover;
        expect_readable(state);
    }
}

TEST(AllCards, can_be_read_without_a_curve_and_with_several) {
    expect_readable(EditorState());
    Editor editor;
    open_text(editor, sample_text);
    for (const std::size_t active : {0U, 1U, 2U}) {
        ASSERT_TRUE(editor.run(ActivateCurve{.index = active}));
        expect_readable(editor.state());
        ASSERT_TRUE(editor.run(SetCurveVisible{.index = active, .visible = false}));
        expect_readable(editor.state());
    }
}

}  // namespace batten::editor
