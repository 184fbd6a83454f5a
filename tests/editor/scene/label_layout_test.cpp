#include "app/editor/scene/label_layout.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "app/editor/scene/label_spots.h"
#include "app/editor/scene/text_size.h"

namespace batten::editor {
namespace {

constexpr glm::dvec2 picture{800.0, 600.0};
constexpr glm::dvec2 text{30.0, 16.0};
constexpr glm::dvec2 point{400.0, 300.0};

std::optional<LabelPlace> place(LabelLayout& layout, glm::dvec2 at = point) {
    return layout.place(at, text, 11.0, LabelSide::upper_right, Crowding::leave_out);
}

TEST(LabelLayout, prefers_the_upper_right) {
    LabelLayout layout(picture);
    const auto found = place(layout);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->anchor, render::Anchor::left);
    EXPECT_DOUBLE_EQ(found->position.x, 411.0);
    EXPECT_LT(found->position.y, 300.0 - 8.0);
    EXPECT_DOUBLE_EQ(found->box.upper_px.x - found->box.lower_px.x, 30.0);
}

TEST(LabelLayout, makes_way_for_a_line) {
    LabelLayout layout(picture);
    layout.avoid_line(std::array{point, glm::dvec2(500.0, 250.0)});
    const auto found = place(layout);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->anchor, render::Anchor::right) << "upper left comes next";
    EXPECT_LT(found->position.y, 300.0);
}

TEST(LabelLayout, stays_on_a_side_that_is_told) {
    LabelLayout layout(picture);
    const auto found = layout.place_on(LabelSide::lower_left, point, text, 11.0, Crowding::leave_out);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->side, LabelSide::lower_left);
    EXPECT_DOUBLE_EQ(found->position.x, 389.0);
    EXPECT_GT(found->position.y, 300.0);
    EXPECT_FALSE(layout.place_on(LabelSide::lower_left, point, text, 11.0, Crowding::cover_symbols)) << "it is taken";
}

TEST(LabelLayout, stands_nearer_to_its_point_than_to_another_one_with_a_name) {
    LabelLayout layout(picture);
    layout.tell_apart({point, point + glm::dvec2(30.0, -8.0)});
    const auto found = place(layout);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->side, LabelSide::upper_left) << "to the upper right it would be the name of the other one";
    LabelLayout crowded(picture);
    std::vector<glm::dvec2> around{point};
    for (const glm::dvec2 way : {glm::dvec2(1, 0), glm::dvec2(0, 1), glm::dvec2(1, 1), glm::dvec2(1, -1)})
        for (const double sign : {-14.0, 14.0}) around.push_back(point + sign * way);
    crowded.tell_apart(around);
    EXPECT_FALSE(place(crowded));
    EXPECT_TRUE(place(crowded, point + glm::dvec2(2.0, 0.0))) << "what has no such name may stand there";
    LabelLayout doubled(picture);
    doubled.tell_apart({point, point + glm::dvec2(3.0, -1.0)});
    EXPECT_TRUE(place(doubled)) << "both are one mark to the eye";
}

TEST(LabelLayout, a_line_costs_the_same_however_finely_it_is_drawn) {
    for (const std::size_t count : {2U, 30U, 20000U}) {
        // On all sides of the point, and there and back.
        std::vector<glm::dvec2> across;
        for (const double y : {-12.0, 12.0, -12.0})
            for (std::size_t k = 0; k < count; ++k)
                across.push_back(
                    point + glm::dvec2(200.0 * (static_cast<double>(k) / static_cast<double>(count - 1)) - 100.0, y));
        LabelLayout layout(picture);
        layout.avoid_line(across);
        EXPECT_TRUE(layout.place(point, text, 11.0, LabelSide::upper_right, Crowding::leave_out)) << count;
        EXPECT_FALSE(layout.place(point, text, 11.0, LabelSide::upper_right, Crowding::cover_nothing)) << count;
    }
}

TEST(LabelSpots, tells_labels_apart_by_what_does_not_change) {
    LabelSpots spots;
    spots.put(spots.next("C(1/4)"), {LabelSide::left, 13.0});
    spots.put(spots.next("P_{3}"), {LabelSide::below, 11.0});
    spots.begin_frame();
    const auto curve_point = spots.spot(spots.next("C(0.255)"));
    ASSERT_TRUE(curve_point);
    EXPECT_EQ(curve_point->side, LabelSide::left);
    EXPECT_EQ(curve_point->distance, 13.0);
    EXPECT_FALSE(spots.spot(spots.next("P_{4}"))) << "another point";
    EXPECT_EQ(spots.spot(spots.next("P_{3}"))->side, LabelSide::below);
    EXPECT_FALSE(spots.spot(spots.next("P_{3}"))) << "the second one of that name";
}

