#include "app/cli/figure_show.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "app/editor/words/nearest_name.h"
#include "core/base/ascii.h"
#include "core/base/sentence.h"

namespace batten::cli {

namespace {

using core::sentence;
using editor::FigureView;
using editor::Overlay;
using editor::PictureParts;

/// Nothing, or what is wrong.
using Checked = tl::expected<void, std::string>;

/// The pictures in which something is seen.
struct Sight {
    bool curve = false;
    bool basis = false;
    bool lifted = false;
};
constexpr Sight on_curve{.curve = true};
constexpr Sight on_basis{.basis = true};
constexpr Sight on_both{.curve = true, .basis = true};
constexpr Sight everywhere{.curve = true, .basis = true, .lifted = true};
constexpr Sight nowhere{};

bool sees(FigureView view, const Sight& sight) {
    switch (view) {
        case FigureView::curve:
            return sight.curve;
        case FigureView::basis:
            return sight.basis;
        case FigureView::both:
            return sight.curve || sight.basis;
        case FigureView::homogeneous:
            break;
    }
    return sight.lifted;
}

/// Words of --show that are no names of overlays.
struct ShownPart {
    const char* name;
    bool PictureParts::*part;
    Sight sight;
};
constexpr std::array shown_parts{
    ShownPart{"points", &PictureParts::points, {.curve = true, .lifted = true}},
    ShownPart{"legend", &PictureParts::legend, on_curve},
    ShownPart{"parameter", &PictureParts::parameter, everywhere},
    ShownPart{"arrow", &PictureParts::arrow, on_curve},
};

struct ShownContent {
    const char* name;
    bool FigureOrder::*content;
};
constexpr std::array shown_contents{ShownContent{"pictures", &FigureOrder::has_pictures},
                                    ShownContent{"guides", &FigureOrder::has_guides}};

struct OverlayAlias {
    const char* name;
    Overlay overlay;
};
constexpr std::array overlay_aliases{
    OverlayAlias{"deboor", Overlay::construction}, OverlayAlias{"comb", Overlay::curvature_comb},
    OverlayAlias{"bezier", Overlay::bezier_pieces}, OverlayAlias{"circle", Overlay::osculating_circle}};

constexpr const char* basis_word = "basis";
constexpr const char* usual_words = "polygon,points,labels";

Sight sight_of(Overlay overlay) {
    switch (overlay) {
        case Overlay::polygon:
            return {.curve = true, .lifted = true};
        case Overlay::labels:
            return everywhere;
        case Overlay::knots:
        case Overlay::corner_cutting:
        case Overlay::equal_steps:
        case Overlay::equal_lengths:
            return on_both;
        case Overlay::basis_pieces:
        case Overlay::basis_values:
        case Overlay::rational_basis:
        case Overlay::curvature_plot:
        case Overlay::speed_plot:
            return on_basis;
        // Cards of the window, and what is seen where its pointer is.
        case Overlay::recurrence:
        case Overlay::basis_derivatives:
        case Overlay::support:
        case Overlay::cubic_conditions:
        case Overlay::cubic_matrix:
        case Overlay::invariance:
        case Overlay::knot_questions:
        case Overlay::quiz:
            return nowhere;
        default:
            return on_curve;
    }
}

bool is_seen_at_all(Overlay overlay) {
    const Sight sight = sight_of(overlay);
    return sight.curve || sight.basis || sight.lifted;
}

template <class Table>
auto entry_named(const Table& table, std::string_view name) {
    return std::ranges::find_if(table, [&](const auto& entry) { return entry.name == name; });
}

/// "a, b or c" of all entries of a table.
template <class Table>
std::string alternatives(const Table& table) {
    std::vector<std::string> names;
    for (const auto& entry : table) names.emplace_back(entry.name);
    return core::listed_as_alternatives(names);
}

std::string unknown_name(const std::string& word) {
    if (const auto nearest = editor::nearest_name(word, names_to_show()))
        return sentence(
            "--show: there is nothing called '{name}' to show; did you mean '{nearest}'? 'batten figure "
            "--help' lists all that can be shown",
            {{"name", word}, {"nearest", *nearest}});
    return sentence(
        "--show: there is nothing called '{name}' to show; 'batten figure --help' lists all that can be "
        "shown",
        {{"name", word}});
}

/// Puts what `word` names into the order, and returns where it is seen.
tl::expected<Sight, std::string> take_word(FigureOrder& order, const std::string& word) {
    const auto* const part = entry_named(shown_parts, word);
    const auto* const content = entry_named(shown_contents, word);
    const auto* const alias = entry_named(overlay_aliases, word);
    const auto overlay = alias != overlay_aliases.end() ? alias->overlay : core::value_named<Overlay>(word);
    if (word == basis_word) return on_basis;
    if (part != shown_parts.end()) {
        order.parts.*part->part = true;
        return part->sight;
    }
    if (content != shown_contents.end()) {
        order.*content->content = true;
        return on_curve;
    }
    if (!overlay) return tl::unexpected(unknown_name(word));
    if (!is_seen_at_all(*overlay))
        return tl::unexpected(sentence("--show: '{name}' is seen in the window only, as a card or where the pointer is",
                                       {{"name", word}}));
    order.overlays.show(*overlay, true);
    return sight_of(*overlay);
}

std::string views_that_see(const Sight& sight) {
    std::vector<std::string> names;
    for (const auto& entry : core::Names<FigureView>::table)
        if (sees(entry.value, sight)) names.emplace_back(entry.name);
    return core::listed_as_alternatives(names);
}

Checked read_chosen_view(FigureOrder& order, const std::string& view) {
    if (view.empty()) return {};
    const auto found = core::value_named<FigureView>(view);
    if (!found)
        return tl::unexpected(sentence("--view: '{found}' is no view of a figure; {names} are",
                                       {{"found", view}, {"names", alternatives(core::Names<FigureView>::table)}}));
    order.form.view = *found;
    return {};
}

Checked read_word(FigureOrder& order, const std::string& word, bool has_chosen_view) {
    const auto sight = take_word(order, word);
    if (!sight) return tl::unexpected(sight.error());
    if (sees(order.form.view, *sight)) return {};
    if (!has_chosen_view) {
        order.form.view = FigureView::both;
        return {};
    }
    return tl::unexpected(
        sentence("--show: '{name}' is not seen with --view {view}, but with {views}",
                 {{"name", word}, {"view", core::name_of(order.form.view)}, {"views", views_that_see(*sight)}}));
}

}  // namespace

std::vector<std::string> words_between_commas(std::string_view text) {
    std::vector<std::string> words;
    if (core::trimmed(text).empty()) return words;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        words.emplace_back(core::trimmed(text.substr(begin, end - begin)));
        begin = end + 1;
    }
    return words;
}

