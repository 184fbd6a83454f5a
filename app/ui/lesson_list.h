/// The lessons of the program.
#pragma once

#include <vector>

#include "app/ui/panels.h"

namespace batten::ui {

/// In the order of a lecture; read when they are asked for first. Files that are no lessons are left out.
const std::vector<LessonEntry>& lessons_of(const PanelContext& context);

}  // namespace batten::ui
