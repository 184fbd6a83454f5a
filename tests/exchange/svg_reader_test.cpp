#include "exchange/svg/svg_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/evaluate/evaluate.h"
#include "core/measure/area.h"
#include "tests/exchange/svg_elements.h"

namespace batten::exchange {

namespace {

using core::Curve;
using core::Point;

Imported read_path(const std::string& data) {
    return read_elements("<path d=\"" + data + "\"/>");
}

Curve path_curve(const std::string& data) {
    return curve_of(read_path(data));
}

std::string refusal_of(const std::string& text) {
    const auto imported = read_svg(text);
    EXPECT_FALSE(imported);
    return imported ? "" : imported.error().sentence();
}

double signed_area(const Curve& curve) {
    return core::enclosed_area(curve)->signed_area;
}

void expect_on_circle(const Curve& curve, Point center, double radius, double tolerance = 1e-12) {
    for (int i = 0; i <= 400; ++i) {
        const double u = curve.domain().lower + curve.domain().length() * i / 400.0;
        EXPECT_NEAR(core::distance(core::point_at(curve, u), center), radius, tolerance) << u;
    }
}

}  // namespace

TEST(SvgPath, ReadsLinesWithYUpward) {
    const Curve curve = path_curve("M 1 2 L 4 6 H 7 V -1");
    EXPECT_EQ(curve.degree(), 1);
    EXPECT_FALSE(curve.is_periodic());
    EXPECT_EQ(points_of(curve), (std::vector<Point>{{1, -2}, {4, -6}, {7, -6}, {7, 1}}));
    EXPECT_EQ(curve.domain(), (core::Interval{0, 3}));
}

TEST(SvgPath, ReadsRelativeCommands) {
    EXPECT_EQ(points_of(path_curve("m1 2 3 4h3v-7l-1-1")),
              (std::vector<Point>{{1, -2}, {4, -6}, {7, -6}, {7, 1}, {6, 2}}));
}

TEST(SvgPath, ReadsNumbersThatAreRunTogether) {
    EXPECT_EQ(points_of(path_curve("M1.5.5-3e2-.25L+2,3\n4\t5,6 7e-1")),
              (std::vector<Point>{{1.5, -0.5}, {-300, 0.25}, {2, -3}, {4, -5}, {6, -0.7}}));
}

TEST(SvgPath, ReadsCubicsAndTheirReflectedHandles) {
    const Curve curve = path_curve("M0 0 C1 2 3 2 4 0 S7-3 8 0 s3 3 4 0");
    EXPECT_EQ(curve.degree(), 3);
    EXPECT_EQ(
        points_of(curve),
        (std::vector<Point>{{0, 0}, {1, -2}, {3, -2}, {4, 0}, {5, 2}, {7, 3}, {8, 0}, {9, -3}, {11, -3}, {12, 0}}));
    EXPECT_EQ(curve.knots().kind(), core::KnotKind::piecewise_bezier);
}

TEST(SvgPath, ReflectsNoHandleOfAnotherDegree) {
    EXPECT_EQ(points_of(path_curve("M0 0 Q1 1 2 0 S3 1 4 0"))[3], Point(2, 0))
        << "the first handle is the point itself";
    EXPECT_EQ(points_of(path_curve("M0 0 C0 1 1 1 2 0 T4 0")).back(), Point(4, 0));
}

TEST(SvgPath, ReadsQuadraticsAndTheirReflectedHandles) {
    const Curve curve = path_curve("M0 0q1 2 2 0t2 0T8 0");
    EXPECT_EQ(curve.degree(), 2);
    EXPECT_EQ(points_of(curve), (std::vector<Point>{{0, 0}, {1, -2}, {2, 0}, {3, 2}, {4, 0}, {5, -2}, {8, 0}}));
}

TEST(SvgPath, RaisesPiecesToTheHighestDegree) {
    const Curve curve = path_curve("M0 0 L3 3 Q6 6 9 3 C9 2 8 1 7 0");
    EXPECT_EQ(
        points_of(curve),
        (std::vector<Point>{{0, 0}, {1, -1}, {2, -2}, {3, -3}, {5, -5}, {7, -5}, {9, -3}, {9, -2}, {8, -1}, {7, 0}}));
}

TEST(SvgPath, MakesOneCurveOfEachSubpath) {
    const Imported imported = read_elements(R"(<path id="ring" d="M0 0h4v4h-4z m1 1h2v2h-2z"/>)");
    ASSERT_EQ(imported.document.curves.size(), 2U);
    EXPECT_EQ(imported.document.curves[1].name, "ring 2");
    EXPECT_EQ(imported.document.curves[1].group, "ring");
    EXPECT_TRUE(curve_of(imported).is_periodic());
    EXPECT_EQ(points_of(curve_of(imported)), (std::vector<Point>{{0, 0}, {4, 0}, {4, -4}, {0, -4}}));
    EXPECT_EQ(points_of(curve_of(imported, 1)).front(), Point(1, -1)) << "m goes on from the start of the closed one";
}

TEST(SvgPath, GoesOnFromTheStartAfterAClosedSubpath) {
    const Imported imported = read_path("M1 1h2v2z l-1-1");
    ASSERT_EQ(imported.document.curves.size(), 2U);
    EXPECT_EQ(points_of(curve_of(imported, 1)), (std::vector<Point>{{1, -1}, {0, 0}}));
}

TEST(SvgPath, ClosesCurvedOutlinesWithoutSeam) {
    const Curve curve = path_curve("M0 0 C0 4 4 4 4 0 C4-4 0-4 0 0 Z");
    EXPECT_TRUE(curve.is_periodic());
    EXPECT_EQ(curve.control_points().size(), 6U);
    EXPECT_EQ(core::point_at(curve, 0.0), Point(0, 0));
    expect_near(core::point_at(curve, 0.5), {2, -3});
    expect_near(core::point_at(curve, 1.5), {2, 3});
}

TEST(SvgPath, MovesAnEndThatMissesItsStartByRounding) {
    const Imported imported = read_path("M0 0L10 0L10 10L0.000001 0Z");
    EXPECT_EQ(curve_of(imported).control_points().size(), 3U);
    EXPECT_DOUBLE_EQ(imported.report.largest_error, 1e-6);
    EXPECT_EQ(path_curve("M0 0L10 0L10 10L0.001 0Z").control_points().size(), 4U);
}

TEST(SvgPath, ReadsArcsAsExactConics) {
    const Imported imported = read_path("M 5 0 A 5 5 0 0 1 0 5 A 5 5 0 0 1 -5 0 A 5 5 0 1 1 5 0 z");
    const Curve curve = curve_of(imported);
    EXPECT_TRUE(curve.is_periodic());
    EXPECT_EQ(curve.degree(), 2);
    expect_on_circle(curve, {0, 0}, 5);
    EXPECT_EQ(core::point_at(curve, 1.0), Point(0, -5));
    EXPECT_NEAR(signed_area(curve), -25 * std::numbers::pi, 1e-9) << "y down: clockwise in the plane";
    EXPECT_EQ(imported.report.largest_error, 0.0);
}

// The four arcs between two points, by the centers of their circles: Pythagoras in 3, 4, 5.
TEST(SvgPath, TakesTheArcThatTheFlagsMean) {
    struct Case {
        std::string flags;
        Point center;
        Point apex;
    };
    for (const Case& c : {Case{"0 0", {0, -3}, {0, 2}}, Case{"0 1", {0, 3}, {0, -2}}, Case{"1 0", {0, 3}, {0, 8}},
                          Case{"1 1", {0, -3}, {0, -8}}}) {
        const Curve curve = path_curve("M4 0A5 5 0 " + c.flags + " -4 0");
        expect_on_circle(curve, c.center, 5);
        expect_near(core::point_at(curve, curve.domain().length() / 2), c.apex);
        EXPECT_EQ(core::point_at(curve, 0.0), Point(4, 0));
        EXPECT_EQ(core::point_at(curve, curve.domain().upper), Point(-4, 0));
    }
}

TEST(SvgPath, ReadsFlagsWithoutSeparators) {
    EXPECT_EQ(path_curve("M4 0A5 5 0 10-4 0"), path_curve("M 4 0 A 5 5 0 1 0 -4 0"));
    EXPECT_EQ(path_curve("M4 0a5 5 0 01-8 0 3 2 30 1110 4"), path_curve("M4 0 a5,5 0 0,1 -8,0 a 3 2 30 1 1 10 4"));
}

// Seen from its own axes the ellipse is ((x / rx)^2 + (y / ry)^2 = 1).
TEST(SvgPath, ReadsTurnedEllipses) {
    const Curve curve = path_curve("M 0 0 A 8 3 30 1 1 6 2");
    const double angle = std::numbers::pi / 6;
    const auto own = [&](Point p) {  // y down
        return Point(std::cos(angle) * p.x - std::sin(angle) * p.y, -std::sin(angle) * p.x - std::cos(angle) * p.y);
    };
    // The center is where both ends lie on the ellipse, on the right of the chord for the large positive arc.
    const Point a = own(core::point_at(curve, 0.0));
    const Point b = own(core::point_at(curve, curve.domain().upper));
    const Point ua{a.x / 8, a.y / 3};
    const Point ub{b.x / 8, b.y / 3};
    const double d = core::distance(ua, ub) / 2;
    const core::Vector t = (ub - ua) / (2 * d);
    const Point center = core::middle(ua, ub) - std::sqrt(1 - d * d) * core::turned_left(t);
    for (int i = 0; i <= 100; ++i) {
        const Point p = own(core::point_at(curve, curve.domain().upper * i / 100.0));
        EXPECT_NEAR(core::distance({p.x / 8, p.y / 3}, center), 1.0, 1e-12);
    }
}

// Where the center is so near to the middle of the ends that doubles leave no digit of its distance. The apexes are
// those of the numbers as they are written: by Pythagoras, and by arithmetic of 50 digits.
TEST(SvgPath, ReadsArcsOfNearlyHalfAnEllipse) {
    struct Case {
        std::string data;
        double start;  // of the arc, behind so many lines
        Point apex;
    };
    for (const Case& c : {Case{"M.1 .1A.5 .5 0 0 1 .7 .9", 0, {0.8, -0.2}},
                          Case{"M.1 .1l.2 .3 .3 .4a.5 .5 0 1 0 .6 .8", 2, {0.5, -1.5}},
                          Case{"M.1 .1h.2v.3l.3 .4a.5 .5 0 1 0 .6 .8", 3, {0.5, -1.5}},
                          Case{"M0 0A1 1 0 0 1 1.9999999999999 0", 0, {0.99999999999995, 0.99999968377223398317}},
                          Case{"M267.142416221 .89999087847A50-.5 30 1 1 333.057583779 39.7000091215",
                               0,
                               {328.18740717903399735, -36.074678421798063992}}}) {
        const Imported imported = read_path(c.data);
        const Curve curve = curve_of(imported);
        const double middle = 0.5 * (c.start + curve.domain().upper);
        expect_near(core::point_at(curve, middle), c.apex, 1e-15 * std::max(1.0, std::abs(c.apex.x)));
        EXPECT_EQ(imported.report.largest_error, 0.0);
    }
}

TEST(SvgPath, GrowsRadiiThatAreTooSmall) {
    expect_on_circle(path_curve("M-3 0A1 1 0 0 1 3 0"), {0, 0}, 3);
    EXPECT_EQ(points_of(path_curve("M0 0A0 5 0 0 1 3 4")), (std::vector<Point>{{0, 0}, {3, -4}})) << "a line";
    EXPECT_EQ(points_of(path_curve("M0 0A-5-5 0 0 1 3 4A5 5 0 1 1 3 4")).back(), Point(3, -4)) << "nothing";
}

TEST(SvgPath, KeepsFlatArcsFlat) {
    const Curve curve = path_curve("M-1 0A1e9 1e9 0 0 1 1 0");
    const Point middle = core::point_at(curve, 0.5);
    EXPECT_NEAR(middle.y * 1e10, 5.0, 1e-9) << "the sagitta of a chord 2 is 1 / (2 r)";
    expect_near(core::point_at(path_curve("M1e6 1e6a5 5 0 0 1 6 8"), 1.0), {1e6 + 3 + 4, -1e6 - 4 + 3}, 1e-9);
}

TEST(SvgPath, ReadsUpToWhatGoesWrong) {
    const Imported imported = read_elements(R"(<path id="wave" d="M0 0L1 1 2 X 5"/>)");
    EXPECT_EQ(points_of(curve_of(imported)), (std::vector<Point>{{0, 0}, {1, -1}}));
    EXPECT_EQ(
        imported.report.left_out,
        (std::vector<std::string>{"the path data go wrong at character 12 of 'wave'; they are read up to there"}));
    const Imported several = read_elements(R"(<path id="a" d="M0 0h1 X"/><polygon id="b" points="0,0 1,0 1,1 x"/>
        <path id="c" d="M0 0h1 L5"/><polyline id="d" points="0,0 1,0 1"/>)");
    EXPECT_EQ(several.report.left_out,
              (std::vector<std::string>{
                  "the data of 2 paths go wrong, first at character 8 of 'a'; they are read up to there",
                  "the points of 2 polygons or polylines go wrong, first at character 13 of 'b'; they are read up to "
                  "there"}));
    for (const std::string data : {"M0 0h1 1e999", "M0 0h1 L5", "M0 0h1A1 1 0 2 0 5 5", "M0 0h1L", "M0 0h1,",
                                   "M0 0h1 nan", "M0 0h1L inf 0", "M0 0h1#", "M0 0h1Z3", "M0 0h1L0x10 3"})
        EXPECT_EQ(read_path(data).report.left_out.size(), 1U) << data;
    EXPECT_TRUE(read_path("M0 0h1 2 3 ").report.left_out.empty());
}

TEST(SvgPath, LeavesOutCurvesThatCannotBe) {
    const Imported imported = read_elements(R"(<path id="far" d="M1e308 0l1e308 0"/><path d="M0 0h1"/>)");
    EXPECT_EQ(imported.document.curves.size(), 1U);
    ASSERT_EQ(imported.report.left_out.size(), 1U);
    EXPECT_TRUE(imported.report.left_out[0].starts_with("'far' is left out: ")) << imported.report.left_out[0];
}

TEST(SvgShapes, AreExact) {
    const Imported imported = read_elements(
        R"(<circle cx="1" cy="2" r="3"/><ellipse cx="1" cy="2" rx="4" ry="2"/><line x1="1" y1="2" x2="3" y2="5"/>
           <polyline points="0,0 1,2 3 4"/><polygon points="0,0 4,0 4,3"/><rect x="1" y="2" width="10" height="6"/>
           <rect x="1" y="2" width="10" height="6" rx="2"/>)");
    ASSERT_EQ(imported.document.curves.size(), 7U);
    expect_on_circle(curve_of(imported, 0), {1, -2}, 3);
    EXPECT_EQ(core::point_at(curve_of(imported, 0), 1.0), Point(1, -5)) << "clockwise in the plane, as SVG draws it";
    EXPECT_NEAR(signed_area(curve_of(imported, 1)), -8 * std::numbers::pi, 1e-9);
    EXPECT_EQ(points_of(curve_of(imported, 2)), (std::vector<Point>{{1, -2}, {3, -5}}));
    EXPECT_EQ(points_of(curve_of(imported, 3)), (std::vector<Point>{{0, 0}, {1, -2}, {3, -4}}));
    EXPECT_TRUE(curve_of(imported, 4).is_periodic());
    EXPECT_EQ(points_of(curve_of(imported, 5)), (std::vector<Point>{{1, -2}, {11, -2}, {11, -8}, {1, -8}}));
    EXPECT_NEAR(signed_area(curve_of(imported, 6)), -(60 - 16 + 4 * std::numbers::pi), 1e-9);
}

TEST(SvgShapes, WithoutSizeAreNotDrawn) {
    EXPECT_EQ(refusal_of(drawing_of_paths(R"(<circle r="0"/><rect width="3"/><path d=""/><line/>)")),
              "no path and no shape is drawn in this file");
}

TEST(SvgTransforms, AreAppliedFromTheInnermostOut) {
    const auto end_of = [](const std::string& transform) {
        return points_of(curve_of(read_elements("<g transform=\"" + transform + R"("><path d="M0 0L3 5"/></g>)")))
            .back();
    };
    EXPECT_EQ(end_of("translate(10, 20)"), Point(13, -25));
    EXPECT_EQ(end_of("translate(10)"), Point(13, -5));
    EXPECT_EQ(end_of("scale(2)"), Point(6, -10));
    EXPECT_EQ(end_of("scale(2 -1)"), Point(6, 5));
    EXPECT_EQ(end_of("rotate(90)"), Point(-5, -3)) << "from x to y, which goes down";
    expect_near(end_of("rotate(90 1 1)"), {-3, -3});
    expect_near(end_of("skewX(45)"), {8, -5});
    expect_near(end_of("skewY(45)"), {3, -8});
    EXPECT_EQ(end_of("matrix(1 2 3 4 5 6)"), Point(3 + 15 + 5, -(6 + 20 + 6)));
    EXPECT_EQ(end_of("translate(1,2),scale(2) "), Point(7, -12)) << "scaled first";
    const Imported nested = read_elements(
        R"svg(<g transform="scale(2)"><g transform="translate(1 0)"><path transform="rotate(90)" d="M0 0L3 5"/></g></g>)svg");
    EXPECT_EQ(points_of(curve_of(nested)).back(), Point(-8, -6));
    EXPECT_EQ(read_elements(R"svg(<path id="p" transform="turn(3)" d="M0 0h1"/>)svg").report.left_out,
              std::vector<std::string>{"the transform of 'p' cannot be read, so it stands where it would without"});
}

TEST(SvgTransforms, KeepArcsExact) {
    const Curve curve =
        curve_of(read_elements(R"svg(<circle r="2" transform="translate(3 1) rotate(25) scale(.5)"/>)svg"));
    expect_on_circle(curve, {3, -1}, 1);
}

TEST(SvgPage, HasTheUnitOfItsWidth) {
    const auto read = [](const std::string& attributes) {
        return *read_svg("<svg " + attributes + R"(><path d="M10 20L30 40"/></svg>)");
    };
    const Imported millimeters = read(R"(width="100mm" height="50mm" viewBox="0 0 200 100")");
    EXPECT_EQ(millimeters.document.units, (core::DocumentUnits{.unit = core::LengthUnit::mm, .scale = 2.0}));
    EXPECT_EQ(points_of(curve_of(millimeters)), (std::vector<Point>{{10, 80}, {30, 60}})) << "from the lower edge up";
    EXPECT_EQ(read(R"(width="5cm" height="5cm" viewBox="0 0 100 100")").document.units->scale, 2.0);
    EXPECT_EQ(read(R"(width="2in" height="1in" viewBox="0 -10 2 1")").document.units->unit, core::LengthUnit::inch);
    EXPECT_EQ(points_of(curve_of(read(R"(viewBox="0 -10 2 100")"))).front(), Point(10, 70));
    EXPECT_EQ(read(R"(viewBox="0 0 2 1")").document.units, std::nullopt);
    EXPECT_EQ(read(R"(width="100%" height="100%" viewBox="0 0 2 1")").document.units, std::nullopt);
    EXPECT_EQ(read(R"(width="300" height="200")").document.units, (core::DocumentUnits{.unit = core::LengthUnit::px}));
    EXPECT_EQ(points_of(curve_of(read(R"(width="300" height="200")"))).front(), Point(10, 180));
    EXPECT_NEAR(read(R"(width="144pt" height="144pt" viewBox="0 0 10 10")").document.units->scale, 5.0, 1e-12);
    EXPECT_NEAR(read(R"(width="100mm" height="50mm" viewBox="0 0 100 100")").document.units->scale, 2.0, 1e-12)
        << "the smaller scale counts";
}

TEST(SvgPage, MayLieAboutItsSize) {
    for (const std::string box : {"0 0 0 0", "0 0 -5 3", "a b c d", "0 0", "0 0 1e308 1e-300", ""})
        EXPECT_TRUE(
            read_svg(R"(<svg width="1e308mm" height="1e-308" viewBox=")" + box + R"("><path d="M0 0L1 1"/></svg>)"))
            << box;
}

TEST(SvgTree, UsesElementsWhereTheyAreWanted) {
    const Imported imported = read_elements(
        R"svg(<defs><path id="a" d="M0 0L1 1"/><symbol id="s"><path d="M0 0L2 2"/></symbol></defs>
              <use href="#a" x="10" y="20"/><use xlink:href="#s" transform="scale(2)"/>
              <clipPath><path d="M0 0h9"/></clipPath>)svg");
    ASSERT_EQ(imported.document.curves.size(), 2U);
    EXPECT_EQ(points_of(curve_of(imported)), (std::vector<Point>{{10, -20}, {11, -21}}));
    EXPECT_EQ(points_of(curve_of(imported, 1)), (std::vector<Point>{{0, 0}, {4, -4}}));
    EXPECT_TRUE(imported.report.left_out.empty());
}

TEST(SvgTree, FollowsNoCircleAndNoAddress) {
    const Imported imported = read_elements(
        R"(<path d="M0 0h1"/><g id="g"><use href="#g"/></g><use href="other.svg#a"/><use href="#none"/>
           <use href="http://example.org/a.svg#b"/>)");
    EXPECT_EQ(imported.document.curves.size(), 1U);
    EXPECT_EQ(
        imported.report.left_out,
        (std::vector<std::string>{
            "an element that uses itself is left out: '#g'",
            "2 elements of other files are left out, the first one 'other.svg#a'; nothing outside this file is read",
            "an element that is used but not there is left out: '#none'"}));
}

TEST(SvgTree, TakesNumbersBelowTheDoublesForZeros) {
    const Imported imported = read_elements(R"(<path d="M1e-400 2L-1e-400 5"/>)");
    EXPECT_TRUE(imported.report.left_out.empty());
    EXPECT_EQ(points_of(curve_of(imported)), (std::vector<Point>{{0, -2}, {0, -5}}));
}

TEST(SvgTree, LeavesOutWhatIsNoCurveWithOneSentenceForEachKind) {
    const Imported imported = read_elements(
        R"svg(<path d="M0 0h1"/><text>a</text><text>b</text><image/><path display="none" d="M0 0h1"/>
              <g style="display: none"><path d="M0 0h1"/></g><path clip-path="url(#c)" d="M0 0h1"/>)svg");
    EXPECT_EQ(imported.document.curves.size(), 2U);
    EXPECT_EQ(
        imported.report.left_out,
        (std::vector<std::string>{"2 texts are left out; in the program that made them, they can be turned into paths",
                                  "an image is left out", "2 elements that are not displayed are left out",
                                  "an element that is clipped or masked is read whole"}));
}

TEST(SvgTree, KeepsTheLayersAndLocksOfInkscape) {
    const std::string layer = "<g inkscape:groupmode='layer' inkscape:label=";
    const auto curves =
        read_elements(layer + "'Hull' id='layer1'><path id='a' d='M0 0h1'/>" + layer +
                      "'Ribs' sodipodi:insensitive='true'><g><path id='b' d='M0 0h1M0 1h1'/></g></g></g>"
                      "<path id='c' d='M0 0h1'/><path id='d' sodipodi:insensitive='true' d='M0 0h1M0 1h1'/>")
            .document.curves;
    ASSERT_EQ(curves.size(), 6U);
    const std::vector<std::string> groups{"Hull", "Hull / Ribs", "Hull / Ribs", "", "d", "d"};
    const std::vector<bool> locks{false, true, true, false, true, true};
    for (std::size_t i = 0; i < curves.size(); ++i) {
        EXPECT_EQ(curves[i].group, groups[i]) << i;
        EXPECT_EQ(curves[i].locked, locks[i]) << i;
    }
    const auto of_one_layer = read_elements(layer + "'Layer 1'><path d='M0 0h1'/><path d='M0 0h2'/></g>").document;
    EXPECT_EQ(of_one_layer.curves[1].group, "") << "which all are in";
}

TEST(SvgTree, KeepsNamesColorsAndWhatIsHidden) {
    const Imported imported = read_elements(
        R"svg(<g stroke="#123456"><path id="a" d="M0 0h1"/><path id="b" inkscape:label="hull" style="stroke:none;fill:TEAL" d="M0 0h1"/>
           <path d="M0 0h1" stroke="rgb(255, 50%,0)" visibility="hidden"><title>keel</title></path></g>
           <circle r="1" fill="url(#g)" stroke="#f80"/><circle r="1"/>)svg");
    const auto& curves = imported.document.curves;
    ASSERT_EQ(curves.size(), 5U);
    EXPECT_EQ(curves[0].name, "a");
    EXPECT_EQ(curves[0].color, (core::DocumentColor{0x12, 0x34, 0x56}));
    EXPECT_EQ(curves[1].name, "hull");
    EXPECT_EQ(curves[1].color, (core::DocumentColor{0, 0x80, 0x80}));
    EXPECT_EQ(curves[2].name, "keel");
    EXPECT_EQ(curves[2].color, (core::DocumentColor{255, 128, 0}));
    EXPECT_FALSE(curves[2].visible);
    EXPECT_EQ(curves[3].color, (core::DocumentColor{255, 0x88, 0}));
    EXPECT_EQ(curves[4].color, std::nullopt);
    EXPECT_EQ(curves[4].name, "circle 2");
}

}  // namespace batten::exchange
