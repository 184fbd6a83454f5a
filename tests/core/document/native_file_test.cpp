#include "core/document/native_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>

#include "tests/core/document/random_document.h"
#include "tests/core/document/replaced.h"

namespace batten::core {
namespace {

namespace fs = std::filesystem;

// A folder of its own that goes with the test.
class NativeFile : public testing::Test {
  protected:
    NativeFile() : folder_(fs::temp_directory_path() / ("batten-" + std::to_string(getpid()))) {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    ~NativeFile() override { fs::remove_all(folder_); }

    fs::path in_folder(const char* name) const { return folder_ / name; }

    std::size_t files_in_folder() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }

  private:
    fs::path folder_;
};

std::string file_of(const std::string& curve_members) {
    return R"({"format": "batten", "version": 1, "curves": [{)" + curve_members + "}]}";
}

const std::string plain_members = R"("degree": 2, "knots": [0,0,0,1,1,1], "points": [[0,0],[1,2],[2,0]])";

FileError error_of(const std::string& text) {
    const auto document = parse_document(text);
    EXPECT_FALSE(document.has_value()) << text;
    return document ? FileError{} : document.error();
}

void expect_error(const std::string& text, const std::string& where, const std::string& part_of_what) {
    const FileError error = error_of(text);
    EXPECT_EQ(error.where, where) << error.what;
    EXPECT_NE(error.what.find(part_of_what), std::string::npos) << error.what;
}

Document titled(const std::string& title) {
    Document document;
    document.title = title;
    return document;
}

TEST(NativeFormat, text_is_laid_out_for_people_and_diffs) {
    const std::string text =
        "{\n"
        "  \"format\": \"batten\",\n"
        "  \"version\": 1,\n"
        "  \"title\": \"A wave\",\n"
        "  \"description\": \"Drag it.\",\n"
        "  \"curves\": [\n"
        "    {\n"
        "      \"name\": \"wave\",\n"
        "      \"degree\": 2,\n"
        "      \"knots\": [0, 0, 0, 0.1, 1, 1, 1],\n"
        "      \"points\": [\n"
        "        [0, 0],\n"
        "        [1, -2.5],\n"
        "        [3, 2],\n"
        "        [4e+20, 0]\n"
        "      ],\n"
        "      \"weights\": [1, 0.7071067811865476, 1, 1],\n"
        "      \"periodic\": false,\n"
        "      \"kind\": \"custom\",\n"
        "      \"color\": \"#4c7fe0\",\n"
        "      \"visible\": true,\n"
        "      \"locked\": false,\n"
        "      \"note\": \"kept\"\n"
        "    }\n"
        "  ],\n"
        "  \"view\": {\n"
        "    \"parameter\": 0.4,\n"
        "    \"overlays\": [\"polygon\", \"knots\"]\n"
        "  },\n"
        "  \"author\": {}\n"
        "}\n";
    const auto document = parse_document(text);
    ASSERT_TRUE(document.has_value()) << document.error().sentence();
    EXPECT_EQ(format_document(*document), text);
    EXPECT_EQ(document->title, "A wave");
    EXPECT_EQ(document->description, "Drag it.");
    EXPECT_EQ(document->curves[0].color, (DocumentColor{0x4c, 0x7f, 0xe0}));
    EXPECT_EQ(document->view.parameter, 0.4);
    EXPECT_EQ(document->view.overlays, (std::vector<std::string>{"polygon", "knots"}));
}

TEST(NativeFormat, everything_comes_back_and_the_text_too) {
    RandomCurves random(111);
    for (int i = 0; i < 300; ++i) {
        const Document document = random_document(random);
        const std::string text = format_document(document);
        const auto back = parse_document(text);
        ASSERT_TRUE(back.has_value()) << back.error().sentence();
        EXPECT_EQ(format_document(*back), text);
        ASSERT_EQ(back->curves.size(), document.curves.size());
        for (std::size_t k = 0; k < document.curves.size(); ++k) {
            EXPECT_EQ(*back->curves[k].curve, *document.curves[k].curve) << "bit by bit";
            EXPECT_EQ(back->curves[k].name, document.curves[k].name);
            EXPECT_EQ(back->curves[k].color, document.curves[k].color);
            EXPECT_EQ(back->curves[k].visible, document.curves[k].visible);
            EXPECT_EQ(back->curves[k].locked, document.curves[k].locked);
            EXPECT_EQ(back->curves[k].unknown_members, document.curves[k].unknown_members);
        }
        EXPECT_EQ(back->active, document.active);
        EXPECT_EQ(back->view, document.view);
        EXPECT_EQ(back->title, document.title);
        EXPECT_EQ(back->unknown_members, document.unknown_members);
    }
}

TEST(NativeFormat, numbers_come_back_to_the_last_bit) {
    const std::vector<double> hard{0.1,    1.0 / 3.0, 5e-324, 2.2250738585072014e-308, 1.7976931348623157e308, -0.0,
                                   1e15,   1e16,      1e22,   9007199254740993.0,      123456789012345.0,      -1e15,
                                   1e-300, 4.35,      0.5};
    for (const double value : hard) {
        Document document;
        const auto curve = std::make_shared<const Curve>(
            Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{value, 0}, {1, value}}}).value());
        document.curves.push_back({.name = "n", .curve = curve, .color = {}, .unknown_members = {}});
        const std::string text = format_document(document);
        const auto back = parse_document(text).value();
        const Point point = back.curves[0].curve->control_points()[0];
        EXPECT_EQ(std::signbit(point.x), std::signbit(value));
        EXPECT_EQ(point.x, value);
        EXPECT_EQ(format_document(back), text);
    }
}

