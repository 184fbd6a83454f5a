#include "core/document/detail/fit_member.h"

#include <gtest/gtest.h>

#include "core/make/through_points.h"
#include "tests/core/document/replaced.h"

namespace batten::core {
namespace {

DocumentCurve curve_through(FitPoints fit) {
    DocumentCurve entry;
    entry.name = "through";
    entry.curve = std::make_shared<const Curve>(through_points(fit).value());
    entry.fit = std::make_shared<const FitPoints>(std::move(fit));
    return entry;
}

FitPoints square(FitKind kind, bool closed) {
    const Point places[] = {{0, 0}, {4, 0}, {4, 4}, {0.1, 1e9 / 3.0}};
    return fit_points_at(places, {kind, Parametrization::centripetal, closed}).value();
}

std::string text_of(const FitPoints& fit) {
    Document document;
    document.curves.push_back(curve_through(fit));
    return format_document(document);
}

std::string error_text_of(const std::string& text) {
    const auto document = parse_document(text);
    return document ? "none" : document.error().where + ": " + document.error().what;
}

const std::string small = R"({"format": "batten", "version": 1, "curves": [{"degree": 3, "knots": [0,0,0,0,3,3,3,3],
 "points": [[0,0],[1,0],[2,0],[3,0]], "fit": {"kind": "c2", "points": [[0,0],[3,0]], "parameters": [0,3]}}]})";

}  // namespace

TEST(FitMember, keeps_members_that_it_does_not_know) {
    const std::string text = replaced(small, "\"kind\": \"c2\"", "\"kind\": \"c2\", \"source\": {\"table\": [1, 2]}");
    const auto document = parse_document(text);
    ASSERT_TRUE(document && document->curves[0].fit != nullptr);
    EXPECT_EQ(document->curves[0].unknown_fit_members, R"({"source":{"table":[1,2]}})");
    const std::string written = format_document(*document);
    EXPECT_NE(written.find("\"source\""), std::string::npos) << written;
    EXPECT_EQ(format_document(parse_document(written).value()), written);
    EXPECT_EQ(document->lost_fits, 0U);
}

TEST(FitMember, of_another_curve_is_counted_as_lost) {
    const auto document = parse_document(replaced(small, "[1,0],[2,0]", "[1,0],[2,0.1]"));
    ASSERT_TRUE(document);
    EXPECT_EQ(document->curves[0].fit, nullptr);
    EXPECT_EQ(document->lost_fits, 1U);
}

TEST(FitMember, comes_back_bit_by_bit) {
    for (const FitKind kind : {FitKind::c2, FitKind::local, FitKind::fair})
        for (const bool closed : {false, true}) {
            FitPoints fit = set_fit_joint(square(kind, closed), 1, FitJoint::tangent, {1.0 / 3.0, -0.1}).value();
            fit = set_fit_joint(fit, 2, FitJoint::corner_straight).value();
            for (const FitPoints& each : {fit, square(kind, closed)}) {
                const std::string text = text_of(each);
                const auto document = parse_document(text);
                ASSERT_TRUE(document) << document.error().sentence();
                ASSERT_NE(document->curves[0].fit, nullptr);
                EXPECT_EQ(*document->curves[0].fit, each);
                EXPECT_EQ(format_document(*document), text);
            }
        }
}

TEST(FitMember, is_written_only_where_it_is_there) {
    EXPECT_EQ(text_of(square(FitKind::c2, false)).find("joints"), std::string::npos);
    EXPECT_EQ(text_of(square(FitKind::c2, false)).find("handles"), std::string::npos);
    Document document;
    document.curves.push_back(curve_through(square(FitKind::c2, false)));
    document.curves[0].fit.reset();
    EXPECT_EQ(format_document(document).find("fit"), std::string::npos);
}

TEST(FitMember, of_another_curve_is_left_out) {
    EXPECT_NE(parse_document(small)->curves[0].fit, nullptr);
    EXPECT_NE(parse_document(replaced(small, "[1,0]", "[1.000000001,0]"))->curves[0].fit, nullptr);
    EXPECT_EQ(parse_document(replaced(small, "[1,0]", "[1.0001,0]"))->curves[0].fit, nullptr);
    EXPECT_EQ(parse_document(replaced(small, "[0,0,0,0,3,3,3,3]", "[0,0,0,0,4,4,4,4]"))->curves[0].fit, nullptr);
    EXPECT_EQ(parse_document(replaced(small, "\"c2\"", "\"fair\""))->curves[0].fit, nullptr);
    EXPECT_EQ(parse_document(replaced(small, "\"fit\"", "\"weights\": [1,1,1,2], \"fit\""))->curves[0].fit, nullptr);
}

TEST(FitMember, says_what_is_wrong_and_where) {
    EXPECT_EQ(error_text_of(replaced(small, "\"c2\"", "\"c3\"")),
              "/curves/0/fit/kind: found \"c3\", but it must be \"c2\", \"local\" or \"fair\"");
    EXPECT_EQ(error_text_of(replaced(small, "{\"kind\": \"c2\", ", "{")),
              "/curves/0/fit: the member \"kind\" is missing");
    EXPECT_EQ(error_text_of(replaced(small, "[0,3]}", "[0,3], \"joints\": [\"smooth\"]}")),
              "/curves/0/fit/joints: one item was found; there must be 2, one for each point");
    EXPECT_EQ(error_text_of(replaced(small, "[0,3]}", "[0,3], \"joints\": [\"smooth\", \"round\"]}")),
              "/curves/0/fit/joints/1: found \"round\", but it must be \"smooth\", \"tangent\", \"corner\", "
              "\"straight\" or \"corner-straight\"");
    EXPECT_EQ(error_text_of(replaced(small, "[0,3]}", "[0,3], \"handles\": [[0,0],[1]]}")),
              "/curves/0/fit/handles/1: found a list of one item, but it must be a list of two numbers, x and y");
    EXPECT_EQ(error_text_of(replaced(small, "[0,3]}", "[0,0]}")),
              "/curves/0/fit/parameters/1: parameter 1 is not above the one before it; parameters must be finite and "
              "increase from point to point");
    EXPECT_EQ(error_text_of(replaced(small, "[0,3]}", "[0,1,3]}")),
              "/curves/0/fit/parameters: 3 parameters were found; 2 are needed, one for each point, and one more for "
              "the way back to the first point of a closed curve");
    EXPECT_EQ(error_text_of(replaced(small, "[[0,0],[3,0]]", "[[0,0]]")),
              "/curves/0/fit/points: one point was found; at least 2 are needed");
    EXPECT_EQ(
        error_text_of(replaced(small, "{\"kind\": \"c2\", \"points\": [[0,0],[3,0]], \"parameters\": [0,3]}", "7")),
        "/curves/0/fit: found 7, but it must be an object");
}

}  // namespace batten::core
