#include "app/editor/cards/basis_pieces_card.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/editor/cards/card_texts.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/derived/shown_function.h"
#include "app/editor/words/basis_formula.h"
#include "app/editor/words/uniform_cubic_formula.h"
#include "core/base/sentence.h"
#include "core/evaluate/basis.h"

namespace batten::editor {

namespace {

constexpr std::size_t most_functions = 12;

class PieceLines {
  public:
    PieceLines(const EditorState& state, HoveredBasisCell cell)
        : state_(state),
          knots_(state.active_curve()->knots()),
          cell_(cell),
          theme_(shown_theme(state.view)),
          variable_(local_parameter(state.view.notation)) {}

    void add_to(Card& card) const {
        const auto pieces = core::basis_pieces(knots_, cell_.function, static_cast<int>(cell_.degree));
        if (pieces.empty()) card.line("All its knots are one: it is 0 everywhere.", CardTone::dim);
        for (std::size_t n = 0; n < pieces.size(); ++n) add_piece(card, n, pieces[n]);
        if (is_evenly_spaced()) card.line(shift_sentence(), CardTone::dim);
    }

  private:
    std::string number(double value) const { return exact_text(state_.view.notation, value); }

    std::string place(double u) const { return knot_value_text(knots_, u, state_.view.notation); }

    std::string name() const {
        return cell_.degree == static_cast<std::size_t>(knots_.degree()) ? function_name(state_, knots_, cell_.function)
                                                                         : basis_name(cell_.function, cell_.degree);
    }

    bool is_evenly_spaced() const {
        const core::KnotKind kind = state_.derived.of(knots_)->kind;
        return kind == core::KnotKind::uniform || kind == core::KnotKind::periodic;
    }

    std::string shift_sentence() const {
        const double step = knots_[1] - knots_[0];
        const char* pattern =
            step == 1.0
                ? "The knots are equally spaced: each N_{{i,{k}}}(u) is N_{{0,{k}}}(u − i), the first one shifted."
                : "The knots are equally spaced: each N_{{i,{k}}}(u) is N_{{0,{k}}}(u − i · {step}), the first one "
                  "shifted.";
        return core::filled_as_needed(pattern, {{"k", cell_.degree}, {"step", number(step)}});
    }

    void add_piece(Card& card, std::size_t n, const core::BasisPiece& piece) const {
        card.add(CardLine{{.text = core::sentence("{function} on [{lower}, {upper}) = [{begin}, {end})",
                                                  {{"function", name()},
                                                   {"lower", fmt::format("u_{{{}}}", piece.span)},
                                                   {"upper", fmt::format("u_{{{}}}", piece.span + 1)},
                                                   {"begin", place(piece.interval.lower)},
                                                   {"end", place(piece.interval.upper)}}),
                           .tone = CardTone::strong,
                           .hover = HoveredSpan{piece.span},
                           .color = theme_.level(n + 1)}});
        add_form(card, piece, piece.in_u, "u");
        if (piece.interval == core::Interval{0.0, 1.0}) return;  // t is u
        add_form(card, piece, piece.in_t, variable_);
        card.formula(substitution(piece), CardTone::dim);
    }

    void add_form(Card& card, const core::BasisPiece& piece, const core::PowerForm& form,
                  const std::string& variable) const {
        card.add(
            CardLine{{.text = core::sentence("= {polynomial}",
                                             {{"polynomial", polynomial_text(form, variable, state_.view.notation)}}),
                      .hover = HoveredSpan{piece.span}},
                     true});
    }

    /// "with t = (u − 1)/2".
    std::string substitution(const core::BasisPiece& piece) const {
        const double begin = piece.interval.lower;
        const double length = piece.interval.length();
        return core::filled_as_needed(substitution_pattern(begin, length), {{"t", variable_},
                                                                            {"begin", place(std::abs(begin))},
                                                                            {"length", number(length)},
                                                                            {"factor", number(1.0 / length)}});
    }

    static const char* substitution_pattern(double begin, double length) {
        if (length == 1.0) return begin < 0.0 ? "with {t} = u + {begin}" : "with {t} = u − {begin}";
        if (length != std::floor(length)) {
            if (begin == 0.0) return "with {t} = {factor} u";
            return begin < 0.0 ? "with {t} = {factor} (u + {begin})" : "with {t} = {factor} (u − {begin})";
        }
        if (begin == 0.0) return "with {t} = u/{length}";
        return begin < 0.0 ? "with {t} = (u + {begin})/{length}" : "with {t} = (u − {begin})/{length}";
    }

    const EditorState& state_;
    const core::KnotVector& knots_;
    HoveredBasisCell cell_;
    Theme theme_;
    std::string variable_;
};

/// The functions by name, each a click away: all of a few, else those of the active span.
CardButtons function_buttons(const EditorState& state, std::size_t shown) {
    const core::KnotVector& knots = state.active_curve()->knots();
    const std::size_t n = knots.control_point_count();
    const auto p = static_cast<std::size_t>(knots.degree());
    const bool are_few = n <= most_functions;
    const std::size_t first = are_few ? 0 : core::basis_functions(knots, state.parameter()).span - p;
    const std::size_t count = are_few ? n : std::min(p + 1, most_functions);
    CardButtons buttons;
    for (std::size_t k = first; k < first + count; ++k)
        buttons.buttons.push_back(
            {function_name(state, knots, k % n), SelectPoints{.points = {k % n}}, k % n == shown});
    return buttons;
}

}  // namespace

Card basis_pieces_card(const EditorState& state) {
    Card card{.title = "Polynomials", .blocks = {}};
    const std::optional<HoveredBasisCell> cell = shown_basis_cell(state);
    if (!cell) return card_without_curve(std::move(card));
    card.add(function_buttons(state, shown_function(state)->index));
    PieceLines(state, *cell).add_to(card);
    return card;
}

}  // namespace batten::editor
