#include <gtest/gtest.h>

#include "sample_editor.h"

namespace batten::editor {
namespace {

class RefinementCommands : public ::testing::Test {
  protected:
    void SetUp() override { open_text(editor_, bezier_text); }
    bool run(const std::string& name, std::vector<Argument> arguments = {}) {
        return editor_.run({name, std::move(arguments)});
    }
    const std::string& message() const { return editor_.state().message.text; }

    Editor editor_;
};

TEST_F(RefinementCommands, insert_many_knots_at_once) {
    ASSERT_TRUE(run("insert-knots", {std::vector<double>{0.5, 0.25, 0.5}})) << message();
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.25, 0.5, 0.5, 1, 1, 1, 1}));
    EXPECT_FALSE(run("insert-knots", {std::vector<double>{0.5, 2.0}}));
    EXPECT_EQ(knots(editor_).size(), 11U);
}

TEST_F(RefinementCommands, remove_what_was_inserted) {
    const std::vector<core::Point> before = points(editor_);
    ASSERT_TRUE(run("insert-knots", {std::vector<double>{0.5, 0.5, 0.25}}));
    ASSERT_TRUE(run("remove-knot", {0.5, 2.0})) << message();
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.25, 1, 1, 1, 1}));
    ASSERT_TRUE(run("remove-knots")) << message();
    EXPECT_EQ(points(editor_), before);
}

TEST_F(RefinementCommands, remove_nothing_over_the_tolerance) {
    ASSERT_TRUE(run("insert-knot", {0.5}));
    ASSERT_TRUE(run("set-point", {2.0, 2.0, 3.0}));
    const std::vector<core::Point> before = points(editor_);
    EXPECT_FALSE(run("remove-knot", {0.5, 1.0, 0.01}));
    EXPECT_NE(message().find("only 0 of the knots can be removed"), std::string::npos) << message();
    EXPECT_EQ(points(editor_), before);
    EXPECT_TRUE(run("remove-knot", {0.5, 1.0, 10.0})) << message();
    EXPECT_NE(message().find("Removed knot 0.5: deviates by at most"), std::string::npos) << message();
}

TEST_F(RefinementCommands, merge_near_knots) {
    ASSERT_TRUE(run("insert-knots", {std::vector<double>{0.5, 0.500001}}));
    EXPECT_FALSE(run("merge-knots"));
    ASSERT_TRUE(run("merge-knots", {1e-5})) << message();
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.5, 0.5, 1, 1, 1, 1}));
}

TEST_F(RefinementCommands, domains_are_set_and_normalized) {
    const std::vector<core::Point> before = points(editor_);
    ASSERT_TRUE(run("reparametrize", {2.0, 6.0})) << message();
    EXPECT_EQ(knots(editor_), (std::vector<double>{2, 2, 2, 2, 6, 6, 6, 6}));
    ASSERT_TRUE(run("normalize"));
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 1, 1, 1, 1}));
    EXPECT_EQ(points(editor_), before);
    EXPECT_FALSE(run("reparametrize", {1.0, 1.0}));
}

TEST_F(RefinementCommands, unclamp_and_clamp) {
    const std::vector<core::Point> before = points(editor_);
    ASSERT_TRUE(run("unclamp", {"start"})) << message();
    EXPECT_LT(knots(editor_).front(), 0.0);
    EXPECT_EQ(knots(editor_).back(), 1.0);
    ASSERT_TRUE(run("clamp", {"both"})) << message();
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 1, 1, 1, 1}));
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_NEAR(points(editor_)[i].x, before[i].x, 1e-14);
        EXPECT_NEAR(points(editor_)[i].y, before[i].y, 1e-14);
    }
    EXPECT_FALSE(run("clamp", {"middle"}));
    EXPECT_EQ(message(), "end is 'middle'; it must be start, end or both");
}

TEST_F(RefinementCommands, make_uniform_spaces_the_knots) {
    ASSERT_TRUE(run("insert-knots", {std::vector<double>{0.25, 0.375}}));
    ASSERT_TRUE(run("make-uniform")) << message();
    const std::vector<double> expected{0, 0, 0, 0, 1.0 / 3.0, 2.0 / 3.0, 1, 1, 1, 1};
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(knots(editor_)[i], expected[i], 1e-15);
    EXPECT_NE(message().find("deviates by at most"), std::string::npos) << message();
}

TEST_F(RefinementCommands, elevate_and_reduce_by_several) {
    const std::vector<core::Point> before = points(editor_);
    ASSERT_TRUE(run("elevate", {2.0})) << message();
    EXPECT_EQ(message(), "Raised degree to 5: the curve is unchanged");
    EXPECT_EQ(curve(editor_).degree(), 5);
    ASSERT_TRUE(run("reduce", {2.0, 1e-9})) << message();
    EXPECT_EQ(curve(editor_).degree(), 3);
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(points(editor_)[i].y, before[i].y, 1e-13);
    EXPECT_FALSE(run("reduce", {1.0, 1e-9}));
    EXPECT_EQ(curve(editor_).degree(), 3);
    EXPECT_FALSE(run("elevate", {0.0}));
    EXPECT_EQ(message(), "t is 0; it must be 1 or more");
}

TEST_F(RefinementCommands, to_bezier_raises_every_knot) {
    ASSERT_TRUE(run("insert-knot", {0.5}));
    ASSERT_TRUE(run("to-bezier")) << message();
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1, 1}));
    // De Casteljau at 1/2: the middle point is (P0 + 3 P1 + 3 P2 + P3) / 8.
    EXPECT_EQ(points(editor_)[3], core::Point(2.0, 1.5));
}

}  // namespace
}  // namespace batten::editor
