/// A whole draw list as triangles, grouped into runs that one draw call each can paint.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "render/draw_list.h"
#include "render/fill_mesh.h"
#include "render/image_mesh.h"
#include "render/ink_mesh.h"
#include "render/marker_mesh.h"
#include "render/mesh.h"
#include "render/stroke_mesh.h"

namespace batten::render {

enum class RunKind {
    fill,
    stroke,
    stroke_once,  ///< a single translucent line that may cover a pixel twice and must not darken there
    ink,          ///< one map
    image,        ///< one image
    marker,
};

/// Consecutive commands of one kind: `count` indices from `first` in the mesh of that kind.
struct Run {
    RunKind kind{};
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

struct PictureMesh {
    Mesh<FillVertex> fills;
    Mesh<StrokeVertex> strokes;
    Mesh<InkVertex> inks;
    std::vector<std::shared_ptr<const CoverageMap>> maps;  ///< in the order of the runs that show them
    Mesh<ImageVertex> image_parts;
    std::vector<std::shared_ptr<const Image>> images;  ///< likewise
    Mesh<MarkerVertex> markers;
    std::vector<Run> runs;  ///< in the order of painting
};

/// Rebuilds `picture` from `list`, enlarged by `scale`, for a viewport of `size_px` framebuffer pixels. What lies
/// outside is left out. Keeps the memory of the frame before.
void build_picture(PictureMesh& picture, const DrawList& list, glm::ivec2 size_px, double scale);

}  // namespace batten::render
