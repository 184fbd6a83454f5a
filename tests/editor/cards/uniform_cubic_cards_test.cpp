#include <gtest/gtest.h>

#include "app/editor/cards/cubic_cards.h"
#include "app/editor/cards/formula_picture.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

core::CurveDefinition coons() {
    return {.degree = 3,
            .knots = {-3, -2, -1, 0, 1, 2, 3, 4, 5},
            .points = {{0, 0}, {6, 18}, {24, 18}, {30, -6}, {42, 12}}};
}

EditorState coons_state(double u) {
    EditorState state = test::scene_state(coons());
    state.view.parameter = u;
    return state;
}

EditorState with_second(core::CurveDefinition second) {
    EditorState state = coons_state(0.5);
    core::Document document = state.history.present();
    core::DocumentCurve other = document.curves[0];
    other.name = "other";
    other.curve = std::make_shared<const core::Curve>(core::Curve::make(std::move(second)).value());
    document.curves.push_back(other);
    state.preview = document;
    return state;
}

bool has_line(const Card& card, const std::string& line) {
    const std::string text = "\n" + card_text(card) + "\n";
    return text.find("\n" + line + "\n") != std::string::npos;
}

std::vector<std::string> entries_of(const Card& card, std::size_t picture) {
    for (const CardBlock& block : card.blocks) {
        const auto* found = std::get_if<CardPicture>(&block);
        if (found == nullptr || picture-- > 0) continue;
        return test::texts_of(found->draw({320.0, found->height}, 1.0).list);
    }
    return {};
}

TEST(CubicConditionsCard, has_fifteen_equations_and_the_sum) {
    const Card card = cubic_conditions_card(coons_state(0.25));
    for (const char* line :
         {"0 | 0 = b₃(0) | 0 = 0 | ✓", " | b₃′(1) = b₂′(0) | 1/2 = 1/2 | ✓", "2 | b₂(1) = b₁(0) | 2/3 = 2/3 | ✓",
          " | b₂″(1) = b₁″(0) | −2 = −2 | ✓", " | b₁′(1) = b₀′(0) | −1/2 = −1/2 | ✓", " | b₀″(1) = 0 | 0 = 0 | ✓",
          "b₀(0) + b₁(0) + b₂(0) + b₃(0) = 1", "1/6 + 2/3 + 1/6 + 0 = 1 | ✓", "b₁(t) = (4 − 6 t² + 3 t³)/6"})
        EXPECT_TRUE(has_line(card, line)) << line << "\n" << card_text(card);
    std::size_t ticks = 0;
    const std::string text = card_text(card);
    for (std::size_t at = text.find("✓"); at != std::string::npos; at = text.find("✓", at + 1)) ++ticks;
    EXPECT_EQ(ticks, 16u);
    EXPECT_EQ(text.find("✗"), std::string::npos);
}

TEST(CubicConditionsCard, needs_no_curve) {
    EXPECT_EQ(card_text(cubic_conditions_card(test::sample_state())), card_text(cubic_conditions_card(coons_state(0))));
}

TEST(CubicMatrixCard, has_the_matrix_and_the_points_put_in) {
    const Card card = cubic_matrix_card(coons_state(1.25));
    EXPECT_TRUE(has_line(card, "Segment 2 of 2, u from 1 to 2: t = 1/4")) << card_text(card);
    EXPECT_EQ(entries_of(card, 0),
              (std::vector<std::string>{"C =", "1", "t", "t^{2}", "t^{3}", "1/6",   "1",     "−3",   "3",
                                        "−1",  "4", "0", "−6",    "3",     "1",     "3",     "3",    "−3",
                                        "0",   "0", "0", "1",     "P_{1}", "P_{2}", "P_{3}", "P_{4}"}));
    // Columns of the points' x and y, and of the coefficients: (P1 + 4 P2 + P3)/6, (P3 - P1)/2 and so on.
    const std::vector<std::string> numbers = entries_of(card, 1);
    ASSERT_EQ(numbers.size(), 22u);
    EXPECT_EQ(std::vector<std::string>(numbers.begin() + 5, numbers.begin() + 13),
              (std::vector<std::string>{"6", "24", "30", "42", "18", "18", "−6", "12"}));
    EXPECT_EQ(std::vector<std::string>(numbers.begin() + 14, numbers.end()),
              (std::vector<std::string>{"22", "12", "−6", "3", "14", "−12", "−12", "11"}));
    EXPECT_TRUE(has_line(card, "b₀ | b₁ | b₂ | b₃ | Σ"));
    EXPECT_TRUE(has_line(card, "9/128 | 235/384 | 121/384 | 1/384 | 1")) << card_text(card);
    // 22 + 3 - 3/8 + 3/64 = 1579/64 and 14 - 3 - 3/4 + 11/64 = 667/64.
    EXPECT_TRUE(has_line(card, "C(1/4) = (24.67, 10.42)")) << card_text(card);
}

