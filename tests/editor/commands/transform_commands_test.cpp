#include "app/editor/commands/transform_commands.h"

#include <gtest/gtest.h>

#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "core/evaluate/evaluate.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

using Points = std::vector<core::Point>;

// The arch and a closed ring.
constexpr const char* two_text = R"({ "format": "batten", "version": 1, "curves": [
  { "name": "arch", "degree": 3, "knots": [0,0,0,0,1,1,1,1], "points": [[0,0],[1,2],[3,2],[4,0]] },
  { "name": "ring", "degree": 2, "knots": [0,1,2,3,4], "points": [[10,0],[12,0],[12,2],[10,2]], "periodic": true } ] })";

class TransformCommands : public ::testing::Test {
  protected:
    TransformCommands() { open_text(editor_, two_text); }
    const EditorState& state() const { return editor_.state(); }
    const std::string& message() const { return state().message.text; }
    bool run(const Command& command) { return editor_.run(command); }
    bool type(const std::string& text) { return run_typed(editor_, text); }
    Points ring() const {
        const auto found = document(editor_).curves[1].curve->control_points();
        return {found.begin(), found.end()};
    }

    Editor editor_;
};

TEST_F(TransformCommands, move_the_curve_or_all) {
    EXPECT_TRUE(type("move 1 -2"));
    EXPECT_EQ(points(editor_), (Points{{1, -2}, {2, 0}, {4, 0}, {5, -2}}));
    EXPECT_EQ(message(),
              "Moved the curve by (1, -2); the curve moved by at most 2.23606797749979; every point of the curve is "
              "mapped with the control points");
    EXPECT_EQ(state().history.undo_label(), "Move the curve");
    EXPECT_TRUE(type("move -1 2 all"));
    EXPECT_EQ(points(editor_), (Points{{0, 0}, {1, 2}, {3, 2}, {4, 0}}));
    EXPECT_EQ(ring(), (Points{{9, 2}, {11, 2}, {11, 4}, {9, 4}}));
    EXPECT_EQ(state().history.undo_label(), "Move all curves");
}

TEST_F(TransformCommands, rotate_about_the_middle_of_the_box_or_a_pivot) {
    EXPECT_TRUE(type("rotate 90"));
    EXPECT_EQ(points(editor_), (Points{{3, -1}, {1, 0}, {1, 2}, {3, 3}})) << "about (2, 1)";
    EXPECT_EQ(message().rfind("Rotated the curve by 90° about (2, 1); ", 0), 0U) << message();
    run(Undo{});
    EXPECT_TRUE(type("rotate 90 curve 0 0"));
    EXPECT_EQ(points(editor_), (Points{{0, 0}, {-2, 1}, {-2, 3}, {0, 4}}));
    run(Undo{});
    EXPECT_TRUE(type("rotate 180 all")) << "about the middle of the box of both, (6, 1)";
    EXPECT_EQ(points(editor_), (Points{{12, 2}, {11, 0}, {9, 0}, {8, 2}}));
    EXPECT_EQ(ring(), (Points{{2, 2}, {0, 2}, {0, 0}, {2, 0}}));
    EXPECT_TRUE(document(editor_).curves[1].curve->is_periodic());
    run(Undo{});
    EXPECT_TRUE(type("rotate 90 curve center"));
    EXPECT_EQ(points(editor_)[0], core::Point(3, -1));
}

TEST_F(TransformCommands, map_the_selected_points_alone_where_there_are_any) {
    run(SelectPoints{.points = {1, 2}});
    EXPECT_TRUE(type("scale 2"));
    EXPECT_EQ(points(editor_), (Points{{0, 0}, {0, 2}, {4, 2}, {4, 0}}));
    EXPECT_NE(message().find("Scaled 2 points by 2 from (2, 2); "), std::string::npos) << message();
    EXPECT_NE(message().find("; the other control points stayed, so the curve has another shape"), std::string::npos);
    EXPECT_EQ(state().history.undo_label(), "Scale 2 points");
    EXPECT_EQ(state().selection.points, (std::vector<std::size_t>{1, 2}));
    EXPECT_TRUE(type("scale 2 curve 0 0"));
    EXPECT_EQ(points(editor_), (Points{{0, 0}, {0, 4}, {8, 4}, {8, 0}}));
    run(SelectAll{});
    EXPECT_TRUE(type("scale 0.5 selection 0 0"));
    EXPECT_NE(message().find("every point of the curve is mapped"), std::string::npos);
    run(SelectNone{});
    EXPECT_FALSE(type("scale 2 selection"));
    EXPECT_EQ(message(), "no control point is selected");
}

