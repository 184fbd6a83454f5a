#include "app/cli/figure_idle.h"

#include <fmt/format.h>

#include <optional>

#include "app/cli/figure_frames.h"
#include "app/cli/figure_show.h"
#include "core/base/sentence.h"
#include "render/svg_painter.h"

namespace batten::cli {

namespace {

/// A figure with what it has no room for, as text.
std::string text_of(const render::Figure& figure) {
    return fmt::format("{}{}{}", render::svg_text(figure), fmt::join(figure.unplaced, ","),
                       figure.lacks_legend ? "legend" : "");
}

/// None where the order cannot be read or drawn.
std::optional<std::string> look(const FigureOptions& options, const core::Document& document) {
    const auto order = read_order(options);
    if (!order) return std::nullopt;
    auto frames = FigureFrames::make(document, *order);
    if (!frames) return std::nullopt;
    std::string text = text_of(frames->at(0.0));
    if (order->motion)
        for (const double share : {0.5, 1.0}) text += text_of(frames->at(share));
    return text;
}

}  // namespace

std::vector<std::string> idle_words(const FigureOptions& options, const core::Document& document) {
    std::vector<std::string> idle;
    const std::vector<std::string> words = words_between_commas(options.show.value_or(""));
    if (words.empty()) return idle;
    const auto whole = look(options, document);
    for (const std::string& word : words) {
        std::vector<std::string> others = words;
        std::erase(others, word);
        FigureOptions without = options;
        without.show = fmt::format("{}", fmt::join(others, ","));
        if (whole && look(without, document) == whole) idle.push_back(word);
    }
    return idle;
}

std::string note_on_idle_words(const std::vector<std::string>& words) {
    return core::sentence({.one = "--show: {names} adds nothing to this figure: there is nothing of that kind, or "
                                  "it stands there already",
                           .many = "--show: {names} add nothing to this figure: there is nothing of these kinds, "
                                   "or it stands there already"},
                          words.size(), {{"names", fmt::format("{}", fmt::join(words, ", "))}});
}

}  // namespace batten::cli
