#include "app/editor/pointer/typed_place.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/pointer/place_text.h"

namespace batten::editor {
namespace {

/// Types characters; '\t' and '\b' are Tab and Backspace.
TypedPlace typed(const std::u32string& text) {
    TypedPlace place;
    for (const char32_t c : text) {
        const auto next = c == U'\t'   ? typed_key(place, Key::tab)
                          : c == U'\b' ? typed_key(place, Key::backspace)
                                       : typed_character(place, c);
        if (next) place = *next;
    }
    return place;
}

void expect_place(const std::u32string& text, core::Point wanted, std::optional<core::Point> from = core::Point(1, 2),
                  core::Point pointed = {4, 6}) {
    const auto place = place_typed(typed(text), from, pointed);
    ASSERT_TRUE(place) << place.error();
    EXPECT_LE(core::distance(*place, wanted), 1e-15 * (1.0 + std::abs(wanted.x) + std::abs(wanted.y)))
        << place->x << ", " << place->y;
}

// The pointer is at 5 units in the direction (3, 4).
TEST(TypedPlace, is_length_and_angle_from_the_start) {
    expect_place(U"10", {7, 10});
    expect_place(U"12.5\t30", {1 + 12.5 * std::sqrt(0.75), 8.25});
    expect_place(U"12,5\t90", {1, 14.5});
    expect_place(U"2\t-90", {1, 0});
    expect_place(U"<90", {1, 6});
    expect_place(U"<0", {4, 2});
    expect_place(U"<180", {4, 2});
    expect_place(U"10<45", {1 + std::sqrt(50.0), 2 + std::sqrt(50.0)});
    expect_place(U"@10<45", {1 + std::sqrt(50.0), 2 + std::sqrt(50.0)});
    expect_place(U"(sqrt(2))<45 deg", {2, 3});
    expect_place(U"2*sin(30 deg)<pi rad", {0, 2});
}

// sin 30 deg is 1/2, and a quarter of a turn has no part along the other axis, to the last bit.
TEST(TypedPlace, at_the_usual_angles_is_exact) {
    const core::Point from(0.1, 0.3);
    const auto way = [&](const std::u32string& text, core::Point pointed) {
        return place_typed(typed(text), core::Point(0, 0), pointed).value_or(core::Point(9, 9));
    };
    EXPECT_EQ(place_typed(typed(U"1<90"), from, {5, 5}), core::Point(0.1, 0.3 + 1.0));
    EXPECT_EQ(place_typed(typed(U"7<180"), from, {5, 5}), core::Point(0.1 - 7.0, 0.3));
    EXPECT_EQ(place_typed(typed(U"7<270"), from, {5, 5}), core::Point(0.1, 0.3 - 7.0));
    EXPECT_EQ(place_typed(typed(U"7<-450"), from, {5, 5}), core::Point(0.1, 0.3 - 7.0));
    EXPECT_EQ(way(U"2<30", {5, 5}).y, 1.0);
    EXPECT_EQ(way(U"2<120", {5, 5}).x, -1.0);
    EXPECT_EQ(way(U"2<45", {5, 5}).x, way(U"2<45", {5, 5}).y);
}

// The pointer snaps to a direction, at places that are rounded, and only the length is typed.
TEST(TypedPlace, is_exact_in_the_direction_that_the_pointer_shows) {
    for (const core::Point from : {core::Point(0, 0), core::Point(0.1, 0.3), core::Point(-12.7, 3.9)})
        for (int k = 0; k < 24; ++k) {
            const double angle = 15.0 * k;
            const std::string degrees = std::to_string(15 * k);
            const std::u32string polar = U"2<" + std::u32string(degrees.begin(), degrees.end());
            for (const double reach : {0.1, 1.7, 33.3}) {
                const double radians = angle * std::acos(-1.0) / 180.0;
                const core::Point pointed(from.x + reach * std::cos(radians), from.y + reach * std::sin(radians));
                const auto place = place_typed(typed(U"2"), from, pointed);
                EXPECT_EQ(place, place_typed(typed(polar), from, {50, 70})) << angle << " from " << from.x;
            }
        }
    EXPECT_EQ(place_typed(typed(U"2"), core::Point(0, 0), {5.0 * std::sqrt(0.75), 2.5})->y, 1.0);
    EXPECT_EQ(place_typed(typed(U"1"), core::Point(0, 0), {6e-17, 1.0}), core::Point(0, 1));
    EXPECT_EQ(place_typed(typed(U"10"), core::Point(0, 0), {3, 4}), core::Point(6, 8));
}

TEST(TypedPlace, is_dx_and_dy_after_x_or_y) {
    expect_place(U"x10", {11, 6});
    expect_place(U"y-3", {4, -1});
    expect_place(U"x1/3\t2", {4.0 / 3.0, 4});
    expect_place(U"@10,5", {11, 7});
    expect_place(U"@10;0,5", {11, 2.5});
    expect_place(U"@10", {11, 6});
    expect_place(U"@,5", {4, 7});
    expect_place(U"x\b10", {7, 10});
}

TEST(TypedPlace, is_a_whole_place) {
    expect_place(U"3,4", {3, 4});
    expect_place(U"0,5;1e3", {0.5, 1000});
    expect_place(U"3,", {3, 6});
    expect_place(U"3,4", {3, 4}, std::nullopt);
    expect_place(U"10<90", {0, 10}, std::nullopt);
    expect_place(U"-1e6,1e6", {-1e6, 1e6});
}

TEST(TypedPlace, begins_with_what_no_shortcut_is) {
    EXPECT_TRUE(typed(U"qwert!").is_empty());
    EXPECT_TRUE(typed(U"5\b").is_empty());
    EXPECT_FALSE(typed_key(TypedPlace{}, Key::tab));
    EXPECT_FALSE(typed_key(TypedPlace{}, Key::backspace));
    EXPECT_EQ(typed(U"5π°").texts[0], "5π°");
    EXPECT_EQ(typed(U"5π\b").texts[0], "5");
    EXPECT_EQ(typed(U"\u22125").texts[0], "\u22125");
    expect_place(U"\u22125", {-2, -2});
    EXPECT_FALSE(typed_character(typed(U"5"), U'\u0436'));
}

TEST(TypedPlace, begins_with_letters_where_nothing_else_listens_to_them) {
    const auto first = [](char32_t c) { return typed_character({}, c, FirstLetters::begin_numbers); };
    EXPECT_EQ(first(U's')->texts[0], "s");
    EXPECT_EQ(first(U'\u03c0')->texts[0], "π");
    EXPECT_TRUE(first(U'x')->has_offsets) << "and no number";
    EXPECT_FALSE(first(U'!'));
    EXPECT_FALSE(first(U'\u0436'));
}

TEST(TypedPlace, may_begin_with_an_equals_sign_as_in_a_spreadsheet) {
    expect_place(U"=sqrt(2)<45", {2, 3});
    expect_place(U"= 3, sqrt(16)", {3, 4});
    expect_place(U"=10\t= 90", {1, 12});
    EXPECT_EQ(typed_factor(typed(U"=sqrt(9)"), 0), 3.0);
    EXPECT_EQ(typed_angle(typed(U"=60+30")), 90.0);
    EXPECT_FALSE(place_typed(typed(U"==3"), core::Point(0, 0), {1, 1}));
}

TEST(TypedPlace, refuses_what_cannot_be_read_in_a_sentence) {
    EXPECT_EQ(place_typed(typed(U"1+"), core::Point(0, 0), {1, 1}).error(), "a number is missing at the end");
    EXPECT_EQ(place_typed(typed(U"1e308*10"), core::Point(0, 0), {1, 1}).error(),
              "the result is too large for a number");
    EXPECT_FALSE(place_typed(typed(U"@1e308,0"), core::Point(1e308, 0), {1, 1}));
    expect_place(U"5", {6, 2}, core::Point(1, 2), {1, 2});  // without a direction to the right
}

TEST(TypedPlace, is_read_with_a_caret) {
    EXPECT_EQ(typed_reading({}), "");
    EXPECT_EQ(typed_reading(typed(U"12.5")), "length 12.5| · angle ");
    EXPECT_EQ(typed_reading(typed(U"12.5\t30")), "length 12.5 · angle 30|");
    EXPECT_EQ(typed_reading(typed(U"x1\t")), "dx 1 · dy |");
    EXPECT_EQ(typed_reading(typed(U"@10,5")), "@10,5|");
    EXPECT_EQ(typed_length(typed(U"12.5\t30"), {}), 12.5);
    EXPECT_EQ(typed_length(typed(U"<30"), {}), std::nullopt);
    EXPECT_EQ(typed_length(typed(U"x3"), {}), std::nullopt);
}

}  // namespace
}  // namespace batten::editor
