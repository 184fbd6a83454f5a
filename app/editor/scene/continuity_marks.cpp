#include "app/editor/scene/continuity_marks.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "app/editor/derived/continuity_meter.h"
#include "app/editor/scene/arrow.h"
#include "app/editor/words/continuity_words.h"

namespace batten::editor {

namespace {

constexpr double longest_velocity = 180.0;
constexpr double longest_acceleration = 130.0;
constexpr double joint_text_size = 13.0;
constexpr double least_named_arrow = 6.0;
constexpr double verdict_distance = 16.0;
constexpr double farthest_verdict = 130.0;

// Two vectors of the picture, both shorter by one factor where one is too long.
struct Arms {
    glm::dvec2 left;
    glm::dvec2 right;

    Arms within(double longest) const {
        const double larger = std::max(glm::length(left), glm::length(right));
        const double factor = larger > longest ? longest / larger : 1.0;
        return {factor * left, factor * right};
    }
};

bool are_drawable(const Arms& arms) {
    return std::isfinite(glm::length(arms.left)) && std::isfinite(glm::length(arms.right));
}

class JointPainter {
  public:
    explicit JointPainter(CanvasFrame& frame) : frame_(frame) {}

    /// `is_named`: with the names of the derivatives.
    void draw(const core::JointContinuity& joint, bool is_named) {
        left_ = frame_.screen(joint.left.point);
        right_ = frame_.screen(joint.right.point);
        if (joint.geometric < 0)
            frame_.pen.segment(left_, right_, {.color = frame_.theme.text, .width = 1.5, .dash = 5.0, .gap = 4.0});
        write_verdict(joint);
        draw_velocities(joint, is_named);
        draw_accelerations(joint, is_named);
    }

  private:
    void write_verdict(const core::JointContinuity& joint) {
        const TextStyle style{.color = frame_.theme.text, .size = joint_text_size, .font = render::LabelFont::bold};
        frame_.labels.push_back({.place = right_,
                                 .words = {{continuity_verdict(joint), style}},
                                 .distance = verdict_distance,
                                 .first = LabelSide::upper_right,
                                 .crowding = Crowding::cover_symbols,
                                 .farthest = farthest_verdict,
                                 .has_ground = true});
    }

    void draw_velocities(const core::JointContinuity& joint, bool is_named) {
        const double scale = velocity_scale(*frame_.curve);
        const Arms whole{vector_in_picture(frame_, scale * joint.left.first),
                         vector_in_picture(frame_, scale * joint.right.first)};
        if (!are_drawable(whole)) return;
        const Arms arms = whole.within(frame_.pen.px(longest_velocity));
        draw_arrow(frame_, left_ - arms.left, left_, stroke(frame_.theme.error));
        draw_arrow(frame_, right_, right_ + arms.right, stroke(frame_.theme.comb));
        if (!is_named) return;
        name(left_, -arms.left, "C′(u−)", frame_.theme.error);
        name(right_, arms.right, "C′(u+)", frame_.theme.comb);
    }

    void draw_accelerations(const core::JointContinuity& joint, bool is_named) {
        if (frame_.curve->degree() < 2) return;
        const double scale = acceleration_scale(*frame_.curve);
        const Arms whole{vector_in_picture(frame_, scale * joint.left.second),
                         vector_in_picture(frame_, scale * joint.right.second)};
        if (!are_drawable(whole)) return;
        const Arms arms = whole.within(frame_.pen.px(longest_acceleration));
        draw_arrow(frame_, left_, left_ + arms.left, dashed(frame_.theme.error));
        draw_arrow(frame_, right_, right_ + arms.right, dashed(frame_.theme.comb));
        if (!is_named) return;
        if (joint.second.is_rounding()) {
            name(right_, arms.right, "C″(u)", frame_.theme.comb);
            return;
        }
        name(left_, arms.left, "C″(u−)", frame_.theme.error);
        name(right_, arms.right, "C″(u+)", frame_.theme.comb);
    }

    static Stroke stroke(render::Color color) { return {.color = color, .width = 2.5}; }
    static Stroke dashed(render::Color color) { return {.color = color, .width = 1.5, .dash = 5.0, .gap = 3.0}; }

    /// At the free end of an arrow that can be seen.
    void name(glm::dvec2 joint, glm::dvec2 arrow, const char* text, render::Color color) {
        if (glm::length(arrow) < frame_.pen.px(least_named_arrow)) return;
        frame_.labels.push_back({.place = joint + arrow, .words = {{text, {.color = color, .size = joint_text_size}}}});
    }

    CanvasFrame& frame_;
    glm::dvec2 left_{};
    glm::dvec2 right_{};
};

}  // namespace

void draw_continuity_marks(CanvasFrame& frame) {
    const ContinuityMeter meter = continuity_meter(frame.state, 1);
    JointPainter painter(frame);
    if (meter.focus) painter.draw(meter.focus->joint, true);
    if (meter.ends) painter.draw(*meter.ends, !meter.focus);
    for (const CurveMeeting& meeting : meter.meetings) painter.draw(meeting.joint, !meter.focus);
}

}  // namespace batten::editor
