/// The one widget for numbers: drag or type, preview while it changes, one commit when it ends.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/words/length.h"
#include "app/ui/panels.h"

namespace batten::ui {

/// What a number field edits.
struct NumberField {
    std::string name;                ///< unique in the window, also of its WidgetPlace
    double value = 0.0;              ///< shown when not being typed
    int decimals = 2;                ///< shown; dragged values are rounded to them. Typing shows all digits
    int most_decimals = 17;          ///< shown, where a column has no room for all
    double extent = 0.0;             ///< how far the numbers of its column differ; 0 where that is not known
    double speed = 0.01;             ///< change per design pixel dragged; for multiplicative fields the relative change
    bool is_multiplicative = false;  ///< a drag multiplies, so that 0.01 and 100 are equally far from 1
    float width_px = 0.0F;           ///< 0: what is left
    bool is_enabled = true;
    double height = 24.0;                                      ///< design pixels
    double lowest = -std::numeric_limits<double>::infinity();  ///< where a drag ends; typed values go as they are
    double highest = std::numeric_limits<double>::infinity();
    bool is_whole = false;   ///< only whole numbers may be typed
    bool is_live = false;    ///< commands that are not undone run at every change instead of being previewed
    std::string unit;        ///< shown after the number
    editor::Units length{};  ///< of which the number is a length, so that it may be typed in another unit
    std::string tooltip = {};
};

/// How far an edit of a field has come.
enum class EditPhase { preview, commit, cancel };

/// What happened to a field in this frame.
struct NumberEdit {
    double value = 0.0;
    EditPhase phase = EditPhase::commit;  ///< on cancel the value is the one before
    bool is_entered = false;              ///< typed and ended with Enter; the value may be the old one
};

/// Draws the field, for what is not a command. Dragging gives previews and on release a commit, typing a commit on
/// Enter, Tab or loss of focus, Escape a cancel. A typed text that is no number leaves the value and says so below the
/// field. Typed may be what editor::parse_expression reads: "0.5", "0,5", "1/3", "sqrt(2)/2", "30 deg"; and "+=2",
/// "*=2" change the value that is there.
std::optional<NumberEdit> edit_number(const PanelContext& context, const NumberField& field);

/// The same; the command for a new value is made by `command` and previewed, committed or canceled.
void draw_number_field(const PanelContext& context, const NumberField& field,
                       const std::function<editor::Command(double)>& command);

/// The decimals that numbers of up to this size have room for in fields of this width, so that all of a column can be
/// written alike.
int decimals_in(const PanelContext& context, float width_px, double lowest, double highest);

/// What a drag over one design pixel changes, one unit of the last decimal.
double step_of(int decimals);

/// Gives up a field that is no longer drawn, and its preview.
void drop_lost_field(const PanelContext& context);

}  // namespace batten::ui
