#include "tests/editor/scene_sample.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/editor/scene/text_size.h"
#include "tests/editor/pointer_driver.h"

namespace batten::editor::test {

namespace {

double distance_to_segment(glm::dvec2 a, glm::dvec2 b, glm::dvec2 place) {
    const glm::dvec2 along = b - a;
    const double squared = glm::dot(along, along);
    const double t = squared > 0.0 ? std::clamp(glm::dot(place - a, along) / squared, 0.0, 1.0) : 0.0;
    return glm::distance(place, a + t * along);
}

/// By more than a rounding of floats.
bool overlap(const render::PixelBox& a, const render::PixelBox& b) {
    constexpr double slack = 0.01;
    return a.lower_px.x + slack < b.upper_px.x && b.lower_px.x + slack < a.upper_px.x &&
           a.lower_px.y + slack < b.upper_px.y && b.lower_px.y + slack < a.upper_px.y;
}

/// Collects the faults of one command after the other.
struct FaultFinder {
    glm::dvec2 size_px;
    double margin_px;
    std::vector<std::string> faults;

    void check_place(const char* what, render::Pixel place) {
        const bool is_near = place.x >= -margin_px && place.y >= -margin_px && place.x <= size_px.x + margin_px &&
                             place.y <= size_px.y + margin_px;
        if (!is_near)
            faults.push_back(std::string(what) + " at " + std::to_string(place.x) + ", " + std::to_string(place.y));
    }
    void check_size(const char* what, float size, bool may_be_zero) {
        const bool is_good = std::isfinite(size) && (size > 0.0F || (may_be_zero && size == 0.0F)) && size < 1e4F;
        if (!is_good) faults.push_back(std::string(what) + " of size " + std::to_string(size));
    }
    void operator()(const render::Polyline& line) {
        if (line.points.size() < 2) faults.emplace_back("line of one point");
        for (const render::Pixel place : line.points) check_place("line", place);
        check_size("width", line.width_px, false);
        check_size("dash", line.dash_px, true);
        check_size("gap", line.gap_px, true);
    }
    void operator()(const render::Fill& fill) {
        if (fill.points.size() < 3) faults.emplace_back("fill of two points");
        for (const render::Pixel place : fill.points) check_place("fill", place);
    }
    void operator()(const render::Ink& ink) {
        if (!ink.map || ink.map->size_px() != glm::ivec2(glm::ceil(size_px)))
            faults.emplace_back("ink of another size");
    }
    void operator()(const render::Region& region) { (*this)(render::Ink{region.map, region.color}); }
    void operator()(const render::ImageQuad& quad) {
        if (!quad.image || quad.image->width < 1) faults.emplace_back("image without pixels");
    }
    void operator()(const render::Marker& marker) {
        check_place("marker", marker.center);
        check_size("radius", marker.radius_px, false);
        check_size("outline", marker.outline_px, true);
    }
    void operator()(const render::Label& label) {
        check_place("label", label.position);
        check_size("text", label.size_px, false);
        if (label.text.find("nan") != std::string::npos) faults.push_back("label " + label.text);
    }
};

}  // namespace

render::PixelBox box_of(const render::Label& label) {
    const glm::dvec2 size = text_size(label.text, static_cast<double>(label.size_px), label.font);
    const glm::dvec2 place(label.position);
    const double share = label.anchor == render::Anchor::left     ? 0.0
                         : label.anchor == render::Anchor::center ? 0.5
                                                                  : 1.0;
    const glm::dvec2 lower{place.x - share * size.x, place.y - 0.5 * size.y};
    return {lower, lower + size};
}

EditorState scene_state(core::CurveDefinition definition) {
    EditorState state = state_with(std::move(definition));
    state.view.camera = {{0.0, 0.1}, 66.0, {1048.0, 566.0}};
    return state;
}

EditorState sample_state() {
    core::CurveDefinition definition = cubic();
    definition.weights = {1, 1, 1, 1, 1, 2, 1};
    EditorState state = scene_state(std::move(definition));
    state.view.parameter = 0.4;
    return state;
}

std::vector<core::Point> scattered_points(std::size_t count, core::Vector extent) {
    std::vector<core::Point> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double k = static_cast<double>(i);
        points.emplace_back(extent.x * (std::fmod(k * 0.6180339887, 1.0) - 0.5),
                            extent.y * (std::fmod(k * k * 0.4142135623, 1.0) - 0.5));
    }
    return points;
}

glm::dvec2 screen(const EditorState& state, core::Point place) {
    return render::screen_from_world(state.view.camera, place);
}

Theme dark() {
    return theme_of(ThemeName::dark);
}

render::DrawList canvas_picture(const EditorState& state, const CanvasMode& mode) {
    SceneCache cache;
    return canvas_scene(state, mode, cache);
}

render::DrawList plot_picture(const EditorState& state, const PlotMode& mode, glm::dvec2 size_px) {
    SceneCache cache;
    return plot_scene(state, mode, size_px, cache);
}

EditorState doubled(EditorState state) {
    state.view.interface_scale *= 2.0;
    state.view.camera.scale *= 2.0;
    state.view.camera.size_px *= 2.0;
    return state;
}

std::vector<render::Polyline> lines_of(const render::DrawList& list, render::Color color, float width_px) {
    std::vector<render::Polyline> lines = all_of<render::Polyline>(list);
    std::erase_if(lines,
                  [&](const render::Polyline& line) { return line.color != color || line.width_px != width_px; });
    return lines;
}

std::vector<render::Marker> markers_of(const render::DrawList& list, render::MarkerShape shape, float radius_px) {
    std::vector<render::Marker> markers = all_of<render::Marker>(list);
    std::erase_if(markers,
                  [&](const render::Marker& marker) { return marker.shape != shape || marker.radius_px != radius_px; });
    return markers;
}

std::vector<std::string> texts_of(const render::DrawList& list) {
    std::vector<std::string> texts;
    for (const render::Label& label : all_of<render::Label>(list)) texts.push_back(label.text);
    return texts;
}

bool has_text(const render::DrawList& list, const std::string& text) {
    const std::vector<std::string> texts = texts_of(list);
    return std::find(texts.begin(), texts.end(), text) != texts.end();
}

double distance_to(const std::vector<render::Polyline>& lines, glm::dvec2 place) {
    double least = 1e300;
    for (const render::Polyline& line : lines)
        for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
            least = std::min(least, distance_to_segment(line.points[i], line.points[i + 1], place));
    return least;
}

std::vector<std::string> overlapping_labels(const render::DrawList& list) {
    const std::vector<render::Label> labels = all_of<render::Label>(list);
    std::vector<std::string> pairs;
    for (std::size_t i = 0; i < labels.size(); ++i)
        for (std::size_t j = i + 1; j < labels.size(); ++j)
            if (overlap(box_of(labels[i]), box_of(labels[j]))) pairs.push_back(labels[i].text + " / " + labels[j].text);
    return pairs;
}

std::vector<std::string> faults_of(const render::DrawList& list, glm::dvec2 size_px, double margin_px) {
    FaultFinder finder{size_px, margin_px, {}};
    for (const render::DrawCommand& command : list.commands) std::visit(finder, command);
    return finder.faults;
}

}  // namespace batten::editor::test
