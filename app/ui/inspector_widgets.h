/// The small widgets of the inspector: texts, buttons, check boxes; each reports its place.
#pragma once

#include <imgui.h>

#include <string>

#include "app/editor/command_spec.h"
#include "app/ui/panels.h"

namespace batten::ui {

/// A text on one line of rich_text notation.
struct TextLine {
    std::string text;
    ImFont* font = nullptr;
    double size = 0.0;  ///< design pixels; 0: as the font was loaded
    render::Color color;
    render::Anchor anchor = render::Anchor::left;
    float most_px = 0.0F;   ///< the text is shrunk to this width, then cut; 0: any width
    bool is_typed = false;  ///< by a person; all others are shown in the notation
};

/// Draws the line centered vertically on `position` (window pixels), which is its left end, center or right end.
/// Returns its width.
float draw_text(const PanelContext& context, ImVec2 position, const TextLine& line);

/// For a text that is drawn cut or shortened between these corners: all of it as a tool tip while the pointer is there.
void show_cut_text(const PanelContext& context, const std::string& text, ImVec2 lower, ImVec2 upper);

/// Reports the last Dear ImGui item under `name`, as far as it is in sight.
void report_item(const PanelContext& context, std::string name, std::string value = {});

/// Shows `text` to the left of the current window, or right of it where there is no room, while the last item is
/// hovered, in the notation. Nothing for an empty text.
void show_tooltip(const PanelContext& context, const std::string& text);

/// The same for a text that a person typed, as names of files are.
void show_typed_tooltip(const PanelContext& context, const std::string& text);

/// The background of a field from `origin`, lit when hovered.
void draw_field_frame(const PanelContext& context, ImVec2 origin, ImVec2 size, bool is_lit);

/// What can be drawn on a button instead of a text.
enum class Icon { none, play, pause, ping_pong, jump_back, eye, closed_eye, lock, open_lock, plus, minus };

void draw_icon(const PanelContext& context, ImVec2 center, Icon icon, render::Color color);

struct Button {
    std::string name;  ///< of its place; unique in the window
    std::string text;  ///< rich text
    Icon icon = Icon::none;
    float width_px = 0.0F;
    double height = 24.0;  ///< design pixels
    bool is_active = false;
    bool is_enabled = true;
    bool has_frame = true;
    bool is_small = false;  ///< the text
    render::Anchor anchor = render::Anchor::center;
    std::string tooltip = {};
};

/// Returns whether it was clicked while enabled.
bool draw_button(const PanelContext& context, const Button& button);

/// A button that runs a command; explanation, shortcut, effect on the shape and refusal come from its description.
void draw_command_button(const PanelContext& context, Button button, const editor::Command& command);

/// The same for a command with what suggests itself.
void draw_command_button(const PanelContext& context, Button button, const editor::CommandSpec& spec);

/// A field with one of a few choices.
struct ChoiceField {
    std::string name;  ///< of its place; unique in the window
    std::string text;  ///< of the present choice
    float width_px = 0.0F;
    bool is_enabled = true;
    std::string tooltip = {};
    bool opens_upward = false;  ///< at the lower edge of a window
    float top_px = 0.0F;        ///< of the window, above which what opens upward does not reach
};

/// Draws the field; a click opens the list below it, or above. Returns whether that is open: then draw its choices, and
/// end it.
bool begin_choices(const PanelContext& context, const ChoiceField& field);
void end_choices();

/// A line of the list, as wide as the field, of which the button has the width. Returns whether it was clicked, which
/// closes the list.
bool draw_choice(const PanelContext& context, Button button);

/// A box with a tick and a text beside it, `width_px` wide in all. Returns whether it was clicked.
bool draw_check_box(const PanelContext& context, const Button& button);

}  // namespace batten::ui