TEST(NativeFormat, document_without_curves_is_one) {
    EXPECT_EQ(format_document(Document{}), "{\n  \"format\": \"batten\",\n  \"version\": 1,\n  \"curves\": []\n}\n");
    EXPECT_TRUE(parse_document(format_document(Document{}))->curves.empty());
    EXPECT_TRUE(parse_document(R"({"format": "batten", "version": 1})")->curves.empty());
}

TEST(NativeFormat, what_may_be_left_out_has_its_default) {
    const Document document = parse_document(file_of(plain_members)).value();
    const DocumentCurve& entry = document.curves[0];
    EXPECT_TRUE(entry.visible);
    EXPECT_FALSE(entry.locked);
    EXPECT_FALSE(entry.color.has_value());
    EXPECT_FALSE(entry.curve->is_rational());
    EXPECT_FALSE(entry.curve->is_periodic());
    EXPECT_EQ(entry.curve->knots().kind(), KnotKind::bezier) << "the kind is what the values say";
    EXPECT_FALSE(document.view.parameter.has_value());
}

TEST(NativeFormat, kind_is_believed_only_when_the_values_have_it) {
    const auto kind_of = [](const std::string& kind) {
        return parse_document(file_of(plain_members + ", \"kind\": \"" + kind + "\""))->curves[0].curve->knots().kind();
    };
    EXPECT_EQ(kind_of("bezier"), KnotKind::bezier);
    EXPECT_EQ(kind_of("clamped-uniform"), KnotKind::clamped_uniform);
    EXPECT_EQ(kind_of("piecewise-bezier"), KnotKind::piecewise_bezier);
    EXPECT_EQ(kind_of("uniform"), KnotKind::custom);
    EXPECT_EQ(kind_of("periodic"), KnotKind::custom);
    EXPECT_EQ(kind_of("custom"), KnotKind::custom);
    expect_error(file_of(plain_members + R"(, "kind": "wavy")"), "/curves/0/kind", "\"wavy\"");
}

TEST(NativeFormat, unknown_members_stay_on_every_level) {
    const std::string text =
        R"({"format": "batten", "version": 1, "maker": {"name": "x"}, "curves": [{)" + plain_members +
        R"(, "tags": [1, "two", null, [3]], "joints": [{"end": "end", "joint": 4, "mark": "corner", "dye": "red"}],
            "symmetry": {"group": 1, "place": 0, "center": [0, 0], "mirror": 90, "axle": [1]}},
            {"degree": 1, "knots": [0,0,1,2,2], "points": [[0,0],[1,1],[2,0]],
             "joints": [{"mark": "corner", "since": {"day": 3}, "u": 1}]}], "guides": [{"point": [1, 2], "angle": 30, "ink": "blue"}], "view": {"zoom": 2.50, "parameter": 1}})";
    const std::string formatted = format_document(parse_document(text).value());
    for (const char* part : {"\"maker\": {\n    \"name\": \"x\"\n  }", "\"zoom\": 2.5", "\"tags\": [\n", "\"two\"",
                             "\"ink\": \"blue\"", "\"dye\": \"red\"", "\"axle\": [1]", "\"since\": {\n"})
        EXPECT_NE(formatted.find(part), std::string::npos) << part << " in\n" << formatted;
    EXPECT_EQ(format_document(parse_document(formatted).value()), formatted);
}

TEST(NativeFormat, active_curve_is_named_unless_it_is_the_first) {
    const auto curve = parse_document(file_of(plain_members))->curves[0].curve;
    Document document;
    for (const char* name : {"a", "b", "b"})
        document.curves.push_back({.name = name, .curve = curve, .color = {}, .unknown_members = {}});
    EXPECT_EQ(format_document(document).find("active"), std::string::npos);
    document.active = 1;
    EXPECT_NE(format_document(document).find("\"active\": \"b\""), std::string::npos);
    document.active = 2;
    EXPECT_EQ(parse_document(format_document(document))->active, 2U) << "although another curve has the name";
    const std::string stranger = replaced(format_document(document), "\"active\": 2", "\"active\": \"c\"");
    EXPECT_EQ(parse_document(stranger)->active, 0U);
}

TEST(NativeFormat, text_that_is_not_utf8_is_written_all_the_same) {
    Document document;
    document.title = "caf\xe9";
    EXPECT_TRUE(parse_document(format_document(document)).has_value());
}

TEST(NativeFormat, syntax_errors_have_line_and_column) {
    expect_error("{\n  \"format\": \"batten\",\n  \"version\": nul\n}", "line 3, column 17", "invalid literal");
    expect_error("", "line 1, column 1", "unexpected end of input");
    expect_error("[1, 2,]", "line 1, column 7", "unexpected ']'");
    expect_error("{\"format\": \"caf\xe9\"}", "line 1, column 17", "UTF-8");
    expect_error("{\"a\": NaN}", "line 1, column 7", "invalid literal");
    expect_error("{\"a\": Infinity}", "line 1, column 7", "invalid literal");
    EXPECT_EQ(error_of("[1 2]").what.find("last read"), std::string::npos);
}

TEST(NativeFormat, zero_bytes_are_refused_where_they_stand) {
    const std::string whole = format_document(Document{});
    const std::string lines = std::to_string(std::count(whole.begin(), whole.end(), '\n') + 1);
    expect_error(whole + '\0' + "no JSON", "line " + lines + ", column 1", "zero byte");
    expect_error(std::string("{\n  \0}", 7), "line 2, column 3", "zero byte");
    expect_error(std::string(1, '\0'), "line 1, column 1", "zero byte");
}

TEST(NativeFormat, numbers_beyond_doubles_are_refused) {
    for (const std::string number : {"1e400", "-1e999999"}) {
        const std::string text = replaced(file_of(plain_members), "[1,2]", "[1," + number + "]");
        const std::size_t end_of_number = text.find(number) + number.size();
        expect_error(text, "line 1, column " + std::to_string(end_of_number), "too large");
    }
}

