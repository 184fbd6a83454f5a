#include "app/editor/cards/continuity_card.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/file_commands.h"
#include "app/editor/derived/continuity_meter.h"
#include "app/editor/state/state.h"
#include "app/editor/words/continuity_words.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/wording.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

using core::JointContinuity;
using core::Place;
using core::sentence;

constexpr std::size_t most_joint_rows = 10;
constexpr double least_bend = 1e-12;  // of curvature times size, which is not above its rounding

void offer_curve_with_knots(Card& card) {
    card.add(CardButtons{{{.text = "Open an example", .command = OpenExample{.name = "quadratic-double-knot"}}}});
}

class ContinuityCard {
  public:
    explicit ContinuityCard(const EditorState& state)
        : state_(state), notation_(state.view.notation), meter_(continuity_meter(state, most_joint_rows)) {
        for (std::size_t i = 1; i < meter_.rows.size(); ++i) {
            const double u = meter_.rows[i].joint.u;
            digits_ = std::max(digits_, digits_that_tell_apart(meter_.rows[i - 1].joint.u, u, u));
        }
    }

    Card made() {
        card_.title = "Continuity";
        if (meter_.count == 0) {
            card_.line("No knot lies inside the domain: the curve is one piece.", CardTone::dim);
            offer_curve_with_knots(card_);
        }
        if (meter_.focus) add_focus(*meter_.focus);
        add_joints();
        if (meter_.rows.size() < meter_.count)
            card_.line(
                sentence("Knots {first} to {last} of {count}, around u.", {{"first", meter_.first + 1},
                                                                           {"last", meter_.first + meter_.rows.size()},
                                                                           {"count", meter_.count}}),
                CardTone::dim);
        return std::move(card_);
    }

  private:
    std::string number(double value) const { return exact_text(notation_, value); }
    std::string vector(core::Vector v) const {
        const core::Vector kept = without_rounding(v);
        return fmt::format("({}, {})", number(kept.x), number(kept.y));
    }

    /// 0 where it bends the curve by no more than rounding.
    std::string curvature(const std::optional<double>& value) const {
        if (!value) return "–";
        const bool is_straight = std::abs(*value) * state_.derived.of(*state_.active_curve())->size < least_bend;
        return number(is_straight ? 0.0 : *value);
    }

    void add_joints() {
        if (meter_.rows.empty() && !meter_.ends && meter_.meetings.empty()) return;
        CardTable table{.rows = {{{"[C]"}, {"[C′]"}, {"[C″]"}, {"turn"}, {"[κ]"}}}, .has_heading = true};
        for (const KnotJoint& row : meter_.rows) add_knot(table, row);
        if (meter_.ends) add_joint(table, {.text = sentence("Ends: {verdict}", {verdict(*meter_.ends)})}, *meter_.ends);
        for (const CurveMeeting& meeting : meter_.meetings)
            add_joint(table, {.text = meeting_text(meeting), .hover = HoveredOtherCurve{meeting.other}}, meeting.joint);
        card_.line("[C′] is how far C′ jumps; up to a millionth of C′ counts as none.", CardTone::dim);
        card_.add(std::move(table));
        add_reasons();
    }

    /// Why ends meet as they do; a table would not break these lines.
    void add_reasons() {
        if (meter_.ends) card_.line(sentence("Ends: {reason}", {reason(*meter_.ends)}), CardTone::dim);
        for (const CurveMeeting& meeting : meter_.meetings)
            card_.line(sentence("With '{name}': {reason}",
                                {{"name", state_.shown().curves[meeting.other].name}, reason(meeting.joint)}),
                       CardTone::dim);
    }

    Place reason(const JointContinuity& joint) const { return {"reason", continuity_reason(joint, notation_)}; }

    static Place verdict(const JointContinuity& joint) { return {"verdict", continuity_verdict(joint)}; }

    void add_knot(CardTable& table, const KnotJoint& row) const {
        const Place u("u", exact_text(notation_, row.joint.u, digits_));
        const std::string text =
            row.joint.multiplicity == 1
                ? sentence("u = {u}: {verdict}", {u, verdict(row.joint)})
                : sentence("u = {u} ×{times}: {verdict}", {u, {"times", row.joint.multiplicity}, verdict(row.joint)});
        add_joint(table,
                  {.text = text,
                   .tone = meter_.focus && meter_.focus->knot == row.knot ? CardTone::strong : CardTone::plain,
                   .hover = HoveredKnot{row.knot},
                   .command = SetParameter{.u = row.joint.u}},
                  row.joint);
    }

    void add_joint(CardTable& table, CardText heading, const JointContinuity& joint) const {
        table.rows.push_back({std::move(heading)});
        auto& cells = table.rows.emplace_back();
        for (const std::string& text :
             {jump_text(joint.position, notation_), jump_text(joint.first, notation_),
              jump_text(joint.second, notation_), turn_text(joint, notation_), curvature_jump_text(joint, notation_)})
            cells.push_back({.text = text, .tone = CardTone::dim});
    }

    std::string meeting_text(const CurveMeeting& meeting) const {
        const Place name("name", state_.shown().curves[meeting.other].name);
        const bool is_end = meeting.ends.first == core::CurveEnd::end;
        if (meeting.ends.second == core::CurveEnd::start)
            return is_end ? sentence("End to start of '{name}': {verdict}", {name, verdict(meeting.joint)})
                          : sentence("Start to start of '{name}': {verdict}", {name, verdict(meeting.joint)});
        return is_end ? sentence("End to end of '{name}': {verdict}", {name, verdict(meeting.joint)})
                      : sentence("Start to end of '{name}': {verdict}", {name, verdict(meeting.joint)});
    }

    void add_focus(const KnotJoint& focus) {
        const JointContinuity& joint = focus.joint;
        card_.line(sentence("At u = {u}: {reason}", {{"u", exact_text(notation_, joint.u, digits_)},
                                                     {"reason", continuity_reason(joint, notation_)}}),
                   CardTone::strong);
        CardTable table{.rows = {{{""}, {"u−"}, {"u+"}}}, .has_heading = true};
        table.rows.push_back({{"C′"}, {vector(joint.left.first)}, {vector(joint.right.first)}});
        table.rows.push_back({{"C″"}, {vector(joint.left.second)}, {vector(joint.right.second)}});
        table.rows.push_back({{"κ"}, {curvature(joint.before)}, {curvature(joint.after)}});
        card_.add(std::move(table));
    }

    const EditorState& state_;
    const Notation& notation_;
    ContinuityMeter meter_;
    int digits_ = 4;  // that tell the knots apart
    Card card_;
};

}  // namespace

Card continuity_card(const EditorState& state) {
    if (state.visible_active_curve() == nullptr) {
        Card card;
        card.title = "Continuity";
        card.line("There is no curve to be measured.", CardTone::dim);
        offer_curve_with_knots(card);
        return card;
    }
    return ContinuityCard(state).made();
}

}  // namespace batten::editor
