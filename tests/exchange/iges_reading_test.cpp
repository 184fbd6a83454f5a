#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/base/number_text.h"
#include "core/evaluate/evaluate.h"
#include "exchange/format.h"

namespace batten::exchange {

namespace {

using core::Point;

struct IgesEntity {
    int type = 0;
    int form = 0;
    std::string parameters{};
    std::string status = "00000000";
    int placed_by = 0;  // line of the directory
};

std::string to_width(const std::string& text, std::size_t width) {
    return std::string(width - std::min(width, text.size()), ' ') + text;
}

std::string iges_line(const std::string& text, char section, std::size_t number) {
    return text + std::string(72 - text.size(), ' ') + section + to_width(std::to_string(number), 7) + "\n";
}

// Texts of at most 64 characters, which end behind commas, or at the end.
std::vector<std::string> parameter_lines(std::string text) {
    std::vector<std::string> lines;
    while (text.size() > 64) {
        const std::size_t length = text.rfind(',', 63) + 1;
        lines.push_back(text.substr(0, length) + std::string(64 - length, ' '));
        text.erase(0, length);
    }
    lines.push_back(text + std::string(64 - text.size(), ' '));
    return lines;
}

// In the unit that this part of section G says. The entities have the lines 1, 3, 5 and so on of the directory.
std::string iges_file(const std::vector<IgesEntity>& entities, const std::string& unit = "2,2HMM") {
    std::string directory;
    std::string data;
    std::size_t directory_lines = 0;
    std::size_t data_lines = 0;
    const auto add_line = [&](const std::vector<std::string>& fields) {
        std::string line;
        for (const std::string& field : fields) line += to_width(field, 8);
        directory += iges_line(line, 'D', ++directory_lines);
    };
    for (const IgesEntity& entity : entities) {
        const std::string type = std::to_string(entity.type);
        const std::vector<std::string> lines = parameter_lines(type + "," + entity.parameters + ";");
        add_line({type, std::to_string(data_lines + 1), "0", "0", "0", "0", std::to_string(entity.placed_by), "0",
                  entity.status});
        add_line({type, "0", "0", std::to_string(lines.size()), std::to_string(entity.form), "", "", "", "0"});
        for (const std::string& line : lines)
            data += iges_line(line + to_width(std::to_string(directory_lines - 1), 8), 'P', ++data_lines);
    }
    const std::string end = "S      1G      2D" + to_width(std::to_string(directory_lines), 7) + "P" +
                            to_width(std::to_string(data_lines), 7);
    return iges_line("test", 'S', 1) +
           iges_line("1H,,1H;,1Ht,1Ht,1Ht,1Ht,32,308,15,308,15,1Ht,1.," + unit + ",", 'G', 1) +
           iges_line("1,0.01,15H20260101.000000,1E-07,60.,,,11,0,15H20260101.000000,;", 'G', 2) + directory + data +
           iges_line(end, 'T', 1);
}

std::string listed(const std::vector<double>& numbers) {
    std::string text;
    for (const double number : numbers) text += core::shortest_text(number) + ",";
    return text;
}

// Entity 126 of a clamped curve.
IgesEntity b_spline_entity(const core::CurveDefinition& curve) {
    const std::size_t n = curve.points.size();
    std::string text = std::to_string(n - 1) + "," + std::to_string(curve.degree) + ",1,0,0,0," + listed(curve.knots);
    text += listed(curve.weights.empty() ? std::vector<double>(n, 1.0) : curve.weights);
    for (const Point point : curve.points) text += listed({point.x, point.y, 0.0});
    return {126, 0, text + listed({curve.knots.front(), curve.knots.back()}) + "0.,0.,1."};
}

// x^2 = 4 y from (-2, 1) to (2, 1), whose tangents meet in (0, -1).
const IgesEntity upright_parabola{104, 3, "1.,0.,0.,0.,-4.,0.,0.,-2.,1.,2.,1."};

// A quarter turn, and 10 to the right.
const IgesEntity quarter_turn{124, 0, "0.,-1.,0.,10.,1.,0.,0.,0.,0.,0.,1.,0."};

class IgesReading : public testing::Test {
  protected:
    void SetUp() override {
        if (spec_of(Format::iges).read == nullptr) GTEST_SKIP() << "this build has no OpenCASCADE";
    }