TEST(NativeFormat, doubled_members_are_refused) {
    expect_error(file_of(plain_members + R"(, "degree": 3)"), "line 1, column 123", "\"degree\" occurs twice");
    expect_error(R"({"format": "batten", "version": 1, "x": {"y": 1, "y": 2}})", "line 1, column 52",
                 "\"y\" occurs twice");
    EXPECT_TRUE(parse_document(R"({"format": "batten", "version": 1, "x": [{"y": 1}, {"y": 2}]})").has_value());
}

TEST(NativeFormat, format_and_version_are_looked_at_first) {
    expect_error("[]", "", "an object");
    expect_error("{}", "", "\"format\" is missing");
    expect_error(R"({"format": "other", "version": 9, "curves": 5})", "/format", "\"other\"");
    expect_error(R"({"format": "batten", "curves": 5})", "", "\"version\" is missing");
    expect_error(R"({"format": "batten", "version": 2, "curves": 5})", "/version", "version 2");
    expect_error(R"({"format": "batten", "version": 1.5})", "/version", "version 1.5");
    expect_error(R"({"format": "batten", "version": "1"})", "/version", "a number");
}

TEST(NativeFormat, required_members_are_missed_by_name) {
    for (const std::string name : {"degree", "knots", "points"})
        expect_error(replaced(file_of(plain_members), "\"" + name + "\"", "\"other\""), "/curves/0",
                     "\"" + name + "\" is missing");
}

TEST(NativeFormat, wrong_types_are_named_with_their_place) {
    const std::string good = file_of(plain_members);
    expect_error(replaced(good, "\"degree\": 2", "\"degree\": \"two\""), "/curves/0/degree", "\"two\"");
    expect_error(replaced(good, "\"degree\": 2", "\"degree\": 2.5"), "/curves/0/degree", "whole");
    expect_error(replaced(good, "\"degree\": 2", "\"degree\": 1e300"), "/curves/0/degree", "from 1 to 25");
    expect_error(replaced(good, "[0,0,0,1,1,1]", "7"), "/curves/0/knots", "a list");
    expect_error(replaced(good, "[0,0,0,1,1,1]", "[0,0,0,1,null,1]"), "/curves/0/knots/4", "null");
    expect_error(replaced(good, "[1,2]", "[1]"), "/curves/0/points/1", "two numbers");
    expect_error(replaced(good, "[1,2]", "[1,2,3]"), "/curves/0/points/1", "two numbers");
    expect_error(replaced(good, "[1,2]", "[1,\"2\"]"), "/curves/0/points/1/1", "a number");
    expect_error(file_of(plain_members + R"(, "weights": [1, true, 1])"), "/curves/0/weights/1", "true");
    expect_error(file_of(plain_members + R"(, "periodic": 0)"), "/curves/0/periodic", "true or false");
    expect_error(file_of(plain_members + R"(, "name": 5)"), "/curves/0/name", "a text");
    expect_error(file_of(plain_members + R"(, "color": "red")"), "/curves/0/color", "#4c7fe0");
    expect_error(file_of(plain_members + R"(, "color": "#12345g")"), "/curves/0/color", "#4c7fe0");
    expect_error(file_of(plain_members + R"(, "visible": null)"), "/curves/0/visible", "true or false");
    expect_error(R"({"format": "batten", "version": 1, "curves": {}})", "/curves", "a list of curves");
    expect_error(R"({"format": "batten", "version": 1, "curves": [7]})", "/curves/0", "an object");
    expect_error(R"({"format": "batten", "version": 1, "view": []})", "/view", "an object");
    expect_error(R"({"format": "batten", "version": 1, "view": {"parameter": "x"}})", "/view/parameter", "a number");
    expect_error(R"({"format": "batten", "version": 1, "view": {"overlays": ["a", 1]}})", "/view/overlays/1", "a text");
    expect_error(R"({"format": "batten", "version": 1, "view": {"notation": "t"}})", "/view/notation", "an object");
    expect_error(R"({"format": "batten", "version": 1, "view": {"notation": {"points": 3}}})", "/view/notation/points",
                 "a text");
}

TEST(NativeFormat, invalid_curves_are_refused_with_place_and_sentence) {
    const std::string good = file_of(plain_members);
    expect_error(replaced(good, "[0,0,0,1,1,1]", "[0,0,0,1,0.5,1]"), "/curves/0/knots/4",
                 "knot 4 is 0.5, less than knot 3, which is 1");
    expect_error(replaced(good, "[0,0,0,1,1,1]", "[0,0,0,1,1]"), "/curves/0/knots", "5 knots were found; 6 are needed");
    expect_error(replaced(good, "[0,0,0,1,1,1]", "[0,0,0,0,0,0]"), "/curves/0/knots", "begins and ends at 0");
    expect_error(replaced(good, "\"degree\": 2", "\"degree\": 26"), "/curves/0/degree", "26");
    expect_error(replaced(good, "\"degree\": 2", "\"degree\": 3"), "/curves/0/points", "at least 4");
    expect_error(file_of(plain_members + R"(, "weights": [1, 1])"), "/curves/0/weights", "2 weights");
    expect_error(file_of(plain_members + R"(, "weights": [1, -1, 1])"), "/curves/0/weights/1", "weight 1 is -1");
    const std::string torn = R"("degree": 1, "knots": [0,0,1,1,2,2], "points": [[0,0],[1,1],[2,0],[3,1]])";
    expect_error(file_of(torn), "/curves/0/knots/2", "occurs 2 times");
    EXPECT_TRUE(parse_document(file_of(torn + R"(, "tears": true)")).has_value());
}

TEST(NativeFormat, the_group_of_a_curve_comes_back) {
    const std::string line = R"("degree": 1, "knots": [0,0,1,1], "points": [[0,0],[1,1]])";
    const Document document = parse_document(file_of(line + R"(, "group": "hull lines")")).value();
    EXPECT_EQ(document.curves[0].group, "hull lines");
    EXPECT_EQ(document.curves[0].unknown_members, "");
    const std::string text = format_document(document);
    EXPECT_NE(text.find("\"group\": \"hull lines\""), std::string::npos);
    EXPECT_EQ(format_document(parse_document(text).value()), text);
    EXPECT_EQ(format_document(parse_document(file_of(line)).value()).find("group"), std::string::npos);
    const auto refused = parse_document(file_of(line + R"(, "group": 3)"));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().where, "/curves/0/group");
}

TEST(NativeFormat, marked_joints_come_back_in_order) {
    const std::string line = R"("degree": 1, "knots": [0,0,1,2,3,3], "points": [[0,0],[1,0],[2,0],[3,0]], "joints": )";
    const std::string marks = R"([{"end": "end", "joint": 4, "mark": "corner"}, {"u": 2, "mark": "curvature"},
                                  {"u": 1, "mark": "smooth"}])";
    const Document document = parse_document(file_of(line + marks)).value();
    const JointMarks& joints = document.curves[0].joints;
    EXPECT_EQ(joints.knots, (std::vector<KnotMark>{{1.0, JointMark::smooth}, {2.0, JointMark::curvature}}));
    EXPECT_EQ(joints.ends, (std::vector<EndMark>{{CurveEnd::end, 4, JointMark::corner}}));
    EXPECT_EQ(parse_document(format_document(document))->curves[0].joints, joints);
    EXPECT_EQ(format_document(parse_document(file_of(line + "[]")).value()).find("joints"), std::string::npos);
    const auto refusal = [&](const std::string& list) {
        const auto refused = parse_document(file_of(line + list));
        return refused ? std::string("none") : refused.error().where + ": " + refused.error().what;
    };
    EXPECT_EQ(refusal("3"), "/curves/0/joints: found 3, but it must be a list of joints");
    EXPECT_EQ(refusal(R"([{"u": 1.5, "mark": "smooth"}])"),
              "/curves/0/joints/0/u: found 1.5, but it must be a knot inside the domain");
    EXPECT_EQ(refusal(R"([{"u": 0, "mark": "smooth"}])"),
              "/curves/0/joints/0/u: found 0, but it must be a knot inside the domain");
    EXPECT_EQ(refusal(R"([{"u": 1}])"), "/curves/0/joints/0: the member \"mark\" is missing");
    EXPECT_EQ(refusal(R"([{"u": 1, "mark": "smooth"}, {"u": 1, "mark": "corner"}])"),
              "/curves/0/joints/1/u: the knot is marked twice");
    EXPECT_EQ(refusal(R"([{"end": "end", "joint": 0.5, "mark": "smooth"}])"),
              "/curves/0/joints/0/joint: found 0.5, but it must be a whole number from 0 to 1000000000");
    EXPECT_EQ(
        refusal(R"([{"end": "end", "joint": 1, "mark": "smooth"}, {"end": "end", "joint": 2, "mark": "smooth"}])"),
        "/curves/0/joints/1/end: the end is marked twice");
}

