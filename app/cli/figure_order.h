/// What the options of `batten figure` ask for.
#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <variant>

#include "app/cli/subcommands.h"
#include "app/editor/state/view.h"
#include "core/base/geometry.h"
#include "render/figure_file.h"

namespace batten::cli {

/// What changes from frame to frame.
struct RunningParameter {
    core::Interval range;  ///< from `lower` to `upper`, which may be less
};
struct InsertedKnot {
    double u = 0.0;
};
struct MergedKnot {
    std::size_t index = 0;  ///< among the stored knots; goes to the next one that is larger
};
using Motion = std::variant<RunningParameter, InsertedKnot, MergedKnot>;

enum class MovieFormat { gif, mp4 };

struct FigureOrder {
    std::variant<render::FigureFormat, MovieFormat> format;
    editor::FigureForm form;
    glm::dvec2 size_px{};
    editor::Overlays overlays;
    editor::PictureParts parts;
    bool has_pictures = false;  ///< those to draw by
    bool has_guides = false;
    editor::ThemeName theme = editor::ThemeName::light;
    std::optional<double> at;
    std::optional<Motion> motion;
    std::size_t frames = 50;
    double rate = 25.0;  ///< frames a second
};

/// The order that the words of `options` make; the error is a sentence about the first that cannot be read.
tl::expected<FigureOrder, std::string> read_order(const FigureOptions& options);

}  // namespace batten::cli
