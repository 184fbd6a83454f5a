#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "core/evaluate/evaluate.h"
#include "core/measure/nearest.h"
#include "sample_editor.h"

namespace batten::editor {
namespace {

class FittingCommands : public ::testing::Test {
  protected:
    const EditorState& state() const { return editor_.state(); }
    const std::string& message() const { return state().message.text; }
    bool run(const std::string& name, std::vector<Argument> arguments = {}) {
        return editor_.run({name, std::move(arguments)});
    }
    void expect_refused(const std::string& name, std::vector<Argument> arguments, const std::string& sentence) {
        const std::size_t before = document(editor_).curves.size();
        EXPECT_FALSE(run(name, std::move(arguments)));
        EXPECT_EQ(message(), sentence);
        EXPECT_EQ(document(editor_).curves.size(), before);
    }
    double distance_to(core::Point point) const {
        return glm::distance(core::nearest_point(curve(editor_), point).point, point);
    }

    Editor editor_;
};

const std::vector<double> zigzag{0, 0, 1, 2, 3, 1, 4, 3, 6, 0};

TEST_F(FittingCommands, interpolate_typed_points) {
    EXPECT_TRUE(run("interpolate", {zigzag}));
    EXPECT_EQ(message(), "Interpolated points");
    EXPECT_EQ(curve(editor_).degree(), 3);
    EXPECT_EQ(points(editor_).size(), 5U);
    for (std::size_t k = 0; k < 5; ++k) EXPECT_LT(distance_to({zigzag[2 * k], zigzag[2 * k + 1]}), 1e-13);
    EXPECT_TRUE(run("interpolate", {std::vector<double>{0, 0, 1, 1, 2, 0}}));
    EXPECT_EQ(curve(editor_).degree(), 2);
    EXPECT_EQ(document(editor_).active_curve()->name, "curve 2");
}

TEST_F(FittingCommands, take_the_parametrization_by_name) {
    run("interpolate", {zigzag, 3.0, "uniform"});
    const auto uniform = points(editor_);
    run("interpolate", {zigzag, 3.0, "chordal"});
    EXPECT_NE(points(editor_), uniform);
    EXPECT_NE(knots(editor_)[4], 0.5);
    expect_refused("interpolate", {zigzag, 3.0, "round"},
                   "parametrization is 'round'; it must be uniform, chordal or centripetal");
}

TEST_F(FittingCommands, left_out_points_are_the_control_points) {
    open_text(editor_, sample_text);
    const auto through = points(editor_);
    EXPECT_TRUE(run("interpolate"));
    EXPECT_EQ(document(editor_).curves.size(), 4U);
    for (const core::Point& point : through) EXPECT_LT(distance_to(point), 1e-13);
    run("activate-curve", {0.0});
    run("select-points", {std::vector<double>{0, 2, 3, 5}});
    EXPECT_TRUE(run("interpolate-closed"));
    EXPECT_TRUE(curve(editor_).is_periodic());
    EXPECT_EQ(points(editor_).size(), 4U);
    for (const std::size_t i : {0U, 2U, 3U, 5U}) EXPECT_LT(distance_to(through[i]), 1e-13);
    EXPECT_GT(distance_to(through[1]), 0.1);
}

TEST_F(FittingCommands, natural_ends_and_tangents) {
    EXPECT_TRUE(run("interpolate-natural", {zigzag}));
    EXPECT_LT(glm::length(core::derivatives_at(curve(editor_), 0.0, 2)[2]), 1e-10);
    EXPECT_TRUE(run("interpolate-tangents", {std::vector<double>{0, 5}, std::vector<double>{0, 0}, zigzag}));
    EXPECT_LT(glm::distance(core::derivatives_at(curve(editor_), 0.0, 1)[1], core::Vector(0, 5)), 1e-12);
    EXPECT_EQ(points(editor_).size(), 6U);
    expect_refused("interpolate-tangents", {std::vector<double>{1}, std::vector<double>{0, 0}, zigzag},
                   "start needs x and y; 1 number was given");
    expect_refused("interpolate-natural", {zigzag, 2.0}, "the degree is 2; it must be at least 3 here");
}

TEST_F(FittingCommands, name_the_point_that_is_repeated) {
    expect_refused("interpolate", {std::vector<double>{0, 0, 1, 1, 1, 1, 2, 0}},
                   "point 2 lies on point 1; the two must differ");
    expect_refused("interpolate", {std::vector<double>{0, 0, 1}},
                   "interpolation needs x and y of 2 points or more; 3 coordinates were given");
    expect_refused("interpolate-closed", {std::vector<double>{0, 0, 1, 1}},
                   "2 points were found; at least 3 are needed");
}

std::vector<double> bow(int count) {
    std::vector<double> coordinates;
    for (int k = 0; k <= count; ++k) {
        coordinates.push_back(5.0 * k / count);
        coordinates.push_back(std::sin(5.0 * k / count));
    }
    return coordinates;
}

TEST_F(FittingCommands, fit_points_keeps_end_tangents) {
    ASSERT_TRUE(run("fit-points", {8.0, bow(50), 3.0, 0.0, 0.0, std::vector<double>{3, 1}, std::vector<double>{0, -2}}))
        << message();
    const auto start = core::derivatives_at(curve(editor_), 0.0, 1);
    const auto end = core::derivatives_at(curve(editor_), 1.0, 1);
    EXPECT_NEAR(start[1].x, 3.0, 1e-12);
    EXPECT_NEAR(start[1].y, 1.0, 1e-12);
    EXPECT_NEAR(end[1].x, 0.0, 1e-12);
    EXPECT_NEAR(end[1].y, -2.0, 1e-12);
}

TEST_F(FittingCommands, fit_points_says_the_error) {
    EXPECT_TRUE(run("fit-points", {8.0, bow(50)}));
    EXPECT_EQ(points(editor_).size(), 8U);
    EXPECT_EQ(message().substr(0, 38), "Fitted curve to points: error at most ") << message();
    EXPECT_TRUE(run("fit-points-within", {1e-4, bow(50)}));
    EXPECT_EQ(message().substr(0, 44), "Fitted curve within tolerance: error at most") << message();
    for (int k = 0; k <= 50; ++k) EXPECT_LT(distance_to({5.0 * k / 50, std::sin(5.0 * k / 50)}), 1e-4);
    EXPECT_TRUE(run("fit-points", {8.0, bow(50), 3.0, 1.0}));
    EXPECT_TRUE(curve(editor_).is_periodic());
    expect_refused("fit-points", {60.0, bow(50)},
                   "60 control points were asked for; at most 51 can be determined by these points");
    expect_refused("fit-points-within", {0.0, bow(50)}, "the tolerance is 0; it must be above 0 and finite");
}

TEST_F(FittingCommands, fit_points_smoothly) {
    EXPECT_TRUE(run("fit-points", {8.0, bow(50), 3.0, 0.0, 1e9}));
    for (const core::Point& point : points(editor_)) EXPECT_NEAR(point.y, point.x / 5.0 * std::sin(5.0), 1e-3);
}

TEST_F(FittingCommands, need_points_from_somewhere) {
    EXPECT_FALSE(run("interpolate"));
    EXPECT_TRUE(state().message.is_error);
    EXPECT_FALSE(run("fit-points-within", {0.1}));
}

}  // namespace
}  // namespace batten::editor
