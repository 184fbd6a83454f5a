#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

#include "core/document/native_file.h"
#include "core/evaluate/evaluate.h"
#include "core/make/conics.h"
#include "core/measure/deviation.h"
#include "core/refine/clamping.h"
#include "core/refine/periodic.h"
#include "exchange/cad/cad_files.h"
#include "exchange/cad/occt_process.h"
#include "exchange/format.h"
#include "tests/core/made_curve.h"

namespace batten::exchange {

namespace {

std::vector<double> clamped_knots(int degree, std::vector<double> inner = {}) {
    std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
    knots.insert(knots.end(), inner.begin(), inner.end());
    knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, 1.0);
    return knots;
}

// A curve of a degree with these inner knots, whose points lie irregularly.
core::Curve curve_over(int degree, const std::vector<double>& inner, bool has_weights) {
    std::mt19937 engine(static_cast<unsigned>(degree) + 100U * static_cast<unsigned>(inner.size()));
    std::uniform_real_distribution<double> place(-5.0, 5.0);
    std::uniform_real_distribution<double> weight(0.1, 9.0);
    core::CurveDefinition definition{.degree = degree, .knots = clamped_knots(degree, inner)};
    for (std::size_t i = 0; i < inner.size() + static_cast<std::size_t>(degree) + 1; ++i) {
        definition.points.push_back({place(engine), place(engine)});
        if (has_weights) definition.weights.push_back(weight(engine));
    }
    return core::made_curve(std::move(definition));
}

core::Document document_with_units(const core::Curve& curve, const std::string& name = "wave") {
    core::Document document;
    document.curves.emplace_back();
    document.curves.back().name = name;
    document.curves.back().curve = std::make_shared<const core::Curve>(curve);
    document.units = core::DocumentUnits{};
    return document;
}

class ThroughOpenCascade : public testing::TestWithParam<Format> {
  protected:
    void SetUp() override {
        if (format().read == nullptr) GTEST_SKIP() << "this build has no OpenCASCADE";
    }

    static const FormatSpec& format() { return spec_of(GetParam()); }

    static Exported written(const core::Document& document) {
        const auto exported = format().write(document, {});
        EXPECT_TRUE(exported) << exported.error().sentence();
        return exported ? *exported : Exported{};
    }

    static Imported read(const std::string& text) {
        const auto imported = format().read(text);
        EXPECT_TRUE(imported) << imported.error().sentence();
        return imported ? *imported : Imported{};
    }

    // The same numbers come back, to the last bit.
    static void expect_exact(const std::vector<core::Curve>& curves) {
        core::Document document;
        for (const core::Curve& curve : curves) {
            const std::string name = "c" + std::to_string(document.curves.size());
            document.curves.push_back(document_with_units(curve, name).curves.front());
        }
        document.units = core::DocumentUnits{};
        const Exported exported = written(document);
        EXPECT_EQ(exported.report.largest_error, 0.0);
        EXPECT_TRUE(exported.report.left_out.empty()) << exported.report.left_out.front();
        const Imported imported = read(exported.text);
        EXPECT_EQ(imported.report.largest_error, 0.0);
        EXPECT_TRUE(imported.report.left_out.empty()) << imported.report.left_out.front();
        ASSERT_EQ(imported.document.curves.size(), curves.size());
        for (std::size_t i = 0; i < curves.size(); ++i) {
            SCOPED_TRACE(i);
            EXPECT_EQ(imported.document.curves[i].name, document.curves[i].name);
            const core::Curve& copy = *imported.document.curves[i].curve;
            EXPECT_EQ(copy.degree(), curves[i].degree());
            EXPECT_TRUE(std::ranges::equal(copy.knots().values(), curves[i].knots().values()));
            EXPECT_TRUE(std::ranges::equal(copy.control_points(), curves[i].control_points()));
            EXPECT_TRUE(std::ranges::equal(copy.weights(), curves[i].weights()));
        }
    }

