#include "app/editor/cards/corner_cutting_card.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/file_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/refinement_commands.h"
#include "app/editor/commands/subdivision_commands.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/derived/shown_cutting.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/wording.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

using core::sentence;

constexpr std::size_t most_formulas = 6;         // of more new points there is a table
constexpr double least_distance_of_size = 1e-9;  // an older polygon that is nearer is the one the curve came from

/// Writes about one cutting.
class CuttingText {
  public:
    CuttingText(const EditorState& state, const ShownCutting& shown)
        : notation_(state.view.notation),
          shown_(shown),
          curve_(*state.shown().active_curve()->curve),
          has_weights_(std::ranges::any_of(shown.cutting.corners, [&](const core::OldCorner& corner) {
              return corner.weight != shown.cutting.corners.front().weight;
          })) {}

    std::string number(double value) const { return exact_text(notation_, value); }

    /// "Inserting u = 1/2 puts 3 new points in the place of 2."
    std::string headline() const {
        const core::Place u("u", number(shown_.cutting.u));
        const core::Place places("new", shown_.cutting.cuts.size());
        const std::size_t gone = shown_.cutting.corners.size() - 2;
        if (shown_.has_happened)
            return sentence({.one = "Knot {u} came in: {new} new points took the place of one.",
                             .many = "Knot {u} came in: {new} new points took the place of {count}.",
                             .none = "Knot {u} came in: one new point lies on a leg."},
                            gone, {u, places});
        return sentence({.one = "Inserting u = {u} puts {new} new points in the place of one.",
                         .many = "Inserting u = {u} puts {new} new points in the place of {count}.",
                         .none = "Inserting u = {u} puts one new point on a leg."},
                        gone, {u, places});
    }

    /// "The knot then has multiplicity 1: C^{2} there."
    std::string continuity() const {
        const int multiplicity = shown_.cutting.multiplicity + 1;
        return sentence(
            "Its multiplicity becomes {multiplicity}: {continuity} there.",
            {{"multiplicity", multiplicity}, {"continuity", continuity_text(curve_.degree() - multiplicity)}});
    }

    std::string corner(std::size_t j) const { return fmt::format("P_{{{}}}", shown_.cutting.corners[j].index); }
    std::string cut_name(std::size_t j) const { return fmt::format("Q_{{{}}}", shown_.cutting.cuts[j].i); }

    /// "Q_{3} = 1/6 P_{2} + 5/6 P_{3}"; of different weights "w Q" for "Q" and "w P" for "P".
    std::string blend(std::size_t j) const {
        const core::LegCut& cut = shown_.cutting.cuts[j];
        const auto weighted = [&](const std::string& name, const std::string& index) {
            return has_weights_ ? fmt::format("w_{{{}}} {}", index, name) : name;
        };
        const std::string from = weighted(corner(j), std::to_string(shown_.cutting.corners[j].index));
        const std::string to = weighted(corner(j + 1), std::to_string(shown_.cutting.corners[j + 1].index));
        return fmt::format("{} = {} {} + {} {}", weighted(cut_name(j), fmt::format("Q{}", cut.i)),
                           number(1.0 - cut.alpha), from, number(cut.alpha), to);
    }

    /// "α_{3} = (u − u_{3})/(u_{6} − u_{3})"
    std::string alpha(std::size_t j) const {
        const core::LegCut& cut = shown_.cutting.cuts[j];
        const auto p = static_cast<std::size_t>(curve_.degree());
        return fmt::format("α_{{{0}}} = (u − u_{{{0}}})/(u_{{{1}}} − u_{{{0}}})", cut.i, cut.i + p);
    }

    /// "= (1/2 − 0)/(3/5 − 0) = 5/6"
    std::string alpha_numbers(std::size_t j) const {
        const core::LegCut& cut = shown_.cutting.cuts[j];
        const std::string lower = in_difference(cut.knots.lower);
        return fmt::format("= ({} − {})/({} − {}) = {}", number(shown_.cutting.u), lower, number(cut.knots.upper),
                           lower, number(cut.alpha));
    }

    /// "w_{Q3} = 1/6 · 1 + 5/6 · 2 = 11/6, so Q_{3} is at 10/11 of its leg"
    std::string weight(std::size_t j) const {
        const core::LegCut& cut = shown_.cutting.cuts[j];
        return fmt::format("w_{{Q{}}} = {} · {} + {} · {} = {}", cut.i, number(1.0 - cut.alpha),
                           number(shown_.cutting.corners[j].weight), number(cut.alpha),
                           number(shown_.cutting.corners[j + 1].weight), number(cut.weight));
    }

