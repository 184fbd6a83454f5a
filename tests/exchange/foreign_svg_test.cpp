// SVG files that other programs made (tests/data/exchange/README.md), against what they were told to draw.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include "core/document/native_file.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/area.h"
#include "core/measure/bounds.h"
#include "exchange/svg/svg_reader.h"

namespace batten::exchange {

namespace {

using core::Curve;
using core::Point;

Imported read_file(const std::string& name) {
    auto imported = read_svg(*core::read_text(std::filesystem::path(BATTEN_EXCHANGE_DATA) / name));
    EXPECT_TRUE(imported) << (imported ? "" : imported.error().sentence());
    return imported ? *std::move(imported) : Imported{};
}

const Curve& curve_called(const Imported& imported, const std::string& name) {
    return *imported.document.curves.at(core::index_of_curve(imported.document, name).value()).curve;
}

double area_of(const Curve& curve) {
    return std::abs(core::enclosed_area(curve)->signed_area);
}

// The ellipse with the semi-axes 12 and 5 about (60, 20), turned by 30 degrees clockwise.
void expect_on_egg(const Curve& curve, double tolerance) {
    const double c = std::cos(std::numbers::pi / 6);
    const double s = std::sin(std::numbers::pi / 6);
    for (int i = 0; i <= 100; ++i) {
        const Point p = core::point_at(curve, curve.domain().upper * i / 100);
        const core::Vector v = p - Point(60, 20);
        EXPECT_NEAR(std::hypot((c * v.x - s * v.y) / 12, (s * v.x + c * v.y) / 5), 1.0, tolerance) << i;
    }
}

}  // namespace

TEST(ForeignSvg, ShapesAreWhatTheyAre) {
    const Imported imported = read_file("shapes.svg");
    EXPECT_EQ(imported.document.units, (core::DocumentUnits{.unit = core::LengthUnit::mm}));
    EXPECT_NEAR(area_of(curve_called(imported, "plate")), 600 - (4 - std::numbers::pi) * 25, 1e-9);
    expect_on_egg(curve_called(imported, "egg"), 1e-12);
    EXPECT_EQ(imported.report.left_out.size(), 1U);
}

TEST(ForeignSvg, InkscapeWritesPaths) {
    const Imported imported = read_file("inkscape_paths.svg");
    EXPECT_TRUE(imported.report.left_out.empty());
    ASSERT_EQ(imported.document.curves.size(), 8U) << "the union, three shapes, and R and g of two contours each";
    // Two circles of radius 20 whose centers are 20 apart, as one; Inkscape computes it in single precision.
    const double lens = 2 * 400 * std::numbers::pi / 3 - 10 * std::sqrt(1200.0);
    EXPECT_NEAR(area_of(curve_called(imported, "left")), 2 * 400 * std::numbers::pi - lens, 0.05);
    const core::Box box = core::tight_box(curve_called(imported, "left"));
    EXPECT_NEAR(box.lower.y, 30, 1e-3);
    EXPECT_NEAR(box.upper.x, 70, 1e-3);
    expect_on_egg(curve_called(imported, "egg"), 1e-12);
    EXPECT_NEAR(area_of(curve_called(imported, "plate")), 600 - (4 - std::numbers::pi) * 25, 0.1);
    EXPECT_EQ(imported.document.curves[1].color, (core::DocumentColor{0xaa, 0, 0}));
    EXPECT_EQ(curve_called(imported, "wave").control_points()[1], Point(15, 30));
    EXPECT_EQ(curve_called(imported, "wave").control_points()[4], Point(45, 30)) << "the handle of S";
    for (const std::size_t i : {4U, 5U, 6U, 7U}) {
        EXPECT_EQ(imported.document.curves[i].curve->degree(), 2) << "letters of TrueType";
        EXPECT_TRUE(imported.document.curves[i].curve->is_periodic());
    }
}

TEST(ForeignSvg, InkscapeMovesShapes) {
    const Imported imported = read_file("inkscape_moved.svg");
    ASSERT_EQ(imported.document.curves.size(), 5U);
    // 10 and 5 px, of which 96 are 25.4 mm.
    const Point start = core::point_at(curve_called(imported, "wave"), 0);
    EXPECT_NEAR(start.x, 5 + 10 * 25.4 / 96, 1e-5);
    EXPECT_NEAR(start.y, 10 - 5 * 25.4 / 96, 1e-5);
    EXPECT_NEAR(area_of(curve_called(imported, "right")), 400 * std::numbers::pi, 1e-6);
}

TEST(ForeignSvg, CairoWritesCubics) {
    const Imported imported = read_file("cairo.svg");
    ASSERT_GE(imported.document.curves.size(), 5U);
    // Its unit is the px; and its circles are cubics, which are 3e-4 too large.
    const double px = 96 / 25.4;
    const core::Box box = core::tight_box(*imported.document.curves[0].curve);
    EXPECT_NEAR(box.upper.x, 50 * px, 0.02);
    EXPECT_NEAR(box.upper.y, (80 - 10) * px, 0.02);
    EXPECT_EQ(imported.document.units->unit, core::LengthUnit::px);
}

TEST(ForeignSvg, MatplotlibUsesMarkers) {
    const Imported imported = read_file("matplotlib.svg");
    ASSERT_EQ(imported.document.curves.size(), 6U);
    const Curve& line = *imported.document.curves[2].curve;
    EXPECT_EQ(std::vector<Point>(line.control_points().begin(), line.control_points().end()),
              (std::vector<Point>{{18, 18}, {72, 54}, {126, 18}}));
    EXPECT_EQ(imported.document.curves[2].color, (core::DocumentColor{0x1f, 0x77, 0xb4}));
    const Curve& circle = *imported.document.curves[1].curve;
    for (int i = 0; i <= 50; ++i)
        EXPECT_NEAR(core::distance(core::point_at(circle, circle.domain().upper * i / 50), {72, 36}), 18, 0.01);
    for (std::size_t i = 0; i < 3; ++i) {
        const core::Box box = core::tight_box(*imported.document.curves[3 + i].curve);
        EXPECT_NEAR(core::distance(box.center(), line.control_points()[i]), 0.0, 1e-6);
    }
}

TEST(ForeignSvg, InkscapeKeepsTheDocument) {
    const Imported imported = read_file("inkscape_resaved.svg");
    EXPECT_TRUE(imported.report.left_out.empty());
    const Curve& conic = curve_called(imported, "ellipse");
    EXPECT_EQ(conic.degree(), 2);
    EXPECT_EQ(conic.weights()[1], 2.0);
    EXPECT_EQ(conic.control_points()[1], Point(30, 40));
}

TEST(ForeignSvg, WhatInkscapeEditedIsRead) {
    const Imported imported = read_file("inkscape_edited.svg");
    EXPECT_EQ(imported.report.left_out.size(), 1U);
    const auto line = curve_called(imported, "line").control_points();
    EXPECT_NEAR(line[1].x, 50 + 10 * 25.4 / 96, 1e-5);
    EXPECT_NEAR(line[1].y, 10 - 5 * 25.4 / 96, 1e-5);
    // The conic's apex is 2/3 of the way up to its corner.
    const Curve& conic = curve_called(imported, "ellipse");
    EXPECT_EQ(conic.degree(), 3);
    EXPECT_NEAR(core::tight_box(conic).upper.y, 40.0 * 2 / 3, 1e-4);
    EXPECT_EQ(imported.document.curves[0].color, (core::DocumentColor{0xc0, 0x30, 0x30}));
}

}  // namespace batten::exchange