    // Another description of the same curve comes back, and the report says so.
    static void expect_same_shape(const core::Curve& curve, const std::string& said, double tolerance) {
        const Exported exported = written(document_with_units(curve));
        ASSERT_EQ(exported.report.left_out.size(), 1u);
        EXPECT_EQ(exported.report.left_out[0], said);
        const Imported imported = read(exported.text);
        ASSERT_EQ(imported.document.curves.size(), 1u);
        const double error = core::largest_deviation(*imported.document.curves[0].curve, curve);
        EXPECT_LE(error, tolerance);
        EXPECT_LE(error, exported.report.largest_error);
    }
};

// Asks a shell script in place of batten-occt.
class OcctProcess : public testing::Test {
  protected:
    void SetUp() override {
        if (const char* path = std::getenv("BATTEN_OCCT")) before_ = path;
        std::filesystem::remove(script_);
    }
    void TearDown() override {
        if (before_)
            setenv("BATTEN_OCCT", before_->c_str(), 1);
        else
            unsetenv("BATTEN_OCCT");
        std::filesystem::remove(script_);
    }

    void use_script(const std::string& commands, const std::string& interpreter = "/bin/sh") {
        std::ofstream(script_) << "#!" << interpreter << "\n" << commands << "\n";
        std::filesystem::permissions(script_, std::filesystem::perms::owner_all);
        setenv("BATTEN_OCCT", script_.c_str(), 1);
    }

    // What is told within half a minute where the program does `commands`.
    std::string told(const std::string& commands, std::chrono::milliseconds most_time,
                     const std::string& interpreter = "/bin/sh") {
        use_script(commands, interpreter);
        const auto start = std::chrono::steady_clock::now();
        const auto answer = ask_occt("read", "step", "text", most_time);
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
        return answer ? "answered: " + answer->text : answer.error().what;
    }

  private:
    std::optional<std::string> before_{};
    std::string script_ = testing::TempDir() + "batten_occt_" + std::to_string(getpid());
};

constexpr const char* occt_is_late = "OpenCASCADE takes more than a minute for this file";

TEST_F(OcctProcess, AnAnswerThatIsTooLongEndsIt) {
    EXPECT_EQ(told("exec cat /dev/zero", std::chrono::minutes(2)), "OpenCASCADE makes more than 256 MiB of this file");
}

TEST_F(OcctProcess, WaitingWithoutAnAnswerEndsIt) {
    EXPECT_EQ(told("exec sleep 100", std::chrono::milliseconds(200)), occt_is_late);
    EXPECT_EQ(told("echo '{\"text\": \"whole\"}'; exec >&-; exec sleep 100", std::chrono::milliseconds(200)),
              occt_is_late);
}

TEST_F(OcctProcess, EachEndHasItsSentence) {
    EXPECT_EQ(told("kill -SEGV $$", std::chrono::minutes(2)), "OpenCASCADE fails on this file");
    EXPECT_EQ(told("exit 3", std::chrono::minutes(2)), "OpenCASCADE fails on this file");
    EXPECT_EQ(told("kill -XCPU $$", std::chrono::minutes(2)), occt_is_late);
}

TEST_F(OcctProcess, AnswersInTimeAreTaken) {
    EXPECT_EQ(told("cat >/dev/null; echo '{\"text\": \"whole\"}'", std::chrono::minutes(2)), "answered: whole");
}

// Else whoever asked it to end would wait. A shell would let all signals through by itself.
TEST_F(OcctProcess, HoldsBackNoSignals) {
    sigset_t ends;
    sigset_t before;
    sigemptyset(&ends);
    sigaddset(&ends, SIGTERM);
    ASSERT_EQ(pthread_sigmask(SIG_BLOCK, &ends, &before), 0);
    const std::string answer = told(R"(BEGIN { while ((getline line < "/proc/self/status") > 0)
                            if (line ~ /^SigBlk/) printf "{\"text\": \"%s\"}", substr(line, 9) })",
                                    std::chrono::minutes(2), "/usr/bin/awk -f");
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    EXPECT_EQ(answer, "answered: 0000000000000000");
}

