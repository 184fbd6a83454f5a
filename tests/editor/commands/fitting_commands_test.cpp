#include "app/editor/commands/fitting_commands.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/commands/selection_commands.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/nearest.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

class FittingCommands : public ::testing::Test {
  protected:
    const EditorState& state() const { return editor_.state(); }
    const std::string& message() const { return state().message.text; }
    bool run(const Command& command) { return editor_.run(command); }
    bool type(const std::string& text) { return run_typed(editor_, text); }
    void expect_refused(const Command& command, const std::string& sentence) {
        const std::size_t before = document(editor_).curves.size();
        EXPECT_FALSE(run(command));
        EXPECT_EQ(message(), sentence);
        EXPECT_EQ(document(editor_).curves.size(), before);
    }
    void expect_refused(const std::string& typed, const std::string& sentence) {
        EXPECT_FALSE(type(typed));
        EXPECT_EQ(message(), sentence);
    }
    double distance_to(core::Point point) const {
        return core::distance(core::nearest_point(curve(editor_), point).point, point);
    }

    Editor editor_;
};

const std::vector<core::Point> zigzag_points{{0, 0}, {1, 2}, {3, 1}, {4, 3}, {6, 0}};

Interpolate through_zigzag(core::Parametrization parametrization) {
    return {.points = zigzag_points, .degree = 3, .parametrization = parametrization};
}

TEST_F(FittingCommands, interpolate_typed_points) {
    EXPECT_TRUE(run(through_zigzag(core::Parametrization::centripetal)));
    EXPECT_EQ(message(), "Interpolated points");
    EXPECT_EQ(curve(editor_).degree(), 3);
    EXPECT_EQ(points(editor_).size(), 5U);
    for (const core::Point point : zigzag_points) EXPECT_LT(distance_to(point), 1e-13);
    EXPECT_TRUE(type("interpolate 0,0,1,1,2,0"));
    EXPECT_EQ(curve(editor_).degree(), 2);
    EXPECT_EQ(document(editor_).active_curve()->name, "curve 2");
}

TEST_F(FittingCommands, take_the_parametrization_by_name) {
    run(through_zigzag(core::Parametrization::uniform));
    const auto uniform = points(editor_);
    run(through_zigzag(core::Parametrization::chordal));
    EXPECT_NE(points(editor_), uniform);
    EXPECT_NE(knots(editor_)[4], 0.5);
    expect_refused("interpolate 0,0,1,2,3,1 3 round",
                   "parametrization is 'round'; it must be uniform, chordal or centripetal");
}

TEST_F(FittingCommands, left_out_points_are_the_control_points) {
    open_text(editor_, sample_text);
    const auto through = points(editor_);
    EXPECT_TRUE(type("interpolate"));
    EXPECT_EQ(document(editor_).curves.size(), 4U);
    for (const core::Point& point : through) EXPECT_LT(distance_to(point), 1e-13);
    run(ActivateCurve{.index = 0});
    run(SelectPoints{.points = {0, 2, 3, 5}});
    EXPECT_TRUE(type("interpolate-closed"));
    EXPECT_TRUE(curve(editor_).is_periodic());
    EXPECT_EQ(points(editor_).size(), 4U);
    for (const std::size_t i : {0U, 2U, 3U, 5U}) EXPECT_LT(distance_to(through[i]), 1e-13);
    EXPECT_GT(distance_to(through[1]), 0.1);
}

TEST_F(FittingCommands, natural_ends_and_tangents) {
    EXPECT_TRUE(run(InterpolateNatural{
        .points = zigzag_points, .degree = 3, .parametrization = core::Parametrization::centripetal}));
    EXPECT_LT(core::length(core::derivatives_at(curve(editor_), 0.0, 2)[2]), 1e-10);
    EXPECT_TRUE(run(InterpolateTangents{.start = core::Vector(0, 5),
                                        .end = std::nullopt,
                                        .points = zigzag_points,
                                        .degree = 3,
                                        .parametrization = core::Parametrization::centripetal}));
    EXPECT_LT(core::length(core::derivatives_at(curve(editor_), 0.0, 1)[1] - core::Vector(0, 5)), 1e-12);
    EXPECT_EQ(points(editor_).size(), 6U);
    expect_refused("interpolate-tangents 1, 0,0 0,0,1,2,3,1",
                   "start is a list of one number; a list of two numbers is needed, x and y of the derivative at the "
                   "start; none leaves it free");
    expect_refused(
        InterpolateNatural{.points = zigzag_points, .degree = 2, .parametrization = core::Parametrization::chordal},
        "the degree is 2; it must be at least 3 here");
}

