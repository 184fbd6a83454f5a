/// The curves that are not the active one.
#pragma once

#include <memory>
#include <vector>

#include "app/editor/scene/kept_ink.h"
#include "core/curve/curve.h"
#include "render/draw_list.h"

namespace batten::editor {

struct CanvasFrame;

/// Curves that together have more places than the picture should have, as one map for each color.
struct OtherInk {
    struct Item {
        std::shared_ptr<const core::Curve> curve;
        render::Color color;

        bool operator==(const Item&) const = default;
    };

    InkPlace place;
    double tolerance_px = 0.0;
    std::vector<Item> items;
    std::vector<render::Ink> inks;  ///< in the order of the first curves of their colors; none when lines show all
};

/// A visible curve, by its place in the document, and the color that it gets.
struct CurveInColor {
    std::size_t index = 0;
    OtherInk::Item item;
};

/// What is painted of very many curves while a preview moves them.
enum class MovingInk { coarse, nothing };

/// The curves as lines `width` design pixels wide; where these have more places than the picture should have, as ink,
/// which stays in `kept`, and is less while a preview moves them. Cost: where these are the same curves in the same
/// view as the last time and in ink, that of finding so.
void draw_curves(CanvasFrame& frame, const std::vector<CurveInColor>& curves, double width, MovingInk moving,
                 OtherInk& kept);

/// All visible curves but the active one, thinner and dimmer than that; over them a hovered one at full strength. Cost:
/// that of draw_curves().
void draw_other_curves(CanvasFrame& frame);

}  // namespace batten::editor