// What is told of a line from (0, 0) to (1, 1) that is written where reading has this answer.
TEST_F(OcctProcess, WhatComesBackIsComparedWithWhatWasMeant) {
    const auto exported_where_read = [&](const std::string& answer) {
        use_script(
            "if [ $1 = write ]; then echo '{\"text\": \"ISO-10303-21;DATA;ENDSEC;END-ISO-10303-21;\"}'; else echo '" +
            answer + "'; fi; cat >/dev/null");
        const core::Curve line = core::made_curve({.degree = 1, .knots = clamped_knots(1), .points = {{0, 0}, {1, 1}}});
        return write_step(document_with_units(line), {});
    };
    const auto answer_of_line_to = [](core::Point end) {
        std::string text = core::format_document(
            document_with_units(core::made_curve({.degree = 1, .knots = clamped_knots(1), .points = {{0, 0}, end}})));
        std::string quoted;
        for (const char c : text) {
            if (c == '"') quoted += '\\';
            if (c != '\n') quoted += c;
        }
        return "{\"text\": \"" + quoted + "\"}";
    };
    const auto same = exported_where_read(answer_of_line_to({1, 1}));
    ASSERT_TRUE(same);
    EXPECT_EQ(same->report.largest_error, 0.0);
    EXPECT_TRUE(same->report.left_out.empty());
    const auto other = exported_where_read(answer_of_line_to({1, 1.5}));
    ASSERT_TRUE(other);
    EXPECT_NEAR(other->report.largest_error, 0.5, 1e-12);
    EXPECT_EQ(other->report.left_out,
              std::vector<std::string>{"'wave' is read from the file otherwise than it was written, by at most the "
                                       "error that is told"});
    const auto none = exported_where_read("{\"what\": \"it is broken\"}");
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().what, "'wave' was left out, since the file with it cannot be read: it is broken");
}

TEST_P(ThroughOpenCascade, CurvesOfEveryDegreeKeepEveryBit) {
    std::vector<core::Curve> curves;
    for (int degree = 1; degree <= 25; ++degree)
        for (const bool has_weights : {false, true})
            curves.push_back(curve_over(degree, {0.2, 0.3, 1.0 / 3.0}, has_weights));
    expect_exact(curves);
}

TEST_P(ThroughOpenCascade, KnotsOfEveryMultiplicityStay) {
    std::vector<core::Curve> curves;
    for (int degree = 1; degree <= 25; ++degree)
        for (int multiplicity = 1; multiplicity <= degree; ++multiplicity)
            curves.push_back(curve_over(degree, std::vector<double>(static_cast<std::size_t>(multiplicity), 0.4),
                                        multiplicity % 2 == 0));
    expect_exact(curves);
}

TEST_P(ThroughOpenCascade, HugeTinyAndFarNumbersStay) {
    std::vector<core::Curve> curves;
    for (const double size : {1e20, 1e6, 1e-5}) {
        curves.push_back(
            core::made_curve({.degree = 3,
                              .knots = clamped_knots(3),
                              .points = {{0, 0}, {size, 2 * size}, {3 * size, 2 * size}, {4 * size, -0.0}}}));
        curves.push_back(core::made_curve({.degree = 2,
                                           .knots = {0, 0, 0, size / 3, size, size, size},
                                           .points = {{1e6, 0}, {1e6 + 0.1, 2}, {1e6 + 3, 1}, {1e6, -1e6}}}));
    }
    curves.push_back(core::made_curve({.degree = 3,
                                       .knots = clamped_knots(3, {0.5, 0.5 + 1e-9}),
                                       .points = {{0, 0}, {1, 2}, {3, 2}, {4, 1}, {5, 5}, {6, 0}}}));
    expect_exact(curves);
}

