#include "exchange/svg/svg_writer.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <string>

#include "core/base/number_text.h"
#include "core/document/native_file.h"
#include "core/evaluate/bezier_pieces.h"
#include "core/evaluate/evaluate.h"
#include "core/make/conics.h"
#include "core/measure/nearest.h"
#include "exchange/svg/svg_reader.h"
#include "tests/core/random_curves.h"

namespace batten::exchange {

namespace {

using core::Curve;
using core::CurveDefinition;
using core::Document;
using core::Point;

Document document_of(const std::vector<Curve>& curves) {
    Document document;
    for (const Curve& curve : curves) {
        core::DocumentCurve entry;
        entry.name = "curve " + std::to_string(document.curves.size());
        entry.curve = std::make_shared<const Curve>(curve);
        document.curves.push_back(entry);
    }
    return document;
}

Curve curve_from(CurveDefinition definition) {
    return *Curve::make(std::move(definition));
}

Exported written(const Document& document, const WriteOptions& options = {}) {
    auto exported = write_svg(document, options);
    EXPECT_TRUE(exported) << (exported ? "" : exported.error().sentence());
    return exported ? *std::move(exported) : Exported{};
}

// As another program would see the file.
Imported read_paths(std::string text) {
    const std::string name = "batten:document";
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name)) text.replace(at, 6, "others");
    return *read_svg(text);
}

std::string path_data_in(const std::string& text) {
    const std::size_t start = text.find(" d=\"") + 4;
    return text.substr(start, text.find('"', start) - start);
}

// Every piece of the polynomial curve, to the last bit.
void expect_same_pieces(const Curve& found, const Curve& expected) {
    const core::BezierPieces a = core::bezier_pieces(found);
    const core::BezierPieces b = core::bezier_pieces(expected);
    ASSERT_EQ(found.degree(), expected.degree());
    ASSERT_EQ(found.is_periodic(), expected.is_periodic());
    ASSERT_EQ(a.size(), b.size());
    EXPECT_FALSE(found.is_rational());
    for (std::size_t k = 0; k < a.size(); ++k)
        for (std::size_t i = 0; i < a.points(k).size(); ++i) {
            // The later piece of a joint may differ by rounding; it is written as the end of the earlier one.
            const double unit = 4e-16 * std::max(std::abs(b.points(k)[i].x), std::abs(b.points(k)[i].y));
            EXPECT_NEAR(a.points(k)[i].x, b.points(k)[i].x, unit);
            EXPECT_NEAR(a.points(k)[i].y, b.points(k)[i].y, unit);
        }
}

double farthest_from(const Curve& other, const Curve& samples_of) {
    double farthest = 0.0;
    constexpr int count = 120;
    const core::NearestFinder finder(other);
    for (int i = 0; i <= count; ++i) {
        const double u = samples_of.domain().lower + samples_of.domain().length() * i / count;
        const Point point = core::point_at(samples_of, u);
        farthest = std::max(farthest, core::distance(point, finder.nearest(point).point));
    }
    return farthest;
}

double largest_coordinate(const Curve& curve) {
    double largest = 0.0;
    for (const Point point : curve.control_points())
        largest = std::max({largest, std::abs(point.x), std::abs(point.y)});
    return largest;
}

// What is read back stays as near as the report says, seen from both.
void expect_round_trip(const Curve& curve, double tolerance) {
    const Exported exported = written(document_of({curve}), {.tolerance = tolerance});
    EXPECT_LE(exported.report.largest_error, tolerance);
    const Imported imported = read_paths(exported.text);
    ASSERT_EQ(imported.document.curves.size(), 1U);
    const Curve& found = *imported.document.curves[0].curve;
    const bool is_closed = core::point_at(curve, curve.domain().lower) == core::point_at(curve, curve.domain().upper);
    EXPECT_EQ(found.is_periodic(), curve.is_periodic() || (is_closed && !found.is_torn()));
    const double rounding = 1e-13 * largest_coordinate(curve);
    EXPECT_LE(farthest_from(found, curve), exported.report.largest_error + rounding);
    EXPECT_LE(farthest_from(curve, found), exported.report.largest_error + rounding);
}

}  // namespace

