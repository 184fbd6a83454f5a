#include "app/editor/commands/joint_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "app/editor/words/wording.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/measure/bounds.h"

namespace batten::editor {

namespace {

using core::sentence;

// Degrees below this are what rounding leaves.
constexpr double least_degrees = 1e-7;

// And curvatures below this, relative to others there or to 1 / size of the curve.
constexpr double least_curvature = 1e-12;

std::string degrees_text(double radians) {
    const double degrees = std::abs(radians) * 180.0 / std::numbers::pi;
    return sentence("{degrees}°", {{"degrees", core::shortest_text(degrees < least_degrees ? 0.0 : degrees)}});
}

// 0 where the curvature is not above its own error.
std::string text_above(const Units& units, double error, double curvature) {
    return quantity_words(units, std::abs(curvature) <= error ? 0.0 : curvature, -1);
}

double turn_of(const core::SmoothnessLoss& loss) {
    return std::abs(loss.after.angle.value_or(std::numbers::pi));
}

double jump_of(const core::SmoothnessLoss& loss) {
    return std::abs(loss.after.after.value_or(0.0) - loss.after.before.value_or(0.0));
}

std::string corners_sentence(std::span<const core::SmoothnessLoss> corners) {
    const auto& worst = *std::ranges::max_element(corners, {}, turn_of);
    return sentence({.one = "the curve now has a corner of {angle} at u = {u}",
                     .many = "the curve now has {count} more corners, the sharpest of {angle} at u = {u}"},
                    corners.size(),
                    {{"angle", degrees_text(turn_of(worst))}, {"u", core::shortest_text(worst.after.u)}});
}

std::string jumps_sentence(const Units& units, std::span<const core::SmoothnessLoss> jumps) {
    const auto& worst = *std::ranges::max_element(jumps, {}, jump_of);
    const core::Place u("u", core::shortest_text(worst.after.u));
    if (!worst.after.before || !worst.after.after)
        return sentence({.one = "it now has no curvature on one side of u = {u}",
                         .many = "its curvature now jumps at {count} more knots; on one side of u = {u} there is none"},
                        jumps.size(), {u});
    const double error = least_curvature * jump_of(worst);
    return sentence({.one = "its curvature now jumps from {before} to {after} at u = {u}",
                     .many = "its curvature now jumps at {count} more knots, most from {before} to {after} at u = {u}"},
                    jumps.size(),
                    {{"before", text_above(units, error, *worst.after.before)},
                     {"after", text_above(units, error, *worst.after.after)},
                     u});
}

std::string gap_sentence(const Units& units, const core::SmoothnessLoss& loss) {
    const core::Place gap("gap", length_words(units, loss.after.position.size));
    if (loss.after.kind == core::JointKind::ends) return sentence("its ends, which met, are now {gap} apart", {gap});
    return sentence("the curve now has a gap of {gap} at u = {u}", {gap, {"u", core::shortest_text(loss.after.u)}});
}

// Where the other curve stands and how, unless it simply follows.
std::optional<std::string> placing(const std::string& name, core::JoinedEnds ends) {
    const bool is_before = ends.first == core::CurveEnd::start;
    const bool is_turned = ends.first == ends.second;
    if (is_before && is_turned) return sentence("'{name}' was turned and goes before", {{"name", name}});
    if (is_before) return sentence("'{name}' goes before", {{"name", name}});
    if (is_turned) return sentence("'{name}' was turned", {{"name", name}});
    return std::nullopt;
}

// One sentence for each of what two curves may lack where they meet.
struct MeetingPatterns {
    const char* whole;
    const char* without_first;
    const char* without_second;
    const char* without_both;
    const char* without_direction;
};

constexpr MeetingPatterns as_it_was{
    "the joint had a gap of {gap}, a turn of {angle} and the curvatures {before} and {after}",
    "the joint had a gap of {gap}, a turn of {angle}, no curvature before it and the curvature {after} behind it",
    "the joint had a gap of {gap}, a turn of {angle}, the curvature {before} before it and no curvature behind it",
    "the joint had a gap of {gap}, a turn of {angle} and no curvature on either side",
    "the joint had a gap of {gap} and no direction on one side"};

constexpr MeetingPatterns as_it_is{
    "it has a gap of {gap}, a turn of {angle} and the curvatures {before} and {after}",
    "it has a gap of {gap}, a turn of {angle}, no curvature before it and the curvature {after} behind it",
    "it has a gap of {gap}, a turn of {angle}, the curvature {before} before it and no curvature behind it",
    "it has a gap of {gap}, a turn of {angle} and no curvature on either side",
    "it has a gap of {gap} and no direction on one side"};

const char* pattern_of(const MeetingPatterns& patterns, const core::Meeting& meeting) {
    if (!meeting.angle) return patterns.without_direction;
    if (!meeting.before) return meeting.after ? patterns.without_first : patterns.without_both;
    return meeting.after ? patterns.whole : patterns.without_second;
}

std::string number_of(const std::optional<double>& value) {
    return message_text(value.value_or(0.0));
}

std::string sentence_of_meeting(const MeetingPatterns& patterns, const core::Meeting& meeting, const Units& units) {
    return core::filled_as_needed(pattern_of(patterns, meeting), {{"gap", with_unit(units, message_text(meeting.gap))},
                                                                  {"angle", degrees_text(meeting.angle.value_or(0.0))},
                                                                  {"before", number_of(meeting.before)},
                                                                  {"after", number_of(meeting.after)}});
}

std::string change_sentence(const JointChange& joint) {
    return sentence(
        "per length the curvature changed by {before} and {after} there, now by {before_now} and {after_now}",
        {{"before", number_of(joint.before.change_before)},
         {"after", number_of(joint.before.change_after)},
         {"before_now", number_of(joint.after.change_before)},
         {"after_now", number_of(joint.after.change_after)}});
}

// What a joint was and is, and how much of the curve called `name` changed for it.
struct ChangedJoint {
    const std::string& name;
    const core::Curve& curve;
    JointChange change;
    core::Interval changed;
    std::span<const core::SmoothnessLoss> lost;
    int old_degree;
    bool is_third_order;  // the change of curvature was asked for
    const Units& units;
};

void tell(std::vector<std::string>& sentences, const ChangedJoint& joint) {
    const core::Box box = core::tight_box(joint.curve);
    const JointChange change{in_units(joint.units, without_noise(joint.change.before, box)),
                             in_units(joint.units, without_noise(joint.change.after, box))};
    sentences.push_back(sentence_of_meeting(as_it_was, change.before, joint.units));
    if (joint.changed.length() > 0.0) {
        sentences.push_back(sentence_of_meeting(as_it_is, change.after, joint.units));
        if (joint.is_third_order) sentences.push_back(change_sentence(change));
        sentences.push_back(
            sentence("'{name}' changed from u = {from} to {to}", {{"name", joint.name},
                                                                  {"from", core::shortest_text(joint.changed.lower)},
                                                                  {"to", core::shortest_text(joint.changed.upper)}}));
    } else {
        sentences.emplace_back("nothing had to be moved");
    }
    if (joint.curve.degree() != joint.old_degree)
        sentences.push_back(sentence("the degree rose from {from} to {to}",
                                     {{"from", joint.old_degree}, {"to", joint.curve.degree()}}));
    if (const auto lost = lost_smoothness(joint.units, joint.lost)) sentences.push_back(*lost);
}

}  // namespace

std::optional<std::string> told_in_turn(std::span<const std::string> sentences) {
    if (sentences.empty()) return std::nullopt;
    std::string told = sentences.front();
    for (const std::string& next : sentences.subspan(1))
        told = sentence("{told}; {next}", {{"told", told}, {"next", next}});
    return told;
}

std::optional<std::string> lost_smoothness(const Units& units, std::span<const core::SmoothnessLoss> losses) {
    std::vector<core::SmoothnessLoss> corners;
    std::vector<core::SmoothnessLoss> jumps;
    std::vector<std::string> sentences;
    for (const core::SmoothnessLoss& loss : losses)
        if (loss.after.geometric < 0)
            sentences.push_back(gap_sentence(units, loss));
        else
            (loss.after.geometric < 1 ? corners : jumps).push_back(loss);
    if (!corners.empty()) sentences.push_back(corners_sentence(corners));
    if (!jumps.empty()) sentences.push_back(jumps_sentence(units, jumps));
    return told_in_turn(sentences);
}

JointChange change_of(const core::JoinedCurve& joined) {
    if (joined.ends.first == core::CurveEnd::end) return {joined.before, joined.after};
    return {core::run_back(joined.before), core::run_back(joined.after)};
}

JointChange change_of(const core::MatchedCurve& matched) {
    return {core::run_back(matched.before), core::run_back(matched.after)};
}

core::Meeting without_noise(core::Meeting meeting, const core::Box& box) {
    const double size = core::robust_length(box.size());
    // The error of a curvature is relative to that of a circle as large as the curves.
    const double of_curvature = size > 0.0 ? least_curvature / size : 0.0;
    const double of_change = size > 0.0 ? of_curvature / size : 0.0;
    const auto drop = [](std::optional<double>& value, double error) {
        if (value && std::abs(*value) <= error) value = 0.0;
    };
    if (meeting.gap <= coordinate_error(box)) meeting.gap = 0.0;
    if (meeting.angle) meeting.angle = std::abs(*meeting.angle);
    drop(meeting.angle, least_degrees * std::numbers::pi / 180.0);
    for (std::optional<double>* value : {&meeting.before, &meeting.after})
        drop(*value, std::max(of_curvature, meeting.curvature_noise));
    for (std::optional<double>* value : {&meeting.change_before, &meeting.change_after})
        drop(*value, std::max(of_change, meeting.change_noise));
    return meeting;
}

core::Meeting in_units(const Units& units, core::Meeting meeting) {
    const double unit = world_per_length(units);
    meeting.gap /= unit;
    for (std::optional<double>* value : {&meeting.before, &meeting.after})
        if (*value) **value *= unit;
    for (std::optional<double>* value : {&meeting.change_before, &meeting.change_after})
        if (*value) **value *= unit * unit;
    return meeting;
}

std::string join_report(const std::string& name, const core::JoinedCurve& joined, int degree, const Units& units) {
    std::vector<std::string> sentences;
    if (const auto placed = placing(name, joined.ends)) sentences.push_back(*placed);
    tell(sentences, {name, joined.curve, change_of(joined), joined.changed, joined.lost, degree, false, units});
    return *told_in_turn(sentences);
}

std::string match_report(const std::string& name, const core::MatchedCurve& matched, int degree,
                         core::GeometricContinuity continuity, const Units& units) {
    std::vector<std::string> sentences;
    tell(sentences, {name, matched.curve, change_of(matched), matched.changed, matched.lost, degree,
                     continuity == core::GeometricContinuity::g3, units});
    return *told_in_turn(sentences);
}

std::string level_text(int level) {
    constexpr std::array texts{"gap", "G⁰", "G¹", "G²", "G³"};
    return texts[static_cast<std::size_t>(std::clamp(level + 1, 0, 4))];
}

}  // namespace batten::editor
