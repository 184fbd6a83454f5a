/// One row of a command's form: the name of a field, an input for each of its parts, and what it means.
#pragma once

#include <string>
#include <vector>

#include "app/editor/fields/field.h"
#include "app/ui/panels.h"

namespace batten::ui {

/// The height in pixels of the row in a form of this width.
float form_row_height_px(const PanelContext& context, const editor::Field& field, float width_px);

/// Draws the row at the cursor, in the width that is left; what is typed or chosen goes into `texts`, one for each part
/// of the field.
void draw_form_row(const PanelContext& context, const editor::Field& field, std::vector<std::string>& texts);

/// The height in pixels of a text that is wrapped at `width_px`.
float wrapped_height_px(const std::string& text, ImFont* font, float width_px);

}  // namespace batten::ui
