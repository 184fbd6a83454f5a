/// The text input that a field of the inspector turns into while it is being typed.
#pragma once

#include <imgui.h>

#include <optional>
#include <string>

#include "app/ui/panels.h"

namespace batten::ui {

/// Makes `id` the field that is typed, with the whole of `text` selected.
void begin_typing(FieldState& field, unsigned id, std::string text);

bool is_typing(const FieldState& field, unsigned id);

/// Whether the key went down in this frame.
bool is_pressed(const PanelContext& context, editor::Key key);

/// How the frame left the input.
enum class TypingStep {
    goes_on,
    ended,    ///< by Tab or by losing the keyboard: the text counts
    entered,  ///< by Enter: the text counts
    escaped   ///< the text does not count
};

/// Draws the input of the typed field at the cursor. All but goes_on end the typing; the text stays in
/// FieldState::typed.
TypingStep draw_typing(const PanelContext& context, ImVec2 size);

/// Notes why the typed text of field `id` could not be used.
void set_problem(FieldState& field, unsigned id, std::string sentence);

/// Shows the problem of field `id`, if it has one, below the last item and reports it as "field problem". It goes with
/// the next click.
void draw_problem(const PanelContext& context, unsigned id);

/// A field for text: shows `shown`; a click turns it into an input of the full text.
struct TextField {
    std::string name;
    std::string shown;
    float width_px = 0.0F;
    double height = 24.0;  ///< design pixels
    ImFont* font = nullptr;
    bool is_enabled = true;
    bool has_frame = true;
    bool needs_double_click = false;
    std::string tooltip = {};
};

/// What happened to a text field in this frame.
struct TextEvents {
    bool is_clicked = false;  ///< once, and not to type
    bool begins = false;      ///< the caller gives the full text with begin_typing(state, id, text)
    unsigned id = 0;
    std::optional<std::string> typed;  ///< the new text, when it was changed
};
TextEvents draw_text_field(const PanelContext& context, const TextField& field);

}  // namespace batten::ui
