#include "app/cli/figure_order.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "app/cli/figure_show.h"
#include "app/cli/frame_names.h"
#include "app/cli/standard_streams.h"
#include "app/editor/fields/expression.h"
#include "app/editor/scene/figure_scene.h"
#include "core/base/ascii.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/base/utf8.h"

namespace batten::cli {

namespace {

using core::sentence;
using editor::Overlay;

/// Nothing, or what is wrong.
using Checked = tl::expected<void, std::string>;

constexpr double most_side_px = 10000.0;
constexpr double rounding_px = 1e-6;  // of sizes that are multiplied by a scale

Checked read_theme(FigureOrder& order, const std::string& theme) {
    order.parts.high_contrast = theme == "high-contrast";
    const auto found = core::value_named<editor::ThemeName>(theme);
    if (!found && !order.parts.high_contrast)
        return tl::unexpected(
            sentence("--theme: '{found}' is no theme; dark, light and high-contrast are", {{"found", theme}}));
    order.theme = found.value_or(editor::ThemeName::light);
    return {};
}

/// A whole number of pixels; none for anything else.
std::optional<double> pixels_of(std::string_view text) {
    unsigned number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool is_whole = error == std::errc() && end == text.data() + text.size();
    return is_whole && number > 0 ? std::optional<double>(number) : std::nullopt;
}

Checked read_size(FigureOrder& order, const FigureOptions& options) {
    const std::size_t cross = std::min(options.size.find_first_of("xX"), options.size.size());
    const auto width = pixels_of(std::string_view(options.size).substr(0, cross));
    const auto height = pixels_of(std::string_view(options.size).substr(std::min(cross + 1, options.size.size())));
    if (!width || !height)
        return tl::unexpected(sentence("--size: '{found}' is no size; two whole numbers of pixels are, as in 800x450",
                                       {{"found", options.size}}));
    if (!(std::max(*width, *height) * options.scale <= most_side_px))
        return tl::unexpected(
            sentence("--size: a figure of {size} at a scale of {scale} cannot be made; each side may have "
                     "at most {most} pixels",
                     {{"size", options.size},
                      {"scale", core::shortest_text(options.scale)},
                      {"most", core::shortest_text(most_side_px)}}));
    order.size_px = {*width, *height};
    order.form.scale = options.scale;
    return {};
}

Checked check_height(const FigureOrder& order) {
    editor::View view;
    view.overlays = order.overlays;
    const double least = editor::least_figure_height(view, order.form, order.size_px.x);
    if (order.size_px.y >= least) return {};
    return tl::unexpected(sentence("--size: with these parts a figure needs a height of at least {least} pixels",
                                   {{"least", core::shortest_text(least)}}));
}

tl::expected<double, std::string> read_number(const char* option, std::string_view text) {
    return editor::parse_expression(text).map_error([&](const std::string& problem) {
        return sentence("{option}: {found}: {problem}",
                        {{"option", option}, {"found", std::string(text)}, {"problem", problem}});
    });
}

Checked read_parameter(FigureOrder& order, const std::string& at) {
    constexpr std::array at_parameter{Overlay::construction,  Overlay::hull,         Overlay::triangle,
                                      Overlay::halves,        Overlay::by_insertion, Overlay::osculating_circle,
                                      Overlay::tangent_normal};
    const bool needs_one =
        std::ranges::any_of(at_parameter, [&](Overlay overlay) { return order.overlays.is_shown(overlay); });
    if (needs_one || !at.empty()) order.parts.parameter = true;
    if (at.empty()) return {};
    const auto u = read_number("--at", at);
    if (!u) return tl::unexpected(u.error());
    order.at = *u;
    return {};
}

constexpr const char* motions =
    "u=0..1 (from one parameter to another), insert=0.5 (a knot) and merge=5 (the index of a knot)";

tl::expected<Motion, std::string> read_motion(const std::string& text) {
    const std::size_t sign = std::min(text.find('='), text.size());
    const std::string_view what = core::trimmed(std::string_view(text).substr(0, sign));
    const std::string_view how = std::string_view(text).substr(std::min(sign + 1, text.size()));
    const std::size_t dots = how.find("..");
    if (what == "u" && dots != std::string_view::npos) {
        const auto from = read_number("--animate", how.substr(0, dots));
        const auto to = read_number("--animate", how.substr(dots + 2));
        if (!from || !to) return tl::unexpected(from ? to.error() : from.error());
        return RunningParameter{{*from, *to}};
    }
    if (what == "insert") return read_number("--animate", how).map([](double u) { return Motion(InsertedKnot{u}); });
    if (what == "merge") {
        std::size_t index = 0;
        const auto [end, error] = std::from_chars(how.data(), how.data() + how.size(), index);
        if (error == std::errc() && end == how.data() + how.size()) return MergedKnot{index};
    }
    return tl::unexpected(
        sentence("--animate: '{found}' is no motion; {motions} are", {{"found", text}, {"motions", motions}}));
}

Checked read_animation(FigureOrder& order, const FigureOptions& options) {
    if (options.animate.empty() && (options.frames || options.rate))
        return tl::unexpected(sentence("{option}: nothing moves; --animate says what does",
                                       {{"option", options.frames ? "--frames" : "--rate"}}));
    if (options.animate.empty()) return {};
    auto motion = read_motion(options.animate);
    if (!motion) return tl::unexpected(std::move(motion.error()));
    if (std::holds_alternative<RunningParameter>(*motion)) {
        if (order.at) return tl::unexpected(std::string("--at: the parameter is what moves; leave one of the two out"));
        order.parts.parameter = true;
    }
    order.motion = *motion;
    order.frames = options.frames.value_or(order.frames);
    order.rate = options.rate.value_or(order.rate);
    return {};
}

std::optional<MovieFormat> movie_format(const std::filesystem::path& file) {
    const std::string ending = file.extension().string();
    if (ending == ".gif") return MovieFormat::gif;
    if (ending == ".mp4") return MovieFormat::mp4;
    return std::nullopt;
}

Checked read_format(FigureOrder& order, const FigureOptions& options) {
    const bool names_format = !options.format.empty();
    const std::filesystem::path named =
        names_format ? std::filesystem::path(sentence("figure.{format}", {{"format", options.format}}))
                     : options.result;
    const auto still = render::figure_format(named);
    const auto movie = movie_format(named);
    if (still) order.format = *still;
    if (movie) order.format = *movie;
    if (movie && !order.motion)
        return tl::unexpected(std::string("a GIF or MP4 needs --animate, which says what moves"));
    if (still && !order.motion && frame_number_count(options.result) > 0)
        return tl::unexpected(sentence("-o: '{found}' is a pattern for the frames that --animate makes",
                                       {{"found", options.result.string()}}));
    if (still || movie) return {};
    if (names_format)
        return tl::unexpected(
            sentence("--format: '{found}' is no format of figures; svg, pdf, png and tex are, and gif "
                     "and mp4 with --animate",
                     {{"found", options.format}}));
    if (is_standard(options.result))
        return tl::unexpected(std::string("--format is needed for standard output: svg, pdf, png or tex"));
    return tl::unexpected(
        sentence("-o: '{found}' has the ending of no figure; .svg, .pdf, .png and .tex are such, and .gif "
                 "and .mp4 with --animate",
                 {{"found", options.result.string()}}));
}

bool has_pixels(const FigureOrder& order) {
    const auto* still = std::get_if<render::FigureFormat>(&order.format);
    return still == nullptr || render::has_pixels(*still);
}

/// What has pixels has whole ones, and a movie of the kind MP4 an even number of them on each side.
void make_whole(FigureOrder& order) {
    const auto* movie = std::get_if<MovieFormat>(&order.format);
    const double step = movie != nullptr && *movie == MovieFormat::mp4 ? 2.0 : 1.0;
    const double scale = order.form.scale;
    for (double* side : {&order.size_px.x, &order.size_px.y})
        *side = step * std::ceil(scale * *side / step - rounding_px) / scale;
}

Checked check_scale(const FigureOrder& order) {
    if (has_pixels(order) || order.form.scale == 1.0) return {};
    return tl::unexpected(
        std::string("--scale is for pixels: PNG, GIF and MP4 have them; other figures can be enlarged as they are"));
}

Checked check_rate(const FigureOrder& order, const FigureOptions& options) {
    if (!options.rate || std::holds_alternative<MovieFormat>(order.format)) return {};
    return tl::unexpected(std::string("--rate: numbered frames have none; GIF and MP4 have one"));
}

Checked read_ground(FigureOrder& order, const FigureOptions& options) {
    const auto* movie = std::get_if<MovieFormat>(&order.format);
    if (options.is_transparent && movie != nullptr && *movie == MovieFormat::mp4)
        return tl::unexpected(std::string("--transparent: an MP4 has a ground; GIF and numbered PNG may have none"));
    order.form.is_transparent = options.is_transparent;
    return {};
}

Checked read_title(FigureOrder& order, const FigureOptions& options) {
    if (!core::is_utf8(options.title)) return tl::unexpected(std::string("--title: the text is not UTF-8"));
    order.form.title = options.title;
    return {};
}

}  // namespace

tl::expected<FigureOrder, std::string> read_order(const FigureOptions& options) {
    FigureOrder order;
    order.parts = {.points = false, .parameter = false, .legend = false, .arrow = false, .window = false};
    for (const auto& entry : core::Names<Overlay>::table) order.overlays.show(entry.value, false);
    Checked checked = read_show_and_view(order, options);
    if (checked) checked = read_theme(order, options.theme);
    if (checked) checked = read_size(order, options);
    if (checked) checked = read_parameter(order, options.at);
    if (checked) checked = read_animation(order, options);
    if (checked) checked = read_format(order, options);
    if (checked) checked = check_scale(order);
    if (checked) checked = check_rate(order, options);
    if (checked) checked = read_ground(order, options);
    if (checked) checked = read_title(order, options);
    if (checked) checked = check_height(order);
    if (!checked) return tl::unexpected(std::move(checked.error()));
    if (has_pixels(order))
        make_whole(order);
    else
        order.form.fineness = editor::fineness_to_enlarge;
    return order;
}

}  // namespace batten::cli
