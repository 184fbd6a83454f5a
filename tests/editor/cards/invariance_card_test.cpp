#include "app/editor/cards/invariance_card.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "app/editor/commands/construction_commands.h"
#include "core/curve/control_box.h"
#include "core/curve/knot_kinds.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

class InvarianceCard : public ::testing::Test {
  protected:
    InvarianceCard() { open_text(editor_, bezier_text); }
    const EditorState& state() const { return editor_.state(); }
    bool type(const std::string& text) { return run_typed(editor_, text); }
    std::string text() const { return card_text(invariance_card(state())); }
    const MapCheck& check() const {
        const core::Curve& curve = *state().active_curve();
        check_ = state().derived.map_check({curve, map_over(state().view.shown_map, core::control_box(curve))});
        return *check_;
    }
    void show(core::Curve curve) {
        core::Document document;
        core::DocumentCurve& item = document.curves.emplace_back();
        item.name = "one";
        item.curve = std::make_shared<const core::Curve>(std::move(curve));
        editor_ = Editor(std::move(document));
    }

    Editor editor_;
    mutable std::shared_ptr<const MapCheck> check_;
};

TEST_F(InvarianceCard, says_that_both_ways_agree) {
    type("set-parameter 0.5");
    EXPECT_TRUE(type("show-map rotate 90"));
    EXPECT_TRUE(state().view.overlays.is_shown(Overlay::invariance));
    // C(1/2) = (2, 3/2), turned about (2, 1).
    EXPECT_NE(text().find("Rotation by 90°"), std::string::npos) << text();
    EXPECT_NE(text().find("M(C(u)) = (3/2, 1)"), std::string::npos) << text();
    EXPECT_NE(text().find("(u) = (3/2, 1)"), std::string::npos) << text();
    EXPECT_NE(text().find("They agree: "), std::string::npos) << text();
    EXPECT_TRUE(check().agrees());
    EXPECT_LT(check().difference.distance, 1e-14);
    EXPECT_FALSE(check().kept_difference);
}

TEST_F(InvarianceCard, has_every_kind_of_map) {
    for (const ShownMapKind kind : all_shown_maps) {
        EXPECT_TRUE(type(std::string("show-map ") + core::name_of(kind)));
        EXPECT_EQ(state().view.shown_map, (ShownMap{kind, usual_amount(kind)}));
        EXPECT_NE(text().find("They agree: "), std::string::npos) << text();
        EXPECT_TRUE(check().agrees());
    }
    EXPECT_FALSE(type("show-map scale 0"));
    EXPECT_EQ(state().message.text, "the amount is 0; it must be from 0.25 to 4 here");
}

TEST_F(InvarianceCard, tells_that_a_projection_makes_the_curve_rational) {
    type("show-map project 0.5");
    // The box is 4 wide with its middle at x = 2: factors 1/2, 3/4, 5/4 and 3/2.
    EXPECT_NE(text().find("The B-spline becomes rational: its weights were equal, now they are from 1/2 to 3/2."),
              std::string::npos)
        << text();
    EXPECT_NE(text().find("With the old weights (red dots) the results would be 0.708 apart"), std::string::npos)
        << text();
    ASSERT_TRUE(check().kept_difference);
    EXPECT_GT(check().kept_difference->distance, 0.1);
    EXPECT_LT(check().difference.distance, 1e-14);
}

TEST_F(InvarianceCard, has_a_button_that_maps_the_curve_as_it_is_shown) {
    for (const ShownMapKind kind : all_shown_maps) {
        open_text(editor_, bezier_text);
        type(std::string("show-map ") + core::name_of(kind));
        const std::vector<core::Point> expected{check().image->control_points().begin(),
                                                check().image->control_points().end()};
        const std::vector<double> weights{check().image->weights().begin(), check().image->weights().end()};
        const Card card = invariance_card(state());
        const auto& amounts = std::get<CardButtons>(card.blocks[2]);
        ASSERT_EQ(amounts.buttons.back().text, "Map the curve so");
        EXPECT_TRUE(editor_.run(amounts.buttons.back().command)) << state().message.text;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            EXPECT_LT(core::distance(points(editor_)[i], expected[i]), 1e-14) << core::name_of(kind);
            EXPECT_NEAR(curve(editor_).weights()[i], weights[i], 1e-15);
        }
    }
}

TEST_F(InvarianceCard, changes_the_amount_by_steps_within_its_range) {
    type("show-map project 0.875");
    Card card = invariance_card(state());
    const auto& amounts = std::get<CardButtons>(card.blocks[2]);
    EXPECT_TRUE(editor_.run(amounts.buttons[1].command));
    EXPECT_EQ(state().view.shown_map.amount, 0.875) << "more is not possible";
    EXPECT_TRUE(editor_.run(amounts.buttons[0].command));
    EXPECT_EQ(state().view.shown_map.amount, 0.75);
}

TEST_F(InvarianceCard, speaks_without_a_curve) {
    editor_ = Editor();
    EXPECT_NE(text().find("There is no curve"), std::string::npos);
}

TEST_F(InvarianceCard, draws_whatever_curve) {
    std::vector<core::Curve> curves;
    std::vector<core::Point> zigzag;
    for (int i = 0; i < 10000; ++i) zigzag.emplace_back(1e6 + i, i % 2 == 0 ? -1e6 : 1e6);
    curves.push_back(
        core::Curve::make(core::make_knots(core::KnotKind::clamped_uniform, 25, 10000).value(), zigzag, {}).value());
    curves.push_back(core::Curve::make({.degree = 2,
                                        .knots = {0, 1, 2, 3, 4},
                                        .points = {{1e6, 0}, {1e6 + 2, 0}, {1e6 + 2, 2}, {1e6, 2}},
                                        .weights = {1, 1e3, 1, 1e-3},
                                        .periodic = true})
                         .value());
    curves.push_back(core::Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{3, 3}, {3, 3}}}).value());
    curves.push_back(
        core::Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0}, {1e300, 1e300}}}).value());
    for (const core::Curve& curve : curves)
        for (const ShownMapKind kind : all_shown_maps) {
            show(curve);
            type(std::string("show-map ") + core::name_of(kind));
            EXPECT_TRUE(check().agrees()) << core::name_of(kind);
            const Card card = invariance_card(state());
            const auto& picture = std::get<CardPicture>(card.blocks.at(3));
            const CardDrawing drawing = picture.draw({320.0, 190.0}, 1.0);
            EXPECT_LT(drawing.list.commands.size(), 1000U);
            EXPECT_EQ(text().find("nan"), std::string::npos) << text();
            EXPECT_EQ(text().find("inf"), std::string::npos) << text();
        }
}

}  // namespace
}  // namespace batten::editor