TEST(NativeFormat, pinned_points_come_back_in_order) {
    const std::string cubic = R"("degree": 1, "knots": [0,0,1,2,2], "points": [[0,0],[1,1],[2,0]], "pinned": )";
    const Document document = parse_document(file_of(cubic + "[2,0,2]")).value();
    EXPECT_EQ(document.curves[0].pinned, (std::vector<std::size_t>{0, 2}));
    EXPECT_NE(format_document(document).find("\"pinned\": [0, 2]"), std::string::npos);
    EXPECT_EQ(format_document(parse_document(file_of(cubic + "[]")).value()).find("pinned"), std::string::npos);
    for (const char* wrong : {"[0,3]", "[0,-1]", "[0,0.5]"}) {
        const auto refused = parse_document(file_of(cubic + wrong));
        ASSERT_FALSE(refused.has_value());
        EXPECT_EQ(refused.error().where, "/curves/0/pinned/1");
        EXPECT_NE(refused.error().what.find("but it must be the index of a control point, 0 to 2"), std::string::npos)
            << refused.error().what;
    }
}

TEST(NativeFormat, symmetries_come_back) {
    const std::string line = R"("degree": 1, "knots": [0,0,1,1], "points": [[0,0],[1,1]], "symmetry": )";
    const Document mirror =
        parse_document(file_of(line + R"({"group": 7, "place": 1, "center": [2, 0.5], "mirror": 30})")).value();
    EXPECT_EQ(mirror.curves[0].symmetry,
              (Symmetry{.group = 7, .place = 1, .turns = std::nullopt, .center = {2, 0.5}, .angle = 30.0}));
    EXPECT_EQ(parse_document(format_document(mirror)).value().curves[0].symmetry, mirror.curves[0].symmetry);
    const Document ring =
        parse_document(file_of(line + R"({"group": 0, "place": 4, "center": [2, 0.5], "turns": 5})")).value();
    EXPECT_EQ(ring.curves[0].symmetry->turns, 5U);
    EXPECT_EQ(parse_document(format_document(ring)).value().curves[0].symmetry, ring.curves[0].symmetry);
    const auto refused = parse_document(file_of(line + R"({"group": 0, "place": 5, "center": [0, 0], "turns": 5})"));
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().sentence(),
              "/curves/0/symmetry/place: found 5, but it must be a whole number from 0 to 4");
    EXPECT_FALSE(parse_document(file_of(line + R"({"group": 0, "place": 1, "center": [0, 0]})")).has_value());
}

