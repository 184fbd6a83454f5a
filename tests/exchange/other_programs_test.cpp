#include <gtest/gtest.h>

#include <cmath>

#include "core/evaluate/evaluate.h"
#include "exchange/format.h"
#include "tests/core/point_at_share.h"

namespace batten::exchange {

namespace {

using core::Curve;
using core::Point;

Imported file(const std::string& name) {
    const std::filesystem::path path = std::filesystem::path(BATTEN_EXCHANGE_DATA) / name;
    const auto text = core::read_text(path);
    EXPECT_TRUE(text) << text.error().sentence();
    auto read = spec_of(format_of(path).value()).read(*text);
    EXPECT_TRUE(read) << read.error().sentence();
    return read ? *std::move(read) : Imported{};
}

const Curve& curve_in(const Imported& imported, std::size_t i) {
    return *imported.document.curves.at(i).curve;
}

// For numbers that the program wrote with so many digits.
void expect_near(Point found, Point expected, double tolerance) {
    EXPECT_NEAR(found.x, expected.x, tolerance);
    EXPECT_NEAR(found.y, expected.y, tolerance);
}

constexpr double written_digits = 2e-5;

}  // namespace

TEST(OtherPrograms, FreeCadDxf) {
    const Imported found = file("freecad.dxf");
    EXPECT_TRUE(found.report.left_out.empty());
    ASSERT_EQ(found.document.curves.size(), 6U);
    expect_near(at_share(curve_in(found, 0), 0.0), {0, 0}, written_digits);
    expect_near(at_share(curve_in(found, 0), 1.0), {6, 1}, written_digits);
    for (int i = 0; i <= 8; ++i)
        EXPECT_NEAR(core::distance(at_share(curve_in(found, 1), i / 8.0), {1, 2}), 3.0, written_digits);
    expect_near(at_share(curve_in(found, 2), 0.0), {10 + 2 * std::cos(0.5), 2 * std::sin(0.5)}, written_digits);
    expect_near(at_share(curve_in(found, 2), 1.0), {10 + 2 * std::cos(2.5), 2 * std::sin(2.5)}, written_digits);
    // The rest of the circle has the same ends, and the middle on the other side.
    expect_near(at_share(curve_in(found, 2), 0.5), {10 + 2 * std::cos(1.5), 2 * std::sin(1.5)}, written_digits);
    expect_near(at_share(curve_in(found, 3), 0.25), {20, 2}, written_digits);
    expect_near(at_share(curve_in(found, 4), 0.0), {20 + 4 * std::cos(0.5), 2 * std::sin(0.5)}, written_digits);
    expect_near(at_share(curve_in(found, 4), 1.0), {20 + 4 * std::cos(2.0), 2 * std::sin(2.0)}, written_digits);
    expect_near(at_share(curve_in(found, 4), 0.5), {20 + 4 * std::cos(1.25), 2 * std::sin(1.25)}, written_digits);
    expect_near(at_share(curve_in(found, 5), 1.0), {7, -6}, written_digits);
}

TEST(OtherPrograms, InkscapeDxf) {
    const Imported found = file("inkscape.dxf");
    // The first piece of the path, with y upward on a page of 100 mm; and the circle in quarters.
    ASSERT_EQ(found.document.curves.size(), 8U);
    std::size_t cubics = 0;
    for (const core::DocumentCurve& entry : found.document.curves) cubics += entry.curve->degree() == 3 ? 1U : 0U;
    EXPECT_EQ(cubics, 7U);
    expect_near(at_share(curve_in(found, 0), 0.0), {10, 90}, written_digits);
    expect_near(at_share(curve_in(found, 0), 0.5), {30, 67.5}, written_digits);
    expect_near(at_share(curve_in(found, 0), 1.0), {50, 90}, written_digits);
}

TEST(OtherPrograms, EzdxfDxf) {
    const Imported found = file("ezdxf.dxf");
    ASSERT_EQ(found.document.curves.size(), 9U);
    EXPECT_EQ(found.document.units, core::DocumentUnits{core::LengthUnit::mm});
    EXPECT_EQ(found.report.left_out.size(), 3U);  // fit points, a text, a block
    EXPECT_EQ(found.document.curves[0].name, "outline");
    EXPECT_EQ(found.document.curves[0].color, (core::DocumentColor{255, 0, 0}));
    // Bernstein: (6 (1, 2) + 1.5 (3, 2) + (4, 0)) / 8 over the weight (1 + 6 + 1.5 + 1) / 8.
    expect_near(at_share(curve_in(found, 0), 0.5), {14.5 / 9.5, 15.0 / 9.5}, 1e-15);
    EXPECT_TRUE(curve_in(found, 2).is_periodic());
    EXPECT_EQ(curve_in(found, 2).control_points().size(), 5U);
    // A half circle on the right of the closed polyline, and less than one on its left.
    expect_near(core::point_at(curve_in(found, 3), 2.0), {5, 6}, 1e-15);
    const double minor = 0.5;
    expect_near(at_share(curve_in(found, 4), 0.0),
                {10 + 3 * std::cos(0.5) - minor * std::sin(0.5), std::cos(0.5) + 3 * minor * std::sin(0.5)}, 1e-14);
    expect_near(at_share(curve_in(found, 6), 0.25), {10, 8}, 1e-14);
    expect_near(at_share(curve_in(found, 8), 1.0), {2, 14}, 1e-14);
}

TEST(OtherPrograms, EzdxfOldDxf) {
    const Imported found = file("ezdxf-r12.dxf");
    ASSERT_EQ(found.document.curves.size(), 2U);
    EXPECT_TRUE(curve_in(found, 0).is_periodic());
    expect_near(core::point_at(curve_in(found, 0), 2.0), {3, 13}, 1e-15);
}

TEST(OtherPrograms, FreeCadOpenCascade) {
    const Imported found = file("freecad.opencascade.json");
    ASSERT_EQ(found.document.curves.size(), 4U);
    EXPECT_TRUE(found.report.left_out.empty());
    // Points as FreeCAD itself evaluates them.
    const Curve& simple = curve_in(found, 0);
    EXPECT_TRUE(simple.is_periodic());
    expect_near(core::point_at(simple, 0.0), {1.8571428571428572, 0.20408163265306126}, 1e-15);
    expect_near(core::point_at(simple, 1.0), {2.5652173913043472, 1.4565217391304348}, 1e-15);
    expect_near(core::point_at(simple, 2.75), {-0.2910219586769202, 2.1285092189382007}, 1e-15);
    expect_near(core::point_at(simple, 4.5), {1.1421421421421425, 0.07007007007007006}, 1e-15);
    const Curve& double_seam = curve_in(found, 1);
    expect_near(core::point_at(double_seam, 0.0), {1.3333333333333335, 0.0}, 1e-15);
    expect_near(core::point_at(double_seam, 0.8), {2.314666666666667, 1.28}, 1e-15);
    expect_near(core::point_at(double_seam, 3.6), {0.5893333333333335, 0.21333333333333326}, 1e-15);
    const Curve& circle = curve_in(found, 2);
    EXPECT_EQ(circle.degree(), 13);
    for (int i = 0; i <= 8; ++i) EXPECT_NEAR(core::distance(at_share(circle, i / 8.0), {1, 2}), 3.0, 1e-7);
    expect_near(at_share(curve_in(found, 3), 0.55), {2.8011498140006768, 1.167399391274941}, 1e-15);
}

}  // namespace batten::exchange