TEST(AnticentroidsCard, tells_the_construction_with_numbers) {
    const Card card = anticentroids_card(coons_state(0.25));
    EXPECT_TRUE(has_line(card, "Triangle P₀ P₁ P₂, joint S = C(0)"));
    EXPECT_TRUE(has_line(card, "M | (P₀ + P₂)/2 | (12, 9)"));
    EXPECT_TRUE(has_line(card, "S | P₁ + (M − P₁)/3 | (8, 15)"));
    EXPECT_TRUE(has_line(card, "S′ | (P₂ − P₀)/2 | (12, 9)"));
    EXPECT_TRUE(has_line(card, "S″ | P₀ − 2 P₁ + P₂ | (12, −18)")) << card_text(card);
    EditorState hovering = coons_state(0.25);
    hovering.hover = HoveredPoint{3};
    EXPECT_TRUE(has_line(anticentroids_card(hovering), "Triangle P₂ P₃ P₄, joint S = C(2)"));
    core::CurveDefinition slow = coons();
    for (double& knot : slow.knots) knot *= 2.0;
    EXPECT_TRUE(has_line(anticentroids_card(test::scene_state(slow)),
                         "Derivatives are per knot step; by u the first is divided by 2, the second by 4."));
}

TEST(FergusonCard, has_ends_and_tangents) {
    const Card card = ferguson_card(coons_state(0.5));
    EXPECT_TRUE(has_line(card, "Q₀ | (P₀ + 4 P₁ + P₂)/6 | (8, 15)"));
    EXPECT_TRUE(has_line(card, "Q₁ | (P₁ + 4 P₂ + P₃)/6 | (22, 14)"));
    EXPECT_TRUE(has_line(card, "Q₀′ | (P₂ − P₀)/2 | (12, 9)"));
    EXPECT_TRUE(has_line(card, "Q₁′ | (P₃ − P₁)/2 | (12, −12)")) << card_text(card);
    EXPECT_TRUE(has_line(card, "F₀ | 1 − 3 t² + 2 t³ | 1/2"));
    EXPECT_TRUE(has_line(card, "F₂ | t − 2 t² + t³ | 1/8"));
    EXPECT_TRUE(has_line(card, "F₃ | −t² + t³ | −1/8"));
    EXPECT_TRUE(has_line(card, "Next segment"));
    EXPECT_FALSE(has_line(card, "Previous segment"));
}

TEST(EndVerticesCard, has_both_ends_and_what_one_can_do) {
    const Card card = end_vertices_card(coons_state(0.25));
    EXPECT_TRUE(has_line(card, "as it is | (P₀ + 4 P₁ + P₂)/6 | (P₂ − P₀)/2"));
    EXPECT_TRUE(has_line(card, "double | (5 P₀ + P₁)/6 | (P₁ − P₀)/2"));
    EXPECT_TRUE(has_line(card, "phantom | P₄ | P₄ − P₃")) << card_text(card);
    EXPECT_TRUE(has_line(card, "triple | P₄ | 0"));
    EXPECT_FALSE(has_line(card, "Double P₁")) << "of no kind, it would not stay uniform";
    core::CurveDefinition uniform = coons();
    uniform.kind = core::KnotKind::uniform;
    EXPECT_TRUE(has_line(end_vertices_card(test::scene_state(uniform)), "Double P₁"));
    core::CurveDefinition straight = coons();
    straight.points = {{0, 0}, {6, 6}, {18, 18}, {12, 12}, {12, 40}};
    EXPECT_TRUE(has_line(end_vertices_card(test::scene_state(straight)),
                         "The four control points of the segment at u are on one line: it is straight."));
    core::CurveDefinition ring{
        .degree = 3, .knots = {0, 1, 2, 3}, .points = {{0, 0}, {6, 0}, {0, 6}}, .periodic = true};
    EXPECT_TRUE(
        has_line(end_vertices_card(test::scene_state(ring)),
                 "The curve is periodic and has no ends; inner vertices can be double, triple or on a line, too."));
}