TEST(NativeFormat, tears_come_back) {
    const std::string text =
        file_of(R"("degree": 1, "knots": [0,0,1,1,2,2], "points": [[0,0],[1,1],[2,0],[3,1]], "tears": true)");
    const std::string formatted = format_document(parse_document(text).value());
    EXPECT_NE(formatted.find("\"tears\": true"), std::string::npos);
    EXPECT_EQ(format_document(parse_document(formatted).value()), formatted);
}

TEST(NativeFormat, guides_come_back_and_are_checked) {
    Document document;
    EXPECT_EQ(format_document(document).find("guides"), std::string::npos);
    document.guides = {{{1.5, -2}, 0.0}, {{0, 1e6}, 22.5}};
    const std::string text = format_document(document);
    EXPECT_EQ(parse_document(text).value().guides, document.guides);
    EXPECT_EQ(format_document(parse_document(text).value()), text);
    const auto with_guides = [](const std::string& guides) {
        return R"({"format": "batten", "version": 1, "guides": )" + guides + "}";
    };
    expect_error(with_guides("3"), "/guides", "a list of guides");
    expect_error(with_guides("[3]"), "/guides/0", "an object");
    expect_error(with_guides(R"([{"point": [0, 0], "angle": 180}])"), "/guides/0/angle", "from 0 up to but not 180");
    expect_error(with_guides(R"([{"point": [0, 0], "angle": -1}])"), "/guides/0/angle", "found -1");
    expect_error(with_guides(R"([{"angle": 0}])"), "/guides/0", "\"point\" is missing");
    expect_error(with_guides(R"([{"point": [0], "angle": 0}])"), "/guides/0/point", "found");
}

TEST(NativeFormat, units_come_back_and_are_checked) {
    Document document;
    EXPECT_EQ(format_document(document).find("units"), std::string::npos);
    for (const LengthUnit unit : {LengthUnit::mm, LengthUnit::inch, LengthUnit::px}) {
        document.units = DocumentUnits{.unit = unit, .scale = 0.1};
        const std::string text = format_document(document);
        EXPECT_EQ(parse_document(text).value().units, document.units);
        EXPECT_EQ(format_document(parse_document(text).value()), text);
    }
    const auto with_units = [](const std::string& units) {
        return R"({"format": "batten", "version": 1, "units": )" + units + "}";
    };
    EXPECT_EQ(parse_document(with_units(R"({"unit": "inch"})")).value().units,
              (DocumentUnits{.unit = LengthUnit::inch, .scale = 1.0}));
    const Document kept = parse_document(with_units(R"({"unit": "mm", "dpi": 300})")).value();
    EXPECT_NE(format_document(kept).find("\"dpi\": 300"), std::string::npos);
    expect_error(with_units("3"), "/units", "an object");
    expect_error(with_units("{}"), "/units", "\"unit\" is missing");
    expect_error(with_units(R"({"unit": "cm"})"), "/units/unit", "inch");
    expect_error(with_units(R"({"unit": "mm", "scale": 0})"), "/units/scale", "a number from 1e-9 to 1e9");
    expect_error(with_units(R"({"unit": "mm", "scale": 1e-320})"), "/units/scale", "a number from 1e-9 to 1e9");
    expect_error(with_units(R"({"unit": "mm", "scale": 0.99e-9})"), "/units/scale", "a number from 1e-9 to 1e9");
    expect_error(with_units(R"({"unit": "mm", "scale": 1.01e9})"), "/units/scale", "a number from 1e-9 to 1e9");
    for (const char* scale : {"1e-9", "1e9"})
        EXPECT_EQ(parse_document(with_units(R"({"unit": "mm", "scale": )" + std::string(scale) + "}")).value().units,
                  (DocumentUnits{.unit = LengthUnit::mm, .scale = std::stod(scale)}));
    expect_error(with_units(R"({"unit": "mm", "scale": -1})"), "/units/scale", "found -1");
    expect_error(with_units(R"({"unit": "mm", "scale": "1"})"), "/units/scale", "a number");
}

