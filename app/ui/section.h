/// Headings and rows that the sections of the inspector have in common.
#pragma once

#include <imgui.h>

#include <functional>
#include <string>

#include "app/ui/panels.h"

namespace batten::ui {

inline constexpr double section_margin = 18.0;  ///< design pixels left and right of the sections
inline constexpr double row_gap = 4.0;          ///< design pixels between rows
inline constexpr double heading_height = 26.0;  ///< design pixels
inline constexpr double window_padding = 4.0;   ///< design pixels, of the inspector's windows

struct Section {
    std::string name;   ///< its place is "section NAME"
    std::string title;  ///< rich text
    std::string info;   ///< dim, at the right; rich text
    bool is_open_at_first = true;
};

/// A small triangle that tells whether what is below is open or folded.
void draw_fold_mark(const PanelContext& context, ImVec2 center, bool is_open);

/// Draws the heading with the line below; a click folds the section. Returns whether it is open.
bool draw_section_heading(const PanelContext& context, const Section& section);

/// The same for what does not fold.
void draw_heading(const PanelContext& context, const Section& section);

/// The width between the margins, in window pixels; for use in the inspector's own window.
float content_width(const PanelContext& context);

/// Starts a row with a dim label; the cursor is then where the field goes, of field_width().
void draw_row_label(const PanelContext& context, const std::string& label);
float field_width(const PanelContext& context);

void add_space(const PanelContext& context, double design_px);

/// Puts the next item beside the last, `gap` design pixels on.
void stay_in_row(const PanelContext& context, double gap = row_gap);

/// A list of rows of equal height that scrolls when it has many.
struct RowList {
    const char* name;         ///< of the child window
    std::size_t count = 0;    ///< of all rows
    std::size_t most = 8;     ///< shown at a time
    double row_height = 0.0;  ///< design pixels
    double overhang = 0.0;    ///< design pixels by which rows reach into the margins
};

/// Draws the rows in sight: `draw_row` gets the index of each and its width in window pixels.
void draw_row_list(const PanelContext& context, const RowList& list,
                   const std::function<void(const PanelContext& context, std::size_t i, float width)>& draw_row);

/// Whether the active curve may be edited; a locked one may not.
bool is_editable(const editor::EditorState& state);

/// The tool tip of what cannot be edited now; empty where it can.
std::string locked_sentence(const editor::EditorState& state);

}  // namespace batten::ui
