#include "app/editor/state/notation.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>

namespace batten::editor {
namespace {

constexpr Notation lecture{PointLetter::V, ParameterLetter::t, DegreeOrOrder::order, CellNumbering::first,
                           NumberStyle::decimals};

TEST(Notation, leaves_its_own_letters_alone) {
    const std::string text = "P_{3}^{1} = 7/15 P_{2} + 8/15 P_{3}, u = 0.4, U = (0, 1)";
    EXPECT_EQ(notated(text, {}), text);
}

TEST(Notation, replaces_letters_that_stand_by_themselves) {
    EXPECT_EQ(notated("P_{3}^{1} = 7/15 P_{2} + 8/15 P_{3}", lecture), "V_{3}^{1} = 7/15 V_{2} + 8/15 V_{3}");
    EXPECT_EQ(notated("C(u) = (u − u_{3})/(u_{6} − u_{3})", lecture), "C(t) = (t − t_{3})/(t_{6} − t_{3})");
    EXPECT_EQ(notated("Moved P₅ at u = 0.4 in U", lecture), "Moved V₅ at t = 0.4 in T");
    EXPECT_EQ(notated("P, C′(u); 3 P_{0}", lecture), "V, C′(t); 3 V_{0}");
    EXPECT_EQ(notated("(−3u^{3} + 21u + 12P_{1})/6", lecture), "(−3t^{3} + 21t + 12V_{1})/6");
    EXPECT_EQ(notated("x2u, N3u", lecture), "x2u, N3u");
    EXPECT_EQ(notated("s = ∫ |C′(u)| du, due, Dudu", lecture), "s = ∫ |C′(t)| dt, due, Dudu");
}

TEST(Notation, leaves_words_alone) {
    EXPECT_EQ(notated("Put up the Parameter, Unclamped CPU", lecture), "Put up the Parameter, Unclamped CPU");
    EXPECT_EQ(notated("you, us, Pu", lecture), "you, us, Pu");
    EXPECT_EQ(notated("", lecture), "");
}

TEST(Notation, writes_small_fractions_where_they_are_wanted) {
    EXPECT_EQ(exact_text({}, 8.0 / 15.0), "8/15");
    EXPECT_EQ(unrounded_text({}, 1.0 / 3.0, "0.3333"), "1/3");
    EXPECT_EQ(unrounded_text({}, -5.0 / 3.0, "−1.667"), "−5/3");
    EXPECT_EQ(unrounded_text({}, 0.5, "0.5"), "0.5") << "which is all of it";
    EXPECT_EQ(unrounded_text({}, 0.33333, "0.3333"), "0.3333");
    EXPECT_EQ(unrounded_text(lecture, 1.0 / 3.0, "0.3333"), "0.3333");
    EXPECT_EQ(exact_text({}, -1.0 / 6.0), "−1/6");
    EXPECT_EQ(exact_text({}, 3.0), "3");
    EXPECT_EQ(exact_text({}, 0.53331), "0.5333");
    EXPECT_EQ(exact_text(lecture, 8.0 / 15.0), "0.5333");
}

TEST(Notation, writes_typed_and_measured_decimals_as_such) {
    EXPECT_EQ(exact_text({}, 2.4), "2.4");
    EXPECT_EQ(exact_text({}, 2.35), "2.35");
    EXPECT_EQ(exact_text({}, 0.35), "0.35");
    EXPECT_EQ(exact_text({}, 7.152), "7.152") << "894/125";
    EXPECT_EQ(exact_text({}, -3.7), "−3.7");
    EXPECT_EQ(exact_text({}, 5000.5), "5000") << "10001/2";
    EXPECT_EQ(exact_text({}, 23.5), "23.5");
    EXPECT_EQ(exact_text({}, 193.0 / 16.0), "12.06");
    EXPECT_EQ(exact_text({}, 0.216), "0.216");
    EXPECT_EQ(exact_text({}, std::sqrt(2.0)), "1.414");
    EXPECT_EQ(exact_text({}, 1e-17), "1e−17");
}

TEST(Notation, writes_what_lectures_have_as_fractions) {
    for (const auto& [value, text] : std::initializer_list<std::pair<double, const char*>>{{0.5, "1/2"},
                                                                                           {0.4, "2/5"},
                                                                                           {0.25, "1/4"},
                                                                                           {3.5, "7/2"},
                                                                                           {-1.5, "−3/2"},
                                                                                           {0.3, "3/10"},
                                                                                           {7.0 / 15.0, "7/15"},
                                                                                           {4.0 / 3.0, "4/3"},
                                                                                           {5.0 / 6.0, "5/6"},
                                                                                           {27.0 / 64.0, "27/64"},
                                                                                           {23.0 / 48.0, "23/48"},
                                                                                           {307.0 / 750.0, "307/750"},
                                                                                           {1.0 / 720.0, "1/720"},
                                                                                           {23.0 / 15.0, "23/15"},
                                                                                           {1.0 / 16.0, "1/16"},
                                                                                           {27.0 / 320.0, "27/320"}})
        EXPECT_EQ(exact_text({}, value), text);
    EXPECT_EQ(exact_text({}, 3001.0 / 3.0), "1000") << "not of small numbers";
    EXPECT_EQ(exact_text({}, 0.216, 2), "27/125") << "two digits would round it";
}

TEST(Notation, writes_numbers_that_are_read_together_alike) {
    using Texts = std::vector<std::string>;
    EXPECT_EQ(exact_texts({}, std::array{0.216, 0.432, 0.288, 0.064}), (Texts{"0.216", "0.432", "0.288", "0.064"}));
    EXPECT_EQ(exact_texts({}, std::array{307.0 / 750.0, 0.064, 1.0}), (Texts{"307/750", "8/125", "1"}));
    EXPECT_EQ(exact_texts({}, std::array{1.0 / 3.0, std::sqrt(0.5)}), (Texts{"0.3333", "0.7071"}));
    EXPECT_EQ(exact_texts(lecture, std::array{1.0 / 3.0, 2.0 / 3.0}), (Texts{"0.3333", "0.6667"}));
    EXPECT_EQ(exact_texts({}, std::array{0.0, 1.0, 2.4}), (Texts{"0", "1", "2.4"}));
    EXPECT_TRUE(exact_texts({}, {}).empty());
}

TEST(Notation, tells_the_order_beside_the_degree) {
    const auto told = [](const std::string& text) { return notated(text, lecture); };
    EXPECT_EQ(told("a curve of degree 3."), "a curve of degree 3 (k = 4).");
    EXPECT_EQ(told("Raised degree from 3 to 4: same shape"), "Raised degree from 3 to 4 (k = 5): same shape");
    EXPECT_EQ(told("Set degree to 2"), "Set degree to 2 (k = 3)");
    EXPECT_EQ(told("for a curve of degree p = 3"), "for a curve of degree p = 3 (k = 4)");
    EXPECT_EQ(told("p = 3: Moved P₅"), "p = 3, k = 4: Moved V₅");
    EXPECT_EQ(told("Degree 25"), "Degree 25 (k = 26)");
    for (const char* text : {"30 degrees", "the degree is 2.5", "p − 1 = 3 − 1 = 2", "degree of the curve", "degree",
                             "'degree 3' is hidden", "degree -3", "a step = 3", "degree from 3"})
        EXPECT_EQ(told(text), text);
    for (const char* text : {"degree 3 to degree 4", "degree from 3 to 4", "p = 3", "P_{0} and u"})
        EXPECT_EQ(told(told(text)), told(text));
    EXPECT_EQ(notated("degree 3", {}), "degree 3");
}

TEST(Notation, leaves_names_in_quotes_alone) {
    EXPECT_EQ(notated("Renamed 'u of P' to 'U', at u = 1", lecture), "Renamed 'u of P' to 'U', at t = 1");
    EXPECT_EQ(notated("P isn't u", lecture), "V isn't t");
}

TEST(Notation, is_written_by_names_and_read_back) {
    EXPECT_EQ(notation_named(names_of(lecture)), lecture);
    EXPECT_EQ(notation_named(names_of({})), Notation{});
    EXPECT_EQ(notation_named({{"points", "Q"}, {"parameter", "t"}, {"more", "less"}}).points, PointLetter::P);
    EXPECT_EQ(notation_named({{"points", "Q"}, {"parameter", "t"}}).parameter, ParameterLetter::t);
}

}  // namespace
}  // namespace batten::editor
