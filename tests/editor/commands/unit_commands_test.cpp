#include "app/editor/commands/unit_commands.h"

#include <gtest/gtest.h>

#include "app/editor/command_reader.h"
#include "app/editor/commands/joint_tool_commands.h"
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

// A millimeter is 10 of the coordinates.
class RefusalsInUnits : public UnitCommands {
  protected:
    void SetUp() override { ASSERT_TRUE(type("set-units mm 10")); }

    std::string refused(const std::string& text) {
        EXPECT_FALSE(type(text)) << text;
        return said();
    }
};

TEST_F(RefusalsInUnits, of_the_core_have_lengths_in_the_unit) {
    ASSERT_TRUE(type("circle 0 0 3"));
    EXPECT_TRUE(refused("offset 4 1e-3").starts_with("the distance is 4 mm, but the radius of curvature at "))
        << said();
    EXPECT_NE(said().find(" is 3 mm; toward the inside the distance must be less"), std::string::npos) << said();
    EXPECT_EQ(refused("circle 0 0 -1"), "a length is -1 mm; radii, axes and other lengths must be above 0");
    EXPECT_EQ(refused("parabola 0 0 1 90 2 1"),
              "the range begins at 2 mm and ends at 1 mm; its end must be above its beginning");
    ASSERT_TRUE(type("polyline 0,0,10,0,10,5"));
    // The shorter leg is 5 mm long, and so is the largest radius.
    EXPECT_EQ(refused("fillet 6 1"),
              "the radius 6 mm is too large for an arc that touches both sides here; 4.999 mm is the most");
}

TEST_F(RefusalsInUnits, about_parameters_have_no_unit) {
    ASSERT_TRUE(type("polyline 0,0,10,0,10,5"));
    EXPECT_EQ(refused("extend-parameter -1"), "a length is -1; radii, axes and other lengths must be above 0");
    EXPECT_EQ(refused("extend -1"), "a length is -1 mm; radii, axes and other lengths must be above 0");
    EXPECT_EQ(refused("merge-knots -1"), "the tolerance is -1; it must be above 0 and finite");
    EXPECT_EQ(refused("simplify -1"), "the tolerance is -1 mm; it must be above 0 and finite");
}

TEST_F(RefusalsInUnits, of_the_limits_of_a_field_do_too) {
    const auto refusal = check_fields(Command(SetJointRadius{.radius = -20.0}), editor.state());
    EXPECT_EQ(refusal, "radius is -2 mm; it must be above 0 mm");
}

TEST_F(RefusalsInUnits, are_answered_by_sentences_in_the_unit) {
    ASSERT_TRUE(type("polyline 0,0,3,0,3,4"));
    ASSERT_TRUE(type("closing"));
    EXPECT_EQ(said(), "polyline is open; its ends are 5 mm apart");
    ASSERT_TRUE(type("evaluate 0"));
    EXPECT_EQ(said(), "polyline is at (0, 0) mm for u = 0");
    // A way of 2 and 1 is sqrt(5) = 2.236... long.
    ASSERT_TRUE(type("set-point 0 2 1"));
    EXPECT_EQ(said(), "Moved P₀ from (0, 0) mm to (2, 1) mm; the curve moved by at most 2.23606797749979 mm");
    ASSERT_TRUE(type("set-point 0 0 0"));
    ASSERT_TRUE(type("select-points 0,1,2"));
    ASSERT_TRUE(type("move 1 -2"));
    EXPECT_TRUE(said().starts_with("Moved 3 points by (1, -2) mm; the curve moved by at most 2.23606797749979 mm"));
    ASSERT_TRUE(type("move-curve-point 0 0 0"));
    EXPECT_EQ(said(), "Moved C(0) to (0 mm, 0 mm); the curve moved by at most 2.23606797749979 mm");
    ASSERT_TRUE(type("circle 0 0 1"));
    ASSERT_TRUE(type("centroid"));
    EXPECT_EQ(said(), "The centroid of circle is (0, 0) mm");
}

// The quadratic (0, 0) (1, 2) (2, 0) is half of 2 below its middle point, and a quarter of that after halving.
TEST_F(RefusalsInUnits, distance_of_a_polygon_is_in_the_unit) {
    ASSERT_TRUE(type("new-curve 0,0,1,2,2,0 2"));
    ASSERT_TRUE(type("refine-midpoints 1"));
    EXPECT_NE(said().find("the control polygon is at most 0.25 mm from it now, 1 mm before"), std::string::npos)
        << said();
}

}  // namespace
}  // namespace batten::editor