    static Imported read(const std::vector<IgesEntity>& entities, const std::string& unit = "2,2HMM") {
        const auto imported = spec_of(Format::iges).read(iges_file(entities, unit));
        EXPECT_TRUE(imported) << imported.error().sentence();
        return imported ? *imported : Imported{};
    }

    static std::vector<Point> points(const Imported& imported, std::size_t i = 0) {
        const auto points = imported.document.curves.at(i).curve->control_points();
        return {points.begin(), points.end()};
    }

    static void expect_exact(const core::CurveDefinition& curve) {
        const Imported imported = read({b_spline_entity(curve)});
        EXPECT_EQ(imported.report.largest_error, 0.0);
        EXPECT_TRUE(imported.report.left_out.empty());
        const core::Curve& copy = *imported.document.curves.at(0).curve;
        EXPECT_TRUE(std::ranges::equal(copy.knots().values(), curve.knots));
        EXPECT_TRUE(std::ranges::equal(copy.control_points(), curve.points));
        EXPECT_TRUE(curve.weights.empty() || std::ranges::equal(copy.weights(), curve.weights));
    }
};

// OpenCASCADE mirrors it.
TEST_F(IgesReading, UprightParabolasRunWhereTheirEquationSays) {
    const Imported found = read({upright_parabola});
    EXPECT_EQ(points(found), (std::vector<Point>{{-2, 1}, {0, -1}, {2, 1}}));
    EXPECT_LT(found.report.largest_error, 1e-12);
    IgesEntity turned = upright_parabola;
    turned.placed_by = 3;
    EXPECT_EQ(points(read({turned, quarter_turn})), (std::vector<Point>{{9, -2}, {11, 0}, {9, 2}}));
    EXPECT_EQ(points(read({upright_parabola}, "6,1HM")), (std::vector<Point>{{-2000, 1000}, {0, -1000}, {2000, 1000}}));
}

// x^2 + y^2 / 4 = 1.
TEST_F(IgesReading, EllipsesThatAreHigherThanWideAreNotTurned) {
    const Imported found = read({{104, 1, "4.,0.,1.,0.,0.,-4.,0.,1.,0.,0.,2."}});
    const Point middle = core::point_at(*found.document.curves.at(0).curve, 0.5);
    EXPECT_NEAR(middle.x, std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(middle.y, std::sqrt(2.0), 1e-15);
}

TEST_F(IgesReading, NearKnotsSmallWeightsAndNearEndsStay) {
    const std::vector<Point> three{{0, 0}, {1, 2}, {3, 2}};
    const std::vector<Point> six{{0, 0}, {1, 2}, {3, 2}, {4, 1}, {5, 5}, {6, 0}};
    for (const double gap : {1e-6, 1e-9, 1e-12, 2.3e-16}) {
        SCOPED_TRACE(gap);
        expect_exact({.degree = 3, .knots = {0, 0, 0, 0, 0.5, 0.5 + gap, 1, 1, 1, 1}, .points = six});
    }
    const std::vector<double> knots{0, 0, 0, 1, 1, 1};
    const double next_to_one = std::nextafter(1.0, 2.0);
    for (const auto& weights : {std::vector<double>{1, 1e-10, 1}, {1e-300, 2e-300, 1e-300}, {1, next_to_one, 1}}) {
        SCOPED_TRACE(weights[1]);
        expect_exact({.degree = 2, .knots = knots, .points = three, .weights = weights});
    }
    expect_exact({.degree = 2, .knots = knots, .points = {{0, 0}, {1e-9, 2e-9}, {3e-9, 1e-9}}});
}

// Blank status is in the first two of eight digits; a field of blanks has the default, 0. By the last two, 01, what a
// group says does not hold for its members.
TEST_F(IgesReading, OnlyWhatIsBlankedIsHidden) {
    const auto is_visible = [](const std::string& status) {
        return read({{110, 0, "0.,0.,0.,1.,1.,0.", status}}).document.curves.at(0).visible;
    };
    for (const char* shown : {"00000000", "", "0", "1", "00010000", "00000001"})
        EXPECT_TRUE(is_visible(shown)) << shown;
    for (const char* hidden : {"01000000", "01010001"}) EXPECT_FALSE(is_visible(hidden)) << hidden;
    const auto is_member_visible = [](const std::string& status) {
        const IgesEntity line{110, 0, "0.,0.,0.,1.,1.,0.", "00010000"};
        return read({{402, 7, "1,3,0,0", status}, line}).document.curves.at(0).visible;
    };
    EXPECT_TRUE(is_member_visible("00000000"));
    EXPECT_FALSE(is_member_visible("01000000"));
    EXPECT_TRUE(is_member_visible("01000001"));
}

TEST_F(IgesReading, MembersOfCompositesAreReadOnce) {
    const std::vector<double> knots{0, 0, 0, 1, 1, 1};
    IgesEntity spline =
        b_spline_entity({.degree = 2, .knots = knots, .points = {{0, 0}, {1, 2}, {3, 2}}, .weights = {1, 2, 1}});
    spline.status = "00010000";
    const Imported found =
        read({{102, 0, "2,3,5", "00000000", 7}, spline, {110, 0, "3.,2.,0.,7.,2.,0.", "00010000"}, quarter_turn});
    EXPECT_EQ(found.report.left_out, std::vector<std::string>());
    ASSERT_EQ(found.document.curves.size(), 2u);
    EXPECT_EQ(points(found), (std::vector<Point>{{10, 0}, {8, 1}, {8, 3}}));
    EXPECT_EQ(found.document.curves[0].curve->weights()[1], 2.0);
}

TEST_F(IgesReading, WhatCompositesLackIsTold) {
    const IgesEntity line{110, 0, "0.,0.,0.,1.,1.,0.", "00010000"};
    const IgesEntity point{110, 0, "1.,1.,0.,1.,1.,0.", "00010000"};
    EXPECT_EQ(
        read({{102, 0, "2,3,5"}, line, point}).report.left_out,
        std::vector<std::string>{"parts of the curve at D1 were left out, since OpenCASCADE makes no curves of them"});
}

// Its end is 3 away from its center, its start 2.
TEST_F(IgesReading, ArcsThatContradictThemselvesAreTold) {
    const Imported found = read({{100, 0, "0.,0.,0.,2.,0.,0.,3."}});
    EXPECT_EQ(
        found.report.left_out,
        std::vector<std::string>{"the numbers of the curve at D1 contradict one another; by how much is in the error"});
    EXPECT_NEAR(found.report.largest_error, 1.0, 1e-12);
}

// Of x^2 + 4 y^2 = 4, from (3, 0), which is 1 beside it.
TEST_F(IgesReading, ConicsWhoseEndsAreBesideThemAreTold) {
    const Imported found = read({{104, 1, "1.,0.,4.,0.,0.,-4.,0.,3.,0.,0.,1."}});
    EXPECT_EQ(
        found.report.left_out,
        std::vector<std::string>{"the numbers of the curve at D1 contradict one another; by how much is in the error"});
    EXPECT_GE(found.report.largest_error, 1.0);
    EXPECT_TRUE(read({{104, 1, "1.,0.,4.,0.,0.,-4.,0.,2.,0.,0.,1."}}).report.left_out.empty());
}

// From (0, 0) to (1, 0), and from (1, 2) to (2, 2). An identity, and a quarter turn, make 2 no larger.
TEST_F(IgesReading, ParametricSplinesWhosePiecesDoNotMeetAreTold) {
    IgesEntity apart{112, 0,
                     "3,1,2,2,0.,1.,2.,0.,1.,0.,0.,0.,0.,0.,0.,0.,0.,0.,0.,1.,1.,0.,0.,2.,0.,0.,0.,0.,0.,0.,0.,"
                     "2.,1.,0.,0.,2.,0.,0.,0.,0.,0.,0.,0."};
    for (const int placed_by : {0, 3}) {
        apart.placed_by = placed_by;
        const Imported found = read({apart, quarter_turn});
        EXPECT_EQ(found.report.left_out,
                  std::vector<std::string>{
                      "the numbers of the curve at D1 contradict one another; by how much is in the error"});
        EXPECT_NEAR(found.report.largest_error, 2.0, 1e-12);
    }
}

// Over the knots 0 and 1, the parabola (2 t, 4 t (1 - t)).
TEST_F(IgesReading, PartsOfSplinesThatAreNotInTheirKnotsAreTold) {
    const auto between = [](const std::string& ends) {
        return read(
            {{126, 0, "2,2,0,0,1,0,0.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.,0.,1.,2.,0.,2.,0.,0.," + ends + ",0.,0.,1."}});
    };
    const std::vector<Point> whole{{0, 0}, {1, 2}, {2, 0}};
    const std::vector<Point> half{{0, 0}, {0.5, 1}, {1, 1}};
    for (const char* none : {"2.,3.", "-3.,-2.", "0.5,0.25", "0.,0."}) {
        const Imported found = between(none);
        EXPECT_EQ(points(found), whole) << none;
        EXPECT_EQ(found.report.left_out,
                  std::vector<std::string>{"the curve at D1 was read whole, since the part that was meant is beyond "
                                           "its knots or does not end after its beginning"});
        EXPECT_EQ(found.report.largest_error, INFINITY);
    }
    const Imported begun = between("-1.,0.5");
    EXPECT_EQ(points(begun), half);
    EXPECT_EQ(begun.report.left_out,
              std::vector<std::string>{
                  "the curve at D1 was to begin or end beyond its knots; the part within them was read"});
    for (const char* all : {"0.,1.", "-1E-9,1.000000001"}) {
        EXPECT_EQ(points(between(all)), whole) << all;
        EXPECT_TRUE(between(all).report.left_out.empty()) << all;
        EXPECT_EQ(between(all).report.largest_error, 0.0) << all;
    }
    EXPECT_EQ(points(between("0.,0.5")), half);
    EXPECT_TRUE(between("0.,0.5").report.left_out.empty());
}

// By the polynomials s^2 over [0, 1] and 1 + 2 s over [1, 2]: Bézier points (0, 0), (1/3, 0), (2/3, 1/3), (1, 1) and so
// on.
TEST_F(IgesReading, ParametricSplinesAreBezierPieces) {
    const std::string first = "0.,1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,0.,";
    const std::string second = "1.,1.,0.,0.,1.,2.,0.,0.,0.,0.,0.,0.,";
    const Imported found =
        read({{112, 0, "3,1,2,2,0.,1.,2.," + first + second + "2.,1.,0.,0.,3.,2.,0.,0.,0.,0.,0.,0."}});
    const std::vector<Point> expected{
        {0, 0}, {1.0 / 3, 0}, {2.0 / 3, 1.0 / 3}, {1, 1}, {4.0 / 3, 5.0 / 3}, {5.0 / 3, 7.0 / 3}, {2, 3}};
    ASSERT_EQ(points(found).size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_LT(core::distance(points(found)[i], expected[i]), 1e-15);
    EXPECT_GT(found.report.largest_error, 0.0);
    EXPECT_LT(found.report.largest_error, 1e-13);
}

TEST_F(IgesReading, SaysWhyACurveIsLeftOut) {
    const auto reason = [](const IgesEntity& entity) {
        const Imported found = read({entity, {110, 0, "0.,0.,0.,1.,1.,0."}});
        EXPECT_EQ(found.document.curves.size(), 1u);
        return found.report.left_out.at(0);
    };
    const std::vector<Point> points{{0, 0}, {1, 2}, {3, 2}};
    EXPECT_EQ(reason(b_spline_entity({.degree = 2, .knots = {0, 0, 0, 1, 0.5, 1}, .points = points})),
              "126 at D1 was left out: knot 4 is 0.5, less than knot 3, which is 1; knots must not decrease");
    EXPECT_EQ(
        reason(b_spline_entity({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = points, .weights = {1, -1, 1}})),
        "126 at D1 was left out: weight 1 is -1; every weight must be above 0");
    EXPECT_EQ(reason({104, 0, "1.,0.,-1.,0.,0.,0.,0.,0.,0.,1.,1."}),
              "104 at D1 was left out: its equation is that of lines or of a point");
}

TEST_F(IgesReading, NumbersOfAnUnknownUnitStay) {
    for (const char* unit : {"3,7HFURLONG", "12,2HMM"}) {
        const Imported found = read({upright_parabola}, unit);
        EXPECT_EQ(points(found), (std::vector<Point>{{-2, 1}, {0, -1}, {2, 1}}));
        EXPECT_FALSE(found.document.units);
        EXPECT_EQ(found.report.left_out.at(0),
                  "the unit of the file is none that IGES has, so it is left out; the numbers stay as they are");
    }
}

}  // namespace

}  // namespace batten::exchange
