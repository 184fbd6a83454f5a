/// The example files as the welcome screen and the menu offer them.
#pragma once

#include <string>
#include <vector>

#include "app/ui/panels.h"

namespace batten::ui {

/// The examples in the desktop's folder, in the order of a lecture; read on the first call. Files that cannot be read
/// are left out.
const std::vector<Example>& examples_of(const PanelContext& context);

/// The document's title, else the file's name.
std::string title_of(const Example& example);

/// Draws the example's control polygon and curves into `place` of the current window.
void draw_thumbnail(const PanelContext& context, const Example& example, const Rectangle& place);

}  // namespace batten::ui
