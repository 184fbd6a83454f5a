#include "app/editor/state/notation.h"

#include <gtest/gtest.h>

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
}

TEST(Notation, leaves_words_alone) {
    EXPECT_EQ(notated("Put up the Parameter, Unclamped CPU", lecture), "Put up the Parameter, Unclamped CPU");
    EXPECT_EQ(notated("you, us, Pu", lecture), "you, us, Pu");
    EXPECT_EQ(notated("", lecture), "");
}

TEST(Notation, writes_small_fractions_where_they_are_wanted) {
    EXPECT_EQ(exact_text({}, 8.0 / 15.0), "8/15");
    EXPECT_EQ(exact_text({}, -1.0 / 6.0), "−1/6");
    EXPECT_EQ(exact_text({}, 3.0), "3");
    EXPECT_EQ(exact_text({}, 0.53331), "0.5333");
    EXPECT_EQ(exact_text(lecture, 8.0 / 15.0), "0.5333");
}

TEST(Notation, is_written_by_names_and_read_back) {
    EXPECT_EQ(notation_named(names_of(lecture)), lecture);
    EXPECT_EQ(notation_named(names_of({})), Notation{});
    EXPECT_EQ(notation_named({{"points", "Q"}, {"parameter", "t"}, {"more", "less"}}).points, PointLetter::P);
    EXPECT_EQ(notation_named({{"points", "Q"}, {"parameter", "t"}}).parameter, ParameterLetter::t);
}

}  // namespace
}  // namespace batten::editor
