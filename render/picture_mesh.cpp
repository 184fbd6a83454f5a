#include "render/picture_mesh.h"

namespace batten::render {
namespace {

class PictureBuilder {
  public:
    PictureBuilder(PictureMesh& picture, const PixelBox& visible, double scale)
        : picture_(picture), visible_(visible), scale_(scale) {}

    void operator()(const Fill& fill) {
        const std::size_t first = picture_.fills.indices.size();
        append_fill(picture_.fills, fill, visible_, scale_);
        add_run(RunKind::fill, first, picture_.fills.indices.size());
    }

    void operator()(const Polyline& line) {
        const std::size_t first = picture_.strokes.indices.size();
        const StrokeOverlap overlap = append_stroke(picture_.strokes, line, visible_, scale_);
        const RunKind kind = overlap == StrokeOverlap::darkens ? RunKind::stroke_once : RunKind::stroke;
        add_run(kind, first, picture_.strokes.indices.size());
    }

    void operator()(const Region& region) { (*this)(Ink{region.map, region.color}); }

    void operator()(const Ink& ink) {
        const std::size_t first_fill = picture_.fills.indices.size();
        const std::size_t first = picture_.inks.indices.size();
        append_ink(picture_.fills, picture_.inks, ink, scale_);
        add_run(RunKind::fill, first_fill, picture_.fills.indices.size());
        if (picture_.inks.indices.size() > first) picture_.maps.push_back(ink.map);
        add_run(RunKind::ink, first, picture_.inks.indices.size());
    }

    void operator()(const ImageQuad& quad) {
        const std::size_t first = picture_.image_parts.indices.size();
        append_image(picture_.image_parts, quad, visible_, scale_);
        if (picture_.image_parts.indices.size() > first) picture_.images.push_back(quad.image);
        add_run(RunKind::image, first, picture_.image_parts.indices.size());
    }

    void operator()(const Marker& marker) {
        if (has_dashed_ring(marker)) {
            Marker disc = marker;
            disc.outline.alpha = 0;
            add_marker(disc);
            (*this)(dashed_ring(marker, scale_));
        } else {
            add_marker(marker);
        }
    }

    void operator()(const Label&) {}  // the interface's business

  private:
    void add_marker(const Marker& marker) {
        if (marker.fill.alpha == 0 && marker.outline.alpha == 0) return;
        const std::size_t first = picture_.markers.indices.size();
        append_marker(picture_.markers, marker, visible_, scale_);
        add_run(RunKind::marker, first, picture_.markers.indices.size());
    }

    void add_run(RunKind kind, std::size_t first, std::size_t end) {
        if (first == end) return;
        const auto count = static_cast<std::uint32_t>(end - first);
        std::vector<Run>& runs = picture_.runs;
        const bool is_single = kind == RunKind::stroke_once || kind == RunKind::ink || kind == RunKind::image;
        if (!runs.empty() && runs.back().kind == kind && !is_single) {
            runs.back().count += count;
        } else {
            runs.push_back({kind, static_cast<std::uint32_t>(first), count});
        }
    }

    PictureMesh& picture_;
    const PixelBox& visible_;
    double scale_;
};

}  // namespace

void build_picture(PictureMesh& picture, const DrawList& list, glm::ivec2 size_px, double scale) {
    picture.fills.clear();
    picture.strokes.clear();
    picture.inks.clear();
    picture.maps.clear();
    picture.image_parts.clear();
    picture.images.clear();
    picture.markers.clear();
    picture.runs.clear();
    const PixelBox visible{{0.0, 0.0}, glm::dvec2(size_px)};
    PictureBuilder builder(picture, visible, scale);
    for (const DrawCommand& command : list.commands) std::visit(builder, command);
}

}  // namespace batten::render
