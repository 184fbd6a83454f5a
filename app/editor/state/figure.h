/// What a figure shows: a picture for a slide or a paper, of the same scene as the window.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "core/base/names.h"

namespace batten::editor {

/// What pictures of the canvas and the plot hold beside what overlays show. A window shows all of it, a figure what was
/// asked for.
struct PictureParts {
    bool points = true;          ///< the control points
    bool names = true;           ///< what control points are called, among the labels
    bool parameter = true;       ///< C(u) on the curve, and u in the plot
    bool legend = true;          ///< what the colors of the construction mean
    bool arrow = true;           ///< which way the active curve runs, where no other arrows tell it
    bool window = true;          ///< what a window tells of itself: how many marks are left out, room for its cards
    bool high_contrast = false;  ///< the colors are those for a projector even where nothing is presented
    double fineness = 1.0;       ///< how many times as many places a curved line has as pixels need, >= 1
};

/// The fineness of pictures that will be enlarged: at sixteen times the size lines are as true as on a screen.
inline constexpr double fineness_to_enlarge = 4.0;

enum class FigureView { curve, basis, both, homogeneous };

enum class FigureTheme { light, dark, high_contrast };

/// A figure that is asked for.
struct FigureForm {
    FigureView view = FigureView::curve;
    double scale = 1.0;                  ///< pixels of a PNG for each of the picture, > 0; other formats have no pixels
    double fineness = 1.0;               ///< of PictureParts; more for formats without pixels
    bool is_transparent = false;         ///< without the ground
    std::string title{};                 ///< set above; empty: none
    std::optional<FigureTheme> theme{};  ///< the colors; none: those of the view
    std::optional<glm::dvec2> size_px{};  ///< of a figure of the window, > 0, in design pixels; none: as on the screen
};

}  // namespace batten::editor

namespace batten::core {

template <>
struct Names<editor::FigureView> {
    using enum editor::FigureView;
    static constexpr std::array table{Named{curve, "curve", "the curve"},
                                      Named{basis, "basis", "its basis functions and knots"},
                                      Named{both, "both", "both, one above the other"},
                                      Named{homogeneous, "homogeneous", "the lifted curve in space"}};
};

template <>
struct Names<editor::FigureTheme> {
    using enum editor::FigureTheme;
    static constexpr std::array table{Named{light, "light", "light"}, Named{dark, "dark", "dark"},
                                      Named{high_contrast, "high-contrast", "high contrast"}};
};

}  // namespace batten::core
