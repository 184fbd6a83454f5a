#include <fmt/core.h>

#include <ostream>
#include <string_view>

#include "app/cli/subcommands.h"
#include "app/editor/command_table.h"

namespace batten::cli {

namespace {

// Headings for scripts, which know no menus.
const char* group_heading(editor::CommandGroup group) {
    switch (group) {
        case editor::CommandGroup::edit:
            return "Points and selection";
        case editor::CommandGroup::make:
            return "New curves";
        case editor::CommandGroup::curve:
            return "Curves";
        case editor::CommandGroup::construct:
            return "Construction";
        case editor::CommandGroup::analyze:
            return "Measures";
        default:
            return "Others";
    }
}

const char* effect_sentence(editor::ShapeEffect effect) {
    switch (effect) {
        case editor::ShapeEffect::keeps:
            return " Keeps the shape.";
        case editor::ShapeEffect::changes:
            return " Changes the shape.";
        case editor::ShapeEffect::none:
            return "";
    }
    return "";
}

// "insert-knot [u]"
void print_usage(std::ostream& out, const editor::CommandSpec& spec) {
    out << "  " << spec.name;
    for (const editor::Field& field : spec.fields)
        for (const editor::FieldPart& part : field.parts)
            out << (field.can_be_left_out() ? fmt::format(" [{}]", part.name) : fmt::format(" <{}>", part.name));
    out << '\n';
}

void print_operation(std::ostream& out, const editor::CommandSpec& spec) {
    print_usage(out, spec);
    out << "      " << spec.explanation << effect_sentence(spec.effect) << '\n';
    for (const editor::Field& field : spec.fields)
        for (const editor::FieldPart& part : field.parts)
            out << fmt::format("      {}: {} ({})\n", part.name, part.meaning, editor::kind_text(field));
}

}  // namespace

void list_operations(std::ostream& out) {
    out << "Operations act on the active curve, in the order given. <needed> [may be left out]\n"
           "A list is written 1,2.5,3; points as x0,y0,x1,y1, and one point as x,y or x y. Knots, points and curves "
           "are counted from 0.\n"
           "A list can also be read from a table of numbers, @FILE or @- for standard input: the points one a line,\n"
           "numbers separated by commas, semicolons, tabs or blanks. Empty lines, a first line of names and what "
           "stands\n"
           "behind # are skipped; points may have decimal commas.\n"
           "A curve is named by its name or its number; an exact name comes before a number, and before an operation.\n"
           "What is needed is taken as an argument whatever it is; -- ends the arguments of an operation.\n";
    std::string_view last_heading;
    for (const editor::CommandSpec& spec : editor::command_table()) {
        if (!spec.offered.scripts) continue;
        const std::string_view heading = group_heading(spec.group);
        if (heading != last_heading) out << '\n' << heading << '\n';
        last_heading = heading;
        print_operation(out, spec);
    }
}

}  // namespace batten::cli
