#include "app/ui/example_list.h"

#include <imgui.h>

#include <algorithm>
#include <filesystem>

#include "app/editor/example_files.h"
#include "app/ui/style.h"
#include "core/document/native_file.h"
#include "core/evaluate/tessellate.h"

namespace batten::ui {

namespace {

/// Finer than a pixel of any thumbnail.
constexpr double relative_tolerance = 1e-3;

core::Box box_of(const core::Document& document) {
    core::Box box;
    for (const core::DocumentCurve& item : document.curves) {
        for (const core::Point& point : item.curve->control_points()) box.include(point);
    }
    return box;
}

std::vector<std::vector<core::Point>> lines_of(const core::Document& document, const core::Box& box) {
    std::vector<std::vector<core::Point>> lines;
    const double tolerance = relative_tolerance * std::max({box.size().x, box.size().y, 1e-300});
    for (const core::DocumentCurve& item : document.curves) {
        if (!item.visible) continue;
        for (const auto& run : core::tessellate(*item.curve, {tolerance, box, item.curve->domain()})) {
            std::vector<core::Point>& line = lines.emplace_back();
            for (const core::CurveSample& sample : run) line.push_back(sample.point);
        }
    }
    return lines;
}

std::vector<Example> read_examples(const std::filesystem::path& folder) {
    std::vector<Example> examples;
    for (const std::filesystem::path& file : editor::example_files(folder)) {
        const auto document = core::load_document(file);
        if (!document || document->curves.empty()) continue;
        const core::Box box = box_of(*document);
        examples.push_back({file.stem().string(), *document, lines_of(*document, box), box});
    }
    return examples;
}

/// From the plane of an example to the pixels of its thumbnail.
class Fit {
  public:
    Fit(const core::Box& box, const Rectangle& place)
        : world_(box.center()), screen_(place.origin_px + 0.5 * place.size_px) {
        const core::Vector size(std::max(box.size().x, 1e-300), std::max(box.size().y, 1e-300));
        scale_ = std::min(place.size_px.x / size.x, place.size_px.y / size.y);
    }
    ImVec2 operator()(core::Point p) const {
        const glm::vec2 pixel(screen_ + scale_ * glm::dvec2(p - world_) * glm::dvec2(1.0, -1.0));
        return {pixel.x, pixel.y};
    }

  private:
    core::Point world_;
    glm::dvec2 screen_;
    double scale_ = 1.0;
};

void draw_line(const std::vector<ImVec2>& points, render::Color color, float width_px) {
    ImGui::GetWindowDrawList()->AddPolyline(points.data(), static_cast<int>(points.size()), imgui_packed(color), 0,
                                            width_px);
}

void draw_polygon(const PanelContext& context, const core::Curve& curve, const Fit& fit) {
    std::vector<ImVec2> points;
    for (const core::Point& point : curve.control_points()) points.push_back(fit(point));
    if (curve.is_periodic()) points.push_back(points.front());
    draw_line(points, context.theme.polygon, context.px(1));
    for (std::size_t i = 0; i < curve.control_points().size(); ++i) {
        ImGui::GetWindowDrawList()->AddCircleFilled(points[i], context.px(2.5), imgui_packed(context.theme.point(i)));
    }
}

}  // namespace

const std::vector<Example>& examples_of(const PanelContext& context) {
    std::optional<std::vector<Example>>& examples = context.panels.examples;
    if (!examples) examples = read_examples(context.state.desktop.examples);
    return *examples;
}

std::string title_of(const Example& example) {
    return example.document.title.empty() ? example.name : example.document.title;
}

void draw_thumbnail(const PanelContext& context, const Example& example, const Rectangle& place) {
    const Fit fit(example.box, place);
    for (const core::DocumentCurve& item : example.document.curves) {
        if (item.visible) draw_polygon(context, *item.curve, fit);
    }
    for (const std::vector<core::Point>& line : example.lines) {
        std::vector<ImVec2> points;
        for (const core::Point& point : line) points.push_back(fit(point));
        draw_line(points, context.theme.curve, context.px(2));
    }
}

}  // namespace batten::ui
