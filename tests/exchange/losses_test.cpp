#include <gtest/gtest.h>

#include "exchange/format.h"
#include "tests/exchange/carried_curves.h"

namespace batten::exchange {

namespace {

// A periodic curve in a document with what only Batten knows.
core::Document rich_document() {
    core::Document document = document_of(
        core::Curve::make(
            {.degree = 2, .knots = {0, 1, 2, 3, 4}, .points = {{0, 0}, {1, 0}, {1, 1}, {0, 2}}, .periodic = true})
            .value(),
        "a<b>");
    core::DocumentCurve& entry = document.curves[0];
    entry.color = core::DocumentColor{1, 2, 3};
    entry.group = "parts";
    entry.pinned = {1};
    document.title = "A title";
    document.guides.emplace_back();
    document.pictures.emplace_back();
    document.units = core::DocumentUnits{.unit = core::LengthUnit::inch};
    return document;
}

std::vector<std::string> told_by(Format format, const core::Document& document) {
    const auto written = spec_of(format).write(document, {});
    return written ? written->report.left_out : std::vector<std::string>{written.error().sentence()};
}

constexpr const char* period = "'a<b>' is periodic and was written as an open curve whose ends meet";
constexpr const char* picture = "one picture was left out; only curves are written";
constexpr const char* unit = "the unit of length was left out, since the format has none; the numbers stay as they are";
constexpr const char* colorless =
    "the format has no place for the title, colors, groups, pinned points or guides of the document";

}  // namespace

TEST(Losses, AreToldByEachFormat) {
    using Told = std::vector<std::string>;
    const core::Document document = rich_document();
    for (const Format format : {Format::nurbs_python, Format::tinyspline, Format::rhino})
        EXPECT_EQ(told_by(format, document), (Told{period, picture, unit, colorless}));
    EXPECT_EQ(told_by(Format::opencascade, document), (Told{picture, unit, colorless}));
    EXPECT_EQ(told_by(Format::dxf, document),
              (Told{picture, "the format has no place for the title, groups, pinned points or guides of the document",
                    "the name 'a<b>' has signs that names of layers cannot have, which became _"}));
}

TEST(Losses, AreNoneOfADocumentThatHasNoSuchThings) {
    const core::Document document = document_of(carried_curves(0)[0].curve);
    for (const Format format :
         {Format::nurbs_python, Format::tinyspline, Format::rhino, Format::opencascade, Format::dxf, Format::csv})
        EXPECT_TRUE(told_by(format, document).empty());
}

TEST(Losses, DescriptionsKeptJointsAndUnknownMembersAreToldByEachFormat) {
    const core::Document plain = document_of(carried_curves(0)[0].curve);
    const auto expect_told = [](const core::Document& document, const std::string& part) {
        const std::string sentence = "the format has no place for " + part + " of the document";
        for (const Format format :
             {Format::nurbs_python, Format::tinyspline, Format::rhino, Format::opencascade, Format::dxf})
            EXPECT_EQ(told_by(format, document), std::vector<std::string>{sentence});
    };
    core::Document document = plain;
    document.description = "Drawn in winter.";
    expect_told(document, "the description");
    document.title = "A hull";
    document.unknown_members = R"({"mass": 3})";
    expect_told(document, "the title, the description or unknown members");
    document = plain;
    document.curves[0].unknown_members = R"({"mass": 3})";
    expect_told(document, "unknown members");
    document.curves[0].joints.knots.push_back({.u = 0.5});
    expect_told(document, "kept joints or unknown members");
    document = plain;
    document.curves[0].unknown_fit_members = R"({"tension": 3})";
    expect_told(document, "unknown members");
}

TEST(Losses, LocksAreToldWhereFormatsHaveNone) {
    core::Document document = document_of(carried_curves(0)[0].curve);
    document.curves[0].locked = true;
    EXPECT_EQ(told_by(Format::rhino, document),
              std::vector<std::string>{"the format has no place for locks of the document"});
    EXPECT_TRUE(told_by(Format::dxf, document).empty());
}

TEST(Losses, TheViewIsNoneOfThem) {
    core::Document document = document_of(carried_curves(0)[0].curve);
    document.view.unknown_members = R"({"forms": {}})";
    EXPECT_TRUE(told_by(Format::rhino, document).empty());
}

TEST(Losses, UnknownMembersOfHiddenCurvesGoWithThem) {
    core::Document document = document_of(carried_curves(0)[0].curve);
    document.curves.resize(2, document.curves[0]);
    document.curves[1].unknown_members = R"({"mass": 3})";
    document.curves[1].visible = false;
    EXPECT_EQ(told_by(Format::rhino, document), std::vector<std::string>{"one curve was left out, since it is hidden"});
}

TEST(Losses, AreCountedForManyCurves) {
    core::Document document = rich_document();
    document.curves.resize(3, document.curves[0]);
    document.curves[2].visible = false;
    const std::vector<std::string> told = told_by(Format::rhino, document);
    ASSERT_GE(told.size(), 2U);
    EXPECT_EQ(told[0], "2 curves are periodic and were written as open ones whose ends meet, the first one 'a<b>'");
    EXPECT_EQ(told[1], "one curve was left out, since it is hidden");
}

TEST(Losses, WhatKnotsOutsideThePeriodAreRoundedIsBounded) {
    const auto error_by = [](Format format, const core::Document& document) {
        return spec_of(format).write(document, {}).value().report.largest_error;
    };
    const auto periodic = [](std::vector<double> knots) {
        return document_of(
            core::Curve::make(
                {.degree = 2, .knots = std::move(knots), .points = {{0, 0}, {6, 0}, {0, 6}}, .periodic = true})
                .value());
    };
    // The knot after the end is no double. The end is the middle of a leg of length 6, and a corner where that knot is
    // rounded to the end: an open curve whose ends are 3 apart.
    const double h = 0x1p53;
    const core::Document rounded_to_seam = periodic({h - 4, h - 3, h - 1, h});
    // The knot 0.4 is rounded by 2^-55, which moves the end of the leg by 6 * 2.5 * 2^-55.
    const core::Document decimal = periodic({0, 0.1, 0.2, 0.3});
    for (const Format format : {Format::dxf, Format::nurbs_python, Format::tinyspline, Format::rhino}) {
        EXPECT_GE(error_by(format, rounded_to_seam), 3.0);
        EXPECT_LE(error_by(format, rounded_to_seam), 12.0);
        EXPECT_GE(error_by(format, decimal), 15 * 0x1p-55);
        EXPECT_LE(error_by(format, decimal), 5 * 15 * 0x1p-55);
        EXPECT_EQ(error_by(format, periodic({-4, -3, -1, 0})), 0.0);
    }
    EXPECT_EQ(error_by(Format::opencascade, rounded_to_seam), 0.0) << "which has periods";
}

TEST(Losses, TablesHoldSamples) {
    const auto table = spec_of(Format::csv).write(rich_document(), {});
    ASSERT_TRUE(table);
    EXPECT_TRUE(table->report.holds_samples);
}

TEST(Losses, NothingToWriteIsSaid) {
    for (const Format format : {Format::dxf, Format::tinyspline, Format::csv})
        EXPECT_EQ(told_by(format, {}), std::vector<std::string>{"there is no curve to write"});
}

}  // namespace batten::exchange
