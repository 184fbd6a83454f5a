/// How the document is looked at: camera, overlays, parameter, construction, theme. Not undone.
#pragma once

#include <array>
#include <bitset>
#include <optional>

#include "app/editor/state/brush.h"
#include "app/editor/state/figure.h"
#include "app/editor/state/joint_tool.h"
#include "app/editor/state/notation.h"
#include "app/editor/state/overlay.h"
#include "app/editor/state/pen_mode.h"
#include "app/editor/state/shape_kind.h"
#include "app/editor/state/shape_view.h"
#include "app/editor/state/shown_map.h"
#include "app/editor/state/snap_kind.h"
#include "app/editor/state/theme.h"
#include "core/base/geometry.h"
#include "core/base/names.h"
#include "core/edit/knot_edit.h"
#include "core/make/fit_stroke.h"
#include "render/camera.h"

namespace batten::editor {

/// What a press on the canvas does.
enum class Tool {
    select,
    add_point,
    insert_knot,
    weight,
    draw_curve,
    parameter,
    shape,
    pencil,
    joint,
    brush,
    transform
};
inline constexpr std::array all_tools{Tool::select,     Tool::add_point, Tool::insert_knot, Tool::weight,
                                      Tool::draw_curve, Tool::parameter, Tool::shape,       Tool::pencil,
                                      Tool::joint,      Tool::brush,     Tool::transform};

/// The parameter running by itself: t seconds move it by direction * speed * t / 5 of the domain's length. At an end it
/// turns, or jumps to the other end, and goes on by what is left of the way.
struct Playback {
    bool is_playing = false;
    double speed = 0.5;     ///< fifths of the domain per second: 1 crosses the domain in five seconds
    bool ping_pong = true;  ///< turns at the ends instead of jumping back
    int direction = 1;      ///< +1 or -1
};

/// What sizes of the interface may be, in design pixels; the user's scale is a factor.
inline constexpr core::Interval inspector_widths{240.0, 800.0};
inline constexpr core::Interval cards_widths{240.0, 900.0};
inline constexpr core::Interval dock_heights{120.0, 800.0};
inline constexpr core::Interval user_scales{0.5, 3.0};

/// How much larger everything is for a projector.
inline constexpr double presenting_scale = 1.5;

/// The corners of the canvas, in the order in which the legend prefers them.
enum class Corner { lower_left, lower_right, upper_left, upper_right };
inline constexpr std::array all_corners{Corner::lower_left, Corner::lower_right, Corner::upper_left,
                                        Corner::upper_right};

/// What resizing the canvas goes back to, so that a smaller canvas shows no less, and a larger one again the same.
struct Framing {
    std::optional<render::Camera> fitted;   ///< as fitting made it; while it is the camera, resizing fits anew
    std::optional<render::Camera> resized;  ///< as resizing made it; while it is the camera, resizing begins at:
    render::Camera chosen;                  ///< as it was chosen last
};

/// From where the lifted curve is seen.
struct Orbit {
    double yaw = -0.5;   ///< radians; see render::OrbitCamera
    double pitch = 0.4;  ///< likewise
    double zoom = 1.0;   ///< within orbit_zooms, 1 where all of it is seen
    bool operator==(const Orbit&) const = default;
};
inline constexpr core::Interval orbit_zooms{0.25, 16.0};

struct View {
    render::Camera camera;
    Framing framing;
    bool fits_on_open = true;
    Corner legend_corner = Corner::lower_left;
    Overlays overlays;
    PictureParts parts;
    Notation notation;            ///< as it is shown
    Notation usual_notation;      ///< of documents that choose none
    double parameter = 0.0;       ///< as set; shown clamped to the domain of the shown curve
    std::optional<int> level;     ///< the last construction level drawn; none: all up to C(u)
    bool blossom_values = false;  ///< blossoms by the values of their knots, else by the indices
    Playback playback;
    ShapeView shape;
    Orbit orbit;
    std::optional<core::Interval> plot_range;  ///< the parameters that the plot shows; none: all knots
    ShownMap shown_map;                        ///< of the view of invariance
    std::bitset<5> hidden_answers;             ///< to the questions about knots, by KnotQuestion
    int smoothness = core::usual_smoothness;   ///< of the next stroke of the pencil
    core::KnotMove knot_move = core::KnotMove::snap;
    PenMode pen_mode = PenMode::through_c2;
    SnapSettings snap;
    ShapeKind shape_kind = ShapeKind::line;  ///< what the shape tool draws
    std::size_t polygon_sides = 6;           ///< of its polygons
    JointTool joint;
    Brush brush;
    ThemeName theme = ThemeName::dark;
    double interface_scale = 1.0;  ///< pixels of the window per design pixel, from display and user together
    double user_scale = 1.0;       ///< the user's part of it, within user_scales
    double cards_width = 360.0;    ///< of the column of cards, within cards_widths
    bool inspector_is_open = true;
    bool dock_is_open = true;
    bool title_is_open = true;       ///< the line with the document's title and sentence, where it has any
    double inspector_width = 340.0;  ///< within inspector_widths
    double dock_height = 260.0;      ///< within dock_heights
    bool is_presenting = false;      ///< for a projector: only the canvas and the dock, larger, on the whole screen
    bool keys_are_shown = false;     ///< the keys that were pressed last, while presenting
};

/// Whether the plot stands below the canvas: where it is unfolded and the drawing mode does not hide it.
inline bool shows_dock(const View& view) {
    return view.dock_is_open && !view.overlays.is_drawing();
}

/// The colors in which everything is shown: of high contrast for a projector.
inline Theme shown_theme(const View& view) {
    return view.is_presenting || view.parts.high_contrast ? high_contrast(view.theme) : theme_of(view.theme);
}

}  // namespace batten::editor

namespace batten::core {

template <>
struct Names<editor::Tool> {
    using enum editor::Tool;
    static constexpr std::array table{Named{select, "select", "select"},
                                      Named{add_point, "add-point", "add points"},
                                      Named{insert_knot, "insert-knot", "insert knots"},
                                      Named{weight, "weight", "change weights"},
                                      Named{draw_curve, "draw-curve", "draw a curve"},
                                      Named{parameter, "parameter", "move the parameter"},
                                      Named{shape, "shape", "draw a shape"},
                                      Named{pencil, "pencil", "draw with the pencil"},
                                      Named{joint, "joint", "join curves"},
                                      Named{brush, "brush", "brush over a curve"},
                                      Named{transform, "transform", "scale and turn"}};
};

}  // namespace batten::core
