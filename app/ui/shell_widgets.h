/// Small parts of the frame and the dialogs: panel windows, buttons with a label, tool tips, shortened texts.
#pragma once

#include <string>

#include "app/ui/panels.h"

namespace batten::ui {

/// Begins a window without decoration that fills `place`; end_panel() must follow. `window_flags` are ImGuiWindowFlags
/// to add.
void begin_panel(const char* name, const Rectangle& place, int window_flags = 0);
void end_panel();

/// Where the last Dear ImGui item is.
Rectangle last_item_place();

/// A line of the theme's line color in the current window.
void draw_edge(const PanelContext& context, glm::dvec2 from, glm::dvec2 to);

/// What a button looks like: `primary` is the one that Enter stands for.
enum class ButtonLook { plain, primary, quiet };

/// A button as wide as its label needs, reported as `name`. Returns whether it was clicked.
bool draw_label_button(const PanelContext& context, const std::string& name, const char* label,
                       ButtonLook look = ButtonLook::plain);

/// The width of such a button.
float label_button_width(const PanelContext& context, const char* label);

/// A button that shows a cross, `size_px` wide and high, reported as `name`.
bool draw_cross_button(const PanelContext& context, const std::string& name, float size_px);

/// A tool tip with `text`, wrapped, whose point `pivot` (0..1 of its width and height) is at `position`, or as near as
/// the window allows.
void draw_tooltip_at(const PanelContext& context, const std::string& text, glm::dvec2 position, glm::dvec2 pivot);

/// A tool tip with `text`, wrapped, to the right of the current window and level with the last item, so that it hides
/// none of the items below; to be called while the item is hovered.
void draw_side_tooltip(const PanelContext& context, const std::string& text);

/// The text in lines of at most this width, broken at spaces only, so that numbers stay whole; a longer word has a line
/// of its own.
std::string wrapped(const std::string& text, ImFont* font, float width_px);

/// The size of a text of one or several lines.
glm::vec2 lines_size(const std::string& text, ImFont* font);

/// Lets Ctrl+C copy `text`, in full, while the last item is hovered.
void offer_copy(const PanelContext& context, const std::string& text);

/// For the last item, which shows `message` with few digits: while it is hovered, all of them in a tool tip (as
/// draw_tooltip_at) and for Ctrl+C.
void offer_full_message(const PanelContext& context, const std::string& message, glm::dvec2 position, glm::dvec2 pivot);

/// The width of `text` in `font` as it was loaded.
float text_width(const std::string& text, ImFont* font);

/// `text`, its end replaced by "…" where it is wider than `width_px`.
std::string elided(const std::string& text, ImFont* font, float width_px);

/// Whether `key` went down in this frame with exactly these modifiers.
bool was_pressed(const PanelContext& context, editor::Key key, editor::Modifiers modifiers = {});

}  // namespace batten::ui
