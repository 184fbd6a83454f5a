#include <gtest/gtest.h>

#include <cmath>

#include "sample_editor.h"

namespace batten::editor {
namespace {

class MakingCommands : public ::testing::Test {
  protected:
    const EditorState& state() const { return editor_.state(); }
    bool run(const std::string& name, std::vector<Argument> arguments = {}) {
        return editor_.run({name, std::move(arguments)});
    }
    void expect_refused(const std::string& name, std::vector<Argument> arguments, const std::string& sentence) {
        const std::size_t before = document(editor_).curves.size();
        EXPECT_FALSE(run(name, std::move(arguments)));
        EXPECT_EQ(state().message.text, sentence);
        EXPECT_EQ(document(editor_).curves.size(), before);
    }

    Editor editor_;
};

TEST_F(MakingCommands, work_at_once_with_a_size_for_the_view) {
    for (const char* name : {"line", "polyline", "polygon", "circle", "arc", "ellipse", "elliptic-arc", "parabola",
                             "hyperbola", "conic"}) {
        const std::size_t before = document(editor_).curves.size();
        EXPECT_TRUE(run(name)) << name << ": " << state().message.text;
        ASSERT_EQ(document(editor_).curves.size(), before + 1) << name;
        EXPECT_EQ(document(editor_).active, before);
        core::Box box;
        for (const core::Point& point : points(editor_)) box.include(point);
        const core::Vector size_px = box.size() * state().view.camera.scale;
        EXPECT_GT(std::max(size_px.x, size_px.y), 80.0) << name;
        EXPECT_LT(std::max(size_px.x, size_px.y), 1000.0) << name;
        EXPECT_TRUE(run("undo"));
    }
    run("line");
    run("line");
    EXPECT_EQ(document(editor_).active_curve()->name, "line 2");
    EXPECT_EQ(state().history.undo_label(), "Make line");
    EXPECT_EQ(state().message.text, "Made line");
}

TEST_F(MakingCommands, take_numbers) {
    EXPECT_TRUE(run("line", {1.0, 2.0, 3.0, 4.0}));
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{1, 2}, {3, 4}}));
    EXPECT_TRUE(run("circle", {1.0, 2.0, 3.0}));
    EXPECT_EQ(points(editor_)[1], (core::Point{4, 5}));
    EXPECT_EQ(points(editor_).size(), 9U);
    EXPECT_TRUE(run("circle", {1.0, 2.0, 3.0, 7.0}));
    EXPECT_EQ(points(editor_).size(), 7U);
    EXPECT_TRUE(run("arc", {0.0, 0.0, 2.0, 90.0, -180.0}));
    EXPECT_EQ(points(editor_).front(), (core::Point{0, 2}));
    EXPECT_EQ(points(editor_)[2], (core::Point{2, 0}));
    EXPECT_EQ(points(editor_).back(), (core::Point{0, -2}));
    EXPECT_TRUE(run("ellipse", {0.0, 0.0, 4.0, 2.0, 90.0}));
    EXPECT_EQ(points(editor_).front(), (core::Point{0, 4}));
    EXPECT_TRUE(run("polygon", {0.0, 0.0, 1.0, 4.0}));
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{0, 1}, {-1, 0}, {0, -1}, {1, 0}}));
    EXPECT_TRUE(run("polyline", {std::vector<double>{0, 0, 1, 0, 1, 1}, 1.0}));
    EXPECT_TRUE(curve(editor_).is_periodic());
    EXPECT_TRUE(run("parabola", {0.0, 0.0, 0.25, 90.0, -1.0, 2.0}));
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{-1, 1}, {0.5, -2}, {2, 4}}));
    EXPECT_TRUE(run("conic", {std::vector<double>{0, 0, 1, 2, 2, 0}, 3.0}));
    EXPECT_EQ(curve(editor_).weights()[1], 3.0);
    EXPECT_EQ(state().history.undo_label(), "Make conic: hyperbola, w/(1 + w) = 0.75");
}

TEST_F(MakingCommands, refuse_what_makes_no_shape) {
    expect_refused("line", {1.0, 1.0, 1.0, 1.0}, "point 1 lies on point 0; the two must differ");
    expect_refused("circle", {0.0, 0.0, -1.0}, "a length is -1; radii, axes and other lengths must be above 0");
    expect_refused("circle", {0.0, 0.0, 1.0, 8.0}, "the circle has 8 control points; it must be 9 or 7");
    expect_refused("arc", {0.0, 0.0, 1.0, 0.0, 400.0},
                   "the angle is 400 degrees; it must be from -360 to 360 and not 0");
    expect_refused("polygon", {0.0, 0.0, 1.0, 2.0}, "2 control points were found; at least 3 are needed");
    expect_refused("polygon", {0.0, 0.0, 1.0, 1e6}, "the polygon has 1000000 sides; at most 1000 are allowed");
    expect_refused("polyline", {std::vector<double>{0, 0, 1}},
                   "a polyline needs x and y of 2 points or more; 3 coordinates were given");
    expect_refused("conic", {std::vector<double>{0, 0, 1, 2}},
                   "a conic needs x and y of 3 points; 4 coordinates were given");
    expect_refused("conic", {std::vector<double>{0, 0, 1, 1, 2, 2}},
                   "the three points lie on one line; they must make a triangle");
    expect_refused("hyperbola", {0.0, 0.0, 1.0, 1.0, 0.0, 2.0, 1.0},
                   "the range begins at 2 and ends at 1; its end must be above its beginning");
    expect_refused("derivative", {}, "there is no curve; draw one or open a file");
}

TEST_F(MakingCommands, derivative_adds_the_hodograph) {
    open_text(editor_, bezier_text);
    EXPECT_TRUE(run("derivative"));
    EXPECT_EQ(document(editor_).active_curve()->name, "hodograph of arch");
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{3, 6}, {6, 0}, {3, -6}}));
    EXPECT_EQ(curve(editor_).degree(), 2);
}

}  // namespace
}  // namespace batten::editor
