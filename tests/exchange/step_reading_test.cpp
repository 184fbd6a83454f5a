#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "exchange/cad/step_text.h"
#include "exchange/format.h"

namespace batten::exchange {

namespace {

using core::Point;

constexpr const char* in_millimeters = "#914=(LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.));\n";

// A file of the curve #6 in `data`.
std::string file_of_curve(const std::string& data, const std::string& unit = in_millimeters) {
    return R"(ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('','2026-01-01T00:00:00',(''),(''),'','','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 }'));
ENDSEC;
DATA;
#901=APPLICATION_CONTEXT('core data for automotive mechanical design processes');
#902=APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#901);
#903=PRODUCT_CONTEXT('',#901,'mechanical');
#904=PRODUCT('','','',(#903));
#905=PRODUCT_DEFINITION_FORMATION('','',#904);
#906=PRODUCT_DEFINITION_CONTEXT('part definition',#901,'design');
#907=PRODUCT_DEFINITION('design','',#905,#906);
#908=PRODUCT_DEFINITION_SHAPE('','',#907);
#909=SHAPE_DEFINITION_REPRESENTATION(#908,#910);
#910=GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION('',(#911),#912);
#911=GEOMETRIC_CURVE_SET('',(#6));
#912=(GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNIT_ASSIGNED_CONTEXT((#914,#915,#916)) REPRESENTATION_CONTEXT('',''));
#915=(NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.));
#916=(NAMED_UNIT(*) SI_UNIT($,.STERADIAN.) SOLID_ANGLE_UNIT());
)" + unit + data +
           "ENDSEC;\nEND-ISO-10303-21;\n";
}

// Of the parabola with the vertex (0, 0), the focal length 2 and the axis x.
std::string trimmed_parabola(const std::string& from, const std::string& to, const std::string& sense,
                             const std::string& points = "") {
    return "#1=CARTESIAN_POINT('',(0.,0.,0.));\n#2=DIRECTION('',(0.,0.,1.));\n#3=DIRECTION('',(1.,0.,0.));\n"
           "#4=AXIS2_PLACEMENT_3D('',#1,#2,#3);\n#5=PARABOLA('',#4,2.);\n#6=TRIMMED_CURVE('arc',#5,(" +
           from + "),(" + to + ")," + sense + ",.PARAMETER.);\n" + points;
}

constexpr const char* parabola_of_bezier_points =
    "#1=CARTESIAN_POINT('',(0.,0.,0.));\n#2=CARTESIAN_POINT('',(1.1,2.2,0.));\n#3=CARTESIAN_POINT('',(3.3,2.3,0.));\n"
    "#6=B_SPLINE_CURVE_WITH_KNOTS('s',2,(#1,#2,#3),.UNSPECIFIED.,.F.,.F.,(3,3),(0.,1.),.UNSPECIFIED.);\n";

// An inch that is 2.54 of a hundredth of a meter.
constexpr const char* in_inches =
    "#914=(CONVERSION_BASED_UNIT('INCH',#920) LENGTH_UNIT() NAMED_UNIT(#921));\n"
    "#920=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(2.54),#922);\n"
    "#921=DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);\n"
    "#922=(LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.CENTI.,.METRE.));\n";

std::string replaced(std::string text, const std::string& before, const std::string& after) {
    const std::size_t at = text.find(before);
    EXPECT_NE(at, std::string::npos) << before;
    return text.replace(at, before.size(), after);
}

class StepReading : public testing::Test {
  protected:
    void SetUp() override {
        if (spec_of(Format::step).read == nullptr) GTEST_SKIP() << "this build has no OpenCASCADE";
    }

    static Imported read(const std::string& text) {
        const auto imported = spec_of(Format::step).read(text);
        EXPECT_TRUE(imported) << imported.error().sentence();
        return imported ? *imported : Imported{};
    }

