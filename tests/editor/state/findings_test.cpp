#include "app/editor/state/findings.h"

#include <gtest/gtest.h>

#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/making_commands.h"
#include "app/editor/commands/measuring_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/unit_commands.h"
#include "tests/editor/sample_editor.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

class FindingsTest : public ::testing::Test {
  protected:
    // (0, 0) (1, 2) (3, 2) (4, 0): y is greatest in the middle, at (2, 1.5).
    void SetUp() override {
        open_text(editor_, bezier_text);
        editor_.change(ResizeCanvas{{1000.0, 600.0}});
        ASSERT_TRUE(editor_.run(Evaluate{.u = 0.5}));
        ASSERT_TRUE(state().findings.has_value());
    }
    const EditorState& state() const { return editor_.state(); }
    render::DrawList picture() const { return test::canvas_picture(state(), {}); }
    static std::vector<render::Marker> marks(const render::DrawList& list) {
        return test::markers_of(list, render::MarkerShape::square, 5.0F);
    }

    Editor editor_;
};

TEST_F(FindingsTest, say_what_was_found_and_make_no_step_of_the_history) {
    EXPECT_EQ(state().message.text, state().findings->summary);
    EXPECT_FALSE(state().history.can_undo());
    EXPECT_EQ(state().findings->rows.front().point, core::Point(2.0, 1.5));
}

TEST_F(FindingsTest, have_the_same_decimals_in_all_rows_and_all_digits_in_full) {
    EditorState shown = state();
    show_findings(shown, {.title = "Points",
                          .summary = "",
                          .rows = {{.label = "a", .parameter = 0.5, .point = core::Point(1.0, -4.4e-16)},
                                   {.label = "b",
                                    .parameter = 1.0 / 3.0,
                                    .point = core::Point(4.0 / 3.0, 2.5),
                                    .numbers = {{"curvature", -1e-17, 1e-15}}}},
                          .coordinate_error = 4e-14});
    const Findings& found = *shown.findings;
    EXPECT_EQ(details_text(found, found.rows[0]), "(1.00000, 0.00000)");
    EXPECT_EQ(details_text(found, found.rows[1]), "(1.33333, 2.50000)   curvature 0");
    EXPECT_EQ(column_text(0.5, found.columns.parameter), "0.500000");
    EXPECT_EQ(full_text(found, found.rows[1]),
              "b\nu = 0.3333333333333333\nx = 1.3333333333333333\ny = 2.5\ncurvature = 0");
}

// C(1/2) is (2, 1.5), C' there (4.5, 0) and C'' (0, -12): the curvature is -12 / 4.5^2.
TEST_F(FindingsTest, are_read_in_the_unit_of_the_document) {
    ASSERT_TRUE(editor_.run(SetUnits{.unit = UnitChoice::mm, .scale = 0.125}));
    ASSERT_TRUE(editor_.run(Evaluate{.u = 0.5}));
    const Finding& row = state().findings->rows.front();
    const std::string full = full_text(*state().findings, row);
    for (const char* line : {"\nx = 16 mm\ny = 12 mm\n", "\nC' x = 36 mm\n", "\nC'' y = -96 mm\n", "\ntangent x = 1\n",
                             "\ncurvature = -0.07407407407407407"})
        EXPECT_NE(full.find(line), std::string::npos) << line << " in " << full;
    EXPECT_EQ(details_text(*state().findings, row).substr(0, 11), "(16, 12) mm");
    EXPECT_EQ(row.point, core::Point(2.0, 1.5)) << "in the world, as programs read it";
    ASSERT_TRUE(editor_.run(AddPolyline{.points = {{0, 0}, {2, 0}, {2, 2}, {0, 2}}, .closed = true}));
    ASSERT_TRUE(editor_.run(MeasureArea{}));
    EXPECT_EQ(state().message.text, "polyline encloses the area 256 mm²");
    EXPECT_EQ(details_text(*state().findings, state().findings->rows.front()).substr(0, 25),
              "(8, 8) mm   area 256 mm²");
}

TEST_F(FindingsTest, are_marked_where_they_are) {
    const std::vector<render::Marker> marked = marks(picture());
    ASSERT_EQ(marked.size(), 1U);
    const glm::dvec2 place = render::screen_from_world(state().view.camera, {2.0, 1.5});
    EXPECT_NEAR(marked[0].center.x, place.x, 0.01);
    EXPECT_NEAR(marked[0].center.y, place.y, 0.01);
    EXPECT_TRUE(test::has_text(picture(), "1"));
}

TEST_F(FindingsTest, are_not_marked_on_another_shape) {
    ASSERT_TRUE(editor_.run(SetPoint{.index = 1, .position = {1.0, 5.0}}, Phase::preview));
    EXPECT_TRUE(marks(picture()).empty());
    editor_.cancel_preview();
    EXPECT_EQ(marks(picture()).size(), 1U);
}

TEST_F(FindingsTest, end_with_the_document_they_are_of) {
    ASSERT_TRUE(editor_.run(SetPoint{.index = 1, .position = {1.0, 5.0}}));
    EXPECT_FALSE(state().findings.has_value());
    ASSERT_TRUE(editor_.run(Evaluate{.u = 0.5}));
    ASSERT_TRUE(editor_.run(Undo{}));
    EXPECT_FALSE(state().findings.has_value());
}

TEST_F(FindingsTest, are_given_up_before_the_selection) {
    ASSERT_TRUE(editor_.run(SelectPoints{.points = {1}}));
    ASSERT_TRUE(run_typed(editor_, "escape"));
    EXPECT_FALSE(state().findings.has_value());
    EXPECT_EQ(state().selection.points.size(), 1U);
    ASSERT_TRUE(run_typed(editor_, "escape"));
    EXPECT_TRUE(state().selection.points.empty());
}

TEST_F(FindingsTest, labels_keep_clear_of_the_marks) {
    EXPECT_TRUE(test::overlapping_labels(picture()).empty());
}

}  // namespace
}  // namespace batten::editor
