#include "app/editor/commands/making_commands.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/commands/edit_commands.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

class MakingCommands : public ::testing::Test {
  protected:
    const EditorState& state() const { return editor_.state(); }
    bool run(const Command& command) { return editor_.run(command); }
    bool type(const std::string& text) { return run_typed(editor_, text); }
    void expect_refused(const std::string& typed, const std::string& sentence) {
        const std::size_t before = document(editor_).curves.size();
        EXPECT_FALSE(type(typed)) << typed;
        EXPECT_EQ(state().message.text, sentence);
        EXPECT_EQ(document(editor_).curves.size(), before);
    }

    Editor editor_;
};

TEST_F(MakingCommands, work_at_once_with_a_size_for_the_view) {
    for (const char* name : {"line", "polyline", "polygon", "circle", "arc", "ellipse", "elliptic-arc", "parabola",
                             "hyperbola", "conic"}) {
        const std::size_t before = document(editor_).curves.size();
        EXPECT_TRUE(type(name)) << name << ": " << state().message.text;
        ASSERT_EQ(document(editor_).curves.size(), before + 1) << name;
        EXPECT_EQ(document(editor_).active, before);
        core::Box box;
        for (const core::Point& point : points(editor_)) box.include(point);
        const core::Vector size_px = box.size() * state().view.camera.scale;
        EXPECT_GT(std::max(size_px.x, size_px.y), 80.0) << name;
        EXPECT_LT(std::max(size_px.x, size_px.y), 1000.0) << name;
        EXPECT_TRUE(run(Undo{}));
    }
    type("line");
    type("line");
    EXPECT_EQ(document(editor_).active_curve()->name, "line 2");
    EXPECT_EQ(state().history.undo_label(), "Make line");
    EXPECT_EQ(state().message.text, "Made line");
}

TEST_F(MakingCommands, take_numbers) {
    EXPECT_TRUE(run(AddLine{.from = {1.0, 2.0}, .to = {3.0, 4.0}}));
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{1, 2}, {3, 4}}));
    EXPECT_TRUE(type("circle 1 2 3"));
    EXPECT_EQ(points(editor_)[1], (core::Point{4, 5}));
    EXPECT_EQ(points(editor_).size(), 9U);
    EXPECT_TRUE(run(AddCircle{.center = {1.0, 2.0}, .radius = 3.0, .polygon = core::CirclePolygon::triangle}));
    EXPECT_EQ(points(editor_).size(), 7U);
    EXPECT_TRUE(run(AddArc{.center = {0.0, 0.0}, .radius = 2.0, .start = 90.0, .sweep = -180.0}));
    EXPECT_EQ(points(editor_).front(), (core::Point{0, 2}));
    EXPECT_EQ(points(editor_)[2], (core::Point{2, 0}));
    EXPECT_EQ(points(editor_).back(), (core::Point{0, -2}));
    EXPECT_TRUE(run(AddEllipse{.center = {0.0, 0.0}, .first_axis = 4.0, .second_axis = 2.0, .rotation = 90.0}));
    EXPECT_EQ(points(editor_).front(), (core::Point{0, 4}));
    EXPECT_TRUE(run(AddPolygon{.center = {0.0, 0.0}, .radius = 1.0, .sides = 4}));
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{0, 1}, {-1, 0}, {0, -1}, {1, 0}}));
    EXPECT_TRUE(run(AddPolyline{.points = {{0, 0}, {1, 0}, {1, 1}}, .closed = true}));
    EXPECT_TRUE(curve(editor_).is_periodic());
    EXPECT_TRUE(run(AddParabola{.vertex = {0.0, 0.0}, .focal_length = 0.25, .axis = 90.0, .from = -1.0, .to = 2.0}));
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{-1, 1}, {0.5, -2}, {2, 4}}));
    EXPECT_TRUE(run(AddConic{.points = {{0, 0}, {1, 2}, {2, 0}}, .weight = 3.0}));
    EXPECT_EQ(curve(editor_).weights()[1], 3.0);
    EXPECT_EQ(state().history.undo_label(), "Make conic: hyperbola, w/(1 + w) = 0.75");
    EXPECT_TRUE(run(AddConic{.points = {{0, 0}, {1, 2}, {2, 0}}, .weight = 1e160}));
    EXPECT_EQ(state().history.undo_label(), "Make conic: hyperbola, w/(1 + w) = 1");
}

TEST_F(MakingCommands, refuse_what_makes_no_shape) {
    expect_refused("line 1 1 1 1", "point 1 lies on point 0; the two must differ");
    expect_refused("circle 0 0 -1", "a length is -1; radii, axes and other lengths must be above 0");
    expect_refused("circle 0 0 1 8", "points is '8'; it must be 9 or 7");
    expect_refused("arc 0 0 1 0 400", "the angle is 400 degrees; it must be from -360 to 360 and not 0");
    expect_refused("polygon 0 0 1 2", "sides is 2; it must be from 3 to 1000");
    expect_refused("polygon 0 0 1 1e6", "sides is 1000000; it must be from 3 to 1000");
    expect_refused("polyline 0,0,1", "coordinates has 3 numbers; x and y of each point are needed");
    expect_refused("conic 0,0,1,2", "2 points were found for coordinates; 3 are needed");
    expect_refused("conic 0,0,1,1,2,2", "the three points lie on one line; they must make a triangle");
    expect_refused("hyperbola 0 0 1 1 0 2 1",
                   "the range begins at 2 and ends at 1; its end must be above its beginning");
    expect_refused("derivative", "there is no curve; draw one or open a file");
}

TEST_F(MakingCommands, derivative_adds_the_hodograph) {
    open_text(editor_, bezier_text);
    EXPECT_TRUE(run(AddHodograph{}));
    EXPECT_EQ(document(editor_).active_curve()->name, "hodograph of arch");
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{3, 6}, {6, 0}, {3, -6}}));
    EXPECT_EQ(curve(editor_).degree(), 2);
}

}  // namespace
}  // namespace batten::editor