std::vector<std::string> names_to_show() {
    std::vector<std::string> names;
    for (const ShownPart& entry : shown_parts) names.emplace_back(entry.name);
    for (const ShownContent& entry : shown_contents) names.emplace_back(entry.name);
    names.emplace_back(basis_word);
    for (const OverlayAlias& entry : overlay_aliases) names.emplace_back(entry.name);
    for (const auto& entry : core::Names<Overlay>::table)
        if (is_seen_at_all(entry.value)) names.emplace_back(entry.name);
    return names;
}

Checked read_show_and_view(FigureOrder& order, const FigureOptions& options) {
    if (auto chosen = read_chosen_view(order, options.view); !chosen) return chosen;
    const std::string usual = order.form.view == FigureView::basis ? "" : usual_words;
    const std::string given = options.show.value_or(usual);
    for (const std::string& word : words_between_commas(given)) {
        if (word.empty())
            return tl::unexpected(sentence(
                "--show: a name is missing beside a comma of '{found}'; names stand between commas, as in {usual}",
                {{"found", given}, {"usual", usual_words}}));
        if (auto read = read_word(order, word, !options.view.empty()); !read) return read;
    }
    if (order.parts.legend && !order.overlays.is_shown(Overlay::construction))
        return tl::unexpected(
            std::string("--show: 'legend' tells what the colors of 'deboor' mean, which is not shown"));
    return {};
}

}  // namespace batten::cli
