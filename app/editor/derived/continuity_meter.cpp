#include "app/editor/derived/continuity_meter.h"

#include <algorithm>
#include <cmath>

#include "core/evaluate/evaluate.h"

namespace batten::editor {

namespace {

// Others are looked at in the order of the document.
constexpr std::size_t most_other_curves = 500;
constexpr std::size_t most_meetings = 6;
// Ends are about to meet below this share of the size of the curves.
constexpr double nearly_met = 0.05;

// The runs of equal knots strictly inside the domain, the seam among them.
class InnerKnots {
  public:
    InnerKnots(const EditorState& state, const core::Curve& curve)
        : curve_(curve),
          facts_(state.derived.of(curve.knots())),
          box_(state.derived.of(curve)->control_box),
          first_(curve.is_periodic() ? 0 : place_of(std::nextafter(curve.domain().lower, curve.domain().upper))),
          count_((curve.is_periodic() ? facts_->runs.size() : place_of(curve.domain().upper)) - first_) {}

    std::size_t count() const { return count_; }

    KnotJoint joint(std::size_t i) const {
        const core::DistinctKnot knot = core::distinct_knot(curve_.knots(), facts_->runs[first_ + i]);
        return {topmost(i), core::joint_continuity_at(curve_, knot, box_)};
    }

    // The knot with that stored index, if it is one of these.
    std::optional<std::size_t> index_of(std::size_t stored_index) const {
        const auto stored = curve_.knots().stored();
        if (count_ == 0 || stored_index >= stored.size()) return std::nullopt;
        const bool is_end_of_period = curve_.is_periodic() && stored[stored_index] == curve_.domain().upper;
        const double value = is_end_of_period ? curve_.domain().lower : stored[stored_index];
        const std::size_t place = place_of(value);
        if (place < first_ || place >= first_ + count_ || value_at(place) != value) return std::nullopt;
        return place - first_;
    }

    // The knot nearest to `u`; there must be one.
    std::size_t nearest(double u) const {
        const std::size_t above = std::clamp(place_of(u), first_, first_ + count_ - 1);
        const std::size_t below = above > first_ ? above - 1 : above;
        return (std::abs(value_at(below) - u) < std::abs(value_at(above) - u) ? below : above) - first_;
    }

  private:
    double value_at(std::size_t place) const { return curve_.knots().stored()[facts_->runs[place]]; }

    // The first run that is not below `u`.
    std::size_t place_of(double u) const {
        const auto found = std::ranges::lower_bound(facts_->runs, u, {},
                                                    [&](std::uint32_t run) { return curve_.knots().stored()[run]; });
        return static_cast<std::size_t>(found - facts_->runs.begin());
    }

    std::size_t topmost(std::size_t i) const {
        const auto stored = curve_.knots().stored();
        std::size_t last = facts_->runs[first_ + i];
        while (last + 1 < stored.size() && stored[last + 1] == stored[last]) ++last;
        return last;
    }

    const core::Curve& curve_;
    std::shared_ptr<const KnotFacts> facts_;
    core::Box box_;
    std::size_t first_;
    std::size_t count_;
};

// What the selection or else the parameter says; it stays while the pointer moves over the rows.
std::size_t chosen_of(const EditorState& state, const InnerKnots& knots) {
    if (state.selection.knot)
        if (const auto selected = knots.index_of(*state.selection.knot)) return *selected;
    return knots.nearest(state.parameter());
}

std::size_t focus_of(const EditorState& state, const InnerKnots& knots) {
    if (const auto* hovered = std::get_if<HoveredKnot>(&state.hover))
        if (const auto index = knots.index_of(hovered->index)) return *index;
    return chosen_of(state, knots);
}

// Around what reaches to both ends of a curve.
core::Box box_around(const core::Box& active, const core::Curve& other) {
    core::Box box = active;
    const auto points = other.control_points();
    const std::size_t reach = std::min(points.size(), static_cast<std::size_t>(other.degree()) + 1);
    for (std::size_t i = 0; i < reach; ++i) {
        box.include(points[i]);
        box.include(points[points.size() - 1 - i]);
    }
    return box;
}

double gap_between(const core::Curve& first, const core::Curve& second, core::JoinedEnds ends) {
    return core::robust_length(core::point_at(second, core::parameter_of(second.domain(), ends.second)) -
                               core::point_at(first, core::parameter_of(first.domain(), ends.first)));
}

// Those that meet; else the nearest ones, where they are near.
std::vector<core::JoinedEnds> ends_to_compare(const core::Curve& curve, const core::Curve& other,
                                              const core::Box& box) {
    std::vector<core::JoinedEnds> meeting = core::ends_that_meet(curve, other, box);
    if (!meeting.empty()) return meeting;
    const auto gap = [&](core::JoinedEnds ends) { return gap_between(curve, other, ends); };
    const core::JoinedEnds nearest = *std::ranges::min_element(core::all_joined_ends, {}, gap);
    if (gap(nearest) <= nearly_met * core::robust_length(box.size())) meeting.push_back(nearest);
    return meeting;
}

void add_meetings(const EditorState& state, const core::Curve& curve, const core::Box& active,
                  std::vector<CurveMeeting>& meetings) {
    const auto& curves = state.shown().curves;
    for (std::size_t k = 0; k < std::min(curves.size(), most_other_curves); ++k) {
        const core::Curve& other = *curves[k].curve;
        if (&other == &curve || !curves[k].visible || other.is_periodic()) continue;
        const core::Box box = box_around(active, other);
        for (const core::JoinedEnds& ends : ends_to_compare(curve, other, box)) {
            if (meetings.size() == most_meetings) return;
            meetings.push_back({k, ends, core::continuity_between(curve, other, ends, box)});
        }
    }
}

}  // namespace

ContinuityMeter continuity_meter(const EditorState& state, std::size_t most_rows) {
    const core::Curve& curve = *state.active_curve();
    const InnerKnots knots(state, curve);
    ContinuityMeter meter{.count = knots.count()};
    if (meter.count > 0) {
        meter.focus = knots.joint(focus_of(state, knots));
        const std::size_t rows = std::min(most_rows, meter.count);
        const std::size_t chosen = chosen_of(state, knots);
        meter.first = std::min(chosen - std::min(chosen, rows / 2), meter.count - rows);
        for (std::size_t i = 0; i < rows; ++i) meter.rows.push_back(knots.joint(meter.first + i));
    }
    if (curve.is_periodic()) return meter;
    const core::Box& box = state.derived.of(curve)->control_box;
    const core::JointContinuity ends = core::continuity_of_ends(curve, box);
    if (ends.geometric >= 0) meter.ends = ends;
    add_meetings(state, curve, box, meter.meetings);
    return meter;
}

}  // namespace batten::editor