TEST(SvgWriter, WritesTheCurveItselfUpToDegreeThree) {
    const Curve cubic =
        curve_from({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{0, 0}, {1, 2}, {3, 2.5}, {4, -1}}});
    EXPECT_EQ(path_data_in(written(document_of({cubic})).text), "M 0 0 C 1 -2 3 -2.5 4 1");
    const Curve line =
        curve_from({.degree = 1, .knots = {0, 0, 1, 2, 2}, .points = {{0, 0}, {1, 2}, {3, 2}}, .weights = {1, 5, 2}});
    const Exported exported = written(document_of({line}));
    EXPECT_EQ(path_data_in(exported.text), "M 0 0 L 1 -2 L 3 -2");
    EXPECT_EQ(exported.report.largest_error, 0.0);
    const Curve parabola = curve_from(
        {.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0}, {1, 2}, {2, 0}}, .weights = {3, 3, 3}});
    EXPECT_EQ(path_data_in(written(document_of({parabola})).text), "M 0 0 Q 1 -2 2 0");
}

TEST(SvgWriter, WritesArcsOfCirclesAsSuch) {
    const Curve circle = *core::circle({3, 4}, 2);
    const Exported exported = written(document_of({circle}));
    EXPECT_EQ(exported.report.largest_error, 0.0);
    EXPECT_EQ(path_data_in(exported.text).find("M 5 -4 A"), 0U);
    const Curve found = *read_paths(exported.text).document.curves[0].curve;
    for (int i = 0; i <= 100; ++i)
        EXPECT_NEAR(core::distance(core::point_at(found, found.domain().upper * i / 100), {3, 4}), 2.0, 1e-14);
    const Point middle = core::point_at(found, 0.5);
    EXPECT_GT(middle.x, 4.0);
    EXPECT_GT(middle.y, 5.0) << "counterclockwise from the right";
    // Weights that are others, but draw the same quarter.
    const Curve quarter = curve_from(
        {.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{1, 0}, {1, 1}, {0, 1}}, .weights = {1, 1, 2}});
    EXPECT_EQ(path_data_in(written(document_of({quarter})).text), "M 1 0 A 1 1 0 0 0 0 -1");
    // A parabola and an ellipse are no circles.
    const Curve ellipse = *core::ellipse({.first_axis = 3, .second_axis = 2});
    EXPECT_EQ(path_data_in(written(document_of({ellipse})).text).find('A'), std::string::npos);
}

TEST(SvgWriter, TellsABoundWhereCubicsStandForTheCurve) {
    const Curve ellipse = *core::ellipse({.first_axis = 3, .second_axis = 2, .rotation = 20});
    for (const double tolerance : {1e-1, 1e-3, 1e-6, 1e-9}) expect_round_trip(ellipse, tolerance);
    const Exported exported = written(document_of({ellipse}));
    EXPECT_GT(exported.report.largest_error, 0.0);
    EXPECT_LE(exported.report.largest_error, 6e-6) << "a millionth of the larger side";
}

// More of them with BATTEN_ROUND_TRIPS in the environment.
TEST(SvgWriter, KeepsCurvesOfEverySort) {
    const char* const wish = std::getenv("BATTEN_ROUND_TRIPS");
    const int count = wish == nullptr ? 60 : std::atoi(wish);
    core::RandomCurves random(12);
    for (int i = 0; i < count; ++i) expect_round_trip(random.curve(), 1e-5);
}

TEST(SvgWriter, KeepsPolynomialsOfEveryMultiplicityToTheLastBits) {
    for (int degree = 1; degree <= 3; ++degree)
        for (int multiplicity = 1; multiplicity <= degree; ++multiplicity) {
            const auto p = static_cast<std::size_t>(degree);
            const auto m = static_cast<std::size_t>(multiplicity);
            CurveDefinition definition{.degree = degree};
            definition.knots.assign(p + 1, 0.0);
            definition.knots.insert(definition.knots.end(), m, 1.0);
            definition.knots.insert(definition.knots.end(), p + 1, 3.0);
            for (std::size_t i = 0; i < p + 1 + m; ++i)
                definition.points.emplace_back(1e6 + 1.1 * static_cast<double>(i),
                                               std::sin(static_cast<double>(i * i)));
            const Curve curve = curve_from(definition);
            const Exported exported = written(document_of({curve}));
            EXPECT_EQ(exported.report.largest_error, 0.0);
            expect_same_pieces(*read_paths(exported.text).document.curves[0].curve, curve);
        }
}

