#include "app/cli/figure_order.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "app/cli/standard_streams.h"
#include "app/editor/fields/expression.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/base/utf8.h"

namespace batten::cli {

namespace {

using core::sentence;
using editor::Overlay;
using editor::PictureParts;

/// Nothing, or what is wrong.
using Checked = tl::expected<void, std::string>;

constexpr double most_side_px = 10000.0;
constexpr std::size_t most_figure_frames = 10000;
constexpr core::Interval frame_rates{0.1, 100.0};

/// Words of --show that are no names of overlays.
struct ShownPart {
    const char* name;
    bool PictureParts::*part;
};
constexpr std::array shown_parts{ShownPart{"points", &PictureParts::points}, ShownPart{"legend", &PictureParts::legend},
                                 ShownPart{"parameter", &PictureParts::parameter}};

struct OverlayAlias {
    const char* name;
    Overlay overlay;
};
constexpr std::array overlay_aliases{
    OverlayAlias{"deboor", Overlay::construction}, OverlayAlias{"comb", Overlay::curvature_comb},
    OverlayAlias{"bezier", Overlay::bezier_pieces}, OverlayAlias{"circle", Overlay::osculating_circle}};

constexpr const char* basis_word = "basis";

/// "a, b or c" of all entries of a table.
template <class Table>
std::string alternatives(const Table& table) {
    std::vector<std::string> names;
    for (const auto& entry : table) names.emplace_back(entry.name);
    return core::listed_as_alternatives(names);
}

std::string words_of_show() {
    std::vector<std::string> names;
    for (const ShownPart& entry : shown_parts) names.emplace_back(entry.name);
    names.emplace_back(basis_word);
    for (const OverlayAlias& entry : overlay_aliases) names.emplace_back(entry.name);
    for (const auto& entry : core::Names<Overlay>::table) names.emplace_back(entry.name);
    return core::listed_as_alternatives(names);
}

std::string_view trimmed(std::string_view text) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    while (text.ends_with(' ')) text.remove_suffix(1);
    return text;
}

std::vector<std::string> words_between_commas(std::string_view text) {
    std::vector<std::string> words;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(','), text.size());
        if (const std::string_view word = trimmed(text.substr(0, end)); !word.empty()) words.emplace_back(word);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return words;
}

template <class Table>
auto entry_named(const Table& table, std::string_view name) {
    return std::ranges::find_if(table, [&](const auto& entry) { return entry.name == name; });
}

Checked read_shown(FigureOrder& order, const std::string& show) {
    for (const std::string& word : words_between_commas(show)) {
        const auto* const part = entry_named(shown_parts, word);
        const auto* const alias = entry_named(overlay_aliases, word);
        const auto overlay = core::value_named<Overlay>(word);
        if (part != shown_parts.end())
            order.parts.*part->part = true;
        else if (word == basis_word)
            order.form.view = editor::FigureView::both;
        else if (alias != overlay_aliases.end())
            order.overlays.show(alias->overlay, true);
        else if (overlay)
            order.overlays.show(*overlay, true);
        else
            return tl::unexpected(
                sentence("--show: there is nothing called '{name}' to show; what can be shown is {names}",
                         {{"name", word}, {"names", words_of_show()}}));
    }
    return {};
}

Checked read_view(FigureOrder& order, const std::string& view) {
    if (view.empty()) return {};
    const auto found = core::value_named<editor::FigureView>(view);
    if (!found)
        return tl::unexpected(
            sentence("--view: '{found}' is no view of a figure; {names} are",
                     {{"found", view}, {"names", alternatives(core::Names<editor::FigureView>::table)}}));
    order.form.view = *found;
    return {};
}

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
    if (!(options.scale > 0.0) || !(std::max(*width, *height) * options.scale <= most_side_px))
        return tl::unexpected(
            sentence("--size: a figure of {size} at a scale of {scale} cannot be made; each side may have "
                     "at most {most} pixels, and the scale is more than 0",
                     {{"size", options.size},
                      {"scale", core::shortest_text(options.scale)},
                      {"most", core::shortest_text(most_side_px)}}));
    order.size_px = {*width, *height};
    order.form.scale = options.scale;
    return {};
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
    const std::string_view what = trimmed(std::string_view(text).substr(0, sign));
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
    if (options.animate.empty()) return {};
    auto motion = read_motion(options.animate);
    if (!motion) return tl::unexpected(std::move(motion.error()));
    if (std::holds_alternative<RunningParameter>(*motion)) order.parts.parameter = true;
    order.motion = *motion;
    if (options.frames == 0 || options.frames > most_figure_frames)
        return tl::unexpected(sentence("--frames: {count} frames cannot be made; from 1 to {most} can",
                                       {{"count", options.frames}, {"most", most_figure_frames}}));
    if (!frame_rates.contains(options.rate))
        return tl::unexpected(sentence("--rate: {rate} frames a second are not possible; from {least} to {most} are",
                                       {{"rate", core::shortest_text(options.rate)},
                                        {"least", core::shortest_text(frame_rates.lower)},
                                        {"most", core::shortest_text(frame_rates.upper)}}));
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

Checked check_scale(const FigureOrder& order) {
    const auto* still = std::get_if<render::FigureFormat>(&order.format);
    const bool has_pixels = still == nullptr || *still == render::FigureFormat::png;
    if (has_pixels || order.form.scale == 1.0) return {};
    return tl::unexpected(
        std::string("--scale is for pixels: PNG, GIF and MP4 have them; other figures can be enlarged as they are"));
}

Checked read_title(FigureOrder& order, const FigureOptions& options) {
    if (!core::is_utf8(options.title)) return tl::unexpected(std::string("--title: the text is not UTF-8"));
    order.form.title = options.title;
    order.form.is_transparent = options.is_transparent;
    return {};
}

}  // namespace

tl::expected<FigureOrder, std::string> read_order(const FigureOptions& options) {
    FigureOrder order;
    order.parts = {.points = false, .parameter = false, .legend = false, .window = false};
    for (const auto& entry : core::Names<Overlay>::table) order.overlays.show(entry.value, false);
    Checked checked = read_shown(order, options.show);
    if (checked) checked = read_view(order, options.view);
    if (checked) checked = read_theme(order, options.theme);
    if (checked) checked = read_size(order, options);
    if (checked) checked = read_parameter(order, options.at);
    if (checked) checked = read_animation(order, options);
    if (checked) checked = read_format(order, options);
    if (checked) checked = check_scale(order);
    if (checked) checked = read_title(order, options);
    if (!checked) return tl::unexpected(std::move(checked.error()));
    return order;
}

}  // namespace batten::cli
