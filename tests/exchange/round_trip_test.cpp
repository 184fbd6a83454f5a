#include <gtest/gtest.h>

#include <cmath>

#include "core/curve/control_box.h"
#include "core/evaluate/evaluate.h"
#include "exchange/format.h"
#include "exchange/written_curves.h"
#include "tests/core/point_at_share.h"
#include "tests/exchange/carried_curves.h"

namespace batten::exchange {

namespace {

// The formats that hold every number as it is.
class ExactRoundTrip : public testing::TestWithParam<Format> {};

// All formats of this kind.
class RoundTrip : public testing::TestWithParam<Format> {};

constexpr int random_count = 200;

struct Carried {
    Imported copy{};
    double stated_error = 0.0;  // of writing and reading
};

Carried carried(const core::Document& document, Format format) {
    const auto written = spec_of(format).write(document, {});
    EXPECT_TRUE(written) << written.error().sentence();
    if (!written) return {};
    auto read = spec_of(format).read(written->text);
    EXPECT_TRUE(read) << read.error().sentence();
    if (!read) return {};
    const double error = written->report.largest_error + read->report.largest_error;
    return {*std::move(read), error};
}

// Points of both at the same parameters, as near as the error that was stated and the rounding of evaluation.
void expect_near(const core::Curve& curve, const core::Curve& copy, double stated_error) {
    const core::Box box = core::control_box(curve);
    const double size =
        std::max({std::abs(box.lower.x), std::abs(box.lower.y), std::abs(box.upper.x), std::abs(box.upper.y)});
    EXPECT_EQ(copy.domain().lower, curve.domain().lower);
    EXPECT_EQ(copy.domain().upper, curve.domain().upper);
    for (int i = 0; i <= 20; ++i) {
        const core::Point expected = at_share(curve, i / 20.0);
        const core::Point found = at_share(copy, i / 20.0);
        EXPECT_LE(std::abs(found.x - expected.x), stated_error + 1e-14 * size);
        EXPECT_LE(std::abs(found.y - expected.y), stated_error + 1e-14 * size);
    }
}

// All numbers to the last bit.
void expect_same(const core::Curve& curve, const core::Curve& copy) {
    const core::CurveDefinition expected = full_definition(curve);
    const core::CurveDefinition found = full_definition(copy);
    EXPECT_EQ(found.degree, expected.degree);
    EXPECT_EQ(found.knots, expected.knots);
    EXPECT_EQ(found.points, expected.points);
    EXPECT_EQ(found.weights, expected.weights);
}

TEST_P(ExactRoundTrip, KeepsEveryNumberOfEachCurve) {
    for (const CarriedCurve& curve : carried_curves(random_count)) {
        SCOPED_TRACE(curve.name);
        const Carried through = carried(document_of(curve.curve), GetParam());
        ASSERT_EQ(through.copy.document.curves.size(), 1U);
        EXPECT_GE(through.stated_error, unrolling_error(curve.curve));
        EXPECT_LE(through.stated_error, 2.0 * unrolling_error(curve.curve)) << "written and read";
        expect_same(curve.curve, *through.copy.document.curves[0].curve);
    }
}

TEST_P(RoundTrip, KeepsTheShapeOfEachCurveWithinTheStatedError) {
    const std::vector<CarriedCurve> curves = carried_curves(random_count);
    ASSERT_EQ(curves.size(), 250U);  // as docs/reliability.md has it
    for (const CarriedCurve& curve : curves) {
        SCOPED_TRACE(curve.name);
        const Carried through = carried(document_of(curve.curve), GetParam());
        ASSERT_EQ(through.copy.document.curves.size(), 1U);
        const double size = core::length(core::vector_to(core::control_box(curve.curve).upper));
        EXPECT_LE(through.stated_error, 1e-15 * size + 1e-300 + 2.0 * unrolling_error(curve.curve));
        expect_near(curve.curve, *through.copy.document.curves[0].curve, through.stated_error);
    }
}

TEST_P(RoundTrip, KeepsManyCurvesTheirNamesAndTheirOrder) {
    const std::vector<CarriedCurve> curves = carried_curves(0);
    const Carried through = carried(document_of(curves), GetParam());
    ASSERT_EQ(through.copy.document.curves.size(), curves.size());
    for (std::size_t i = 0; i < curves.size(); ++i) {
        EXPECT_EQ(through.copy.document.curves[i].name, curves[i].name);
        expect_near(curves[i].curve, *through.copy.document.curves[i].curve, through.stated_error);
    }
}

TEST_P(RoundTrip, LeavesOutWhatIsHiddenAndSaysSo) {
    core::Document document = document_of(carried_curves(0));
    for (core::DocumentCurve& entry : document.curves) entry.visible = false;
    const Writer write = spec_of(GetParam()).write;
    EXPECT_EQ(write(document, {}).error().sentence(), "no curve is visible; show one of them to write it");
    document.curves[1].visible = true;
    const auto written = write(document, {});
    ASSERT_TRUE(written);
    EXPECT_EQ(written->report.left_out, std::vector<std::string>{"49 curves were left out, since they are hidden"});
}

TEST_P(RoundTrip, ReadsAnyFrontOfAFileOrSaysWhyNot) {
    const FormatSpec& spec = spec_of(GetParam());
    const auto written = spec.write(document_of(carried_curves(0)[1].curve), {});
    ASSERT_TRUE(written);
    const std::string& text = written->text;
    const std::size_t whole = text.find_last_not_of(" \r\n") + 1;
    for (std::size_t length = 0; length < whole; ++length) {
        const auto read = spec.read(std::string_view(text).substr(0, length));
        ASSERT_FALSE(read) << length;
        ASSERT_FALSE(read.error().what.empty()) << length;
    }
}

TEST_P(RoundTrip, SurvivesAnyByteThatIsChanged) {
    const FormatSpec& spec = spec_of(GetParam());
    const auto written = spec.write(document_of(carried_curves(0)[1].curve), {});
    ASSERT_TRUE(written);
    for (const char c : {'\0', '9', '-', 'e', '\n', '[', '"', '\xff'})
        for (std::size_t i = static_cast<unsigned char>(c) % 7; i < written->text.size(); i += 7) {
            std::string text = written->text;
            text[i] = c;
            const auto read = spec.read(text);
            ASSERT_TRUE(read || !read.error().what.empty());
        }
}

std::string name_of_test(const testing::TestParamInfo<Format>& format) {
    std::string name(core::name_of(format.param));
    std::erase(name, '-');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Formats, ExactRoundTrip, testing::Values(Format::dxf, Format::nurbs_python), name_of_test);
INSTANTIATE_TEST_SUITE_P(Formats, RoundTrip,
                         testing::Values(Format::dxf, Format::nurbs_python, Format::tinyspline, Format::rhino,
                                         Format::opencascade),
                         name_of_test);

}  // namespace

}  // namespace batten::exchange