TEST(SvgWriter, KeepsPeriodicAndUnclampedPolynomials) {
    const std::vector<Point> points{{0, 0}, {4, 1}, {5, 5}, {1, 3}};
    const Curve periodic = curve_from({.degree = 3, .knots = {0, 1, 2, 3, 5}, .points = points, .periodic = true});
    expect_same_pieces(*read_paths(written(document_of({periodic})).text).document.curves[0].curve, periodic);
    const Curve unclamped = curve_from({.degree = 2, .knots = {0, 1, 2, 3, 4, 5, 6}, .points = points});
    expect_same_pieces(*read_paths(written(document_of({unclamped})).text).document.curves[0].curve, unclamped);
}

TEST(SvgWriter, KeepsEveryDegreeAndSize) {
    for (int degree = 1; degree <= 25; ++degree)
        for (const double scale : {1e-9, 1.0, 1e9}) {
            const auto count = static_cast<std::size_t>(degree) + 1;
            CurveDefinition definition{.degree = degree};
            definition.knots.assign(count, 0.0);
            definition.knots.insert(definition.knots.end(), count, 1.0);
            for (std::size_t i = 0; i < count; ++i) {
                const auto t = static_cast<double>(i);
                definition.points.emplace_back(scale * t, scale * std::cos(3 * t));
                definition.weights.push_back(1.0 + 3.0 * static_cast<double>(i % 3));
            }
            expect_round_trip(curve_from(definition), 1e-4 * scale);
        }
}

TEST(SvgWriter, WritesHugeAndTinyNumbers) {
    for (const double scale : {1e-300, 1e-100, 1e100, 1e300}) {
        const Curve curve = curve_from(
            {.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0}, {scale, 2 * scale}, {2 * scale, 0}}});
        const auto found = *read_paths(written(document_of({curve})).text).document.curves[0].curve;
        EXPECT_EQ(found.control_points()[1], curve.control_points()[1]);
    }
}

TEST(SvgWriter, WritesTheWeightsThatDrawTheCurve) {
    // Half of the way along the conic of weight 3 is 3/4 of the way from the chord to the corner.
    const Curve conic = curve_from(
        {.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0}, {1, 4}, {2, 0}}, .weights = {1, 3, 1}});
    const Curve found = *read_paths(written(document_of({conic}), {.tolerance = 1e-8}).text).document.curves[0].curve;
    const Point apex = core::point_at(found, found.domain().upper / 2);
    EXPECT_NEAR(apex.x, 1.0, 1e-8);
    EXPECT_NEAR(apex.y, 3.0, 1e-8);
}

TEST(SvgWriter, MakesSubpathsOfATornCurve) {
    const Curve torn = curve_from({.degree = 1,
                                   .knots = {0, 0, 1, 1, 2, 2},
                                   .points = {{0, 0}, {1, 1}, {2, 1}, {3, 0}},
                                   .tears = core::Tears::allow});
    const Exported exported = written(document_of({torn}));
    EXPECT_EQ(path_data_in(exported.text), "M 0 0 L 1 -1 M 2 -1 L 3 0");
    EXPECT_EQ(
        exported.report.left_out,
        std::vector<std::string>{"'curve 0' is torn; its parts are one path there, which other programs and edits make "
                                 "several curves"});
    EXPECT_EQ(read_paths(exported.text).document.curves.size(), 2U);
}

TEST(SvgWriter, KeepsTheDocumentInTheFile) {
    Document document = document_of({*core::ellipse({.first_axis = 3, .second_axis = 2}), *core::circle({1, 1}, 1)});
    document.title = "Two <ellipses> & more";
    document.units = core::DocumentUnits{.unit = core::LengthUnit::inch, .scale = 0.1};
    document.curves[1].visible = false;
    document.curves[0].color = core::DocumentColor{1, 2, 3};
    document.guides.push_back({.point = {1, 2}, .angle = 30});
    const Exported exported = written(document);
    const auto imported = *read_svg(exported.text);
    EXPECT_EQ(core::format_document(imported.document), core::format_document(document));
    EXPECT_EQ(imported.report.largest_error, 0.0);
    EXPECT_TRUE(imported.report.left_out.empty());
}

