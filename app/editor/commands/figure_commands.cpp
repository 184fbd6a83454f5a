#include "app/editor/commands/figure_commands.h"

#include "app/editor/commands/file_acts.h"
#include "app/editor/commands/groups.h"
#include "app/editor/fields/field_kinds.h"

namespace batten::editor {

namespace {

constexpr double most_figure_scale = 8.0;

/// Beside the document, with its name.
std::filesystem::path figure_path(const EditorState& state) {
    std::filesystem::path path = state.path.empty() ? "figure.svg" : state.path;
    return path.replace_extension(".svg");
}

Outcome<void> export_figure(EditorState& state, const ExportFigure& command) {
    return export_figure_to(state, absolute_path(command.path),
                            {.view = command.view,
                             .scale = command.scale,
                             .is_transparent = command.is_transparent,
                             .title = command.title.value_or("")});
}

std::optional<Refusal> no_visible_curve(const EditorState& state) {
    if (state.visible_active_curve() != nullptr) return std::nullopt;
    return "there is no visible curve to be shown";
}

}  // namespace

const CommandSpec& ExportFigure::spec() {
    static const CommandSpec spec{
        .name = "export-figure",
        .title = "Export figure",
        .explanation = "Writes what the canvas shows as a figure for a slide or a paper: SVG, PDF, PNG or TikZ.",
        .synonyms = "image picture save svg pdf png tikz latex print screenshot",
        .group = CommandGroup::file,
        .offered = in_the_window,
        .fields =
            {field::file<&ExportFigure::path>("path", "the file, ending in .svg, .pdf, .png or .tex")
                 .beginning_with<figure_path>(),
             field::choice<&ExportFigure::view>("view", "what the figure shows").usually(FigureView::curve),
             field::number<&ExportFigure::scale>("scale", "pixels of a PNG for each on the screen, up to 8")
                 .above(0.0)
                 .at_most(most_figure_scale)
                 .usually(1.0),
             field::flag<&ExportFigure::is_transparent>("transparent", "whether the ground is left out").usually(false),
             field::text<&ExportFigure::title>("title", "a title above the picture")},
        .refusal = no_visible_curve,
        .run = body_of<export_figure>};
    return spec;
}

void add_figure_commands(CommandTable& table) {
    add_all<ExportFigure>(table);
}

}  // namespace batten::editor