TEST(LabelLayout, makes_way_for_a_line_under_its_subscripts) {
    // Right of the point at 10.95 below the upper place ends; subscripts reach 3.2 further.
    for (const double below : {1.0, 4.0}) {
        LabelLayout layout(picture);
        const double y = place(layout)->box.upper_px.y + below;
        LabelLayout lined(picture);
        lined.avoid_line(std::array{glm::dvec2(405.0, y), glm::dvec2(500.0, y)});
        const auto found = place(lined);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->anchor, below < 3.2 ? render::Anchor::right : render::Anchor::left) << below;
    }
}

TEST(LabelLayout, makes_way_for_faint_lines_but_never_for_their_number) {
    LabelLayout layout(picture);
    layout.avoid_faint_line(std::array{point, glm::dvec2(500.0, 250.0)});
    EXPECT_EQ(place(layout)->anchor, render::Anchor::right);
    LabelLayout dense(picture);
    for (int k = -40; k <= 40; ++k)
        dense.avoid_faint_line(std::array{point + glm::dvec2(3.0 * k, -100.0), point + glm::dvec2(3.0 * k, 100.0)});
    EXPECT_TRUE(place(dense)) << "a symbol alone would be worse";
    for (int k = -40; k <= 40; ++k)
        dense.avoid_line(std::array{point + glm::dvec2(3.0 * k, -100.0), point + glm::dvec2(3.0 * k, 100.0)});
    EXPECT_FALSE(place(dense)) << "unlike lines of the curve";
}

TEST(LabelLayout, keeps_labels_apart_from_one_another) {
    LabelLayout layout(picture);
    const auto first = place(layout);
    const auto second =
        layout.place(point + glm::dvec2(31.0, 0.0), text, 11.0, LabelSide::upper_right, Crowding::cover_symbols);
    ASSERT_TRUE(first && second);
    EXPECT_FALSE(second->box.lower_px.y == first->box.lower_px.y &&
                 second->box.lower_px.x < first->box.upper_px.x + 4.0)
        << "a quarter of a line between them";
}

TEST(LabelLayout, is_not_moved_by_lines_elsewhere) {
    LabelLayout empty(picture);
    LabelLayout busy(picture);
    busy.avoid_line(std::array{point, glm::dvec2(300.0, 500.0)});
    busy.avoid_line(std::array{glm::dvec2(-1e9, 10.0), glm::dvec2(1e9, 10.0)});
    busy.avoid_symbol({460.0, 300.0}, 7.0);
    EXPECT_EQ(place(empty)->position, place(busy)->position);
}

TEST(LabelLayout, labels_around_one_point_never_overlap) {
    LabelLayout layout(picture);
    std::vector<render::PixelBox> boxes;
    for (int k = 0; k < 20; ++k)
        if (const auto found = layout.place(point, text, 11.0, LabelSide::upper_right, Crowding::cover_symbols))
            boxes.push_back(found->box);
    EXPECT_GE(boxes.size(), 4U);
    EXPECT_LE(boxes.size(), 8U);
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = i + 1; j < boxes.size(); ++j) EXPECT_FALSE(boxes[i].overlaps(boxes[j])) << i << ", " << j;
}

TEST(LabelLayout, leaves_out_rather_than_cover_symbols_unless_told_to) {
    LabelLayout layout(picture);
    for (int x = -3; x <= 3; ++x)
        for (int y = -3; y <= 3; ++y) layout.avoid_symbol(point + glm::dvec2(12.0 * x, 12.0 * y), 7.0);
    EXPECT_FALSE(place(layout));
    EXPECT_TRUE(layout.place(point, text, 11.0, LabelSide::upper_right, Crowding::cover_symbols));
}

TEST(LabelLayout, covers_not_even_a_line_where_nothing_may_be_covered) {
    LabelLayout layout(picture);
    for (const double y : {-20.0, 0.0, 20.0})
        layout.avoid_faint_line(std::array{point + glm::dvec2(-100.0, y), point + glm::dvec2(100.0, y)});
    const auto found = [&](double distance) {
        return layout.place(point, text, distance, LabelSide::upper_right, Crowding::cover_nothing);
    };
    EXPECT_FALSE(found(11.0)) << "three lines through all sides";
    EXPECT_TRUE(place(layout));
    const auto farther = found(26.0);
    ASSERT_TRUE(farther);
    EXPECT_GE(std::abs(farther->position.y - point.y) - 8.0, 20.0);
}

