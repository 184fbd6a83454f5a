/// The lines of menus: check mark, title, sign of the effect, shortcut, in columns.
#pragma once

#include "app/editor/pointer/context_menu.h"
#include "app/ui/panels.h"

namespace batten::ui {

/// The widths of a menu's columns in window pixels; zero where nothing in the menu needs one.
struct Columns {
    float check = 0.0F;
    float title = 0.0F;
    float sign = 0.0F;
    float shortcut = 0.0F;
    float total() const { return check + title + sign + shortcut; }
};

/// Widens the columns as far as `entry` needs.
void make_room(const PanelContext& context, Columns& columns, const editor::MenuEntry& entry);

/// One line of the menu that is being drawn; choosing it runs its command or opens the command's form.
void draw_menu_entry(const PanelContext& context, const editor::MenuEntry& entry, const Columns& columns);

/// What the signs mean, at the foot of a menu that has some.
void draw_menu_legend(const PanelContext& context);

float menu_text_width(const std::string& text);

}  // namespace batten::ui
