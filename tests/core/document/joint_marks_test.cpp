#include "core/document/joint_marks.h"

#include <gtest/gtest.h>

#include "core/curve/knot_analysis.h"
#include "core/document/document.h"
#include "core/document/native_file.h"
#include "core/edit/joint_keeping.h"
#include "core/edit/transform.h"
#include "tests/core/random_curves.h"

namespace batten::core {
namespace {

// A polygon that turns to the right by a right angle; a straight part and the parabola (t, t^2) behind it; a straight
// line that begins where the parabola ends, in its direction (1, 2), and one that is 3, 4 away from there.
constexpr const char* corner_line = R"({ "degree": 1, "knots": [0,0,1,2,2], "points": [[0,0],[1,1],[2,0]], "joints": )";
constexpr const char* bow_line =
    R"({ "degree": 2, "knots": [0,0,0,1,1,2,2,2], "points": [[-1,0],[-0.5,0],[0,0],[0.5,0],[1,1]], "joints": )";
constexpr const char* tail_line = R"({ "degree": 1, "knots": [0,0,1,1], "points": [[1,1],[3,5]], "joints": )";
constexpr const char* far_line = R"({ "degree": 1, "knots": [0,0,1,1], "points": [[4,5],[4,9]], "joints": )";

std::string refusal_of_curves(const std::string& curves) {
    const auto read = parse_document(R"({"format": "batten", "version": 1, "curves": [)" + curves + "]}");
    return read ? "none" : read.error().where + ": " + read.error().what;
}

TEST(JointMarks, marks_of_joints_that_are_not_so_are_refused) {
    const auto marked = [](const char* mark) {
        return std::string(R"([{"end": "end", "joint": 7, "mark": "corner"}, {"u": 1, "mark": ")") + mark + "\"}]}";
    };
    EXPECT_EQ(refusal_of_curves(corner_line + marked("corner")), "none");
    EXPECT_EQ(refusal_of_curves(corner_line + marked("smooth")),
              "/curves/0/joints/1/mark: found \"smooth\", but it must be \"corner\", since the tangent turns by 90° "
              "there");
    EXPECT_EQ(refusal_of_curves(bow_line + marked("smooth")), "none");
    EXPECT_EQ(
        refusal_of_curves(bow_line + marked("curvature")),
        "/curves/0/joints/1/mark: found \"curvature\", but it must be \"smooth\" or \"corner\", since the curvature "
        "jumps there from 0 to 2");
}

TEST(JointMarks, marks_of_ends_that_do_not_meet_so_are_refused) {
    const auto ends = [](const char* first, const std::string& other, const char* end, const char* mark) {
        return bow_line + std::string(R"([{"u": 1, "mark": "corner"}, {"end": "end", "joint": 5, "mark": ")") + first +
               "\"}]}, " + other + "[{\"end\": \"" + end + R"(", "joint": 5, "mark": ")" + mark + "\"}]}";
    };
    EXPECT_EQ(refusal_of_curves(ends("smooth", tail_line, "start", "smooth")), "none");
    EXPECT_EQ(refusal_of_curves(ends("corner", tail_line, "start", "smooth")), "none");
    // The parabola bends by 2 / (1 + 4 x^2)^(3/2).
    const std::string jumps = refusal_of_curves(ends("smooth", tail_line, "start", "curvature"));
    EXPECT_EQ(jumps.find("/curves/1/joints/0/mark: found \"curvature\", but it must be \"smooth\" or \"corner\", since "
                         "the curvature jumps there from 0.17888543819998"),
              0U)
        << jumps;
    EXPECT_EQ(refusal_of_curves(ends("corner", far_line, "start", "corner")),
              "/curves/0/joints/1/mark: found \"corner\", but it must be a mark of ends that meet; these are 5 apart");
    // Ends that are alone in a file, as in that of one curve that was copied, may have marks.
    EXPECT_EQ(refusal_of_curves(std::string(bow_line) + R"([{"end": "end", "joint": 5, "mark": "smooth"}]})"), "none");
}

// The curve with its inner knots made smooth where that can be, and marked so.
DocumentCurve with_marked_knots(RandomCurves& random, const Curve& curve) {
    DocumentCurve entry;
    std::vector<KeptJoint> joints;
    for (const DistinctKnot& knot : distinct_knots(curve.knots()))
        if (knot.is_interior)
            joints.push_back({{0, knot.value, Side::left}, {0, knot.value, Side::right}, random.whole(1, 2), true});
    const KeptJoints kept = keep_joints({{.curve = curve}}, joints);
    entry.curve = std::make_shared<const Curve>(kept.curves[0]);
    for (std::size_t k = 0; k < joints.size(); ++k)
        if (std::ranges::find(kept.lost, k) == kept.lost.end())
            entry.joints.knots.push_back({joints[k].before.u, static_cast<JointMark>(joints[k].level)});
    return entry;
}

// A second curve whose start is led to the end of `entry`, and both marked where that can be.
std::optional<DocumentCurve> continued(RandomCurves& random, DocumentCurve& entry, std::size_t number) {
    const Curve next = random.open_curve();
    const int level = random.whole(0, 2);
    const KeptJoint joint{
        {0, entry.curve->domain().upper, Side::left}, {1, next.domain().lower, Side::right}, level, true};
    const KeptJoints kept = keep_joints({{.curve = *entry.curve, .is_held = true}, {.curve = next}}, {joint});
    if (!kept.lost.empty()) return std::nullopt;
    entry.joints.ends.push_back({CurveEnd::end, number, static_cast<JointMark>(level)});
    DocumentCurve other;
    other.curve = std::make_shared<const Curve>(kept.curves[1]);
    other.joints.ends.push_back({CurveEnd::start, number, static_cast<JointMark>(level)});
    return other;
}

TEST(JointMarks, that_edits_keep_can_be_read_in_300_random_documents) {
    RandomCurves random(5);
    std::size_t knots = 0;
    std::size_t ends = 0;
    for (int i = 0; i < 300; ++i) {
        Document document;
        for (std::size_t k = 0; k < 3; ++k) {
            document.curves.push_back(with_marked_knots(random, random.curve()));
            DocumentCurve& entry = document.curves.back();
            knots += entry.joints.knots.size();
            if (entry.curve->is_periodic()) continue;
            if (auto other = continued(random, entry, k)) {
                ends += 1;
                document.curves.push_back(*std::move(other));
            }
        }
        // As it is; turned; far away; huge and tiny.
        const std::vector<PlaneMap> maps{PlaneMap{}, rotation(random.number(0, 360), {3, 1}), translation({1e6, -1e6}),
                                         scaling(1e9, 1e9, {0, 0}), scaling(1e-9, 1e-9, {0, 0})};
        for (std::size_t m = 0; m < maps.size(); ++m) {
            Document mapped = document;
            for (DocumentCurve& entry : mapped.curves)
                entry.curve = std::make_shared<const Curve>(transform(*entry.curve, maps[m]).value());
            const auto read = parse_document(format_document(mapped));
            ASSERT_TRUE(read) << i << ", " << m << ": " << read.error().sentence() << format_document(mapped);
            for (std::size_t k = 0; k < mapped.curves.size(); ++k)
                EXPECT_EQ(read->curves[k].joints, mapped.curves[k].joints);
        }
    }
    EXPECT_GT(knots, 500U);
    EXPECT_GT(ends, 200U);
}

TEST(JointMarks, are_at_knots_inside_and_at_seams) {
    const Curve open = Curve::make({.degree = 1, .knots = {0, 0, 1, 2, 2}, .points = {{0, 0}, {1, 0}, {2, 1}}}).value();
    EXPECT_TRUE(is_inner_knot(open, 1.0));
    for (const double u : {0.0, 0.5, 2.0, 3.0}) EXPECT_FALSE(is_inner_knot(open, u)) << u;
    const Curve ring =
        Curve::make({.degree = 2, .knots = {0, 1, 2, 3}, .points = {{0, 0}, {1, 0}, {0, 1}}, .periodic = true}).value();
    EXPECT_TRUE(is_inner_knot(ring, 0.0));
    EXPECT_TRUE(is_inner_knot(ring, 2.0));
    EXPECT_FALSE(is_inner_knot(ring, 3.0)) << "the seam has the lower end's value";
    // Unclamped, the knots outside the domain [1, 2] are none of the curve's.
    const Curve loose =
        Curve::make({.degree = 1, .knots = {0, 1, 1.5, 2, 3}, .points = {{0, 0}, {1, 0}, {2, 1}}}).value();
    EXPECT_TRUE(is_inner_knot(loose, 1.5));
    EXPECT_FALSE(is_inner_knot(loose, 1.0));
}

}  // namespace
}  // namespace batten::core
