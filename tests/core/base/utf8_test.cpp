#include "core/base/utf8.h"

#include <gtest/gtest.h>

namespace batten::core {

// The table of well-formed byte sequences of the Unicode standard, at its edges.
TEST(Utf8, KnowsTheLengthsOfCharacters) {
    for (const char* one : {"a", "\x7f"}) EXPECT_EQ(utf8_length(one), 1U) << one;
    for (const char* two : {"\xc2\x80", "Ж", "\xdf\xbf"}) EXPECT_EQ(utf8_length(two), 2U) << two;
    for (const char* three : {"\xe0\xa0\x80", "−", "\xed\x9f\xbf", "\xee\x80\x80", "\xef\xbf\xbf"})
        EXPECT_EQ(utf8_length(three), 3U) << three;
    for (const char* four : {"\xf0\x90\x80\x80", "\xf4\x8f\xbf\xbf"}) EXPECT_EQ(utf8_length(four), 4U) << four;
}

// By the code charts of the Unicode standard.
TEST(Utf8, KnowsTheNumbersOfCharacters) {
    EXPECT_EQ(utf8_code("ab"), 0x61U);
    EXPECT_EQ(utf8_code("Ж"), 0x416U);
    EXPECT_EQ(utf8_code("−1"), 0x2212U);
    EXPECT_EQ(utf8_code("\xf0\x9f\x98\x80"), 0x1f600U);
    EXPECT_EQ(utf8_code("\xf4\x8f\xbf\xbf"), 0x10ffffU);
    for (const char* none : {"", "\xc2", "\xe0\x9f\xbf", "\xed\xa0\x80"}) EXPECT_FALSE(utf8_code(none)) << none;
}

TEST(Utf8, RefusesWhatIsNoCharacter) {
    for (const char* none : {"", "\x80", "\xc1\xbf", "\xc2", "\xc2\x41", "\xe0\x9f\xbf", "\xed\xa0\x80", "\xe2\x88",
                             "\xf0\x8f\xbf\xbf", "\xf4\x90\x80\x80", "\xf0\x9f\x98", "\xf5\x80\x80\x80", "\xff"})
        EXPECT_EQ(utf8_length(none), 0U) << none;
}

TEST(Utf8, IsWhatConsistsOfCharacters) {
    EXPECT_TRUE(is_utf8(""));
    EXPECT_TRUE(is_utf8(std::string_view("a\0Ж−", 7)));
    EXPECT_FALSE(is_utf8("Ж\xd0"));
    EXPECT_FALSE(is_utf8("a\xe9t"));
}

TEST(Utf8, HasWholeCharactersAtTheFrontOfATextThatIsTooLong) {
    EXPECT_EQ(utf8_front("aЖ−b", 7), "aЖ−b");
    EXPECT_EQ(utf8_front("aЖ−b", 6), "aЖ−");
    EXPECT_EQ(utf8_front("aЖ−b", 5), "aЖ");
    EXPECT_EQ(utf8_front("aЖ−b", 2), "a");
    EXPECT_EQ(utf8_front("Ж", 1), "");
    EXPECT_EQ(utf8_front("a", 0), "");
}

}  // namespace batten::core
