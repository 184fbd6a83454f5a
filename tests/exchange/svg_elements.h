/// Elements of SVG, and what is read of them.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "exchange/svg/svg_reader.h"

namespace batten::exchange {

/// In a file whose baseline is 0, so that y is turned over and no more.
inline std::string drawing_of_paths(const std::string& elements) {
    return R"(<svg xmlns="http://www.w3.org/2000/svg" xmlns:batten="urn:batten" batten:baseline="0">)" + elements +
           "</svg>";
}

inline Imported read_elements(const std::string& elements) {
    auto imported = read_svg(drawing_of_paths(elements));
    EXPECT_TRUE(imported) << (imported ? "" : imported.error().sentence());
    return imported ? *std::move(imported) : Imported{};
}

inline core::Curve curve_of(const Imported& imported, std::size_t index = 0) {
    return *imported.document.curves.at(index).curve;
}

inline std::vector<core::Point> points_of(const core::Curve& curve) {
    return {curve.control_points().begin(), curve.control_points().end()};
}

inline void expect_near(core::Point found, core::Point expected, double tolerance = 1e-12) {
    EXPECT_NEAR(found.x, expected.x, tolerance);
    EXPECT_NEAR(found.y, expected.y, tolerance);
}

}  // namespace batten::exchange
