#include <ostream>
#include <string_view>

#include "app/cli/operation.h"
#include "app/cli/subcommands.h"

namespace batten::cli {

namespace {

const char* group_title(editor::CommandGroup group) {
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

const char* kind_text(editor::ParameterKind kind) {
    switch (kind) {
        case editor::ParameterKind::number:
            return "number";
        case editor::ParameterKind::text:
            return "text";
        case editor::ParameterKind::numbers:
            return "list";
    }
    return "";
}

const char* effect_text(const editor::CommandSpec& spec) {
    switch (spec.effect) {
        case editor::ShapeEffect::keeps:
            return " Keeps the shape.";
        case editor::ShapeEffect::changes:
            return " Changes the shape.";
        case editor::ShapeEffect::none:
            return "";
    }
    return "";
}

// "insert-knot [U]"
std::string usage(const editor::CommandSpec& spec) {
    std::string text = spec.name;
    for (const editor::ParameterSpec& parameter : spec.parameters) {
        std::string name = parameter.name;
        text += parameter.suggestion == nullptr ? " <" + name + ">" : " [" + name + "]";
    }
    return text;
}

void list_operation(std::ostream& out, const editor::CommandSpec& spec) {
    out << "  " << usage(spec) << "\n      " << spec.explanation << effect_text(spec) << '\n';
    for (const editor::ParameterSpec& parameter : spec.parameters)
        out << "      " << parameter.name << ": " << parameter.meaning << " (" << kind_text(parameter.kind) << ")\n";
}

}  // namespace

void list_operations(std::ostream& out) {
    out << "Operations act on the active curve, in the order given. <needed> [may be left out]\n"
           "A list is written 1,2.5,3; points as x0,y0,x1,y1. Knots, points and curves are counted from 0.\n";
    const char* last_title = "";
    for (const editor::CommandSpec& spec : editor::command_table()) {
        if (!is_operation(spec)) continue;
        const char* title = group_title(spec.group);
        if (std::string_view(title) != last_title) out << '\n' << title << '\n';
        last_title = title;
        list_operation(out, spec);
    }
}

}  // namespace batten::cli