    std::string share(std::size_t j) const {
        return sentence("{point} is at {share} of its leg",
                        {{"point", cut_name(j)}, {"share", number(shown_.cutting.cuts[j].leg_share)}});
    }

    /// What lights up with a new point: itself where it is there, else the leg on which it would be.
    Hover hover(std::size_t j) const {
        if (shown_.has_happened) return HoveredPoint{shown_.cutting.cuts[j].new_index};
        return HoveredLeg{shown_.cutting.corners[j].index};
    }

    /// Whether the weights differ where corners are cut; else they do not matter.
    bool has_weights() const { return has_weights_; }

  private:
    std::string in_difference(double value) const {
        const std::string text = number(value);
        return value < 0.0 ? fmt::format("({})", text) : text;
    }

    const Notation& notation_;
    const ShownCutting& shown_;
    const core::Curve& curve_;
    bool has_weights_;
};

void add_cut_formulas(Card& card, const CuttingText& text, const ShownCutting& shown) {
    for (std::size_t j = 0; j < shown.cutting.cuts.size(); ++j) {
        card.add(CardLine{{.text = text.blend(j), .tone = CardTone::strong, .hover = text.hover(j)}, true});
        card.add(CardLine{{.text = text.alpha(j), .tone = CardTone::dim, .hover = text.hover(j)}, true});
        card.add(CardLine{{.text = text.alpha_numbers(j), .tone = CardTone::dim, .hover = text.hover(j)}, true});
        if (!text.has_weights()) continue;
        card.add(CardLine{{.text = text.weight(j), .tone = CardTone::dim, .hover = text.hover(j)}, true});
        card.line(text.share(j), CardTone::dim);
    }
}

void add_table(Card& card, const CuttingText& text, const ShownCutting& shown) {
    CardTable table{.rows = {{{.text = "point"}, {.text = "leg"}, {.text = "α"}}}, .has_heading = true};
    for (std::size_t j = 0; j < shown.cutting.cuts.size(); ++j)
        table.rows.push_back(
            {{.text = text.cut_name(j), .tone = CardTone::strong, .hover = text.hover(j)},
             {.text = fmt::format("{} {}", text.corner(j), text.corner(j + 1)), .hover = text.hover(j)},
             {.text = text.number(shown.cutting.cuts[j].alpha), .hover = text.hover(j)}});
    card.add(std::move(table));
}

/// What was done to the points since, which no insertion explains.
void add_deviation(Card& card, const EditorState& state, const ShownCutting& shown) {
    const core::Curve& curve = *state.shown().active_curve()->curve;
    if (!shown.has_happened || is_within_tolerance(curve, shown.deviation, least_distance_of_size)) return;
    card.line(sentence("Points were moved since: no older polygon gives exactly these. The nearest one, shown as a "
                       "ghost, moves the curve by at most {deviation}.",
                       {{"deviation", bound_text(shown.deviation)}}),
              CardTone::bad);
}

CardButtons buttons_of(const EditorState& state, const ShownCutting& shown) {
    CardButtons buttons;
    if (shown.has_happened) {
        if (const auto tolerance = suggest::tiny_length(state))
            buttons.buttons.push_back(
                {"Take it out again", RemoveKnot{.u = shown.cutting.u, .times = 1, .tolerance = *tolerance}});
        if (shown.cutting.cuts.size() > 1)
            buttons.buttons.push_back({"Insert it once more", InsertKnot{.u = shown.cutting.u}});
    } else {
        buttons.buttons.push_back({"Insert it", InsertKnot{.u = shown.cutting.u}});
    }
    buttons.buttons.push_back({"Next toward Bézier form", InsertForBezier{}});
    return buttons;
}

}  // namespace

Card corner_cutting_card(const EditorState& state) {
    Card card{.title = "Corner cutting", .blocks = {}};
    const auto shown = shown_cutting(state);
    if (!shown) {
        card.line(sentence("Nothing to cut: {reason}.", {{"reason", shown.error()}}));
        card.add(CardButtons{{{"Open an example", OpenExample{.name = "knot-insertion"}}}});
        return card;
    }
    const CuttingText text(state, *shown);
    card.line(text.headline());
    card.line(text.continuity(), CardTone::dim);
    if (shown->cutting.cuts.size() <= most_formulas)
        add_cut_formulas(card, text, *shown);
    else
        add_table(card, text, *shown);
    add_deviation(card, state, *shown);
    card.line(shown->has_happened
                  ? "The ghost is the polygon before, with its names in parentheses, which the formulas use; "
                    "dashed in the plot are the functions before."
                  : "Drag u, and the new points slide along their legs; dashed in the plot are the "
                    "functions after the insertion.",
              CardTone::dim);
    card.add(buttons_of(state, *shown));
    return card;
}

}  // namespace batten::editor
