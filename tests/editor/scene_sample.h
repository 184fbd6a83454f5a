/// States to draw, and ways to find things in what was drawn.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "app/editor/scene/canvas_scene.h"
#include "app/editor/scene/plot_scene.h"
#include "app/editor/state/state.h"
#include "render/draw_list.h"
#include "render/pixel_box.h"

namespace batten::editor::test {

/// The cubic example with weight 2 at point 5 and u = 0.4, seen in a picture of 1048 x 566 pixels at 66 pixels a unit.
EditorState sample_state();

/// A state that shows `definition`, which must be valid, in the same picture.
EditorState scene_state(core::CurveDefinition definition);

/// Points all over a rectangle of this extent about the origin, always the same.
std::vector<core::Point> scattered_points(std::size_t count, core::Vector extent);

/// The picture of the canvas, with nothing kept from another one.
render::DrawList canvas_picture(const EditorState& state, const CanvasMode& mode = CanvasIdle{});

/// Where a place of the world is in it.
glm::dvec2 screen(const EditorState& state, core::Point place);

/// The theme of the states.
Theme dark();

/// Of the dock below that picture.
constexpr glm::dvec2 dock_size{1048.0, 260.0};

/// The picture of the dock, with nothing kept from another one.
render::DrawList plot_picture(const EditorState& state, const PlotMode& mode = PlotIdle{},
                              glm::dvec2 size_px = dock_size);

/// The same state on a screen of twice the density.
EditorState doubled(EditorState state);

template <class Command>
std::vector<Command> all_of(const render::DrawList& list) {
    std::vector<Command> found;
    for (const render::DrawCommand& command : list.commands)
        if (const auto* wanted = std::get_if<Command>(&command)) found.push_back(*wanted);
    return found;
}

std::vector<render::Polyline> lines_of(const render::DrawList& list, render::Color color, float width_px);
std::vector<render::Marker> markers_of(const render::DrawList& list, render::MarkerShape shape, float radius_px);
std::vector<std::string> texts_of(const render::DrawList& list);
bool has_text(const render::DrawList& list, const std::string& text);

/// The least distance of `place` from any of the lines.
double distance_to(const std::vector<render::Polyline>& lines, glm::dvec2 place);

/// About where a label is.
render::PixelBox box_of(const render::Label& label);

/// Pairs of labels whose boxes overlap.
std::vector<std::string> overlapping_labels(const render::DrawList& list);

/// What is wrong with the numbers of a picture: not finite, farther than `margin_px` outside of it, of a size that is
/// not positive.
std::vector<std::string> faults_of(const render::DrawList& list, glm::dvec2 size_px, double margin_px);

}  // namespace batten::editor::test
