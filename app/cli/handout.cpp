#include <algorithm>
#include <ostream>

#include "app/cli/html_text.h"
#include "app/cli/input.h"
#include "app/cli/say.h"
#include "app/cli/standard_streams.h"
#include "app/editor/cards/cards.h"
#include "app/editor/command_spec.h"
#include "app/editor/commands/lesson_commands.h"
#include "app/editor/commands/overlay_commands.h"
#include "app/editor/commands/view_commands.h"
#include "app/editor/editor.h"
#include "app/editor/lesson/lesson_file.h"
#include "app/editor/scene/canvas_scene.h"
#include "app/editor/scene/plot_scene.h"
#include "core/base/sentence.h"
#include "core/document/file_text.h"
#include "render/svg_painter.h"
#include "render/xml_text.h"

namespace batten::cli {

namespace {

using core::sentence;

constexpr glm::dvec2 canvas_size{900.0, 480.0};
constexpr glm::dvec2 plot_size{900.0, 240.0};
constexpr double least_card_width = 360.0;

constexpr const char* page = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{name}</title>
<style>
* {{ box-sizing: border-box; }}
body {{ font: 11pt/1.45 Inter, "DejaVu Sans", sans-serif; color: #1c2128; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }}
h1 {{ font-size: 1.7em; margin-bottom: 0.2em; }}
h2 {{ font-size: 1.1em; margin: 1.6em 0 0.3em; }}
h3 {{ font-size: 1em; margin: 0.8em 0 0.2em; }}
figure {{ margin: 0.6em 0; break-inside: avoid; }}
figure img {{ display: block; width: 100%; border: 1px solid #c9ced6; border-bottom-width: 0; }}
figure img:last-child {{ border-bottom-width: 1px; }}
h2, .step > p {{ break-inside: avoid; break-after: avoid; }}
.shown {{ display: grid; grid-template-columns: minmax(0, 3fr) minmax(0, 2fr); gap: 0 1rem; align-items: start; }}
.shown > :only-child {{ grid-column: 1 / -1; }}
.task {{ font-weight: 600; border-left: 3px solid #0b57d0; padding-left: 0.7em; }}
.card {{ border: 1px solid #c9ced6; border-radius: 6px; padding: 0.2em 0.9em 0.7em; margin: 0.6em 0; font-size: 0.92em; break-inside: avoid; }}
.card img {{ max-width: 100%; height: auto; }}
.formula {{ font-family: "JetBrains Mono", "DejaVu Sans Mono", monospace; font-size: 0.92em; }}
table {{ border-collapse: collapse; margin: 0.4em 0; }}
td, th {{ padding: 0.1em 0.9em 0.1em 0; text-align: left; vertical-align: baseline; }}
sub, sup {{ font-size: 0.72em; line-height: 0; }}
@media screen and (max-width: 40rem) {{ .shown {{ display: block; }} }}
@media print {{ body {{ font-size: 9.5pt; margin: 0; padding: 0; max-width: none; }} }}
@page {{ margin: 12mm; }}
</style>
</head>
<body>
<h1>{title}</h1>
<p>{text}</p>
{steps}</body>
</html>
)";

std::string shown(const editor::EditorState& state, const std::string& text) {
    return html_of_label(editor::notated(text, state.view.notation));
}

std::string cell_html(const editor::EditorState& state, const editor::CardText& cell, const char* tag,
                      std::size_t columns) {
    return sentence("<{tag} colspan=\"{columns}\">{text}</{tag}>",
                    {{"tag", tag}, {"columns", columns}, {"text", shown(state, cell.text)}});
}

/// The last cell of a short row takes the rest of `columns`.
std::string row_html(const editor::EditorState& state, const std::vector<editor::CardText>& row, const char* tag,
                     std::size_t columns) {
    std::string cells;
    for (std::size_t k = 0; k < row.size(); ++k)
        cells += cell_html(state, row[k], tag, k + 1 == row.size() ? columns - k : 1);
    return sentence("<tr>{cells}</tr>\n", {{"cells", cells}});
}

/// What a block of a card says, one case for each kind.
struct BlockHtml {
    const editor::EditorState& state;

    std::string operator()(const editor::CardLine& line) const {
        return sentence(line.is_formula ? "<div class=\"formula\">{text}</div>\n" : "<div>{text}</div>\n",
                        {{"text", shown(state, line.text.text)}});
    }
    std::string operator()(const editor::CardTable& table) const {
        std::size_t columns = 0;
        for (const auto& row : table.rows) columns = std::max(columns, row.size());
        std::string rows;
        for (std::size_t r = 0; r < table.rows.size(); ++r)
            rows += row_html(state, table.rows[r], table.has_heading && r == 0 ? "th" : "td", columns);
        return sentence("<table>\n{rows}</table>\n", {{"rows", rows}});
    }
    std::string operator()(const editor::CardPicture& picture) const {
        const glm::dvec2 size(std::max(least_card_width, picture.least_width), picture.height);
        const render::Color ground = editor::theme_of(state.view.theme).canvas;
        return html_image(render::svg_text(render::page_of(picture.draw(size, 1.0).list, size, ground)),
                          "picture of the card");
    }
    std::string operator()(const editor::CardButtons&) const { return ""; }
};

std::string card_html(const editor::EditorState& state, const editor::CardSource& source) {
    const editor::Card card = source.make(state);
    const std::string title = editor::toggle_overlay_spec(source.overlay).title;  // as in the window
    std::string blocks;
    for (const editor::CardBlock& block : card.blocks) blocks += std::visit(BlockHtml{state}, block);
    return sentence("<div class=\"card\"><h3>{title}</h3>\n{blocks}</div>\n",
                    {{"title", shown(state, title)}, {"blocks", blocks}});
}

std::string figure_html(const editor::EditorState& state) {
    editor::SceneCache cache;
    const render::Color ground = editor::theme_of(state.view.theme).canvas;
    const std::string canvas =
        render::svg_text(render::page_of(canvas_scene(state, editor::CanvasIdle{}, cache), canvas_size, ground));
    const std::string plot =
        render::svg_text(render::page_of(plot_scene(state, editor::PlotIdle{}, plot_size, cache), plot_size, ground));
    return sentence("<figure>{canvas}{plot}</figure>\n", {{"canvas", html_image(canvas, "the curve")},
                                                          {"plot", html_image(plot, "its basis functions and knots")}});
}

std::string task_html(const editor::EditorState& state) {
    const std::string& task = state.lesson->present().task;
    return task.empty() ? "" : sentence("<p class=\"task\">{task}</p>\n", {{"task", shown(state, task)}});
}

/// The cards beside the figure; the one without the other is as wide as the page.
std::string shown_html(const editor::EditorState& state) {
    std::string cards;
    for (const editor::CardSource& source : editor::shown_cards(state)) cards += card_html(state, source);
    return sentence("<div class=\"shown\">{figure}{cards}</div>\n",
                    {{"figure", state.active_curve() != nullptr ? figure_html(state) : ""},
                     {"cards", cards.empty() ? "" : sentence("<div>\n{cards}</div>\n", {{"cards", cards}})}});
}

std::string step_html(const editor::EditorState& state) {
    return sentence("<section class=\"step\">\n<h2>{number}.</h2>\n<p>{text}</p>\n{task}{shown}</section>\n",
                    {{"number", state.lesson->step + 1},
                     {"text", shown(state, state.lesson->present().text)},
                     {"task", task_html(state)},
                     {"shown", shown_html(state)}});
}

/// The whole page; the sentence says which step cannot be shown.
tl::expected<std::string, std::string> page_of(const std::filesystem::path& path) {
    editor::Editor editor;
    editor::Settings settings;
    settings.theme = editor::ThemeName::light;
    editor.apply(settings);
    editor.change(editor::ResizeCanvas{canvas_size});
    if (!editor.run(editor::OpenLesson{path.string()})) return tl::unexpected(editor.state().message.text);
    std::string steps;
    while (true) {
        editor.change(editor::ResizeCanvas{canvas_size});
        editor.run(editor::FitView{});
        steps += step_html(editor.state());
        if (editor.state().lesson->is_last()) break;
        if (!editor.run(editor::NextStep{}))
            return tl::unexpected(sentence("step {step}: {problem}", {{"step", editor.state().lesson->step + 1},
                                                                      {"problem", editor.state().message.text}}));
    }
    const editor::Lesson& lesson = *editor.state().lesson->lesson;
    return sentence(page, {{"name", render::xml_text(lesson.title)},
                           {"title", shown(editor.state(), lesson.title)},
                           {"text", shown(editor.state(), lesson.text)},
                           {"steps", steps}});
}

}  // namespace

ExitStatus handout(const HandoutOptions& options, Output output) {
    if (std::error_code absent;
        !is_standard(options.result) && std::filesystem::equivalent(options.lesson, options.result, absent))
        return say_wrong_usage(
            output,
            core::sentence("batten handout: -o: '{file}' is the lesson itself; the handout needs a name of its own",
                           {{"file", options.result.string()}}));
    // A name alone would be looked for among the lessons of the program.
    std::error_code error;
    const std::filesystem::path lesson = std::filesystem::absolute(options.lesson, error);
    const auto text = error ? tl::unexpected(error.message()) : page_of(lesson);
    if (!text) {
        say_error(output, options.lesson, "", text.error());
        return ExitStatus::wrong_input;
    }
    if (is_standard(options.result)) {
        output.results << *text;
        return ExitStatus::done;
    }
    const auto written = core::replace_text(options.result, *text);
    if (written) return ExitStatus::done;
    say_error(output, options.result, written.error());
    return ExitStatus::wrong_input;
}

}  // namespace batten::cli