TEST_P(ThroughOpenCascade, EndsThatMeetAndCollinearPointsStay) {
    expect_exact(
        {core::made_curve({.degree = 2, .knots = clamped_knots(2, {0.5}), .points = {{0, 0}, {2, 0}, {2, 2}, {0, 0}}}),
         core::made_curve({.degree = 3, .knots = clamped_knots(3), .points = {{0, 0}, {3, 0}, {-3, 0}, {1, 0}}}),
         core::circle({1, 2}, 3.0).value()});
}

TEST_P(ThroughOpenCascade, TenThousandPointsStay) {
    std::vector<double> inner;
    for (int i = 1; i <= 9996; ++i) inner.push_back(i / 9997.0);
    expect_exact({curve_over(3, inner, true)});
}

TEST_P(ThroughOpenCascade, UnclampedAndPeriodicCurvesAreClamped) {
    expect_same_shape(
        core::made_curve(
            {.degree = 3, .knots = {0, 1, 2, 3, 4, 5, 6, 7, 9}, .points = {{0, 0}, {1, 2}, {3, 2}, {4, 0}, {5, 5}}}),
        "'wave' was written with clamped ends", 1e-14);
    expect_same_shape(core::made_curve({.degree = 3,
                                        .knots = {0, 1, 2, 3, 4.5},
                                        .points = {{0, 0}, {2, 0}, {2, 2}, {0.1, 2}},
                                        .weights = {1, 2, 3, 4},
                                        .periodic = true}),
                      "'wave' is periodic and was written as an open curve whose ends meet", 1e-14);
    expect_same_shape(
        core::made_curve({.degree = 2, .knots = {0, 0, 0, 1e-9, 1e-9, 1e-9}, .points = {{0, 0}, {1, 1}, {2, 0}}}),
        "'wave' was written over the parameters from 0 to 1, since its own are too near each other", 1e-14);
}

// By exact fractions: with the knots 0, 1, ... the first end of the curve is (P0 + 4 P1 + P2) / 6 = (7/6, 10/6).
TEST_P(ThroughOpenCascade, ClampedCopiesAreNotCalledExact) {
    const core::Curve curve =
        core::made_curve({.degree = 3, .knots = {0, 1, 2, 3, 4, 5, 6, 7}, .points = {{0, 0}, {1, 2}, {3, 2}, {4, 0}}});
    const Exported exported = written(document_with_units(curve));
    EXPECT_GT(exported.report.largest_error, 0.0) << "no double is 7/6";
    EXPECT_LT(exported.report.largest_error, 2e-15);
    const core::Point end = read(exported.text).document.curves.at(0).curve->control_points().front();
    EXPECT_LE(std::abs(end.x - 7.0 / 6.0), exported.report.largest_error);
    EXPECT_LE(std::abs(end.y - 10.0 / 6.0), exported.report.largest_error);
}

TEST_P(ThroughOpenCascade, EndsThatAreNearStay) {
    std::vector<core::Curve> curves;
    for (const double size : {1e-9, 1e-150})
        curves.push_back(core::made_curve({.degree = 3,
                                           .knots = clamped_knots(3),
                                           .points = {{0, 0}, {size, 2 * size}, {3 * size, 2 * size}, {6 * size, 0}}}));
    expect_exact(curves);
}

