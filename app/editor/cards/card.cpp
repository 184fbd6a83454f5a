#include "app/editor/cards/card.h"

#include <fmt/ranges.h>

#include "app/editor/words/formula.h"

namespace batten::editor {

namespace {

struct LinesOf {
    std::vector<std::string>& lines;

    void operator()(const CardLine& line) const { lines.push_back(plain_text(line.text.text)); }
    void operator()(const CardTable& table) const {
        for (const std::vector<CardText>& row : table.rows) {
            std::vector<std::string> cells;
            for (const CardText& cell : row) cells.push_back(plain_text(cell.text));
            lines.push_back(fmt::format("{}", fmt::join(cells, " | ")));
        }
    }
    void operator()(const CardPicture&) const {}
    void operator()(const CardButtons& buttons) const {
        for (const CardButton& button : buttons.buttons) lines.push_back(plain_text(button.text));
    }
};

}  // namespace

Card& Card::line(std::string text, CardTone tone) {
    return add(CardLine{{.text = std::move(text), .tone = tone}});
}

Card& Card::formula(std::string text, CardTone tone) {
    return add(CardLine{{.text = std::move(text), .tone = tone}, true});
}

Card& Card::add(CardBlock block) {
    blocks.push_back(std::move(block));
    return *this;
}

std::string card_text(const Card& card) {
    std::vector<std::string> lines{plain_text(card.title)};
    for (const CardBlock& block : card.blocks) std::visit(LinesOf{lines}, block);
    return fmt::format("{}", fmt::join(lines, "\n"));
}

}  // namespace batten::editor
