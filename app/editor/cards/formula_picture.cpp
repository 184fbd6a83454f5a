#include "app/editor/cards/formula_picture.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

#include "app/editor/scene/text_size.h"
#include "app/editor/words/formula.h"

namespace batten::editor {

namespace {

// Design pixels.
constexpr double formula_text_height = 14.0;
constexpr double formula_row_pitch = 21.0;
constexpr double column_gap = 8.0;
constexpr double part_gap = 6.0;
constexpr double bracket_gap = 5.0;
constexpr double bracket_tip = 4.0;
constexpr double formula_margin = 4.0;
constexpr double formula_width_error = 1.08;  // widths are known without the font, to about a tenth

double formula_width(const CardText& text, const Notation& notation) {
    return formula_width_error * text_size(notated(text.text, notation), formula_text_height).x;
}

std::vector<double> column_widths(const FormulaPart& part, const Notation& notation) {
    std::vector<double> widths(part.rows.front().size(), 0.0);
    for (const auto& row : part.rows)
        for (std::size_t c = 0; c < widths.size(); ++c)
            widths[c] = std::max(widths[c], formula_width(row[c], notation));
    return widths;
}

double formula_width(const FormulaPart& part, const Notation& notation) {
    const std::vector<double> widths = column_widths(part, notation);
    double whole = column_gap * static_cast<double>(widths.size() - 1);
    for (const double width : widths) whole += width;
    return whole + (part.has_brackets ? 2.0 * bracket_gap : 0.0);
}

double formula_width(const std::vector<FormulaPart>& parts, const Notation& notation) {
    double whole = 2.0 * formula_margin - part_gap;
    for (const FormulaPart& part : parts) whole += formula_width(part, notation) + part_gap;
    return whole;
}

double height_of(const std::vector<FormulaPart>& parts) {
    std::size_t rows = 1;
    for (const FormulaPart& part : parts) rows = std::max(rows, part.rows.size());
    return formula_row_pitch * static_cast<double>(rows) + 2.0 * formula_margin;
}

class FormulaPainter {
  public:
    FormulaPainter(const Theme& theme, const Notation& notation, std::string prefix, glm::dvec2 size_px, double scale)
        : theme_(theme),
          notation_(notation),
          prefix_(std::move(prefix)),
          pen_(drawing_.list, size_px, scale, notation),
          middle_(0.5 * size_px.y) {}

    /// `x` is where the part begins, in design pixels.
    void draw(const FormulaPart& part, std::size_t index, double x) {
        const double width = formula_width(part, notation_);
        if (part.has_brackets) {
            draw_bracket(x, part.rows.size(), 1.0);
            draw_bracket(x + width, part.rows.size(), -1.0);
            x += bracket_gap;
        }
        const std::vector<double> widths = column_widths(part, notation_);
        for (std::size_t c = 0; c < widths.size(); ++c) {
            for (std::size_t r = 0; r < part.rows.size(); ++r)
                draw_entry(part, {index, r, c}, {x + 0.5 * widths[c], offset(r, part.rows.size())}, widths[c]);
            x += widths[c] + column_gap;
        }
    }

    CardDrawing take() { return std::move(drawing_); }

  private:
    struct Entry {
        std::size_t part, row, column;
    };

    /// How far row `r` of `count` is below the middle, in design pixels.
    static double offset(std::size_t r, std::size_t count) {
        return formula_row_pitch * (static_cast<double>(r) - 0.5 * static_cast<double>(count - 1));
    }

    glm::dvec2 place(glm::dvec2 design) const { return {pen_.px(design.x), middle_ + pen_.px(design.y)}; }

    void draw_bracket(double x, std::size_t rows, double inward) {
        const double half = 0.5 * formula_row_pitch * static_cast<double>(rows);
        const double tip = x + inward * bracket_tip;
        pen_.line(std::array{place({tip, -half}), place({x, -half}), place({x, half}), place({tip, half})},
                  {.color = theme_.text, .width = 1.25});
    }

    void draw_entry(const FormulaPart& part, Entry entry, glm::dvec2 center, double width) {
        const CardText& text = part.rows[entry.row][entry.column];
        const render::Color color = text.color                         ? *text.color
                                    : text.tone == CardTone::parameter ? theme_.parameter
                                    : text.tone == CardTone::dim       ? theme_.dim
                                                                       : theme_.text;
        pen_.text(place(center), text.text,
                  {.color = color, .size = formula_text_height, .anchor = render::Anchor::center});
        if (std::holds_alternative<HoveredNothing>(text.hover)) return;
        const glm::dvec2 half{0.5 * width + 2.0, 0.5 * formula_row_pitch};
        drawing_.places.push_back(
            {.name = fmt::format("{} entry {} {} {}", prefix_, entry.part, entry.row, entry.column),
             .box = {place(center - half), place(center + half)},
             .hover = text.hover,
             .value = plain_text(notated(text.text, notation_))});
    }

    Theme theme_;
    Notation notation_;
    std::string prefix_;
    CardDrawing drawing_;
    Pen pen_;
    double middle_;
};

}  // namespace

FormulaPart formula_text(std::string text) {
    return {.rows = {{{.text = std::move(text)}}}, .has_brackets = false};
}

FormulaPart formula_row_vector(const std::vector<std::string>& texts) {
    FormulaPart part{.rows = {{}}};
    for (const std::string& text : texts) part.rows.front().push_back({.text = text});
    return part;
}

FormulaPart formula_column(std::vector<CardText> texts) {
    FormulaPart part;
    for (CardText& text : texts) part.rows.push_back({std::move(text)});
    return part;
}

CardPicture formula_picture(std::vector<FormulaPart> parts, const Theme& theme, const Notation& notation,
                            std::string prefix) {
    const double width = formula_width(parts, notation);
    return {
        .height = height_of(parts),
        .draw =
            [parts = std::move(parts), theme, notation, prefix = std::move(prefix)](glm::dvec2 size_px, double scale) {
                FormulaPainter painter(theme, notation, prefix, size_px, scale);
                double x = formula_margin;
                for (std::size_t i = 0; i < parts.size(); ++i) {
                    painter.draw(parts[i], i, x);
                    x += formula_width(parts[i], notation) + part_gap;
                }
                return painter.take();
            },
        .least_width = width};
}

}  // namespace batten::editor