TEST_F(TransformCommands, stretch_shear_and_mirror) {
    EXPECT_TRUE(type("stretch 2 -1 curve 0 1"));
    EXPECT_EQ(points(editor_), (Points{{0, 2}, {2, 0}, {6, 0}, {8, 2}}));
    EXPECT_NE(message().find("Stretched the curve by 2 along x and -1 along y from (0, 1)"), std::string::npos);
    run(Undo{});
    EXPECT_TRUE(type("shear x 0.5 curve 0 0"));
    EXPECT_EQ(points(editor_), (Points{{0, 0}, {2, 2}, {4, 2}, {4, 0}}));
    EXPECT_NE(message().find("Sheared the curve along x by 0.5"), std::string::npos);
    run(Undo{});
    EXPECT_TRUE(type("shear y 0.5 curve 0 0"));
    EXPECT_EQ(points(editor_), (Points{{0, 0}, {1, 2.5}, {3, 3.5}, {4, 2}}));
    run(Undo{});
    EXPECT_TRUE(type("mirror 0 curve 0 1"));
    EXPECT_EQ(points(editor_), (Points{{0, 2}, {1, 0}, {3, 0}, {4, 2}}));
    EXPECT_NE(message().find("Mirrored the curve in the line through (0, 1) in the direction 0°"), std::string::npos);
    run(Undo{});
    EXPECT_TRUE(type("mirror 90 all"));
    EXPECT_EQ(points(editor_), (Points{{12, 0}, {11, 2}, {9, 2}, {8, 0}}));
}

TEST_F(TransformCommands, map_affinely_and_projectively) {
    EXPECT_TRUE(type("affine 1,2,3 0,1,-1"));
    EXPECT_EQ(points(editor_), (Points{{3, -1}, {8, 1}, {10, 1}, {7, -1}}));
    EXPECT_EQ(message().rfind("Mapped the curve affinely; the curve moved by at most ", 0), 0U) << message();
    run(Undo{});
    const core::Curve before = curve(editor_);
    EXPECT_TRUE(type("project 1,0,0 0,1,0 0.25,0,1"));
    EXPECT_EQ(points(editor_), (Points{{0, 0}, {0.8, 1.6}, {3 / 1.75, 2 / 1.75}, {2, 0}}));
    EXPECT_EQ(curve(editor_).weights()[3], 2.0);
    EXPECT_NE(message().find("mapped with the control points and their weights, and it is rational now"),
              std::string::npos)
        << message();
    const core::Point there = core::point_at(before, 0.3);
    const core::Point mapped = core::point_at(curve(editor_), 0.3);
    EXPECT_NEAR(mapped.x, there.x / (1 + there.x / 4), 1e-15);
    EXPECT_NEAR(mapped.y, there.y / (1 + there.x / 4), 1e-15);
    EXPECT_TRUE(type("project 1,0,0 0,1,0 0.25,0,1"));
    EXPECT_EQ(message().find("rational now"), std::string::npos);
}

TEST_F(TransformCommands, refuse_flat_maps_and_what_would_be_infinite) {
    EXPECT_FALSE(type("scale 0"));
    EXPECT_EQ(message(), "the map takes the plane onto a line or a point; it must have a determinant other than 0");
    EXPECT_FALSE(type("affine 1,2,0 2,4,0"));
    EXPECT_FALSE(type("project 1,0,0 0,1,0 -1,0,2"));
    EXPECT_EQ(message(),
              "the map takes control point 2 to infinity or beyond, where its weight would be -1; every weight must "
              "stay above 0");
    EXPECT_FALSE(type("project 1,0,0 0,1,0 -0.1,0,1 all"));
    EXPECT_EQ(message(),
              "'ring' cannot be mapped: the map takes control point 0 to infinity or beyond, where its weight would be "
              "0; every weight must stay above 0");
    EXPECT_FALSE(type("affine 1,2 0,1,0"));
    EXPECT_EQ(message(), "2 numbers were found for x row; 3 are needed");
    EXPECT_FALSE(type("rotate all"));
    EXPECT_FALSE(type("rotate 30 some"));
    EXPECT_EQ(message(), "what is 'some'; it must be selection, curve or all");
    EXPECT_EQ(points(editor_)[1], core::Point(1, 2));
}

TEST_F(TransformCommands, leave_all_as_it_was_where_one_is_locked) {
    open_text(editor_, sample_text);
    EXPECT_FALSE(type("move 1 1 all"));
    EXPECT_EQ(points(editor_)[0], core::Point(-6, -2.2));
    EXPECT_NE(message().find("line"), std::string::npos) << message();
    EXPECT_TRUE(type("move 1 1"));
}

TEST_F(TransformCommands, show_in_a_preview_what_would_come) {
    EXPECT_TRUE(editor_.run(Rotate{.angle = 90.0, .what = MapTarget::all}, Phase::preview));
    ASSERT_TRUE(state().preview.has_value());
    EXPECT_EQ(points(editor_)[0], core::Point(0, 0));
    EXPECT_EQ(state().preview->curves[0].curve->control_points()[0], core::Point(7, -5)) << "about (6, 1)";
    ASSERT_TRUE(state().ghost.has_value());
    EXPECT_GT(state().ghost->deviation, 1.0);
}

}  // namespace
}  // namespace batten::editor
