#include <gtest/gtest.h>

#include "core/evaluate/evaluate.h"
#include "exchange/format.h"
#include "exchange/written_curves.h"
#include "tests/exchange/carried_curves.h"

namespace batten::exchange {

namespace {

// The formats that hold every number as it is.
class ExactRoundTrip : public testing::TestWithParam<Format> {
  protected:
    static Imported carried(const core::Document& document) {
        const FormatSpec& spec = spec_of(GetParam());
        const auto written = spec.write(document, {});
        EXPECT_TRUE(written) << written.error().sentence();
        if (!written) return {};
        EXPECT_EQ(written->report.largest_error, 0.0);
        auto read = spec.read(written->text);
        EXPECT_TRUE(read) << read.error().sentence();
        return read ? *std::move(read) : Imported{};
    }
};

// All numbers to the last bit; and where it is closed differently, the points.
void expect_same(const core::Curve& curve, const core::Curve& copy) {
    const core::CurveDefinition expected = full_definition(curve);
    const core::CurveDefinition found = full_definition(copy);
    EXPECT_EQ(found.degree, expected.degree);
    EXPECT_EQ(found.knots, expected.knots);
    EXPECT_EQ(found.points, expected.points);
    EXPECT_EQ(found.weights, expected.weights);
    const core::Interval domain = curve.domain();
    for (const double share : {0.0, 0.3, 0.5, 0.9, 1.0}) {
        const double u = domain.lower + share * (domain.upper - domain.lower);
        EXPECT_EQ(core::point_at(copy, u), core::point_at(curve, u));
    }
}

}  // namespace

TEST_P(ExactRoundTrip, KeepsEveryNumberOfEachCurve) {
    constexpr int random_count = 200;
    const std::vector<CarriedCurve> curves = carried_curves(random_count);
    ASSERT_EQ(curves.size(), 250U);  // as docs/reliability.md has it
    for (const CarriedCurve& carried_curve : curves) {
        SCOPED_TRACE(carried_curve.name);
        const Imported copy = carried(document_of(carried_curve.curve));
        ASSERT_EQ(copy.document.curves.size(), 1U);
        expect_same(carried_curve.curve, *copy.document.curves[0].curve);
    }
}

TEST_P(ExactRoundTrip, KeepsManyCurvesAndTheirOrder) {
    const std::vector<CarriedCurve> curves = carried_curves(0);
    const Imported copy = carried(document_of(curves));
    ASSERT_EQ(copy.document.curves.size(), curves.size());
    for (std::size_t i = 0; i < curves.size(); ++i) expect_same(curves[i].curve, *copy.document.curves[i].curve);
}

TEST_P(ExactRoundTrip, LeavesOutWhatIsHiddenAndSaysSo) {
    core::Document document = document_of(carried_curves(0));
    for (core::DocumentCurve& entry : document.curves) entry.visible = false;
    const Writer write = spec_of(GetParam()).write;
    EXPECT_EQ(write(document, {}).error().sentence(), "no curve is visible; show one of them to write it");
    document.curves[1].visible = true;
    const auto written = write(document, {});
    ASSERT_TRUE(written);
    EXPECT_EQ(written->report.left_out, std::vector<std::string>{"49 curves were left out, since they are hidden"});
}

TEST_P(ExactRoundTrip, ReadsAnyFrontOfAFileOrSaysWhyNot) {
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

TEST_P(ExactRoundTrip, SurvivesAnyByteThatIsChanged) {
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

INSTANTIATE_TEST_SUITE_P(Formats, ExactRoundTrip, testing::Values(Format::dxf), [](const auto& format) {
    std::string name(core::name_of(format.param));
    std::erase(name, '-');
    return name;
});

}  // namespace batten::exchange
