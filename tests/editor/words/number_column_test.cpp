#include "app/editor/words/number_column.h"

#include <gtest/gtest.h>

#include <vector>

namespace batten::editor {
namespace {

std::vector<std::string> texts(const std::vector<double>& values) {
    std::vector<std::string> result;
    for (const double value : values) result.push_back(column_text(value, column_for(values)));
    return result;
}

using Texts = std::vector<std::string>;

TEST(NumberColumn, has_the_same_decimals_everywhere) {
    EXPECT_EQ(texts({0.5, 1.25, -3}), (Texts{"0.50", "1.25", "−3.00"}));
    EXPECT_EQ(texts({1, 1.995}), (Texts{"1.000", "1.995"}));
    EXPECT_EQ(texts({1, 2, 30}), (Texts{"1", "2", "30"}));
    EXPECT_EQ(texts({0}), (Texts{"0"}));
    EXPECT_EQ(texts({}), (Texts{}));
}

TEST(NumberColumn, has_six_digits_of_the_largest) {
    EXPECT_EQ(texts({1.0 / 3, 200.0 / 3}), (Texts{"0.3333", "66.6667"}));
    EXPECT_EQ(texts({123456.789}), (Texts{"123457"}));
    EXPECT_EQ(texts({0.70710678118654752, 1}), (Texts{"0.70711", "1.00000"}));
}

TEST(NumberColumn, never_shows_zero_for_what_is_not) {
    EXPECT_EQ(texts({1000.5, 1e-5}), (Texts{"1000.5", "1e−5"}));
    EXPECT_EQ(texts({0.0, 0.25}), (Texts{"0.00", "0.25"}));
}

TEST(NumberColumn, very_large_and_small_ones_have_powers_of_ten) {
    EXPECT_EQ(texts({1234567.5, -2e9}), (Texts{"1.23457e6", "−2e9"}));
    EXPECT_EQ(texts({2.5e-7}), (Texts{"2.5e−7"}));
}

/// A Bézier curve with these weights.
core::Curve weighted(const std::vector<double>& weights) {
    core::CurveDefinition definition;
    definition.degree = static_cast<int>(weights.size()) - 1;
    definition.knots.assign(weights.size(), 0.0);
    definition.knots.insert(definition.knots.end(), weights.size(), 1.0);
    for (std::size_t i = 0; i < weights.size(); ++i) definition.points.emplace_back(static_cast<double>(i), 0.0);
    definition.weights = weights;
    return core::Curve::make(definition).value();
}

Texts weight_texts(const std::vector<double>& weights) {
    Texts result;
    const core::Curve curve = weighted(weights);
    for (const double weight : weights) result.push_back(weight_text(weight, weight_column(curve)));
    return result;
}

TEST(WeightColumn, keeps_the_digits_of_a_weight_beside_greater_ones) {
    EXPECT_EQ(weight_texts({1, 1.995, 1}), (Texts{"1", "1.995", "1"}));
    EXPECT_EQ(weight_texts({1, 1.995, 12345.678}), (Texts{"1", "1.995", "12345.7"}));
    EXPECT_EQ(weight_texts({0.001, 0.70710678118654752, 500}), (Texts{"0.001", "0.70711", "500"}));
    EXPECT_EQ(weight_texts({1, 20.12345, 1e9}), (Texts{"1", "20.1234", "1e9"}));
    EXPECT_EQ(weight_texts({1e-7, 3, 3}), (Texts{"1e−7", "3", "3"}));
}

}  // namespace
}  // namespace batten::editor
