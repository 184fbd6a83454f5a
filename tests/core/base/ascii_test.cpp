#include "core/base/ascii.h"

#include <gtest/gtest.h>

namespace batten::core {

TEST(Ascii, only_its_capital_letters_become_small) {
    std::string all;
    for (int c = 0; c < 256; ++c) all.push_back(static_cast<char>(c));
    const std::string small = in_small_letters(all);
    for (int c = 0; c < 256; ++c)
        EXPECT_EQ(static_cast<unsigned char>(small[static_cast<std::size_t>(c)]), c >= 65 && c <= 90 ? c + 32 : c);
    EXPECT_EQ(in_small_letters("ZIGZAG.SVG"), "zigzag.svg");
    EXPECT_EQ(in_small_letters("ÄZ"), "Äz");
}

TEST(Ascii, its_letters_and_digits_are_62) {
    std::string found;
    for (int c = -128; c < 128; ++c)
        if (const char sign = static_cast<char>(c); is_digit(sign) || is_letter(sign)) found.push_back(sign);
    EXPECT_EQ(found, "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz");
}

TEST(Ascii, blanks_are_taken_off_both_ends) {
    EXPECT_EQ(trimmed(" \t a b\r\n"), "a b");
    EXPECT_EQ(trimmed("x"), "x");
    EXPECT_EQ(trimmed(" \r"), "");
    EXPECT_EQ(trimmed(""), "");
}

}  // namespace batten::core
