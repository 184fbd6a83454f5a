#include "app/platform/key_map.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace batten::platform {

namespace {

using editor::Key;

std::vector<std::string> characters_of(const std::string& row) {
    std::vector<std::string> characters;
    for (const char byte : row) {
        const bool continues = (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
        if (continues)
            characters.back().push_back(byte);
        else
            characters.emplace_back(1, byte);
    }
    return characters;
}

/// What the keys print, in the order of an American keyboard; a blank stands for a dead key.
Layout layout_of(const std::string& rows) {
    const std::string american = "`1234567890-=QWERTYUIOP[]\\ASDFGHJKL;'ZXCVBNM,./";
    const std::vector<std::string> characters = characters_of(rows);
    EXPECT_EQ(characters.size(), american.size());
    std::map<int, std::string> names;
    for (std::size_t i = 0; i < american.size(); ++i)
        names[static_cast<unsigned char>(american[i])] = characters[i] == " " ? "" : characters[i];
    return [names](int key, int) { return names.count(key) == 0 ? "" : names.at(key); };
}

const Layout american = layout_of("`1234567890-=qwertyuiop[]\\asdfghjkl;'zxcvbnm,./");
const Layout russian = layout_of("ё1234567890-=йцукенгшщзхъ\\фывапролджэячсмитьбю.");
const Layout greek = layout_of("`1234567890-=;ςερτυθιοπ[]\\ασδφγηξκλ 'ζχψωβνμ,./");
const Layout czech = layout_of(";+ěščřžýáíé= qwertzuiopú)¨asdfghjklů§yxcvbnm,.-");
const Layout hungarian = layout_of("0123456789öüóqwertzuiopőúűasdfghjkléáyxcvbnm,.-");
const Layout french = layout_of("²&é\"'(-è_çà)=azertyuiop $*qsdfghjklmùwxcvbn,;:!");
const Layout german = layout_of(" 1234567890ß qwertzuiopü+#asdfghjklöäyxcvbnm,.-");
const Layout dvorak = layout_of("`1234567890[]',.pyfgcrl/=\\aoeuidhtns-;qjkxbmwvz");

const std::vector<Layout> all{american, russian, greek, czech, hungarian, french, german, dvorak};

Key offset_key(Key first, int offset) {
    return static_cast<Key>(static_cast<int>(first) + offset);
}

TEST(KeyMap, has_each_letter_on_one_key_of_every_layout) {
    for (std::size_t i = 0; i < all.size(); ++i) {
        std::map<Key, int> counts;
        for (int key = GLFW_KEY_APOSTROPHE; key <= GLFW_KEY_GRAVE_ACCENT; ++key)
            ++counts[key_from_glfw(key, 0, all[i])];
        for (int letter = 0; letter < 26; ++letter)
            EXPECT_EQ(counts[offset_key(Key::a, letter)], 1) << "layout " << i << ", letter " << letter;
    }
}

TEST(KeyMap, takes_letters_from_the_layout_where_it_prints_latin_ones) {
    EXPECT_EQ(key_from_glfw(GLFW_KEY_Z, 0, american), Key::z);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_Y, 0, german), Key::z);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_Z, 0, czech), Key::y);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_Q, 0, french), Key::a);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_SEMICOLON, 0, french), Key::m);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_SLASH, 0, dvorak), Key::z);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_Z, 0, dvorak), Key::none) << "; is no z where another key prints one";
    EXPECT_EQ(key_from_glfw(GLFW_KEY_SEMICOLON, 0, german), Key::none);
}

TEST(KeyMap, takes_letters_from_their_place_where_the_layout_prints_others) {
    EXPECT_EQ(key_from_glfw(GLFW_KEY_Z, 0, russian), Key::z);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_V, 0, russian), Key::v);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_Z, 0, greek), Key::z);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_Q, 0, greek), Key::q) << "prints ; and no other key a q";
}

