#include <ostream>

#include "app/cli/figure_frames.h"
#include "app/cli/frame_names.h"
#include "app/cli/input.h"
#include "app/cli/movie.h"
#include "app/cli/standard_streams.h"
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

Written write_still(const FigureFrames& frames, render::FigureFormat format, const FigureOptions& options,
                    Output output) {
    const auto bytes = render::figure_bytes(frames.at(0.0), format);
    return bytes ? write(options.result, *bytes, output) : failed(bytes.error());
}

Written write_frames(const FigureFrames& frames, render::FigureFormat format, const FigureOptions& options) {
    for (std::size_t k = 0; k < options.frames; ++k) {
        const auto bytes = render::figure_bytes(frames.at(share_of(k, options.frames)), format);
        if (!bytes) return failed(bytes.error());
        if (auto written = core::replace_text(frame_name(options.result, k), *bytes); !written) return written;
    }
    return {};
}

Written write_movie(const FigureFrames& frames, MovieFormat format, const FigureOptions& options, Output output) {
    auto maker = MovieMaker::make();
    if (!maker) return failed(maker.error());
    for (std::size_t k = 0; k < options.frames; ++k) {
        const auto png = render::png_bytes(frames.at(share_of(k, options.frames)));
        if (!png) return failed(png.error());
        if (const auto added = maker->add(*png); !added) return failed(added.error());
    }
    const auto movie = maker->movie(format, options.rate);
    return movie ? write(options.result, *movie, output) : failed(movie.error());
}

Written write_all(const FigureFrames& frames, const FigureOrder& order, const FigureOptions& options, Output output) {
    if (const auto* movie = std::get_if<MovieFormat>(&order.format))
        return write_movie(frames, *movie, options, output);
    const auto format = std::get<render::FigureFormat>(order.format);
    return order.motion ? write_frames(frames, format, options) : write_still(frames, format, options, output);
}

ExitStatus say_wrong_order(Output output, const std::string& what) {
    output.errors << core::sentence("batten figure: {problem}", {{"problem", what}}) << '\n';
    return ExitStatus::wrong_usage;
}

/// What is wrong with the name of the frames, if anything is.
bool lacks_number(const FigureOrder& order, const FigureOptions& options) {
    return order.motion && std::holds_alternative<render::FigureFormat>(order.format) &&
           !has_frame_number(options.result);
}

}  // namespace

ExitStatus figure(const FigureOptions& options, Output output) {
    const auto order = read_order(options);
    if (!order) return say_wrong_order(output, order.error());
    if (lacks_number(*order, options))
        return say_wrong_order(
            output, core::sentence("-o: '{found}' has no place for the number of a frame; one is needed, as in "
                                   "frame-%03d.png",
                                   {{"found", options.result.string()}}));
    std::optional<core::Document> document = load(output, options.file);
    if (!document) return ExitStatus::wrong_input;
    const std::optional<std::size_t> index = find_curve(output, options.file, *document, options.curve);
    if (!index) return ExitStatus::wrong_input;
    document->active = *index;
    document->curves[*index].visible = true;
    const auto frames = FigureFrames::make(*document, *order);
    if (!frames) {
        say_error(output, options.file, core::sentence("curve '{name}'", {{"name", document->active_curve()->name}}),
                  frames.error());
        return ExitStatus::wrong_input;
    }
    const Written written = write_all(*frames, *order, options, output);
    if (written) return ExitStatus::done;
    say_error(output, options.result, written.error());
    return ExitStatus::wrong_input;
}

}  // namespace batten::cli
