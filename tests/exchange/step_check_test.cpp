#include "exchange/cad/step_check.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/exchange/damage.h"

namespace batten::exchange {

namespace {

std::string step_defect_of(const std::string& text) {
    const auto defect = step_defect(text);
    return defect ? defect->sentence() : "";
}

// A file of these lines of data, the first of which is line 4.
std::string step_file(const std::string& data) {
    return "ISO-10303-21;\nHEADER; FILE_NAME('it''s; #1',$); ENDSEC;\nDATA;\n" + data + "ENDSEC;\nEND-ISO-10303-21;\n";
}

const char* const whole_data =
    "#1=POINT('a;''b',(0.,-1.5E-3,+2),.F.,$,*,(),\"0F\"); /* #9=( */\n"
    "#2 = ( CURVE() LINE((#1,#1),LENGTH(3.)) );\n";

}  // namespace

TEST(StepCheck, FindsNothingInAWholeFile) {
    EXPECT_EQ(step_defect_of(core::read_text(BATTEN_EXCHANGE_DATA "/freecad.step").value()), "");
    EXPECT_EQ(step_defect_of(step_file(whole_data)), "");
    EXPECT_EQ(step_defect_of(step_file("")), "");
}

TEST(StepCheck, TakesByteOrderMarksEmptyStatementsAndLinesThatEndAnywhere) {
    EXPECT_EQ(step_defect_of("\xef\xbb\xbf" + step_file(whole_data)), "");
    EXPECT_EQ(step_defect_of(step_file("#1\r\n=\nPOINT\n();;\n;")), "");
    EXPECT_EQ(step_defect_of("ISO-10303-21;;\nDATA;\nENDSEC;;END-ISO-10303-21;"), "");
}

TEST(StepCheck, TakesNumbersBelowTheDoublesForZeros) {
    EXPECT_EQ(step_defect_of(step_file("#1=POINT('',(1.E-400,-1.E-400));\n")), "");
    EXPECT_NE(step_defect_of(step_file("#1=POINT('',(1.E400,0.));\n")), "");
}

TEST(StepCheck, RefusesAFileThatIsCutOff) {
    const std::string text = core::read_text(BATTEN_EXCHANGE_DATA "/freecad.step").value();
    const std::size_t end = text.find("END-ISO-10303-21") + 16;
    for (std::size_t length = 0; length < end; length += 1 + length % 13)
        ASSERT_NE(step_defect_of(text.substr(0, length)), "") << length;
}

// All that stands in the lines of FreeCAD's file belongs to some curve or to what is around it.
TEST(StepCheck, RefusesAFileThatLacksALine) {
    const std::string text = core::read_text(BATTEN_EXCHANGE_DATA "/freecad.step").value();
    std::size_t whole = 0;
    for (std::size_t begin = text.find("DATA;"); begin < text.find("ENDSEC;", begin);
         begin = text.find('\n', begin) + 1) {
        std::string cut = text;
        cut.erase(begin, text.find('\n', begin) + 1 - begin);
        if (step_defect_of(cut).empty()) ++whole;
    }
    EXPECT_LE(whole, 4U) << "instances that nothing names";
}

TEST(StepCheck, NamesTheLineOfWhatIsWrong) {
    EXPECT_EQ(step_defect_of(step_file("#1=POINT('',(1.,\n nan,0.));\n")),
              "line 5: found 'nan,0.)); ENDSEC; EN', which breaks the instance that begins in line 4");
    for (const char* data : {"#1=POINT('',(1.,,0.));\n", "#1=POINT('',(1.,0.);\n", "#1=POINT('',(1. 0.));\n",
                             "#1=POINT('',(1E999,0.));\n", "#1=POINT('',(1.,0.)));\n", "#1=POINT('',(1.,));\n",
                             "#1=POINT(',(1.,0.));\n", "#1=(POINT('',(1.,0.));\n", "#1 POINT();\n", "#=POINT();\n",
                             "#1=POINT(.F);\n", "#1=POINT(1.2.3);\n", "POINT(1.);\n", "#1=POINT(())\n#2=POINT();\n"})
        EXPECT_TRUE(step_defect_of(step_file(data)).starts_with("line ")) << data;
    EXPECT_EQ(step_defect_of(step_file("#1=POINT();\n#12=LINE(#1,\n#3);\n")),
              "line 6: the instance #3, which is named here, is not in the file; a part is missing");
    EXPECT_EQ(step_defect_of(step_file("#1=POINT();\n#1 =POINT();\n#2=LINE(#1);\n")),
              "line 5: two instances have the number #1");
    EXPECT_EQ(step_defect_of("ISO-10303-21;DATA;\n#1=POINT('',\n"),
              "line 2: the file ends within the instance that begins here; a part is missing");
    EXPECT_EQ(step_defect_of("\x7f"
                             "ELF"),
              "this is no STEP file, since it does not begin with ISO-10303-21");
}

TEST(StepCheck, TakesACommentThatDoesNotEnd) {
    EXPECT_NE(step_defect_of("ISO-10303-21; /* DATA; *"), "");
    EXPECT_NE(step_defect_of(step_file("/*")), "");
}

TEST(StepCheck, TakesAnyNesting) {
    const std::string open(100'000, '(');
    EXPECT_EQ(step_defect_of(step_file("#1=A(" + open + std::string(100'000, ')') + ");\n")), "");
    EXPECT_NE(step_defect_of(step_file("#1=A(" + open)), "");
}

// Bytes replaced, left out, repeated: whatever becomes of it, there is an answer, and a defect names what it is.
TEST(StepCheck, HasAnAnswerToAnyDamage) {
    const std::string whole = step_file(whole_data);
    using namespace std::string_literals;
    Damage damage(3, "0159.,;#()'\"=$*/ \n\0\xff"s);  // with the zero
    for (int i = 0; i < 20'000; ++i) {
        const auto defect = step_defect(damage.of(whole));
        ASSERT_TRUE(!defect || !defect->what.empty());
    }
}

}  // namespace batten::exchange
