#include "app/editor/commands/figure_commands.h"

#include "app/editor/commands/file_acts.h"
#include "app/editor/commands/groups.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/scene/figure_scene.h"
#include "app/editor/state/show_dialog.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

constexpr double most_figure_scale = 8.0;
constexpr double most_figure_side = 10000.0;

std::string figure_name(const std::string& stem, std::size_t number) {
    if (number == 1) return core::sentence("{name} figure.svg", {{"name", stem}});
    return core::sentence("{name} figure {number}.svg", {{"name", stem}, {"number", number}});
}

// A name beside the document that no file has: a drawing of that name may be what the document was made of.
std::filesystem::path figure_path(const EditorState& state) {
    const std::filesystem::path& file = state.path.empty() ? state.source : state.path;
    const std::string stem = file.empty() ? "untitled" : file.stem().string();
    std::error_code error;
    for (std::size_t number = 1;; ++number) {
        std::filesystem::path path = absolute_path(file.parent_path() / figure_name(stem, number));
        if (!std::filesystem::exists(path, error)) return path;
    }
}

FigureTheme theme_on_screen(const EditorState& state) {
    const View& view = state.view;
    if (view.is_presenting && view.theme == ThemeName::light) return FigureTheme::high_contrast;
    return view.theme == ThemeName::dark ? FigureTheme::dark : FigureTheme::light;
}

/// What was typed of it; of one side alone the other follows.
std::optional<glm::dvec2> page_size(const EditorState& state, const ExportFigure& command) {
    if (!command.width && !command.height) return std::nullopt;
    const glm::dvec2 screen = window_figure_size(state, command.view);
    const double ratio = command.width ? *command.width / screen.x : *command.height / screen.y;
    return glm::dvec2(command.width.value_or(ratio * screen.x), command.height.value_or(ratio * screen.y));
}

Outcome<void> export_figure(EditorState& state, const ExportFigure& command) {
    const std::filesystem::path path = absolute_path(command.path);
    std::error_code error;
    if (!command.replace && std::filesystem::exists(path, error))
        return tl::unexpected(core::sentence("{file} is there already; choose 'replace', or another name",
                                             {{"file", path.filename().string()}}));
    const FigureForm form{.view = command.view,
                          .scale = command.scale,
                          .is_transparent = command.is_transparent,
                          .title = command.title.value_or(""),
                          .theme = command.theme,
                          .size_px = page_size(state, command)};
    const double least = form.size_px ? least_figure_height(state.view, form, form.size_px->x) : 0.0;
    if (form.size_px && form.size_px->y < least)
        return tl::unexpected(core::sentence("with these parts a figure needs a height of at least {least} pixels",
                                             {{"least", core::shortest_text(least)}}));
    return export_figure_to(state, path, form).map([&] {
        if (state.dialog == Dialog::save_file) show_dialog(state, Dialog::none);
    });
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
             field::number<&ExportFigure::width>("width",
                                                 "pixels, 96 to an inch; empty: by the height, or as on the screen")
                 .above(0.0)
                 .at_most(most_figure_side),
             field::number<&ExportFigure::height>("height", "pixels; empty: by the width, or as on the screen")
                 .above(0.0)
                 .at_most(most_figure_side),
             field::number<&ExportFigure::scale>("scale", "pixels of a PNG for each of width and height, up to 8")
                 .above(0.0)
                 .at_most(most_figure_scale)
                 .usually(1.0),
             field::text<&ExportFigure::title>("title", "a title above the picture"),
             field::choice<&ExportFigure::theme>("theme", "the colors").suggesting<theme_on_screen>(),
             field::flag<&ExportFigure::is_transparent>("transparent", "whether the ground is left out").usually(false),
             field::flag<&ExportFigure::replace>("replace", "whether a file that is there is replaced").usually(false)},
        .refusal = no_visible_curve,
        .run = body_of<export_figure>};
    return spec;
}

void add_figure_commands(CommandTable& table) {
    add_all<ExportFigure>(table);
}

}  // namespace batten::editor
