#include <ostream>

#include "app/cli/figure_frames.h"
#include "app/cli/figure_idle.h"
#include "app/cli/frame_names.h"
#include "app/cli/input.h"
#include "app/cli/movie.h"
#include "app/cli/say.h"
#include "app/cli/standard_streams.h"
#include "app/editor/words/figure_notes.h"
#include "core/base/sentence.h"
#include "core/document/file_text.h"

namespace batten::cli {

namespace {

using Written = tl::expected<void, core::FileError>;

/// A file's error without a place in it.
tl::unexpected<core::FileError> failed(std::string what) {
    return tl::unexpected(core::FileError{"", std::move(what)});
}

Written write(const std::filesystem::path& file, std::string_view bytes, Output output) {
    if (!is_standard(file)) return core::replace_text(file, bytes);
    output.results << bytes;
    return {};
}

double share_of(std::size_t frame, std::size_t count) {
    return count < 2 ? 0.0 : static_cast<double>(frame) / static_cast<double>(count - 1);
}

Written write_still(FigureFrames& frames, render::FigureFormat format, const FigureOptions& options, Output output,
                    render::FigureLosses& losses) {
    const render::Figure figure = frames.at(0.0);
    add_losses(losses, render::figure_losses(figure, format));
    const auto bytes = render::figure_bytes(figure, format);
    return bytes ? write(options.result, *bytes, output) : failed(bytes.error());
}

Written write_frames(FigureFrames& frames, render::FigureFormat format, const std::filesystem::path& pattern,
                     std::size_t count, render::FigureLosses& losses) {
    for (std::size_t k = 0; k < count; ++k) {
        const render::Figure figure = frames.at(share_of(k, count));
        add_losses(losses, render::figure_losses(figure, format));
        const auto bytes = render::figure_bytes(figure, format);
        if (!bytes) return failed(bytes.error());
        if (auto written = core::replace_text(frame_name(pattern, k), *bytes); !written) return written;
    }
    return {};
}

Written write_movie(FigureFrames& frames, const FigureOrder& order, const std::filesystem::path& file, Output output,
                    render::FigureLosses& losses) {
    auto maker = MovieMaker::make();
    if (!maker) return failed(maker.error());
    for (std::size_t k = 0; k < order.frames; ++k) {
        const render::Figure figure = frames.at(share_of(k, order.frames));
        add_losses(losses, render::figure_losses(figure, render::FigureFormat::png));
        const auto png = render::png_bytes(figure);
        if (!png) return failed(png.error());
        if (const auto added = maker->add(*png); !added) return failed(added.error());
    }
    const auto movie = maker->movie(std::get<MovieFormat>(order.format), order.rate);
    return movie ? write(file, *movie, output) : failed(movie.error());
}

Written write_all(FigureFrames& frames, const FigureOrder& order, const FigureOptions& options, Output output,
                  render::FigureLosses& losses) {
    if (std::holds_alternative<MovieFormat>(order.format))
        return write_movie(frames, order, options.result, output, losses);
    const auto format = std::get<render::FigureFormat>(order.format);
    return order.motion ? write_frames(frames, format, options.result, order.frames, losses)
                        : write_still(frames, format, options, output, losses);
}

ExitStatus say_wrong_order(Output output, const std::string& what) {
    return say_wrong_usage(output, core::sentence("batten figure: {problem}", {{"problem", what}}));
}

/// A figure does not hold the curves that it is of.
std::optional<std::string> problem_of_result(const FigureOptions& options) {
    std::error_code error;
    if (is_standard(options.result) || !std::filesystem::equivalent(options.file, options.result, error))
        return std::nullopt;
    return core::sentence("-o: '{file}' is the file that is drawn; the figure needs a name of its own",
                          {{"file", options.result.string()}});
}

/// What is wrong with the name of the frames, if anything is.
std::optional<std::string> problem_of_name(const FigureOrder& order, const std::filesystem::path& file) {
    const bool has_frames = order.motion && std::holds_alternative<render::FigureFormat>(order.format);
    const std::size_t places = frame_number_count(file);
    if (!has_frames || places == 1) return std::nullopt;
    return core::sentence({.one = "",
                           .many = "-o: '{found}' has {count} places for the number of a frame; one is needed, as in "
                                   "frame-%03d.png",
                           .none = "-o: '{found}' has no place for the number of a frame; one is needed, as in "
                                   "frame-%03d.png"},
                          places, {{"found", file.string()}});
}

}  // namespace

ExitStatus figure(const FigureOptions& options, Output output) {
    const auto order = read_order(options);
    if (!order) return say_wrong_order(output, order.error());
    if (const auto problem = problem_of_name(*order, options.result)) return say_wrong_order(output, *problem);
    if (const auto problem = problem_of_result(options)) return say_wrong_order(output, *problem);
    std::optional<core::Document> document = load(output, options.file);
    if (!document) return ExitStatus::wrong_input;
    const std::optional<std::size_t> index = find_curve(output, options.file, *document, options.curve);
    if (!index) return ExitStatus::wrong_input;
    document->active = *index;
    document->curves[*index].visible = true;
    auto frames = FigureFrames::make(*document, *order);
    if (!frames) {
        say_error(output, options.file, core::sentence("curve '{name}'", {{"name", document->active_curve()->name}}),
                  frames.error());
        return ExitStatus::wrong_input;
    }
    render::FigureLosses losses;
    const Written written = write_all(*frames, *order, options, output, losses);
    if (!frames->note().empty()) say_error(output, result_name(options.result), "", frames->note());
    if (const auto idle = idle_words(options, *document); !idle.empty())
        say_error(output, result_name(options.result), "", note_on_idle_words(idle));
    for (const std::string& note : editor::figure_notes(losses))
        say_error(output, result_name(options.result), "", note);
    if (written) return ExitStatus::done;
    say_error(output, result_name(options.result), written.error());
    return ExitStatus::wrong_input;
}

}  // namespace batten::cli