// Other programs read IGES through OpenCASCADE, too, which refuses weights below 1e-9, and takes those for equal that
// differ by less than 1e-10.
TEST_P(ThroughOpenCascade, SmallAndNearWeightsAreMultipliedInIges) {
    const bool is_iges = GetParam() == Format::iges;
    const auto weights_of_copy = [](std::vector<double> weights) {
        const core::Curve curve = core::made_curve({.degree = 2,
                                                    .knots = clamped_knots(2),
                                                    .points = {{0, 0}, {1, 2}, {3, 2}},
                                                    .weights = std::move(weights)});
        const Exported exported = written(document_with_units(curve));
        EXPECT_EQ(exported.report.largest_error, 0.0);
        EXPECT_TRUE(exported.report.left_out.empty());
        const core::Curve copy = *read(exported.text).document.curves.at(0).curve;
        return std::vector<double>(copy.weights().begin(), copy.weights().end());
    };
    EXPECT_EQ(weights_of_copy({1, 2, 1}), (std::vector<double>{1, 2, 1}));
    const double next_to_one = std::nextafter(1.0, 2.0);
    const std::vector<double> near = weights_of_copy({1, next_to_one, 1});
    EXPECT_EQ(near[1] / near[0], next_to_one);
    EXPECT_EQ(near[1] - near[0] > 1e-10, is_iges);
    const std::vector<double> small = weights_of_copy({1e-12, 3, 1e-300});
    EXPECT_EQ(small[1] / 3, small[0] / 1e-12);
    EXPECT_EQ(small[2] > 1e-9, is_iges);
}

TEST_P(ThroughOpenCascade, WhatDoesNotComeBackIsLeftOutByName) {
    core::Document document = document_with_units(curve_over(3, {0.25}, true), "first");
    const core::Curve huge = core::made_curve(
        {.degree = 3, .knots = clamped_knots(3), .points = {{0, 0}, {1e300, 2e300}, {3e300, 2e300}, {4e300, 0}}});
    document.curves.push_back(document_with_units(huge, "a huge one").curves[0]);
    document.curves.push_back(document_with_units(curve_over(2, {0.5}, false), "third").curves[0]);
    const Exported exported = written(document);
    const Imported imported = read(exported.text);
    const bool is_lost = std::ranges::any_of(exported.report.left_out, [](const std::string& told) {
        return told.starts_with("'a huge one' was left out, since the file with it cannot be read: found '");
    });
    ASSERT_EQ(imported.document.curves.size(), is_lost ? 2U : 3U);
    EXPECT_EQ(core::largest_deviation(*imported.document.curves.front().curve, *document.curves.front().curve), 0.0);
    EXPECT_EQ(core::largest_deviation(*imported.document.curves.back().curve, *document.curves.back().curve), 0.0);
    EXPECT_EQ(exported.report.largest_error, 0.0) << "of what is there";
    EXPECT_EQ(format().write(document_with_units(huge), {}).has_value(), !is_lost);
}

// OpenCASCADE takes only such knots as are beyond the next double after the one before.
TEST_P(ThroughOpenCascade, SaysWhichKnotsAndWeightsOpenCascadeRefuses) {
    const auto over = [](double knot, double next) {
        return document_with_units(core::made_curve({.degree = 2,
                                                     .knots = {4, 4, 4, knot, next, 6, 6, 6},
                                                     .points = {{0, 0}, {1, 2}, {2, 0}, {3, 3}, {4, 1}}}),
                                   "near");
    };
    const double next = std::nextafter(5.0, 6.0);
    const char* const said = "'near' was left out, since its knots are too near each other for OpenCASCADE";
    const auto alone = format().write(over(5, next), {});
    ASSERT_FALSE(alone);
    EXPECT_EQ(alone.error().what, said);
    core::Document both = over(5, next);
    both.curves.push_back(over(5, std::nextafter(next, 6.0)).curves[0]);
    both.curves[1].name = "less";
    const Exported exported = written(both);
    EXPECT_EQ(exported.report.left_out, std::vector<std::string>{said});
    EXPECT_EQ(read(exported.text).document.curves.at(0).name, "less");
    const auto tiny = format().write(document_with_units(core::made_curve({.degree = 2,
                                                                           .knots = clamped_knots(2),
                                                                           .points = {{0, 0}, {1, 2}, {3, 2}},
                                                                           .weights = {1e300, 1e-310, 1}})),
                                     {});
    ASSERT_FALSE(tiny);
    EXPECT_EQ(tiny.error().what, "'wave' was left out, since its weights are too small for OpenCASCADE");
}