TEST_F(FittingCommands, name_the_point_that_is_repeated) {
    expect_refused("interpolate 0,0,1,1,1,1,2,0", "point 2 lies on point 1; the two must differ");
    expect_refused("interpolate 0,0,1", "coordinates has 3 numbers; x and y of each point are needed");
    expect_refused("interpolate-closed 0,0,1,1", "2 points were found; at least 3 are needed");
}

std::vector<core::Point> bow(int count) {
    std::vector<core::Point> points;
    for (int k = 0; k <= count; ++k) points.emplace_back(5.0 * k / count, std::sin(5.0 * k / count));
    return points;
}

TEST_F(FittingCommands, fit_points_keeps_end_tangents) {
    ASSERT_TRUE(run(FitPoints{.count = 8, .points = bow(50), .start = core::Vector(3, 1), .end = core::Vector(0, -2)}))
        << message();
    const auto start = core::derivatives_at(curve(editor_), 0.0, 1);
    const auto end = core::derivatives_at(curve(editor_), 1.0, 1);
    EXPECT_NEAR(start[1].x, 3.0, 1e-12);
    EXPECT_NEAR(start[1].y, 1.0, 1e-12);
    EXPECT_NEAR(end[1].x, 0.0, 1e-12);
    EXPECT_NEAR(end[1].y, -2.0, 1e-12);
}

TEST_F(FittingCommands, closed_fits_have_no_ends_for_derivatives_and_say_so) {
    std::vector<core::Point> ring;
    for (int k = 0; k < 40; ++k) ring.emplace_back(3 * std::cos(k * 0.157), 2 * std::sin(k * 0.157));
    ASSERT_TRUE(run(FitPoints{.count = 12, .points = ring, .closed = true}));
    const std::vector<core::Point> plain = points(editor_);
    ASSERT_TRUE(run(FitPoints{.count = 12, .points = ring, .closed = true, .start = core::Vector(9, 9)})) << message();
    EXPECT_EQ(points(editor_), plain);
    EXPECT_EQ(message().substr(0, message().find("; ")),
              "Fitted closed curve to points, without the derivatives at ends that it lacks");
    ASSERT_TRUE(run(FitPointsWithin{.tolerance = 0.1, .points = ring, .closed = true, .end = core::Vector(1, 0)}));
    EXPECT_EQ(message().substr(0, message().find("; ")),
              "Fitted closed curve within tolerance, without the derivatives at ends that it lacks");
}

TEST_F(FittingCommands, fits_refuse_ends_that_exclude_each_other) {
    expect_refused(FitPointsWithin{.tolerance = 0.1, .points = bow(50), .closed = true, .natural = true},
                   "a closed curve has no ends that could be natural: ask for one of the two");
    expect_refused(FitPoints{.count = 8, .points = bow(50), .end = core::Vector(1, 0), .natural = true},
                   "natural ends have free derivatives: leave out those at the start and the end");
    EXPECT_TRUE(run(FitPoints{.count = 8, .points = bow(50), .natural = true}));
    EXPECT_LT(core::length(core::derivatives_at(curve(editor_), 1.0, 2)[2]), 1e-9);
}

TEST_F(FittingCommands, fit_points_says_the_error) {
    EXPECT_TRUE(run(FitPoints{.count = 8, .points = bow(50)}));
    EXPECT_EQ(points(editor_).size(), 8U);
    EXPECT_EQ(message().substr(0, 38), "Fitted curve to points; error at most ") << message();
    EXPECT_TRUE(run(FitPointsWithin{.tolerance = 1e-4, .points = bow(50)}));
    EXPECT_EQ(message().substr(0, 44), "Fitted curve within tolerance; error at most") << message();
    for (int k = 0; k <= 50; ++k) EXPECT_LT(distance_to({5.0 * k / 50, std::sin(5.0 * k / 50)}), 1e-4);
    EXPECT_TRUE(run(FitPoints{.count = 8, .points = bow(50), .closed = true}));
    EXPECT_TRUE(curve(editor_).is_periodic());
    expect_refused(FitPoints{.count = 60, .points = bow(50)},
                   "60 control points were asked for; at most 51 can be determined by these points");
    expect_refused(FitPointsWithin{.tolerance = 0.0, .points = bow(50)},
                   "the tolerance is 0; it must be above 0 and finite");
}

TEST_F(FittingCommands, fit_points_smoothly) {
    EXPECT_TRUE(run(FitPoints{.count = 8, .points = bow(50), .smoothing = 1e9}));
    for (const core::Point& point : points(editor_)) EXPECT_NEAR(point.y, point.x / 5.0 * std::sin(5.0), 1e-3);
}

TEST_F(FittingCommands, need_points_from_somewhere) {
    EXPECT_FALSE(type("interpolate"));
    EXPECT_TRUE(state().message.is_error);
    EXPECT_FALSE(type("fit-points-within 0.1"));
}

}  // namespace
}  // namespace batten::editor
