/// What closed curves enclose, filled.
#pragma once

#include <memory>
#include <vector>

#include "app/editor/scene/kept_ink.h"
#include "core/curve/curve.h"
#include "render/draw_list.h"

namespace batten::editor {

struct CanvasFrame;

/// The visible closed curves as regions, one for each color.
struct FilledShapes {
    struct Item {
        std::shared_ptr<const core::Curve> curve;
        render::Color color;

        bool operator==(const Item&) const = default;
    };

    InkPlace place;
    render::FillRule rule = render::FillRule::non_zero;
    std::vector<Item> items;
    std::vector<render::Region> regions;
};

/// What the visible closed curves enclose, curves of one color together, where one of the overlays of fills is shown.
/// Cost: where these are the same curves in the same view as the last time, that of finding so; else that of what is
/// seen of them.
void draw_filled_shapes(CanvasFrame& frame);

}  // namespace batten::editor