TEST(JoinedCubicsCard, compares_both_sides) {
    core::CurveDefinition second{
        .degree = 3, .knots = {0, 1, 2, 3, 4, 5, 6, 7}, .points = {{24, 18}, {30, -6}, {42, 12}, {60, 0}}};
    const Card joined = joined_cubics_card(with_second(second));
    EXPECT_TRUE(has_line(joined, "C | (31, 1) | (31, 1) | ✓")) << card_text(joined);
    EXPECT_TRUE(has_line(joined, " | P₂ P₃ P₄ | P₀ P₁ P₂")) << card_text(joined);
    EXPECT_TRUE(has_line(joined, "C″ | (6, 42) | (6, 42) | ✓"));
    EXPECT_TRUE(has_line(joined, "They join with C²: the three vertices are common to both."));
    second.points[0] = {24, 12};
    const Card apart = joined_cubics_card(with_second(second));
    EXPECT_TRUE(has_line(apart, "C | (31, 1) | (31, 0) | ✗")) << card_text(apart);
    EXPECT_TRUE(has_line(apart, "Share three vertices"));
}

TEST(JoinedCubicsCard, tells_of_one_curve_alone) {
    EXPECT_TRUE(has_line(joined_cubics_card(coons_state(0.5)),
                         "The segment at u and the next one share P₁, P₂ and P₃, which alone make their joint and its "
                         "first two derivatives. So they join with C²."));
    EXPECT_TRUE(has_line(joined_cubics_card(coons_state(1.5)),
                         "The segment at u and the one before it share P₁, P₂ and P₃, which alone make their joint and "
                         "its first two derivatives. So they join with C²."));
}

TEST(CubicCards, say_what_is_missing_and_offer_it) {
    core::CurveDefinition clamped = coons();
    clamped.knots = {0, 0, 0, 0, 1, 2, 2, 2, 2};
    const EditorState empty;
    for (Card (*make)(const EditorState&) :
         {cubic_matrix_card, anticentroids_card, ferguson_card, end_vertices_card, joined_cubics_card}) {
        EXPECT_TRUE(has_line(make(test::scene_state(clamped)), "Space the knots equally"));
        EXPECT_TRUE(has_line(make(empty), "Open the example"));
    }
}

TEST(CubicCards, survive_the_worst_curves) {
    core::CurveDefinition huge = coons();
    for (core::Point& point : huge.points) point = {1e300 * point.x, -1e300 * point.y};
    core::CurveDefinition one_place = coons();
    one_place.points.assign(5, {1e6, -1e6});
    core::CurveDefinition two{.degree = 3, .knots = {0, 1, 2}, .points = {{0, 0}, {1, 1}}, .periodic = true};
    core::CurveDefinition many{.degree = 3, .points = test::scattered_points(10000, {10, 10})};
    for (std::size_t i = 0; i < 10004; ++i) many.knots.push_back(static_cast<double>(i));
    for (const core::CurveDefinition& definition : {huge, one_place, two, many})
        for (Card (*make)(const EditorState&) : {cubic_conditions_card, cubic_matrix_card, anticentroids_card,
                                                 ferguson_card, end_vertices_card, joined_cubics_card}) {
            const std::string text = card_text(make(test::scene_state(definition)));
            EXPECT_EQ(text.find("nan"), std::string::npos) << text;
        }
}

}  // namespace
}  // namespace batten::editor