// Wherever they stand, the others are all there in their order.
TEST_P(ThroughOpenCascade, OfManyCurvesThoseAreLeftOutThatDoNotComeBack) {
    const core::Curve huge = core::made_curve(
        {.degree = 3, .knots = clamped_knots(3), .points = {{0, 0}, {1e300, 2e300}, {3e300, 2e300}, {4e300, 0}}});
    if (format().write(document_with_units(huge), {}).has_value()) GTEST_SKIP() << "everything comes back";
    const std::vector<int> lost{0, 5, 6, 15};
    core::Document document;
    document.units = core::DocumentUnits{};
    std::vector<std::string> kept;
    for (int i = 0; i < 16; ++i) {
        const bool is_lost = std::ranges::find(lost, i) != lost.end();
        const core::Curve plain =
            core::made_curve({.degree = 1, .knots = clamped_knots(1), .points = {{0, i * 1.0}, {1, 0}}});
        document.curves.push_back(document_with_units(is_lost ? huge : plain, "c" + std::to_string(i)).curves[0]);
        if (!is_lost) kept.push_back(document.curves.back().name);
    }
    const Exported exported = written(document);
    std::vector<std::string> found;
    for (const core::DocumentCurve& entry : read(exported.text).document.curves) found.push_back(entry.name);
    EXPECT_EQ(found, kept);
    ASSERT_EQ(exported.report.left_out.size(), 1u);
    const std::string& told = exported.report.left_out[0];
    EXPECT_TRUE(told.starts_with("4 curves were left out, since files with them cannot be read: found '")) << told;
    EXPECT_TRUE(told.ends_with("; the first one is 'c0'")) << told;
}

TEST_P(ThroughOpenCascade, SaysWhatFilesHaveNoPlaceFor) {
    core::Document document = document_with_units(curve_over(3, {0.25}, true), "first");
    document.curves.push_back(document_with_units(curve_over(2, {0.5}, false), "hidden").curves[0]);
    document.curves[1].visible = false;
    document.curves[0].color = core::DocumentColor{1, 2, 3};
    document.curves[0].group = "parts";
    document.pictures.emplace_back();
    document.units = core::DocumentUnits{.unit = core::LengthUnit::px};
    const Exported exported = written(document);
    const std::vector<std::string> expected{"the lengths, which are pixels, were written in inches, 96 pixels each",
                                            "one curve was left out, since it is hidden",
                                            "one picture was left out; only curves are written",
                                            "the format has no place for colors or groups of the document"};
    EXPECT_EQ(exported.report.left_out, expected);
    EXPECT_EQ(read(exported.text).document.units->unit, core::LengthUnit::inch);
}

TEST_P(ThroughOpenCascade, LengthsKeepTheirUnit) {
    core::Document document = document_with_units(curve_over(3, {0.25}, true));
    document.units = core::DocumentUnits{.unit = core::LengthUnit::inch};
    const Imported imported = read(written(document).text);
    EXPECT_EQ(imported.document.units, document.units);
    EXPECT_EQ(*imported.document.curves.at(0).curve, *document.curves[0].curve);
    document.units->scale = 4.0;
    EXPECT_EQ(read(written(document).text).document.curves.at(0).curve->control_points()[0].x,
              document.curves[0].curve->control_points()[0].x / 4.0);
    document.units->scale = 3.0;
    const double error = written(document).report.largest_error;
    EXPECT_GT(error, 0.0);
    EXPECT_LT(error, 1e-14);
    document.units = std::nullopt;
    EXPECT_EQ(written(document).report.left_out.at(0),
              "the document has no unit; its numbers were written as millimeters");
}

