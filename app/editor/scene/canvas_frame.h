/// What all parts of the canvas are drawn from: the state, the active curve, colors, and where the world is in the
/// picture.
#pragma once

#include <optional>
#include <vector>

#include "app/editor/pointer/highlight.h"
#include "app/editor/scene/label_layout.h"
#include "app/editor/scene/pen.h"
#include "app/editor/scene/scene_cache.h"
#include "app/editor/scene/seen_line.h"
#include "app/editor/state/state.h"
#include "core/evaluate/de_boor.h"

namespace batten::editor {

/// Where `camera` shows a point, finite whatever the point: coordinates beyond 1e30 pixels stop there.
glm::dvec2 shown_place(const render::Camera& camera, core::Point world);

/// A part of a label in a style of its own.
struct LabelWord {
    std::string text;
    TextStyle style;
};

/// A label that a view asks for beside `place`; it gets a free place once everything is drawn.
struct WishedLabel {
    glm::dvec2 place{};
    std::vector<LabelWord> words;
    double distance = 9.0;  ///< design pixels
    LabelSide first = LabelSide::upper_right;
    Crowding crowding = Crowding::leave_out;
    double farthest = 0.0;    ///< where there is no room at `distance`, up to this one
    bool has_ground = false;  ///< what runs below it is faint
};

/// One picture of the canvas while it is drawn.
struct CanvasFrame {
    CanvasFrame(const EditorState& shown_state, SceneCache& scene_cache, render::DrawList& list);

    const EditorState& state;
    SceneCache& cache;
    Theme theme;
    Pen pen;
    const core::Curve* curve = nullptr;  ///< the active curve; null when there is none or it is hidden
    KeptCurve* kept = nullptr;           ///< of the active curve; null with it
    Highlight lit;
    std::optional<core::DeBoorTriangle> triangle;  ///< at the view's parameter; there when the curve is
    SeenLine curve_line;                           ///< the active curve as far as it is seen
    std::vector<WishedLabel> labels;               ///< of views, in the order of their importance
    std::vector<render::PixelBox> covered;         ///< by views: where no label may stand
    std::vector<std::vector<glm::dvec2>> lines;    ///< drawn by views: labels stay off them where they can
    std::vector<glm::dvec2> marks;                 ///< of views: small ones that labels cover only where they must

    bool shows(Overlay overlay) const { return state.view.overlays.is_shown(overlay); }

    /// The place in the palette, for Theme::point(), of control point `i` of the active curve.
    std::size_t hue(std::size_t i) const;

    /// Whether control point `i` of the active curve is pinned.
    bool is_pinned(std::size_t i) const;

    /// No label may stand within `radius` design pixels of `place`, or of the way from `a` to `b`.
    void keep_free(glm::dvec2 place, double radius);
    void keep_free(glm::dvec2 a, glm::dvec2 b, double radius);

    /// The shown_place in the picture.
    glm::dvec2 screen(core::Point world) const;
    std::vector<glm::dvec2> screen(std::span<const core::Point> world) const;

    /// The world as far as it is seen, with `margin_px` pixels around the picture.
    core::Box seen(double margin_px) const;
};

/// How many marks are looked at one by one, to be thinned to what the picture can hold.
std::size_t most_candidates(const CanvasFrame& frame);

/// The span of the view's parameter; the frame must have a curve.
core::Interval active_span(const CanvasFrame& frame);

}  // namespace batten::editor
