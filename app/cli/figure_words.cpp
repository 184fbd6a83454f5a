#include "app/cli/figure_words.h"

#include <CLI/CLI.hpp>

#include "app/cli/command_options.h"
#include "app/cli/figure_show.h"
#include "core/base/sentence.h"

namespace batten::cli {

namespace {

constexpr std::size_t most_figure_frames = 10000;
constexpr double least_frame_rate = 0.1;
constexpr double most_frame_rate = 100.0;

void add_pictured(CLI::App& command, FigureOptions& options) {
    command
        .add_option(
            "--show", options.show,
            core::sentence("What is shown beside the curve, several of these with commas between them (default: "
                           "polygon,points,labels): {names}",
                           {{"names", core::listed_as_alternatives(names_to_show())}}))
        ->type_name("NAMES");
    command.add_option("--at", options.at, "The parameter at which the curve is marked")->type_name("U");
    command.add_option("--curve", options.curve, "The name or number of the curve, instead of the active one")
        ->type_name("NAME");
    command
        .add_option("--view", options.view,
                    "The curve, its basis functions (basis), both, or the lifted curve in space (homogeneous)")
        ->type_name("VIEW");
    command.add_option("--title", options.title, "A title above the picture")->type_name("TEXT");
}

void add_looks(CLI::App& command, FigureOptions& options) {
    command.add_option("--size", options.size, "Width and height in pixels, 96 to an inch (default: 800x450)")
        ->type_name("WxH");
    command.add_option("--scale", options.scale, "Pixels of a PNG, GIF or MP4 for each of the picture (default: 1)")
        ->check(number_above_0())
        ->type_name("NUMBER");
    command.add_option("--theme", options.theme, "The colors: light (the default), dark or high-contrast")
        ->type_name("THEME");
    command.add_flag("--transparent", options.is_transparent, "Leave the ground out");
}

void add_motion(CLI::App& command, FigureOptions& options) {
    command
        .add_option(
            "--animate", options.animate,
            "What moves: u=0..1, the parameter; insert=0.5, a knot that comes in; merge=5, the knot of that index "
            "onto the next one")
        ->type_name("MOTION");
    command.add_option("--frames", options.frames, "How many frames to write (default: 50)")
        ->check(whole_number(1, most_figure_frames))
        ->type_name("N");
    command.add_option("--rate", options.rate, "How many frames a GIF or MP4 shows in a second (default: 25)")
        ->check(number_within(least_frame_rate, most_frame_rate))
        ->type_name("NUMBER");
}

}  // namespace

void add_figure_words(CLI::App& command, FigureOptions& options) {
    command
        .add_option("file", options.file,
                    "A curve file of Batten, or of the program that its ending names; - is standard input")
        ->required()
        ->type_name("FILE");
    command
        .add_option(
            "-o,--output", options.result,
            "Where it is written: .svg, .pdf, .png or .tex; with --animate a pattern such as frame-%03d.png, or "
            ".gif or .mp4; - is standard output")
        ->required()
        ->type_name("FILE");
    command.add_option("--format", options.format, "The format, as an ending, where the file's name does not tell it")
        ->type_name("FORMAT");
    add_pictured(command, options);
    add_looks(command, options);
    add_motion(command, options);
}

}  // namespace batten::cli