TEST(NativeFormat, nesting_without_end_is_refused) {
    const std::size_t deep = 1'000'000;
    expect_error(std::string(deep, '['), "line 1, column 101", "nested");
    expect_error(R"({"format": "batten", "version": 1, "x": )" + std::string(deep, '[') + std::string(deep, ']') + "}",
                 "line 1, column 140", "nested");
    std::string objects;
    for (int i = 0; i < 100'000; ++i) objects += "{\"a\":";
    expect_error(objects, "line 1, column 501", "nested");
}

TEST(NativeFormat, members_without_end_are_refused) {
    std::string members = R"({"format": "batten", "version": 1)";
    for (int i = 0; i < 20'000; ++i) members += ", \"m" + std::to_string(i) + "\": 1";
    expect_error(members + "}", "line 1, column 118908", "members");
}

TEST(NativeFormat, long_names_are_told_by_their_beginnings) {
    const std::string name = std::string(59, 'n') + "é" + std::string(100'000, 'm');
    expect_error("{\"" + name + "\": 1, \"" + name + "\": 2}", "line 1, column 200132",
                 "the member \"" + std::string(59, 'n') + "…\" occurs twice");
    expect_error(R"({"format": "batten", "version": 1, "view": {"notation": {")" + name + "\": 1}}}",
                 "/view/notation/" + std::string(59, 'n') + "…", "found 1, but it must be a text");
}

TEST(NativeFormat, large_files_are_read) {
    std::string points;
    std::string knots;
    constexpr int count = 50'000;
    for (int i = 0; i < count; ++i) points.append(i ? ",[" : "[").append(std::to_string(i)).append(",0.123456789]");
    for (int i = 0; i < count + 2; ++i) knots.append(i ? "," : "").append(std::to_string(i));
    const auto document =
        parse_document(file_of("\"degree\": 1, \"knots\": [" + knots + "], \"points\": [" + points + "]"));
    ASSERT_TRUE(document.has_value()) << document.error().sentence();
    EXPECT_EQ(document->curves[0].curve->control_points().size(), static_cast<std::size_t>(count));
}

std::string spaced_out(const std::string& numbers, std::size_t blanks) {
    std::string text;
    for (const char c : numbers) text += c == ' ' ? std::string(blanks, '\n') : std::string(1, c);
    return text;
}

// Whatever stands between the numbers and however they are written, they are the same.
TEST(NativeFormat, numbers_are_read_however_they_are_written) {
    const std::string many_digits = "1." + std::string(1500, '0');
    for (const std::string numbers : {"0,0,0,1,1,1", " 0 , 0 , 0 , 1 , 1 , 1 ", "0,0,0.0,1e0,1.0,10E-1",
                                      "0,0,1e-400,1,1,1", "-0,0,0e5,1,1,0.1e+1"}) {
        const auto document = parse_document(replaced(file_of(plain_members), "0,0,0,1,1,1", numbers));
        ASSERT_TRUE(document.has_value()) << document.error().sentence();
        const auto knots = document->curves[0].curve->knots().stored();
        EXPECT_TRUE(std::equal(knots.begin(), knots.end(), std::array{0.0, 0.0, 0.0, 1.0, 1.0, 1.0}.begin()));
        EXPECT_FALSE(std::signbit(knots[0])) << "a whole number has no negative zero";
    }
    for (const std::size_t blanks : {1U, 600U, 1500U})
        for (const std::string& one : {std::string("1"), many_digits}) {
            const std::string list = spaced_out("[ 0 , 0 , 0 , " + one + " , 1 , 1 ]", blanks);
            const auto document = parse_document(replaced(file_of(plain_members), "[0,0,0,1,1,1]", list));
            ASSERT_TRUE(document.has_value()) << document.error().sentence();
            EXPECT_EQ(document->curves[0].curve->knots()[3], 1.0);
        }
    const auto document = parse_document(file_of(plain_members + R"(, "weights": [-0.0, 1, 1])"));
    EXPECT_EQ(document.error().where, "/curves/0/weights/0");
}

TEST(NativeFormat, only_numbers_of_curves_are_taken_out_of_the_tree) {
    const std::string text =
        R"({"format": "batten", "version": 1, "knots": [1, 2.0], "x": {"curves": [{"points": [[1, 2]]}]},)"
        R"( "curves": [{)" +
        plain_members + R"(, "shape": {"knots": [1, 2]}, "lists": [[1, 2], [3]]}]})";
    const auto document = parse_document(text);
    ASSERT_TRUE(document.has_value()) << document.error().sentence();
    EXPECT_EQ(document->unknown_members, R"({"knots":[1,2.0],"x":{"curves":[{"points":[[1,2]]}]}})");
    EXPECT_EQ(document->curves[0].unknown_members, R"({"shape":{"knots":[1,2]},"lists":[[1,2],[3]]})");
}

TEST(NativeFormat, errors_in_long_lists_have_their_place) {
    constexpr int count = 50'000;
    std::string knots;
    std::string points;
    for (int i = 0; i < count; ++i) points.append(i ? ",\n[" : "\n[").append(std::to_string(i)).append(", 0.5]");
    for (int i = 0; i < count + 2; ++i) knots.append(i ? "," : "").append(std::to_string(i));
    const std::string good = file_of("\"degree\": 1, \"knots\": [" + knots + "], \"points\": [" + points + "]");
    EXPECT_TRUE(parse_document(good).has_value());
    expect_error(replaced(good, ",49999,", ",null,"), "/curves/0/knots/49999", "found null, but it must be a number");
    expect_error(replaced(good, "[49999, 0.5]", "[49999]"), "/curves/0/points/49999", "found a list of one item");
    expect_error(replaced(good, "[49999, 0.5]", "[49999, true]"), "/curves/0/points/49999/1", "found true");
    expect_error(replaced(good, "[49999, 0.5]", "7"), "/curves/0/points/49999", "found 7");
    expect_error(replaced(good, "[49999, 0.5]", "[49999, 1e999]"), "line 50001, column 13", "too large");
    expect_error(replaced(good, "[49999, 0.5]", "[49999, NaN]"), "line 50001, column 9", "invalid literal");
    expect_error(replaced(good, "[49999, 0.5]", "[49999, 0.5],"), "line 50001, column 14", "unexpected ']'");
    expect_error(replaced(good, "[49999, 0.5]", "[49999, 01]"), "line 50001, column 10", "unexpected number literal");
    expect_error(good.substr(0, good.find("[49999, 0.5]")), "line 50001, column 1", "unexpected end of input");
    expect_error(replaced(good, "[49999, 0.5]", std::string("[4\0", 3)), "line 50001, column 3", "zero byte");
}

TEST(NativeFormat, damaged_files_never_crash) {
    RandomCurves random(112);
    for (int i = 0; i < 2000; ++i) {
        std::string text = format_document(random_document(random));
        const auto place = [&] { return static_cast<std::size_t>(random.whole(0, static_cast<int>(text.size()) - 1)); };
        if (i % 2 == 0) text.resize(place());
        for (int flips = random.whole(0, 3); flips > 0 && !text.empty(); --flips)
            text[place()] = static_cast<char>(random.whole(0, 255));
        const auto document = parse_document(text);
        if (!document) {
            EXPECT_FALSE(document.error().what.empty());
            continue;
        }
        const std::string formatted = format_document(*document);
        EXPECT_EQ(format_document(parse_document(formatted).value()), formatted);
    }
}

TEST_F(NativeFile, saved_and_loaded_is_the_same) {
    RandomCurves random(113);
    const Document document = random_document(random);
    const fs::path path = in_folder("a wave.json");
    ASSERT_TRUE(save_document(document, path).has_value());
    EXPECT_EQ(format_document(load_document(path).value()), format_document(document));
    EXPECT_EQ(files_in_folder(), 1U) << "no temporary file stays";
}

TEST_F(NativeFile, saving_over_a_file_keeps_its_permissions) {
    const fs::path path = in_folder("wave.json");
    std::ofstream(path) << "old";
    ASSERT_EQ(chmod(path.c_str(), 0640), 0);
    ASSERT_TRUE(save_document(Document{}, path).has_value());
    struct stat status {};
    ASSERT_EQ(stat(path.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777U, 0640U);
    EXPECT_TRUE(load_document(path).has_value());
}

TEST_F(NativeFile, new_file_follows_the_mask) {
    const mode_t mask = umask(027);
    ASSERT_TRUE(save_document(Document{}, in_folder("wave.json")).has_value());
    umask(mask);
    struct stat status {};
    ASSERT_EQ(stat(in_folder("wave.json").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777U, 0640U);
}

TEST_F(NativeFile, saving_through_a_link_keeps_the_link) {
    std::ofstream(in_folder("real.json")) << "old";
    fs::create_symlink(in_folder("real.json"), in_folder("link.json"));
    ASSERT_TRUE(save_document(Document{}, in_folder("link.json")).has_value());
    EXPECT_TRUE(fs::is_symlink(in_folder("link.json")));
    EXPECT_TRUE(load_document(in_folder("real.json")).has_value());
}

TEST_F(NativeFile, saving_to_a_dangling_link_makes_what_it_names) {
    fs::create_directory(in_folder("elsewhere"));
    fs::create_symlink("elsewhere/real.json", in_folder("second.json"));
    fs::create_symlink(in_folder("second.json"), in_folder("first.json"));
    ASSERT_TRUE(save_document(Document{}, in_folder("first.json")).has_value());
    EXPECT_TRUE(fs::is_symlink(in_folder("first.json")));
    EXPECT_TRUE(fs::is_symlink(in_folder("second.json")));
    EXPECT_FALSE(fs::is_symlink(in_folder("elsewhere/real.json")));
    EXPECT_TRUE(load_document(in_folder("elsewhere/real.json")).has_value());
    EXPECT_EQ(files_in_folder(), 3U);
}

TEST_F(NativeFile, links_that_lead_nowhere_are_refused) {
    fs::create_symlink("b.json", in_folder("a.json"));
    fs::create_symlink("a.json", in_folder("b.json"));
    EXPECT_NE(save_document(Document{}, in_folder("a.json")).error().what.find("symbolic links"), std::string::npos);
    fs::create_symlink("no folder/c.json", in_folder("c.json"));
    EXPECT_EQ(save_document(Document{}, in_folder("c.json")).error().what,
              "there is no folder " + in_folder("no folder").string());
    EXPECT_EQ(files_in_folder(), 3U);
}

TEST_F(NativeFile, limit_of_file_sizes_leaves_the_old_file_and_no_other) {
    const fs::path path = in_folder("wave.json");
    ASSERT_TRUE(save_document(Document{}, path).has_value());
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    const rlimit small{16, before.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    const auto saved = save_document(titled("larger"), path);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
    ASSERT_FALSE(saved.has_value());
    EXPECT_NE(saved.error().what.find("File too large"), std::string::npos) << saved.error().what;
    EXPECT_EQ(load_document(path).value().title, "");
    EXPECT_EQ(files_in_folder(), 1U);
}

TEST_F(NativeFile, names_may_be_as_long_as_the_system_allows) {
    std::string name(250, 'n');
    name.append(".json");
    ASSERT_TRUE(save_document(Document{}, in_folder(name.c_str())).has_value());
    EXPECT_TRUE(load_document(in_folder(name.c_str())).has_value());
}

TEST_F(NativeFile, what_fails_while_it_is_read_is_a_sentence) {
    const FileError error = load_document("/proc/self/mem").error();
    EXPECT_EQ(error.sentence(), "/proc/self/mem: the file cannot be read: Input/output error");
    EXPECT_EQ(load_document(-1, "standard input").error().sentence(),
              "standard input: the file cannot be read: Bad file descriptor");
}

TEST_F(NativeFile, input_without_end_is_refused) {
    EXPECT_NE(load_document("/dev/zero").error().sentence().find("zero byte"), std::string::npos);
    EXPECT_NE(load_document("/dev/urandom").error().sentence().find("not JSON"), std::string::npos);
    std::ofstream(in_folder("large.json")) << '{';
    fs::resize_file(in_folder("large.json"), most_file_bytes + 1);
    EXPECT_NE(load_document(in_folder("large.json")).error().sentence().find("zero byte"), std::string::npos);
}

TEST_F(NativeFile, bytes_are_read_with_zeros_among_them) {
    const std::string bytes("\0a\0\0b", 5);
    std::ofstream(in_folder("bytes"), std::ios::binary) << bytes;
    EXPECT_EQ(read_bytes(in_folder("bytes")), bytes);
    EXPECT_EQ(read_text(in_folder("bytes")), bytes.substr(0, 1));
    EXPECT_FALSE(read_bytes(in_folder("none")));
}

TEST_F(NativeFile, open_descriptors_are_read_to_their_end) {
    std::array<int, 2> ends{};
    ASSERT_EQ(pipe(ends.data()), 0);
    const std::string text = "left out" + format_document(titled("piped"));
    ASSERT_EQ(write(ends[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
    close(ends[1]);
    std::array<char, 8> skipped{};
    ASSERT_EQ(read(ends[0], skipped.data(), skipped.size()), 8);
    EXPECT_EQ(load_document(ends[0], "pipe").value().title, "piped");
    close(ends[0]);
}

// A file of many blocks, so that numbers, names and ends of lines stand across their edges.
TEST_F(NativeFile, files_and_texts_are_read_alike) {
    RandomCurves random(114);
    Document document;
    for (int i = 0; i < 1500; ++i) document.curves.push_back(random_document(random).curves.emplace_back());
    for (DocumentCurve& entry : document.curves) {
        entry.name = "a curve";
        entry.curve = std::make_shared<const Curve>(random.curve());
    }
    const std::string text = format_document(document);
    ASSERT_GT(text.size(), std::size_t{1} << 20U);
    const fs::path path = in_folder("large.json");
    std::ofstream(path) << text;
    const auto loaded = load_document(path);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().sentence();
    EXPECT_EQ(format_document(*loaded), text);
    for (const char* wrong : {"x", "]"}) {
        std::string damaged = text;
        for (std::size_t at = damaged.size() - 1; at > damaged.size() / 2; at -= damaged.size() / 5) {
            damaged.insert(at, wrong);
            std::ofstream(path) << damaged;
            const FileError error = error_of(damaged);
            EXPECT_EQ(load_document(path).error().sentence(), error.sentence());
        }
    }
}

TEST_F(NativeFile, progress_is_told_and_may_stop_the_reading) {
    const fs::path path = in_folder("large.json");
    Document document = titled(std::string(2'000'000, 'x'));
    ASSERT_TRUE(save_document(document, path).has_value());
    std::vector<double> shares;
    ASSERT_TRUE(load_document(path, [&](double share) { shares.push_back(share); }).has_value());
    EXPECT_GT(shares.size(), 5U);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_GT(shares.front(), 0.0);
    EXPECT_EQ(shares.back(), 1.0);
    struct Stopped {};
    const auto stop = [](double share) {
        if (share > 0.3) throw Stopped{};
    };
    EXPECT_THROW(static_cast<void>(load_document(path, stop)), Stopped);
}

// Points (i, 0) for i from `first` on.
DocumentCurve numbered_curve(std::size_t first, std::size_t count) {
    CurveDefinition definition{.degree = 1, .knots = {0.0}, .points = {}};
    for (std::size_t i = 0; i < count; ++i) {
        definition.knots.push_back(static_cast<double>(i));
        definition.points.emplace_back(static_cast<double>(first + i), 0.0);
    }
    definition.knots.push_back(definition.knots.back());
    DocumentCurve entry;
    entry.curve = std::make_shared<const Curve>(Curve::make(std::move(definition)).value());
    return entry;
}

TEST_F(NativeFile, points_are_told_while_they_are_read) {
    const fs::path path = in_folder("numbered.json");
    Document document;
    for (const std::size_t count : {7U, 100'000U, 50'000U, 4U})
        document.curves.push_back(numbered_curve(1000 * document.curves.size(), count));
    std::vector<Point> points;
    for (const DocumentCurve& entry : document.curves)
        for (const Point point : entry.curve->control_points()) points.push_back(point);
    ASSERT_TRUE(save_document(document, path).has_value());
    std::vector<Point> told;
    const auto take = [&](std::span<const Point> next) { told.insert(told.end(), next.begin(), next.end()); };
    ASSERT_TRUE(load_document(path, {}, take).has_value());
    EXPECT_EQ(told, points);
    struct Stopped {};
    const auto stop = [](double share) {
        if (share > 0.5) throw Stopped{};
    };
    told.clear();
    EXPECT_THROW(static_cast<void>(load_document(path, stop, take)), Stopped);
    ASSERT_GT(told.size(), 30'000U) << "of the long curve, up to the block that was not read";
    ASSERT_LT(told.size(), 100'000U);
    EXPECT_TRUE(std::equal(told.begin(), told.end(), points.begin()));
}

TEST_F(NativeFile, a_file_that_grows_meanwhile_is_read_to_its_end) {
    const fs::path path = in_folder("growing.json");
    ASSERT_TRUE(save_document(titled(std::string(1'000'000, 'x')), path).has_value());
    std::ofstream more(path, std::ios::app);
    int lines = 0;
    const auto grow = [&](double share) {
        EXPECT_LE(share, 1.0);
        if (++lines <= 8) more << std::string(100'000, '\n') << std::flush;
    };
    EXPECT_TRUE(load_document(path, grow).has_value());
    lines = 7;
    const auto spoil = [&](double) {
        if (++lines == 8) more << "x" << std::flush;
    };
    EXPECT_EQ(load_document(path, spoil).error().where, "line 800007, column 1");
}

TEST_F(NativeFile, what_cannot_be_read_or_written_is_a_sentence) {
    EXPECT_NE(load_document(in_folder("missing.json")).error().sentence().find("No such file"), std::string::npos);
    EXPECT_NE(load_document(in_folder("")).error().sentence().find("a folder"), std::string::npos);
    EXPECT_EQ(save_document(Document{}, in_folder("no/such/folder.json")).error().what,
              "there is no folder " + in_folder("no/such").string());
    EXPECT_NE(save_document(Document{}, in_folder(".")).error().sentence().find("not an ordinary file"),
              std::string::npos);
    std::ofstream(in_folder("broken.json")) << "{";
    EXPECT_EQ(load_document(in_folder("broken.json")).error().where, "line 1, column 2");
    EXPECT_EQ(files_in_folder(), 1U);
}

}  // namespace
}  // namespace batten::core