TEST(LabelLayout, leaves_room_for_subscripts_at_the_lower_edge) {
    // Below the point a label ends 20.95 pixels further down; its subscript 3.2 more.
    for (const double below : {21.5, 24.0, 24.3}) {
        LabelLayout layout(picture);
        layout.avoid_box({{300.0, 0.0}, {500.0, 600.0 - below - 0.5}});
        const auto found =
            layout.place({400.0, 600.0 - below}, text, 11.0, LabelSide::lower_right, Crowding::leave_out);
        const bool has_room = below > 24.15;
        EXPECT_EQ(found && found->box.upper_px.y + 3.2 <= 600.0 + 1e-9, has_room) << below;
        EXPECT_EQ(found.has_value() && found->box.lower_px.y > 600.0 - below, has_room) << below;
    }
}

TEST(LabelLayout, stays_inside_the_picture) {
    LabelLayout layout(picture);
    const auto found = place(layout, {790.0, 5.0});
    ASSERT_TRUE(found);
    EXPECT_LE(found->box.upper_px.x, 800.0);
    EXPECT_GE(found->box.lower_px.y, 0.0);
}

TEST(LabelLayout, leaves_out_what_could_only_stand_outside) {
    LabelLayout layout({40.0, 20.0});
    EXPECT_FALSE(layout.place({20.0, 10.0}, {60.0, 16.0}, 11.0, LabelSide::upper_right, Crowding::cover_symbols));
}

TEST(LabelLayout, looks_only_at_what_is_near) {
    constexpr int across = 100;
    LabelLayout layout({50.0 * across, 50.0 * across});
    const auto lattice = [](int i) { return glm::dvec2(25.0 + 50.0 * (i % across), 25.0 + 50.0 * (i / across)); };
    for (int i = 0; i < across * across; ++i) {
        layout.avoid_symbol(lattice(i), 7.0);
        layout.avoid_line(std::array{lattice(i), lattice(i) + glm::dvec2(40.0, 30.0)});
    }
    std::size_t found = 0;
    for (int i = 0; i < across * across; ++i) found += place(layout, lattice(i)) ? 1U : 0U;
    EXPECT_GT(found, across * across / 2U);
    // At most nine places, each in at most six cells, each with a symbol or two, and a few lines and labels.
    EXPECT_LT(layout.look_count(), 9U * 6U * 8U * across * across);
    EXPECT_GT(layout.look_count(), static_cast<std::size_t>(across * across));
}

TEST(LabelLayout, counts_a_line_once_however_many_cells_it_passes) {
    LabelLayout layout(picture);
    // Three lines through every place; those above the point reach over the border of cells at y = 288.
    for (const double x : {370.0, 375.0, 380.0, 390.0, 400.0, 410.0, 420.0, 425.0, 430.0})
        layout.avoid_line(std::array{glm::dvec2(x, 10.0), glm::dvec2(x, 590.0)});
    const auto found = place(layout);
    ASSERT_TRUE(found) << "four would be as much as a symbol";
    EXPECT_LT(found->position.y, 300.0);
    EXPECT_EQ(found->anchor, render::Anchor::left);
}

TEST(LabelLayout, boxes_are_never_covered) {
    LabelLayout layout(picture);
    layout.avoid_box({{401.0, 200.0}, {700.0, 299.0}});
    const auto found = layout.place(point, text, 11.0, LabelSide::upper_right, Crowding::cover_symbols);
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->box.overlaps({{401.0, 200.0}, {700.0, 299.0}}));
}

TEST(TextSize, counts_characters_not_bytes_and_shrinks_scripts) {
    EXPECT_DOUBLE_EQ(text_size("αα", 10.0).x, 2.0 * text_size("α", 10.0).x);
    EXPECT_DOUBLE_EQ(text_size("P_{2}", 10.0).x, text_size("P", 10.0).x + 0.7 * text_size("2", 10.0).x);
    EXPECT_DOUBLE_EQ(text_size("P_{2}^{1}", 20.0).x, 2.0 * text_size("P_{2}^{1}", 10.0).x);
    EXPECT_DOUBLE_EQ(text_size("·", 10.0).x, text_size(".", 10.0).x);
    EXPECT_NEAR(text_size("12345", 10.0, render::LabelFont::number).x, 30.5, 1e-9);
}

TEST(TextSize, is_near_the_ink_of_inter) {
    EXPECT_NEAR(text_size("· w 0.70711", 100.0).x, 506.0, 16.0);
    EXPECT_NEAR(text_size("111", 100.0).x, 120.0, 4.0);
    EXPECT_NEAR(text_size("w 2", 100.0).x, 160.0, 16.0);
}

}  // namespace
}  // namespace batten::editor
