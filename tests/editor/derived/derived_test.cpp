#include "app/editor/derived/derived.h"

#include <gtest/gtest.h>

#include "core/curve/control_box.h"
#include "core/edit/knot_edit.h"
#include "core/edit/point_edit.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {

namespace {

struct Number {
    std::shared_ptr<const int> value;
};

bool is_shared(const Number& a, const Number& b) {
    return a.value == b.value;
}

Number number(int value) {
    return {std::make_shared<const int>(value)};
}

TEST(Kept, computes_once_for_what_is_shared) {
    const Kept<Number, int, is_shared> kept;
    int computed = 0;
    const auto twice = [&](const Number& n) {
        ++computed;
        return 2 * *n.value;
    };
    const Number seven = number(7);
    const Number copy = seven;
    for (int i = 0; i < 5; ++i) {
        EXPECT_EQ(*kept.of(seven, twice), 14);
        EXPECT_EQ(*kept.of(copy, twice), 14);
    }
    EXPECT_EQ(computed, 1);
}

TEST(Kept, keeps_three_and_forgets_the_one_asked_for_longest_ago) {
    const Kept<Number, int, is_shared> kept;
    int computed = 0;
    const auto count = [&](const Number& n) {
        ++computed;
        return *n.value;
    };
    const std::vector<Number> numbers{number(0), number(1), number(2), number(3)};
    for (int round = 0; round < 4; ++round)
        for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(*kept.of(numbers[i], count), static_cast<int>(i));
    EXPECT_EQ(computed, 3);
    kept.of(numbers[0], count);
    kept.of(numbers[3], count);
    EXPECT_EQ(computed, 4);
    kept.of(numbers[0], count);
    kept.of(numbers[2], count);
    EXPECT_EQ(computed, 4);
    kept.of(numbers[1], count);
    EXPECT_EQ(computed, 5);
}

TEST(Kept, lets_go_of_what_it_forgot) {
    const Kept<Number, int, is_shared> kept;
    const auto value = [](const Number& n) { return *n.value; };
    std::weak_ptr<const int> forgotten;
    {
        const Number first = number(0);
        forgotten = first.value;
        kept.of(first, value);
    }
    EXPECT_FALSE(forgotten.expired());
    for (int i = 1; i <= 3; ++i) kept.of(number(i), value);
    EXPECT_TRUE(forgotten.expired());
}

TEST(KeptBeside, keeps_any_number_as_long_as_they_live) {
    const KeptBeside<int, int> kept;
    int computed = 0;
    const auto twice = [&](int n) {
        ++computed;
        return 2 * n;
    };
    std::vector<std::shared_ptr<const int>> numbers;
    for (int i = 0; i < 100; ++i) numbers.push_back(std::make_shared<const int>(i));
    for (int round = 0; round < 3; ++round)
        for (int i = 0; i < 100; ++i) EXPECT_EQ(*kept.of(numbers[static_cast<std::size_t>(i)], twice), 2 * i);
    EXPECT_EQ(computed, 100);
    EXPECT_EQ(kept.size(), 100U);
    numbers.resize(1);
    for (int i = 0; i < 1000; ++i) EXPECT_EQ(*kept.of(std::make_shared<const int>(i), twice), 2 * i);
    EXPECT_LT(kept.size(), 250U);
    EXPECT_EQ(*kept.of(numbers.front(), twice), 0);
    EXPECT_EQ(computed, 1100);
}

class DerivedTest : public ::testing::Test {
  protected:
    void SetUp() override { open_text(editor_, sample_text); }

    Editor editor_;
    Derived derived_;
};

TEST_F(DerivedTest, is_the_same_for_copies_and_for_unchanged_knots) {
    const core::Curve& wave = curve(editor_);
    const core::Curve copy = wave;
    const core::Curve dragged = core::set_control_point(wave, 3, {9.0, 9.0}).value();
    EXPECT_EQ(derived_.of(wave), derived_.of(copy));
    EXPECT_EQ(derived_.of(wave.knots()), derived_.of(copy.knots()));
    EXPECT_EQ(derived_.of(wave.knots()), derived_.of(dragged.knots()));
    EXPECT_NE(derived_.of(wave), derived_.of(dragged));
    EXPECT_EQ(derived_.weights_of(wave), derived_.weights_of(dragged));
    EXPECT_NE(derived_.weights_of(wave), derived_.weights_of(core::set_weight(wave, 3, 5.0).value()));
    const core::Curve other = core::move_knot(wave, 5, 0.4, core::KnotMove::stop).value();
    EXPECT_NE(derived_.of(wave.knots()), derived_.of(other.knots()));
}

TEST_F(DerivedTest, says_what_the_curve_says) {
    for (const core::DocumentCurve& item : document(editor_).curves) {
        const core::Curve& curve = *item.curve;
        const auto knots = derived_.of(curve.knots());
        std::vector<core::DistinctKnot> distinct;
        for (const std::size_t first : knots->runs) distinct.push_back(core::distinct_knot(curve.knots(), first));
        EXPECT_EQ(distinct, core::distinct_knots(curve.knots()));
        EXPECT_EQ(knots->segment_count, core::segment_count(curve.knots()));
        EXPECT_EQ(knots->least_continuity, core::least_continuity(curve.knots()));
        EXPECT_EQ(knots->kind, core::kind_by_values(curve.knots()));
        EXPECT_EQ(knots->is_bezier, core::is_of_kind(curve.knots(), core::KnotKind::bezier));
        EXPECT_EQ(knots->is_torn(), curve.is_torn());
        const auto facts = derived_.of(curve);
        EXPECT_EQ(facts->control_box.lower, core::control_box(curve).lower);
        EXPECT_EQ(facts->control_box.upper, core::control_box(curve).upper);
        EXPECT_EQ(derived_.weights_of(curve)->column, weight_column(curve));
    }
    const auto wave = derived_.of(curve(editor_));
    EXPECT_EQ(wave->size, 12.2);
    EXPECT_EQ(derived_.weights_of(curve(editor_))->lightest, 1.0);
    EXPECT_EQ(derived_.weights_of(curve(editor_))->heaviest, 2.0);
    EXPECT_EQ(*derived_.of(curve(editor_).knots())->least_continuity, 2);
}

TEST_F(DerivedTest, keeps_what_is_near_beside_each_curve) {
    const auto& curves = document(editor_).curves;
    const auto first = derived_.near_parts(curves.front().curve);
    for (const core::DocumentCurve& item : curves) {
        EXPECT_EQ(derived_.near_parts(item.curve)->curve(), *item.curve);
        EXPECT_EQ(derived_.near_parts(item.curve), derived_.near_parts(item.curve));
    }
    EXPECT_EQ(derived_.near_parts(curves.front().curve), first);
}

TEST_F(DerivedTest, sees_a_tear) {
    run_typed(editor_, "allow-tears");
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(run_typed(editor_, "insert-knot 0.5")) << editor_.state().message.text;
    EXPECT_TRUE(curve(editor_).is_torn());
    EXPECT_TRUE(derived_.of(curve(editor_).knots())->is_torn());
}

}  // namespace

}  // namespace batten::editor