TEST_P(ThroughOpenCascade, VisibleCurvesAreWrittenInOrderWithTheirNames) {
    core::Document document = document_with_units(curve_over(2, {}, false), "first");
    for (const char* name : {"hidden", "second", "it's 3"}) {
        document.curves.push_back(document.curves.front());
        document.curves.back().name = name;
        document.curves.back().curve = std::make_shared<const core::Curve>(curve_over(3, {0.5}, true));
        document.curves.back().visible = std::string(name) != "hidden";
    }
    const Imported imported = read(written(document).text);
    ASSERT_EQ(imported.document.curves.size(), 3u);
    EXPECT_EQ(imported.document.curves[0].name, "first");
    EXPECT_EQ(imported.document.curves[1].name, "second");
    EXPECT_EQ(imported.document.curves[2].name, "it's 3");
}

TEST_P(ThroughOpenCascade, WhatCannotBeWrittenIsRefused) {
    EXPECT_FALSE(format().write(core::Document{}, {}));
    const auto torn = format().write(document_with_units(core::made_curve({.degree = 1,
                                                                           .knots = {0, 0, 1, 1, 2, 2},
                                                                           .points = {{0, 0}, {1, 0}, {1, 1}, {2, 1}},
                                                                           .tears = core::Tears::allow})),
                                     {});
    ASSERT_FALSE(torn);
    EXPECT_EQ(torn.error().what, "'wave' was left out, since it comes apart at a knot");
}

// What tests/data/exchange/make_with_freecad.py drew.
TEST_P(ThroughOpenCascade, FilesOfFreeCadAreRead) {
    const std::string path = std::string(BATTEN_EXCHANGE_DATA "/freecad") + format().endings.front();
    const Imported imported = read(core::read_text(path).value());
    EXPECT_EQ(imported.report.left_out,
              (std::vector<std::string>{"one curve has a z that is not 0, which is left out",
                                        "2 curves are left out: they do not lie in planes with one z each"}));
    EXPECT_GT(imported.report.largest_error, 0.0);
    EXPECT_LT(imported.report.largest_error, 1e-13);
    EXPECT_EQ(imported.document.units, core::DocumentUnits{});
    const std::vector<core::DocumentCurve>& curves = imported.document.curves;
    ASSERT_EQ(curves.size(), 9u);
    const std::vector<core::Point> points{{0, 0}, {10, 25}, {30, -5}, {40, 20}, {60, 0}};
    const std::vector<double> knots{0, 0, 0, 0, 0.3, 1, 1, 1, 1};
    EXPECT_EQ(*curves[0].curve, core::made_curve({.degree = 3, .knots = knots, .points = points}));
    EXPECT_EQ(*curves[1].curve,
              core::made_curve({.degree = 3, .knots = knots, .points = points, .weights = {1, 5, 0.5, 2, 1}}));
    EXPECT_EQ(curves[3].curve->control_points().size(), 5u);
    EXPECT_EQ(curves[3].curve->knots().multiplicity(0.5), 2);
    EXPECT_EQ(curves[4].curve->control_points().front(), (core::Point{1, 2}));
    EXPECT_LT(core::distance(curves[4].curve->control_points().back(), {4, 6}), 1e-12);
    EXPECT_LT(core::distance(curves[8].curve->control_points().back(), {1, 1}), 1e-12);
    const auto expect_conic = [&](std::size_t i, core::Point center, double a, double b) {
        const core::Interval domain = curves[i].curve->domain();
        for (int k = 0; k <= 50; ++k) {
            const core::Point at =
                core::point_at(*curves[i].curve, domain.lower + k / 50.0 * (domain.upper - domain.lower));
            EXPECT_NEAR(std::hypot((at.x - center.x) / a, (at.y - center.y) / b), 1.0, 1e-7) << i;
        }
    };
    expect_conic(5, {0, 0}, 5, 5);
    EXPECT_NEAR(core::point_at(*curves[5].curve, curves[5].curve->domain().upper).x, -5.0, 1e-9);
    EXPECT_GT(core::point_at(*curves[5].curve, 1.0).y, 0.0);
    expect_conic(6, {1, 1}, 2.5, 2.5);
    expect_conic(7, {0, 0}, 6, 3);
}

