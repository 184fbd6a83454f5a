/// The frames of an animation, each as a picture of its own.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

#include "app/cli/figure_order.h"
#include "app/editor/scene/label_spots.h"
#include "core/document/document.h"
#include "render/figure.h"

namespace batten::cli {

/// A picture of `document`, whose active curve is the one that is meant, and of each frame of its motion. A figure that
/// stands still has one frame.
class FigureFrames {
  public:
    /// Refused where a parameter or a knot is not one of the curve.
    static tl::expected<FigureFrames, std::string> make(const core::Document& document, const FigureOrder& order);

    /// The picture when `share`, from 0 to 1, of the motion is done. Its labels stay where they stood beside their
    /// points in the picture that was asked for before, as long as they have room there.
    render::Figure at(double share);

    /// What must be known of all frames; empty for most.
    const std::string& note() const { return note_; }

  private:
    explicit FigureFrames(FigureOrder order) : order_(std::move(order)) {}

    editor::EditorState with_curve(const core::Curve& curve) const;

    FigureOrder order_;
    core::Document document_;
    editor::EditorState posed_;
    editor::LabelSpots spots_;
    std::string note_;
};

}  // namespace batten::cli
