#include "app/editor/commands/unit_commands.h"

#include <gtest/gtest.h>

#include "app/editor/pointer/place_text.h"
#include "app/editor/session.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/arc_length.h"
#include "tests/editor/pointer_driver.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

using core::LengthUnit;

class UnitCommands : public testing::Test {
  protected:
    const core::Document& document() const { return editor.state().history.present(); }
    const std::string& said() const { return editor.state().message.text; }
    bool type(const std::string& text) { return run_typed(editor, text); }

    Editor editor = test::zigzag_editor();
};

TEST_F(UnitCommands, choose_the_unit_of_lengths) {
    EXPECT_TRUE(type("set-units mm"));
    EXPECT_EQ(document().units, (core::DocumentUnits{.unit = LengthUnit::mm}));
    EXPECT_EQ(said(), "Lengths are in millimeters now");
    EXPECT_TRUE(type("set-units inch 96"));
    EXPECT_EQ(document().units, (core::DocumentUnits{.unit = LengthUnit::inch, .scale = 96.0}));
    EXPECT_EQ(said(), "Lengths are in inches now, one of which is 96 of the curves' coordinates");
    EXPECT_TRUE(type("set-units none"));
    EXPECT_EQ(document().units, std::nullopt);
    EXPECT_EQ(said(), "Lengths are plain numbers now");
    EXPECT_FALSE(type("set-units cm"));
    EXPECT_FALSE(type("set-units mm 0"));
    EXPECT_FALSE(type("set-units mm -1"));
    for (int i = 0; i < 2; ++i) EXPECT_TRUE(type("undo"));
    EXPECT_EQ(document().units, (core::DocumentUnits{.unit = LengthUnit::mm}));
}

TEST_F(UnitCommands, refuse_a_scale_that_leaves_lengths_no_numbers) {
    for (const char* scale : {"1e-320", "0.99e-9", "1.01e9", "1e300"}) {
        EXPECT_FALSE(type(std::string("set-units mm ") + scale)) << scale;
        EXPECT_NE(said().find("it must be from 1e-09 to 1e+09"), std::string::npos) << said();
        EXPECT_EQ(document().units, std::nullopt);
    }
    EXPECT_TRUE(type("set-units mm 1e-9"));
    EXPECT_TRUE(type("set-units mm 1e9"));
}

TEST_F(UnitCommands, places_and_offsets_are_typed_in_the_unit_as_lengths_are) {
    ASSERT_TRUE(type("set-units mm 0.125"));
    ASSERT_TRUE(type("circle 40 -8 16"));
    const auto ring = document().curves.back().curve;
    EXPECT_EQ(core::point_at(*ring, 0.0), core::Point(7, -1));
    ASSERT_TRUE(type("move 1in*80/25.4 -8 curve"));
    EXPECT_EQ(core::point_at(*document().curves.back().curve, 0.0), core::Point(17, -2));
    ASSERT_TRUE(type("polyline 0,0,80,0,80,16mm no"));
    const auto path = document().curves.back().curve;
    EXPECT_EQ(path->control_points()[1], core::Point(10, 0));
    EXPECT_EQ(path->control_points()[2], core::Point(10, 2));
    EXPECT_FALSE(type("line 0 0 1e308in 0"));
    // Numbers of logs and scripts are coordinates.
    ASSERT_TRUE(editor.run(*parse_command(R"(["circle", 40, -8, 16])", editor.state())));
    EXPECT_EQ(core::point_at(*document().curves.back().curve, 0.0), core::Point(56, -8));
}

TEST_F(UnitCommands, lengths_are_typed_in_the_unit_and_logged_in_coordinates) {
    ASSERT_TRUE(type("set-units inch 96"));
    ASSERT_TRUE(type("set-length 1"));
    EXPECT_TRUE(said().starts_with("Set length to 1 in; the curve moved by at most 0.56")) << said();
    EXPECT_TRUE(said().ends_with(" in")) << said();
    EXPECT_NEAR(core::arc_length(test::committed(editor)).value, 96.0, 1e-9);
    ASSERT_TRUE(type("set-length 25.4mm"));
    EXPECT_NEAR(core::arc_length(test::committed(editor)).value, 96.0, 1e-9);
    ASSERT_TRUE(type("set-distance 0 1 1/2"));
    const auto points = test::committed(editor).control_points();
    EXPECT_NEAR(core::distance(points[0], points[1]), 48.0, 1e-12);
    EXPECT_TRUE(said().starts_with("Moved P₁ to the distance 0.5 in from P₀; the curve moved by at most 0.09"));
    ASSERT_TRUE(type("set-point 2 1in 127mm"));
    EXPECT_EQ(test::committed(editor).control_points()[2], core::Point(96, 480));
    ASSERT_TRUE(type("set-units none"));
    EXPECT_FALSE(type("set-length 25.4mm"));
}

TEST_F(UnitCommands, what_is_placed_is_told_in_the_unit) {
    const ShownPlace place{{3, 4}, core::Point(0, 0), std::nullopt};
    EXPECT_EQ(reading_of(editor.state(), place), "5 ∠ 53.13° · dx 3 · dy 4");
    ASSERT_TRUE(type("set-units mm"));
    EXPECT_EQ(reading_of(editor.state(), place), "5 mm ∠ 53.13° · dx 3 mm · dy 4 mm");
    ASSERT_TRUE(type("set-units inch 2"));
    EXPECT_EQ(reading_of(editor.state(), {{3, 4}, std::nullopt, std::nullopt}), "x 1.5 in · y 2 in");
}

}  // namespace
}  // namespace batten::editor