// The periodic cubic of FreeCAD over the points above begins in no control point.
TEST_P(ThroughOpenCascade, PeriodicCurvesOfFreeCadDrawTheSame) {
    const std::string path = std::string(BATTEN_EXCHANGE_DATA "/freecad") + format().endings.front();
    const Imported imported = read(core::read_text(path).value());
    const core::Curve expected = core::made_curve({.degree = 3,
                                                   .knots = {0, 1, 2, 3, 4, 5.5},
                                                   .points = {{0, 0}, {10, 25}, {30, -5}, {40, 20}, {60, 0}},
                                                   .periodic = true});
    const core::Curve& curve = *imported.document.curves.at(2).curve;
    EXPECT_EQ(curve.domain(), expected.domain());
    // FreeCAD counts the points from another one on.
    double nearest = INFINITY;
    for (std::size_t shift = 0; shift < 5; ++shift) {
        core::CurveDefinition shifted = expected.definition();
        std::rotate(shifted.points.begin(), shifted.points.begin() + static_cast<std::ptrdiff_t>(shift),
                    shifted.points.end());
        nearest = std::min(nearest, core::largest_deviation(core::to_clamped(core::made_curve(shifted)).value(),
                                                            core::to_clamped(curve).value()));
    }
    EXPECT_LT(nearest, 1e-13);
}

// OpenCASCADE takes what is missing or no number for 0.
TEST_P(ThroughOpenCascade, WhatIsDamagedIsNotCalledExact) {
    const core::Curve curve = core::made_curve(
        {.degree = 3, .knots = clamped_knots(3), .points = {{0.125, 2.625}, {1, 2.5}, {3, 2}, {4, 1.75}}});
    const std::string text = written(document_with_units(curve)).text;
    const auto with = [&](const std::string& before, const std::string& after) {
        const std::size_t at = text.find(before);
        EXPECT_NE(at, std::string::npos) << before;
        return std::string(text).replace(at, before.size(), after);
    };
    for (const char* damaged : {"nan", "", "$", "1.X", "(1.)", "1E999", "1.5,"}) {
        SCOPED_TRACE(damaged);
        const auto imported = format().read(with("2.6250000000000000E+00", damaged));
        EXPECT_FALSE(imported);
    }
}

// OpenCASCADE ends on some of these with a signal; the program that asked it goes on.
TEST_P(ThroughOpenCascade, DamagedFilesAreRefusedOrReadInPart) {
    const core::Curve curve = curve_over(3, {0.25, 0.5}, true);
    const std::string text = written(document_with_units(curve)).text;
    std::size_t refused = 0;
    const auto take = [&](const std::string& damaged) {
        auto imported = format().read(damaged);
        if (imported) return imported;
        ++refused;
        EXPECT_FALSE(imported.error().what.empty());
        return imported;
    };
    for (std::size_t length = 0; length < text.size(); length += 100) {
        const auto imported = take(text.substr(0, length));
        if (!imported || !imported->report.left_out.empty()) continue;
        EXPECT_EQ(imported->document.curves.at(0).curve->knots().values().size(), curve.knots().values().size());
        EXPECT_TRUE(std::ranges::equal(imported->document.curves.at(0).curve->weights(), curve.weights()));
    }
    EXPECT_GT(refused, 5u);
    std::mt19937 engine(7);
    const std::string digits = "0123456789";
    for (int k = 0; k < 30; ++k) {
        std::string lying = text;
        const std::size_t place = lying.find_first_of(digits, engine() % lying.size());
        if (place != std::string::npos) take(lying.replace(place, 1, "99999999"));
    }
    for (const std::string& other : {std::string(), std::string(1000, '\0'), std::string("nothing")}) {
        const auto imported = format().read(other);
        ASSERT_FALSE(imported);
        EXPECT_FALSE(imported.error().what.empty());
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, ThroughOpenCascade, testing::Values(Format::iges, Format::step),
                         [](const auto& tested) { return core::title_of(tested.param); });

}  // namespace

}  // namespace batten::exchange
