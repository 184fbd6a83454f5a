/// What panels remember between frames.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/editor/command_spec.h"
#include "app/editor/fields/argument.h"
#include "app/editor/pointer/context_menu.h"
#include "app/editor/pointer/pointer.h"
#include "app/editor/state/overlay.h"
#include "app/editor/state/selection.h"
#include "app/ui/curve_rows.h"
#include "app/ui/file_dialog_state.h"
#include "app/ui/frame.h"
#include "core/document/document.h"

namespace batten::ui {

struct PaletteState {
    bool was_open = false;
    std::string typed;
    std::optional<std::string> replacement;  ///< for the text in the active field, which ImGui keeps to itself
    std::size_t chosen = 0;
    bool takes_focus = false;    ///< the field becomes the active one again in the next frame
    bool was_submitted = false;  ///< the command has run when the next frame begins
    std::string problem;         ///< why the typed command was refused
};

/// The form that asks for the fields of a command.
struct FormState {
    const editor::CommandSpec* spec = nullptr;
    std::vector<std::vector<std::string>> typed;       ///< a text for each part of each field
    std::vector<std::vector<editor::Argument>> begun;  ///< what suggests itself
    std::vector<std::vector<std::string>> initial;     ///< what suggests itself, with all digits; "+=2" changes it
    std::vector<std::vector<std::string>> shown;       ///< the same as it stood there at first, with a few digits
    std::vector<std::vector<std::string>> previewed;   ///< what the canvas shows
    bool takes_focus = true;                           ///< `focused`, else the first input, becomes the active one
    std::string focused;                               ///< the part whose input was active last
    std::string earlier_message;                       ///< what was told before the form, which is not of it
    bool was_previewed = false;
    bool was_tried = false;      ///< Apply or Enter was pressed
    bool was_submitted = false;  ///< the command has run when the next frame begins
    bool is_given_up = false;
    std::string problem;  ///< what is wrong with the fields
};

/// An example with its curves, from which the thumbnail is drawn.
struct Example {
    std::string name;  ///< the file's name without ".json"
    core::Document document;
    std::vector<std::vector<core::Point>> lines;  ///< the visible curves, as polylines
    core::Box box;                                ///< of lines and control points
};

/// A lesson as it is offered.
struct LessonEntry {
    std::string name;  ///< the file's name without ".json"
    std::string title;
};

/// One of the pictures that are painted below the interface.
enum class Picture { none, canvas, plot };

/// Which picture has the pointer.
struct PointerState {
    Picture hovered = Picture::none;
    Picture captured = Picture::none;  ///< where a button went down that is still held
    editor::PointerButton button = editor::PointerButton::none;
    std::optional<glm::dvec2> canvas_px;  ///< where on the canvas the pointer is
    glm::dvec2 last_canvas_px{};          ///< where it was there last
    bool space_is_held = false;
};

/// The field that is being edited: one at a time in the whole window.
struct FieldState {
    unsigned active_id = 0;  ///< 0: none
    int last_frame = 0;      ///< in which the active field was drawn; one that is out of sight is given up

    bool is_typing = false;
    std::string typed;
    std::string original;       ///< what typing began with
    int first_frame = 0;        ///< in which typing began; the key that led there does not end it
    bool has_keyboard = false;  ///< the text input needs a frame or two to get it
    int frames_waited = 0;      ///< for the keyboard

    bool is_dragging = false;
    bool is_given_up = false;  ///< Escape was pressed while the button is still held
    double start = 0.0;
    double dragged = 0.0;    ///< follows the pointer, unrounded
    double previewed = 0.0;  ///< last asked for

    bool begins_next = false;  ///< Tab: the next number field that is drawn begins typing
    unsigned wanted_id = 0;    ///< Shift+Tab: this one does
    unsigned previous_id = 0;  ///< the number field drawn last

    unsigned problem_id = 0;  ///< the field whose typed text could not be read
    std::string problem;
    int problem_frame = 0;  ///< in which it came up
};

/// What the pointer is over in inspector and cards.
struct PanelHover {
    std::optional<editor::Hover> wish;  ///< in this frame
    bool is_inside = false;             ///< the pointer is over one of them
    bool was_busy = false;              ///< an item was pressed or typed at the end of the last frame
    bool is_owner = false;              ///< the pointer was last over one of them
};

/// What the column of cards remembers.
struct CardsState {
    std::map<std::string, bool> open_cards;       ///< those that were folded or unfolded by hand
    std::map<editor::Overlay, float> heights_px;  ///< of the cards at `width_px`, as they were drawn last
    float width_px = 0.0F;
    std::vector<editor::Overlay> shown;     ///< the cards of the last frame
    std::optional<editor::Overlay> wanted;  ///< the card to be brought into view
    std::optional<Rectangle> placed;        ///< where on the canvas they were moved to by hand
};

/// What the list of curves remembers.
struct CurveListState {
    std::vector<CurveRow> rows;  ///< of this frame
    std::set<std::string> folded_groups;
    std::optional<CurveRow> dragged{};
    std::optional<std::size_t> slot{};    ///< the row before which it would be dropped
    bool is_given_up = false;             ///< a drag, while the button is still held
    std::optional<std::size_t> anchor{};  ///< the curve from which Shift selects
};

/// What the inspector remembers.
struct InspectorState {
    std::map<std::string, bool> open_sections;  ///< those that were folded or unfolded by hand
    std::vector<std::size_t> followed_points;   ///< the selection that the table was last scrolled to
    std::optional<std::size_t> followed_knot;
    CurveListState curves;
    std::optional<double> insert_at;    ///< none: at the current parameter
    std::optional<double> inserted_at;  ///< where Enter inserted a knot last
    std::optional<float> insert_row_y;  ///< of the row in the list of sections, while the pointer is on it
    float scroll_y = 0.0F;              ///< so far the sections may be scrolled though they end before
    float height_px = 0.0F;             ///< in which the sections were shown last
};

/// What a projector shows beside.
struct PresentingState {
    bool was_on = false;    ///< in the last frame
    bool has_hint = false;  ///< until something is done
    std::string keys{};     ///< that were pressed last, with what they do
};

/// What a right click asked for.
struct ContextMenuState {
    editor::MenuTarget target;
    bool opens = false;  ///< in this frame
};

/// Which answer to a dialog's question the keys have chosen.
struct AnswerState {
    editor::Dialog dialog = editor::Dialog::none;  ///< that asks
    std::size_t chosen = 0;
};

struct PanelState {
    FileDialogState file_dialog;
    PaletteState palette;
    AnswerState answer;
    std::size_t recovery_row = 0;  ///< the document that is chosen of those that can be recovered
    FormState form;
    FieldState field;
    PanelHover hover;
    CardsState cards;
    InspectorState inspector;
    PointerState pointer;
    ContextMenuState context_menu;
    std::optional<std::vector<Example>> examples;     ///< read when the welcome screen first opens
    std::optional<std::vector<LessonEntry>> lessons;  ///< read when the menu of lessons first opens
    std::string key_sheet_filter;
    PresentingState presenting;
    std::string text_at_pointer;  ///< what Ctrl+C copies in place of the curve; of this frame until its end
};

}  // namespace batten::ui
