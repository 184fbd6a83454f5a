#include "exchange/cad/iges_check.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/exchange/damage.h"

namespace batten::exchange {

namespace {

std::string freecad_text() {
    return core::read_text(BATTEN_EXCHANGE_DATA "/freecad.igs").value();
}

std::string defect_of(const std::string& text) {
    const auto defect = iges_defect(text);
    return defect ? defect->sentence() : "";
}

// `text` with the first `before` from `from` on changed.
std::string with(std::string text, const std::string& before, const std::string& after, std::size_t from = 0) {
    const std::size_t at = text.find(before, from);
    EXPECT_NE(at, std::string::npos);
    return text.replace(at, before.size(), after);
}

std::string padded(std::string text, std::size_t width) {
    return text.append(width - text.size(), ' ');
}

// One entity 126, of degree 1 from (0, 0) to (2.5, 1), with these parameters.
std::string line_file(const std::string& parameters) {
    const std::string both = padded(parameters, 128);
    return padded("1H,,1H;,4Htest;", 72) + "G0000001\n" +
           padded("     126       1       0       0       0       0       0       0       0", 72) + "D      1\n" +
           padded("     126       0       0       2       0", 72) + "D      2\n" + both.substr(0, 64) +
           "       1P      1\n" + both.substr(64) + "       1P      2\n" +
           padded("S      0G      1D      2P      2", 72) + "T      1\n";
}

const char* const whole_line = "126,1,1,0,0,1,0,0.,0.,1.,1.,1.,1.,0.,0.,0.,2.5,1D0,0.,0.,1.;";

}  // namespace

TEST(IgesCheck, FindsNothingInAWholeFile) {
    EXPECT_EQ(defect_of(freecad_text()), "");
    EXPECT_EQ(defect_of(line_file(whole_line)), "");
}

TEST(IgesCheck, TakesNumbersBelowTheDoublesForZeros) {
    EXPECT_EQ(defect_of(line_file(with(whole_line, "2.5", "1D-400"))), "");
    EXPECT_EQ(defect_of(line_file(with(whole_line, "2.5", "-1E-400"))), "");
    EXPECT_EQ(defect_of(line_file(with(whole_line, "2.5", "1D400"))),
              "line 4: found '1D400' where a finite number or a text must be");
}

TEST(IgesCheck, NamesTheEntitiesThatAreDamaged) {
    using Numbers = std::vector<std::size_t>;
    EXPECT_EQ(damaged_iges_entities(freecad_text()), Numbers());
    EXPECT_EQ(damaged_iges_entities(line_file(whole_line)), Numbers());
    EXPECT_EQ(damaged_iges_entities(line_file(with(whole_line, "2.5", "NAN"))), Numbers{0});
    EXPECT_EQ(damaged_iges_entities(""), Numbers());
}

TEST(IgesCheck, RefusesAFileThatIsCutOffAtAnyByte) {
    const std::string text = freecad_text();
    const std::size_t end_of_line_t = text.rfind('T') + 7;
    for (std::size_t end = 0; end < end_of_line_t; ++end) ASSERT_NE(defect_of(text.substr(0, end)), "") << end;
    EXPECT_EQ(defect_of(text.substr(0, 8 * 81)),
              "line 8: the file ends without the line T that ends every IGES file; a part is missing");
    EXPECT_NE(defect_of(""), "");
}

TEST(IgesCheck, RefusesAFileThatLacksALineOrHasItTwice) {
    const std::string text = freecad_text();
    std::size_t number = 1;
    for (std::size_t begin = 0; begin < text.size(); begin = text.find('\n', begin) + 1, ++number) {
        const std::size_t length = text.find('\n', begin) + 1 - begin;
        std::string cut = text;
        ASSERT_NE(defect_of(cut.erase(begin, length)), "") << number;
        std::string doubled = text;
        if (text[begin + 72] == 'T') break;
        ASSERT_NE(defect_of(doubled.insert(begin, text, begin, length)), "") << number;
    }
    EXPECT_EQ(defect_of(with(text, "G0000003", "G0000004")),
              "line 4: this is line 3 of section G, but its number is '0000004'; a line is missing or damaged");
}

TEST(IgesCheck, NamesTheLineOfAParameterThatIsNoNumber) {
    EXPECT_EQ(defect_of(line_file(with(whole_line, "2.5", "2.5X0"))),
              "line 4: found '2.5X0' where a finite number or a text must be");
    EXPECT_EQ(defect_of(line_file(with(whole_line, "2.5", "nan"))),
              "line 4: found 'nan' where a finite number or a text must be");
    EXPECT_EQ(defect_of(line_file(with(whole_line, "1D0", "1E999"))),
              "line 4: found '1E999' where a finite number or a text must be");
}

// OpenCASCADE reads the part before the end of the line as the number.
TEST(IgesCheck, RefusesNumbersThatGoOnInTheNextLine) {
    const auto moved = [](std::size_t blanks) {
        return defect_of(line_file(with(whole_line, "2.5", std::string(blanks, ' ') + "2.5")));
    };
    EXPECT_EQ(moved(18), "") << "it ends in column 64";
    EXPECT_EQ(moved(19), "line 4: the number '2.5' goes on in the next line, which only texts may");
    EXPECT_EQ(moved(21), "") << "it begins the next line";
    EXPECT_EQ(defect_of(line_file(with(whole_line, ";", ",5Habcde;"))), "") << "a text";
}

// With K = M = 1 there are 4 knots, 2 weights, 6 coordinates and 2 ends.
TEST(IgesCheck, CountsTheNumbersOfSplines) {
    const std::string told =
        " numbers behind its flags, but with K = 1 and M = 1 it needs 14: knots, weights, coordinates and ends; a part "
        "is missing or damaged";
    EXPECT_EQ(defect_of(line_file(with(whole_line, ",2.5", ""))), "line 4: the B-spline curve has 13" + told);
    EXPECT_EQ(defect_of(line_file(with(whole_line, "2.5", ""))), "line 4: the B-spline curve has 9" + told);
    EXPECT_EQ(defect_of(line_file(with(whole_line, "126,1", "126,"))),
              "line 4: the B-spline curve does not begin with its numbers K and M");
    EXPECT_NE(defect_of(line_file(with(whole_line, "126,1", "126,9"))), "");
    EXPECT_NE(defect_of(line_file(with(whole_line, "126,1", "126,99999999999"))), "");
    EXPECT_EQ(defect_of(line_file(with(whole_line, ";", ""))),
              "line 4: the parameters of this entity have no end; a part is missing or damaged");
}

// What is left to a default OpenCASCADE takes for 0.
TEST(IgesCheck, CountsTheNumbersOfArcsConicsAndLines) {
    const auto defect = [](const std::string& type, const std::string& numbers) {
        return defect_of(
            with(with(line_file(type + "," + numbers + ";"), "     126", "     " + type), "     126", "     " + type));
    };
    EXPECT_EQ(defect("110", "0.,0.,0.,1.,2.,3."), "");
    EXPECT_EQ(defect("110", "0.,0.,0.,1.,2."),
              "line 4: the entity 110 begins with 5 numbers, but it needs 6; the next one is missing, or left to a "
              "default, which is not read");
    EXPECT_EQ(defect("100", "0.,0.,0.,1.,0.,0.,1."), "");
    EXPECT_NE(defect("100", "0.,,0.,1.,0.,0.,1."), "");
    EXPECT_EQ(defect("104", "1.,0.,0.,0.,-4.,0.,0.,-2.,1.,2.,1."), "");
    EXPECT_NE(defect("104", "1.,0.,0.,0.,-4.,0.,0.,-2.,1.,2."), "");
}

TEST(IgesCheck, FindsADirectoryThatLies) {
    EXPECT_NE(defect_of(with(line_file(whole_line), "     126       1", "     126       2")), "");
    EXPECT_NE(defect_of(with(line_file(whole_line), "     126       1", "     110       1")), "");
    EXPECT_EQ(defect_of(line_file(with(whole_line, "126", "110"))),
              "line 4: the parameters do not begin with 126, as line 2 has it of them");
}

// Else a small file could have the same lines read very often.
TEST(IgesCheck, GivesNoLineToTwoEntities) {
    std::string text = with(line_file(whole_line), "S      0G      1D      2P", "S      0G      1D      4P");
    const std::size_t behind_directory = text.find(whole_line);
    std::string again = text.substr(81, behind_directory - 81);
    again = with(with(again, "D      1", "D      3"), "D      2", "D      4");
    EXPECT_EQ(defect_of(text.insert(behind_directory, again)),
              "line 4: by the directory, entities have more lines in section P than there are");
}

TEST(IgesCheck, LooksOverTheTextsInParameters) {
    EXPECT_EQ(defect_of(line_file(with(whole_line, ";", ",5Ha;,b9,,3H 1 ;"))), "");
    EXPECT_NE(defect_of(line_file(with(whole_line, ";", ",5Ha;,b99,3H 1 ;"))), "");
}

// Bytes replaced, left out, repeated: whatever becomes of it, there is an answer, and a defect names what it is.
TEST(IgesCheck, HasAnAnswerToAnyDamage) {
    const std::string whole = line_file(whole_line);
    using namespace std::string_literals;
    Damage damage(3, "0159.,;HED+- SGDPT\n\0\xff"s);  // with the zero
    for (int i = 0; i < 20'000; ++i) {
        const auto defect = iges_defect(damage.of(whole));
        ASSERT_TRUE(!defect || !defect->what.empty());
    }
}

}  // namespace batten::exchange