TEST(KeyMap, has_digits_in_their_place_in_every_layout) {
    for (std::size_t i = 0; i < all.size(); ++i)
        for (int digit = 0; digit < 10; ++digit) {
            EXPECT_EQ(key_from_glfw(GLFW_KEY_0 + digit, 0, all[i]), offset_key(Key::digit_0, digit)) << "layout " << i;
            EXPECT_EQ(key_from_glfw(GLFW_KEY_KP_0 + digit, 0, all[i]), offset_key(Key::digit_0, digit));
        }
    EXPECT_EQ(key_from_glfw(GLFW_KEY_GRAVE_ACCENT, 0, hungarian), Key::digit_0) << "prints the 0";
}

TEST(KeyMap, has_a_plus_and_a_minus_where_they_are_printed) {
    EXPECT_EQ(key_from_glfw(GLFW_KEY_EQUAL, 0, american), Key::plus);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_EQUAL, 0, russian), Key::plus);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_EQUAL, 0, hungarian), Key::plus) << "+ takes Shift";
    EXPECT_EQ(key_from_glfw(GLFW_KEY_RIGHT_BRACKET, 0, german), Key::plus);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_EQUAL, 0, german), Key::none) << "a dead key";
    EXPECT_EQ(key_from_glfw(GLFW_KEY_MINUS, 0, german), Key::none) << "prints ß";
    for (const Layout& layout : {czech, hungarian, german})
        EXPECT_EQ(key_from_glfw(GLFW_KEY_SLASH, 0, layout), Key::minus);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_MINUS, 0, american), Key::minus);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_MINUS, 0, french), Key::none) << "prints )";
    for (const Layout& layout : all) {
        EXPECT_EQ(key_from_glfw(GLFW_KEY_KP_ADD, 0, layout), Key::plus);
        EXPECT_EQ(key_from_glfw(GLFW_KEY_KP_SUBTRACT, 0, layout), Key::minus);
    }
}

TEST(KeyMap, has_a_comma_and_a_period) {
    EXPECT_EQ(key_from_glfw(GLFW_KEY_COMMA, 0, american), Key::comma);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_COMMA, 0, russian), Key::comma);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_PERIOD, 0, russian), Key::period);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_M, 0, french), Key::comma);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_W, 0, dvorak), Key::comma);
}

TEST(KeyMap, has_brackets_by_their_place_where_no_key_prints_them) {
    EXPECT_EQ(key_from_glfw(GLFW_KEY_LEFT_BRACKET, 0, russian), Key::left_bracket);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_RIGHT_BRACKET, 0, russian), Key::right_bracket);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_LEFT_BRACKET, 0, american), Key::none) << "is a character that is typed";
    EXPECT_EQ(key_from_glfw(GLFW_KEY_LEFT_BRACKET, 0, greek), Key::none);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_LEFT_BRACKET, 0, german), Key::none) << "prints ü";
}

TEST(KeyMap, knows_the_signs_that_take_shift) {
    EXPECT_EQ(key_from_sign('+'), Key::plus);
    EXPECT_EQ(key_from_sign('-'), Key::minus);
    EXPECT_EQ(key_from_sign('.'), Key::period);
    EXPECT_EQ(key_from_sign('='), Key::none);
    EXPECT_EQ(key_from_sign('a'), Key::none);
    EXPECT_EQ(key_from_sign(0x12B), Key::none) << "more than a byte, of which the last is a +";
}

TEST(KeyMap, leads_back_to_the_key_of_a_letter) {
    EXPECT_EQ(american_key(Key::a, 7), GLFW_KEY_A);
    EXPECT_EQ(american_key(Key::z, 7), GLFW_KEY_Z);
    EXPECT_EQ(american_key(Key::digit_0, 7), 7);
    EXPECT_EQ(american_key(Key::none, 7), 7);
}

}  // namespace

}  // namespace batten::platform
