/// The panels and what they share while a frame is drawn.
#pragma once

#include "app/editor/command.h"
#include "app/editor/state/state.h"
#include "app/ui/fonts.h"
#include "app/ui/frame.h"
#include "app/ui/panel_state.h"

namespace batten::ui {

/// Given to every panel: read the state, ask through the queue, report places of widgets.
struct PanelContext {
    const editor::EditorState& state;
    const Fonts& fonts;
    editor::Theme theme;
    double scale;  ///< window pixels per design pixel
    editor::CommandQueue& queue;
    PanelState& panels;
    std::vector<WidgetPlace>& widgets;
    const FrameInput& input;

    float px(double design_px) const { return static_cast<float>(design_px * scale); }

    /// A text of the program's, not of a person's, as it is shown.
    std::string notated(const std::string& text) const { return editor::notated(text, state.view.notation); }
};

// Around the canvas; each fills the rectangle that it is given.
void draw_menu_bar(const PanelContext& context, const Rectangle& place);
void draw_tool_bar(const PanelContext& context, const Rectangle& place);
void draw_status_bar(const PanelContext& context, const Rectangle& place, const std::string& hint,
                     double frames_per_second);
void draw_inspector(const PanelContext& context, const Rectangle& place);

/// The line with the document's title and sentence; nothing in a place of no height.
void draw_title_line(const PanelContext& context, const Rectangle& place);

/// The height in window pixels that this line needs above `canvas`; 0 where it is not shown.
double title_line_height(const PanelContext& context, const Rectangle& canvas);

/// The step of the lesson that is being taken, in the place of the title; nothing where there is none.
void draw_lesson_line(const PanelContext& context, const Rectangle& place);

/// The height in window pixels that it needs in a place of the width of `room_px`, of which it takes a part of the
/// height at most; 0 where no lesson is taken.
double lesson_line_height(const PanelContext& context, glm::dvec2 room_px);

/// What a measuring command found, at the end of the inspector; nothing in a place of no height.
void draw_findings_panel(const PanelContext& context, const Rectangle& place);

/// The height in window pixels that the findings need of an inspector at `place`; 0 where there are none.
double findings_height(const PanelContext& context, const Rectangle& place);

/// The rulers, which fill what `rulers` is larger than `canvas`; nothing while they are hidden.
void draw_rulers(const PanelContext& context, const Rectangle& rulers, const Rectangle& canvas);

/// The cards of the teaching views, one below the other; nothing in a place of no width.
void draw_cards_panel(const PanelContext& context, const Rectangle& place);

/// The same in a window on the canvas that can be moved and resized, for a projector.
void draw_floating_cards(const PanelContext& context, const Rectangle& canvas);

/// What a projector shows beside: a halo around the pointer, and in the line at `place` what the last action did, the
/// keys, and at first how to get at what is hidden. Nothing while there is none.
void draw_presenting(const PanelContext& context, const Rectangle& place);

// Sections of the inspector, drawn one below the other.
void draw_curves_section(const PanelContext& context);
void draw_pictures_section(const PanelContext& context);
void draw_curve_section(const PanelContext& context);
void draw_fit_points_section(const PanelContext& context);
void draw_points_section(const PanelContext& context);
void draw_knots_section(const PanelContext& context);
void draw_construction_section(const PanelContext& context);
void draw_show_section(const PanelContext& context);

// Over the canvas, drawn when the state says so.
void draw_notice(const PanelContext& context, const Rectangle& canvas);
void draw_welcome_screen(const PanelContext& context, const Rectangle& window);
void draw_file_dialog(const PanelContext& context, const Rectangle& window);
void draw_unsaved_dialog(const PanelContext& context, const Rectangle& window);
void draw_changed_file_dialog(const PanelContext& context, const Rectangle& window);
void draw_recovery_dialog(const PanelContext& context, const Rectangle& window);
void draw_command_form(const PanelContext& context, const Rectangle& window, const Rectangle& canvas);
void draw_command_palette(const PanelContext& context, const Rectangle& window);
void draw_key_sheet(const PanelContext& context, const Rectangle& window);
void draw_about_dialog(const PanelContext& context, const Rectangle& window);
void draw_work_dialog(const PanelContext& context, const Rectangle& window, const Rectangle& canvas);

}  // namespace batten::ui