TEST(SvgWriter, LetsTheEditsOfOtherProgramsWin) {
    Document document = document_of({*core::ellipse({.first_axis = 3, .second_axis = 2})});
    document.curves[0].color = core::DocumentColor{1, 2, 3};
    const std::string text = written(document).text;
    const auto edited = [&](const std::string& from, const std::string& to) {
        std::string other = text;
        const std::size_t at = other.rfind(from);
        EXPECT_NE(at, std::string::npos);
        return *read_svg(other.replace(at, from.size(), to));
    };
    for (const Imported& imported : {edited("<path", "<path transform=\"scale(2)\""), edited("M 3", "M 2.5"),
                                     edited("</g>", "<path d=\"M0 0h1\"/></g>")}) {
        EXPECT_EQ(imported.document.curves[0].curve->degree(), 3) << "the path, not the ellipse";
        EXPECT_EQ(imported.report.left_out,
                  std::vector<std::string>{
                      "the document that Batten put into the file is left out, since another program has "
                      "changed what is drawn"});
    }
    EXPECT_EQ(edited("fill=\"none\"", "fill='none' opacity='0.5'").document.curves[0].curve->degree(), 2);
    EXPECT_EQ(edited("</g>", "</g><text/>").report.left_out,
              std::vector<std::string>{"a text is left out; in the program that made it, it can be turned into paths"});
}

TEST(SvgWriter, KeepsTheDocumentWithOtherNamesAndColors) {
    Document document = document_of({*core::circle({1, 1}, 1), *core::ellipse({.first_axis = 3, .second_axis = 2})});
    document.curves[0].visible = false;
    document.curves[1].color = core::DocumentColor{1, 2, 3};
    const std::string text = written(document).text;
    const auto edited = [&](const std::string& from, const std::string& to) {
        std::string other = text;
        other.replace(other.rfind(from), from.size(), to);
        Imported imported = *read_svg(other);
        EXPECT_EQ(imported.document.curves[1].curve->weights().size(), document.curves[1].curve->weights().size());
        EXPECT_EQ(imported.document.curves[0].name, "curve 0");
        EXPECT_FALSE(imported.document.curves[0].visible);
        EXPECT_EQ(imported.report.left_out,
                  std::vector<std::string>{
                      "names, colors, layers, locks and what is hidden are as another program has changed them"});
        return imported.document.curves[1];
    };
    EXPECT_EQ(edited("#010203", "#010204").color, (core::DocumentColor{1, 2, 4}));
    EXPECT_EQ(edited("</title>", " b</title>").name, "curve 1 b");
    EXPECT_EQ(edited("</title>", " b</title>").color, (core::DocumentColor{1, 2, 3}));
    EXPECT_FALSE(edited("<path", "<path visibility='hidden'").visible);
    EXPECT_TRUE(edited("<path", "<path sodipodi:insensitive='true'").locked);
    EXPECT_FALSE(edited("#010203", "#010204").locked);
}

TEST(SvgWriter, LetsTheColorsOfTornCurvesWin) {
    Document document = document_of({curve_from({.degree = 1,
                                                 .knots = {0, 0, 1, 1, 2, 2},
                                                 .points = {{0, 0}, {1, 1}, {2, 1}, {3, 0}},
                                                 .tears = core::Tears::allow})});
    document.curves[0].color = core::DocumentColor{1, 2, 3};
    std::string text = written(document).text;
    EXPECT_EQ(read_svg(text)->document.curves.size(), 1U);
    text.replace(text.rfind("#010203"), 7, "#010204");
    EXPECT_EQ(read_svg(text)->document.curves.size(), 2U);
}

TEST(SvgWriter, LetsTheChangedPageWin) {
    Document document = document_of({curve_from({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{10, 20}, {30, 40}}})});
    document.units = core::DocumentUnits{.unit = core::LengthUnit::mm, .scale = 2.0};
    const std::string text = written(document).text;
    const auto edited = [&](const std::string& from, const std::string& to) {
        std::string other = text;
        return *read_svg(other.replace(other.find(from), from.size(), to));
    };
    for (const Imported& imported :
         {edited("width=\"11mm\" height=\"11mm\"", "width='22mm' height='22mm'"),
          edited("width=\"11mm\"", "width='2in'"), edited("9 -41 22 22", "0 0 11 11"), edited("viewBox", "wasBox")})
        EXPECT_EQ(imported.report.left_out,
                  std::vector<std::string>{"the document that Batten put into the file is left out, "
                                           "since another program has changed the page"});
    EXPECT_EQ(edited("width=\"11mm\" height=\"11mm\"", "width='22mm' height='22mm'").document.units,
              (core::DocumentUnits{.unit = core::LengthUnit::mm, .scale = 1.0}));
    // The same in other digits.
    EXPECT_EQ(edited("9 -41 22 22", "9.0,-41 22.00 22").document.units, document.units);
    EXPECT_TRUE(edited("width=\"11mm\"", "width='1.1e1mm'").report.left_out.empty());
}

