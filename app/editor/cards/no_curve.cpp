#include "app/editor/cards/no_curve.h"

#include "app/editor/commands/file_commands.h"

namespace batten::editor {

Card card_without_curve(const char* example) {
    Card card;
    card.line("There is no curve to show this on.", CardTone::dim);
    card.add(CardButtons{{{.text = "Open an example", .command = OpenExample{.name = example}}}});
    return card;
}

}  // namespace batten::editor