    static void expect_points(const Imported& imported, const std::vector<Point>& expected) {
        ASSERT_EQ(imported.document.curves.size(), 1u);
        const auto points = imported.document.curves[0].curve->control_points();
        ASSERT_EQ(points.size(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i)
            EXPECT_LE(core::distance(points[i], expected[i]), imported.report.largest_error) << i;
    }
};

TEST(StepText, IsAsOpenCascadeReadsIt) {
    EXPECT_EQ(step_text_for_occt("\xef\xbb\xbf"
                                 "A;\n#1\n=B('#2 =;;',#3);"),
              "A;\n#1=B('#2 =;;',#3);");
    EXPECT_EQ(step_text_for_occt("A;;\n#12 /* ; */\r\n = B(#3 ,\"0\");;\n;C;"), "A;\n#12= B(#3 ,\"0\");\nC;");
    EXPECT_EQ(step_text_for_occt("#1=A('without an end"), "#1=A('without an end");
    EXPECT_EQ(step_text_for_occt("#"), "#");
    EXPECT_EQ(step_text_for_occt(""), "");
}

TEST_F(StepReading, LinesMayEndAnywhereAndFilesMayBeginWithAByteOrderMark) {
    const std::string text = file_of_curve(parabola_of_bezier_points);
    const Imported plain = read(text);
    EXPECT_EQ(plain.report.largest_error, 0.0);
    expect_points(plain, {{0, 0}, {1.1, 2.2}, {3.3, 2.3}});
    for (const std::string& other :
         {replaced(text, "#6=", "#6\n="), replaced(text, "#6=", "#6 /* a curve */ =\n"), "\xef\xbb\xbf" + text,
          replaced(text, "ISO-10303-21;", "ISO-10303-21;;"), replaced(text, "DATA;", "DATA;\r\n;")})
        EXPECT_EQ(*read(other).document.curves.at(0).curve, *plain.document.curves.at(0).curve) << other.substr(0, 20);
}

// By ISO 10303-42, 4.4.29, u is at 2 (u^2, 2 u): the arc from 0 to 1 has the tangents x = 0 and y = x + 2. OpenCASCADE
// takes u for the distance from the axis.
TEST_F(StepReading, ParabolasAreTrimmedByTheParametersOfTheStandard) {
    expect_points(read(file_of_curve(trimmed_parabola("PARAMETER_VALUE(0.)", "PARAMETER_VALUE(1.)", ".T."))),
                  {{0, 0}, {0, 2}, {2, 4}});
    expect_points(read(file_of_curve(trimmed_parabola("PARAMETER_VALUE(0.)", "PARAMETER_VALUE(-1.)", ".F."))),
                  {{0, 0}, {0, -2}, {2, -4}});
}

TEST_F(StepReading, PointsTellWhichParametersOfAParabolaAreMeant) {
    const auto with_end = [](const std::string& end) {
        return file_of_curve(
            trimmed_parabola("#7,PARAMETER_VALUE(0.)", "#8,PARAMETER_VALUE(1.)", ".T.",
                             "#7=CARTESIAN_POINT('',(0.,0.,0.));\n#8=CARTESIAN_POINT('',(" + end + "));\n"));
    };
    expect_points(read(with_end("2.,4.,0.")), {{0, 0}, {0, 2}, {2, 4}});
    expect_points(read(with_end("0.125,1.,0.")), {{0, 0}, {0, 0.5}, {0.125, 1}});
    const Imported neither = read(with_end("5.,4.,0."));
    EXPECT_EQ(
        neither.report.left_out,
        std::vector<std::string>{"the numbers of the curve at #6 contradict one another; by how much is in the error"});
    EXPECT_NEAR(neither.report.largest_error, 3.0, 1e-12);
}

// 2.54 times 0.01 is not 0.0254 in doubles.
TEST_F(StepReading, LengthsThatAreMultipliedAreNotCalledExact) {
    const Imported found = read(file_of_curve(parabola_of_bezier_points, in_inches));
    EXPECT_EQ(found.document.units, core::DocumentUnits{.unit = core::LengthUnit::inch});
    expect_points(found, {{0, 0}, {1.1, 2.2}, {3.3, 2.3}});
    EXPECT_GT(found.report.largest_error, 0.0);
    EXPECT_LT(found.report.largest_error, 1e-14);
    EXPECT_TRUE(found.report.left_out.empty());
    const Imported of_meters =
        read(file_of_curve(parabola_of_bezier_points, "#914=(LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT($,.METRE.));\n"));
    expect_points(of_meters, {{0, 0}, {1100, 2200}, {3300, 2300}});
    EXPECT_EQ(of_meters.report.left_out.size(), 1u);
}

// At its end the curve is 1e-13 |C'(1)| = 2e-13 |(2.2, 0.1)| farther than where it is trimmed.
TEST_F(StepReading, PartsThatAreNearlyWholeAreNotCalledExact) {
    const auto trimmed_at = [](const std::string& end) {
        return read(file_of_curve(replaced(parabola_of_bezier_points, "#6=", "#5=") +
                                  "#6=TRIMMED_CURVE('',#5,(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(" + end +
                                  ")),.T.,.PARAMETER.);\n"));
    };
    EXPECT_EQ(trimmed_at("1.").report.largest_error, 0.0);
    const Imported nearly_whole = trimmed_at("0.9999999999999");
    EXPECT_GE(nearly_whole.report.largest_error, 2e-13 * std::hypot(2.2, 0.1));
    EXPECT_LT(nearly_whole.report.largest_error, 1e-12);
}

// Whatever the flag says of them.
TEST_F(StepReading, NearEndsStayTwo) {
    for (const char* is_closed : {".F.", ".T.", ".U."}) {
        const std::string text = replaced(parabola_of_bezier_points, "(3.3,2.3,0.)", "(1.E-9,0.,0.)");
        const Imported found =
            read(file_of_curve(replaced(text, ".UNSPECIFIED.,.F.", std::string(".UNSPECIFIED.,") + is_closed)));
        EXPECT_EQ(found.report.largest_error, 0.0);
        expect_points(found, {{0, 0}, {1.1, 2.2}, {1e-9, 0}});
    }
}

}  // namespace

}  // namespace batten::exchange
