#include <fmt/core.h>

#include "app/editor/cards/weight_cards.h"
#include "app/editor/commands/file_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/weight_commands.h"
#include "app/editor/derived/active_conic.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/root_text.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

using core::ConicKind;
using core::sentence;

/// Writes what a conic is.
class ConicWriter {
  public:
    ConicWriter(const EditorState& state, const core::Curve& curve, const ActiveConic& conic, Card& card)
        : state_(state), curve_(curve), conic_(conic), card_(card) {}

    void write() {
        write_kind();
        write_weight();
        write_ratio();
        if (conic_.arc.circular_weight)
            write_angle();
        else
            write_unequal_legs();
        write_choices();
        card_.line("The faint line is the rest of the conic, which the weight −w draws.", CardTone::dim);
    }

  private:
    std::string exact(double value) const { return root_text(state_.view.notation, value); }
    double weight() const { return conic_.arc.form.weight; }

    void write_kind() {
        const core::Place w("w", exact(weight()));
        switch (conic_.arc.kind) {
            case ConicKind::ellipse:
                return strong(sentence("Ellipse: w = {w} is less than 1", {w}));
            case ConicKind::circle:
                return strong(sentence("Circle: w = {w} is sin a", {w}));
            case ConicKind::parabola:
                return strong("Parabola: w = 1");
            case ConicKind::hyperbola:
                return strong(sentence("Hyperbola: w = {w} is more than 1", {w}));
        }
    }
    void strong(std::string text) { card_.line(std::move(text), CardTone::strong); }

    /// Where the ends weigh something else than 1.
    void write_weight() {
        if (conic_.has_own_ends && conic_.end_scale == 1.0) return;
        if (!conic_.has_own_ends) {
            card_.line(sentence("The piece runs from {from} to {to}, its tangents meet in {corner}. With the weight 1 "
                                "at both ends its corner weighs w.",
                                {{"from", conic_.names[0]}, {"to", conic_.names[2]}, {"corner", conic_.names[1]}}),
                       CardTone::dim);
            return;
        }
        card_.formula(fmt::format("w = w_{{{1}}} / √(w_{{{0}}} w_{{{2}}}) = {3}", index(-1), index(0), index(1),
                                  exact(weight())));
    }

    std::size_t index(int offset) const {
        const std::size_t count = curve_.control_points().size();
        return (conic_.corner + count + static_cast<std::size_t>(offset + 1) - 1) % count;
    }

    void write_ratio() {
        card_.formula(
            fmt::format("|MX| / |M{}| = w / (1 + w) = {}", conic_.names[1], exact(conic_.arc.form.shoulder_ratio)),
            CardTone::accent);
    }

    void write_angle() {
        const double angle = conic_.arc.half_angle;
        card_.formula(fmt::format("a = {}°, sin a = {}", number_text(angle), exact(*conic_.arc.circular_weight)),
                      CardTone::parameter);
        card_.line(
            sentence("a is half the angle at {corner}. With w = sin a the arc is one of a circle, of 180° − 2a = "
                     "{sweep}°.",
                     {{"corner", conic_.names[1]}, {"sweep", number_text(180.0 - 2.0 * angle)}}));
    }

    void write_unequal_legs() {
        card_.line(
            sentence("No weight makes a circle: |{from}{corner}| = {first} and |{corner}{to}| = {second} differ.",
                     {{"from", conic_.names[0]},
                      {"corner", conic_.names[1]},
                      {"to", conic_.names[2]},
                      {"first", exact(conic_.arc.legs[0])},
                      {"second", exact(conic_.arc.legs[1])}}));
    }

    void write_choices() {
        if (!conic_.has_own_ends) {
            card_.line(
                "Where both knots of a piece occur twice, its ends are control points, and the weight between them "
                "decides its kind alone.",
                CardTone::dim);
            return;
        }
        CardButtons kinds;
        const auto add = [&](const char* text, ConicKind kind, const Command& command) {
            kinds.buttons.push_back({text, command, conic_.arc.kind == kind});
        };
        const auto with_weight = [&](double w) {
            return SetWeight{.index = conic_.corner, .weight = conic_.end_scale * w};
        };
        if (conic_.arc.circular_weight) {
            add("Circle: w = sin a", ConicKind::circle, MakeCircular{.u = state_.parameter()});
        }
        add("Ellipse: w = 1/2", ConicKind::ellipse, with_weight(0.5));
        add("Parabola: w = 1", ConicKind::parabola, with_weight(1.0));
        add("Hyperbola: w = 2", ConicKind::hyperbola, with_weight(2.0));
        card_.add(std::move(kinds));
    }

    const EditorState& state_;
    const core::Curve& curve_;
    const ActiveConic& conic_;
    Card& card_;
};

Card& write_refusal(Card& card, const core::Curve& curve, const core::CurveError& error) {
    if (error.code == core::CurveErrorCode::points_collinear)
        return card.line("The three points of this piece lie on one line: it is straight.");
    card.line(sentence("A conic is a rational piece of degree 2; this curve has degree {degree}.",
                       {{"degree", curve.degree()}}));
    return card.add(CardButtons{{{"Example: conic by its weight", OpenExample{.name = "conic-weight"}}}});
}

}  // namespace

Card conic_card(const EditorState& state) {
    Card card{.title = "Conic", .blocks = {}};
    const core::Curve* curve = state.visible_active_curve();
    if (curve == nullptr) return card.line("There is no curve to be seen.", CardTone::dim);
    const auto conic = active_conic(*curve, state.parameter());
    if (!conic) return write_refusal(card, *curve, conic.error());
    ConicWriter(state, *curve, *conic, card).write();
    return card;
}

}  // namespace batten::editor