TEST(SvgWriter, WritesNamesUnitsAndTheBoxOfTheCurves) {
    Document document = document_of({curve_from({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{10, 20}, {30, 40}}}),
                                     curve_from({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{10, 20}, {30, 30}}})});
    document.curves[0].name = "1 & <Größe>\x01";
    document.curves[1].name = "1 & [Größe]";
    document.curves[1].color = core::DocumentColor{255, 0, 16};
    document.units = core::DocumentUnits{.unit = core::LengthUnit::mm, .scale = 2.0};
    const std::string text = written(document).text;
    EXPECT_NE(text.find(R"(width="11mm" height="11mm" viewBox="9 -41 22 22")"), std::string::npos)
        << text.substr(text.rfind("</metadata>"));
    EXPECT_NE(text.find("<title>1 &amp; &lt;Größe&gt;</title>"), std::string::npos);
    EXPECT_NE(text.find(R"(id="_1____Gr____e_")"), std::string::npos);
    EXPECT_NE(text.find(R"(id="_1____Gr____e_-2" stroke="#ff0010")"), std::string::npos);
    const Imported imported = read_paths(text);
    EXPECT_EQ(imported.document.curves[0].name, "1 & <Größe>");
    EXPECT_EQ(imported.document.curves[0].color, std::nullopt);
    EXPECT_EQ(imported.document.curves[1].color, document.curves[1].color);
    EXPECT_EQ(imported.document.units, document.units);
    expect_same_pieces(*imported.document.curves[0].curve, *document.curves[0].curve);
}

// As fast as numbers that count on; an id is a letter of ASCII and what may follow one.
TEST(SvgWriter, GivesNamesThatAreNoIdsNumbers) {
    Document document = document_of(
        std::vector<Curve>(1 << 14, curve_from({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{1, 2}, {3, 4}}})));
    for (std::size_t i = 0; i < document.curves.size(); ++i) {
        std::string& name = document.curves[i].name = "";
        for (std::size_t bit = 0; bit < 14; ++bit) name += (i >> bit) % 2 == 0 ? '!' : '?';
    }
    document.curves[1].name = std::string(14, '_') + "-3";
    const auto start = std::chrono::steady_clock::now();
    const std::string text = written(document).text;
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 60.0) << "a second";
    const std::string id = " id=\"" + std::string(15, '_');
    for (const std::string end : {"\"", "-2\"", "-3\"", "-4\"", "-16384\""})
        EXPECT_NE(text.find(id + end), std::string::npos) << end;
}

TEST(SvgWriter, TellsWhatToleranceWasNotReached) {
    const Curve conic = curve_from(
        {.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0}, {1, 4}, {2, 0}}, .weights = {1, 3, 1}});
    const Exported exported = written(document_of({conic}), {.tolerance = 1e-30});
    ASSERT_EQ(exported.report.left_out.size(), 1U);
    EXPECT_EQ(exported.report.left_out[0], "'curve 0' is within " + core::shortest_text(exported.report.largest_error) +
                                               " of its cubics, not within the 1e-30 that were wanted");
    EXPECT_TRUE(written(document_of({conic}), {.tolerance = 1e-9}).report.left_out.empty());
}

TEST(SvgWriter, LeavesTheDocumentOutOfAFileThatIsTooLarge) {
    Document document = document_of({*core::circle({0, 0}, 1)});
    constexpr std::size_t most_bytes = std::size_t{1} << 20U;
    document.description.assign(most_bytes, 'a');
    const Exported exported = *write_svg(document, {}, most_bytes);
    EXPECT_EQ(exported.report.left_out,
              std::vector<std::string>{
                  "the document itself is not in the file, which would have more than the 1 MiB that are read"});
    EXPECT_LT(exported.text.size(), 10000U);
    EXPECT_EQ(read_svg(exported.text)->document.curves.size(), 1U);
    EXPECT_EQ(write_svg(document, {}, 100).error().sentence(),
              "the file would have more than the 0 MiB that are read; a larger tolerance makes it smaller");
}

TEST(SvgWriter, NeedsAVisibleCurve) {
    Document document = document_of({*core::circle({0, 0}, 1)});
    document.curves[0].visible = false;
    EXPECT_EQ(write_svg(document).error().sentence(), "there is no visible curve to write");
    EXPECT_EQ(write_svg({}).error().sentence(), "there is no visible curve to write");
}

}  // namespace batten::exchange
