#include "core/refine/detail/touching_circle.h"

#include <cmath>
#include <optional>

#include "core/curve/control_box.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/continuity.h"
#include "core/measure/detail/box_tree.h"

namespace batten::core {

namespace {

// Stretches of a span for each degree above 1, whose straight spans are one.
constexpr std::size_t stretches_per_degree = 8;

constexpr int newton_steps = 40;
constexpr double offset_accuracy = 1e-13;  // of the size
constexpr double step_accuracy = 1e-15;    // of the domain
constexpr double margin_of_boxes = 0.25;   // of their size: offsets bend between their ends

// Where the offset of a curve is, and its derivative.
struct TouchPoint {
    Point on_curve;
    Vector along;
    Point point;
    Vector derivative;
};

std::optional<TouchPoint> offset_point(const Curve& curve, double u, Interval run, double by) {
    const Jet jet = derivatives_at(curve, u, 2, u < run.upper ? Side::right : Side::left);
    const double speed = robust_length(jet[1]);
    if (!(speed > 0.0)) return std::nullopt;
    const Vector tangent = jet[1] / speed;
    const double curvature = cross(tangent, jet[2]) / speed / speed;
    return TouchPoint{jet.point, jet[1], jet.point + by * turned_left(tangent), (1.0 - by * curvature) * jet[1]};
}

std::vector<double> edges_of_runs(const Curve& curve) {
    std::vector<double> corners{curve.domain().lower};
    for (const JointContinuity& joint : joint_continuity_within(curve, curve.domain()))
        if (joint.kind == JointKind::knot && joint.geometric < 1) corners.push_back(joint.u);
    corners.push_back(curve.domain().upper);
    return corners;
}

void add_stretches(std::vector<SmoothStretch>& stretches, const Curve& curve, Interval span, Interval run) {
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::size_t count = p == 1 ? 1 : stretches_per_degree * p;
    const auto parameter = [&](std::size_t k) {
        return k == count ? span.upper
                          : span.lower + static_cast<double>(k) / static_cast<double>(count) * span.length();
    };
    for (std::size_t k = 0; k < count; ++k) {
        const Interval range{parameter(k), parameter(k + 1)};
        const auto from = offset_point(curve, range.lower, {range.lower, span.upper}, 1.0);
        const auto to = offset_point(curve, range.upper, {span.lower, range.upper}, 1.0);
        if (!from || !to) continue;
        stretches.push_back(
            {range, run, from->on_curve, to->on_curve, from->point - from->on_curve, to->point - to->on_curve});
    }
}

std::vector<SmoothStretch> stretches_of(const Curve& curve) {
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::vector<double> corners = edges_of_runs(curve);
    const KnotVector& knots = curve.knots();
    const Interval domain = curve.domain();
    std::vector<SmoothStretch> stretches;
    std::size_t run = 0;
    for (std::size_t s = p; s + p + 1 < knots.size(); ++s) {
        if (knots[s] == knots[s + 1] || knots[s] < domain.lower || knots[s + 1] > domain.upper) continue;
        while (run + 2 < corners.size() && corners[run + 1] <= knots[s]) ++run;
        add_stretches(stretches, curve, {knots[s], knots[s + 1]}, {corners[run], corners[run + 1]});
    }
    return stretches;
}

struct OffsetChord {
    Point from;
    Point to;
};

OffsetChord offset_of(const SmoothStretch& stretch, double by) {
    return {stretch.from + by * stretch.normal_from, stretch.to + by * stretch.normal_to};
}

Box box_of(const OffsetChord& chord, const SmoothStretch& stretch) {
    Box box;
    box.include(chord.from);
    box.include(chord.to);
    const double margin =
        margin_of_boxes * (robust_length(chord.to - chord.from) + robust_length(stretch.to - stretch.from));
    box.lower -= Vector(margin, margin);
    box.upper += Vector(margin, margin);
    return box;
}

// Newton's iteration on A(u) + a N_A(u) = B(v) + b N_B(v).
class CircleSearch {
  public:
    CircleSearch(const Curve& first, const Curve& second, double by_first, double by_second, double size)
        : first_(first), second_(second), by_first_(by_first), by_second_(by_second), size_(size) {}

    std::optional<TouchingCircle> from(const SmoothStretch& i, const SmoothStretch& j) const {
        double u = i.range.lower + 0.5 * i.range.length();
        double v = j.range.lower + 0.5 * j.range.length();
        for (int step = 0; step < newton_steps; ++step) {
            const auto a = offset_point(first_, u, i.run, by_first_);
            const auto b = offset_point(second_, v, j.run, by_second_);
            if (!a || !b) return std::nullopt;
            const Vector missing = b->point - a->point;
            const double determinant = cross(a->derivative, b->derivative);
            if (determinant == 0.0) return std::nullopt;
            const double next_u = i.run.clamp(u + cross(missing, b->derivative) / determinant);
            const double next_v = j.run.clamp(v + cross(missing, a->derivative) / determinant);
            const bool is_still = std::abs(next_u - u) <= step_accuracy * first_.domain().length() &&
                                  std::abs(next_v - v) <= step_accuracy * second_.domain().length();
            if (is_still || step + 1 == newton_steps) return found(u, v, *a, *b);
            if (strayed(next_u, i) || strayed(next_v, j)) return std::nullopt;
            u = next_u;
            v = next_v;
        }
        return std::nullopt;
    }

  private:
    // Other stretches are nearer to what is there.
    static bool strayed(double u, const SmoothStretch& stretch) {
        return std::abs(u - (stretch.range.lower + 0.5 * stretch.range.length())) > 3.0 * stretch.range.length();
    }

    std::optional<TouchingCircle> found(double u, double v, const TouchPoint& a, const TouchPoint& b) const {
        const double radius = std::abs(by_first_);
        if (!(robust_length(b.point - a.point) <= offset_accuracy * (size_ + radius))) return std::nullopt;
        return TouchingCircle{u, v, middle(a.point, b.point), a.on_curve, b.on_curve, a.along, b.along};
    }

    const Curve& first_;
    const Curve& second_;
    double by_first_;
    double by_second_;
    double size_;
};

Point common_origin(const Curve& first, const Curve& second) {
    Box box = control_box(first);
    const Box other = control_box(second);
    box.include(other.lower);
    box.include(other.upper);
    return middle(box.lower, box.upper);
}

double extent_of(const Curve& curve) {
    return robust_length(control_box(curve).size());
}

}  // namespace

TouchingFinder::TouchingFinder(const Curve& first, const Curve& second)
    : origin_(common_origin(first, second)),
      first_(seen_from(first, origin_)),
      second_(seen_from(second, origin_)),
      is_one_(&first == &second),
      size_(extent_of(first) + extent_of(second)),
      stretches_of_first_(stretches_of(first_)),
      stretches_of_second_(is_one_ ? stretches_of_first_ : stretches_of(second_)) {}

std::vector<TouchingCircle> TouchingFinder::circles(double radius) const {
    std::vector<TouchingCircle> found;
    if (stretches_of_first_.empty() || stretches_of_second_.empty()) return found;
    for (const double by_second : {radius, -radius}) {
        std::vector<Box> boxes;
        for (const SmoothStretch& stretch : stretches_of_second_)
            boxes.push_back(box_of(offset_of(stretch, by_second), stretch));
        const BoxTree tree(std::move(boxes));
        for (const double by_first : {radius, -radius}) add_circles(found, tree, by_first, by_second);
    }
    for (TouchingCircle& circle : found) {
        circle.center += vector_to(origin_);
        circle.on_first += vector_to(origin_);
        circle.on_second += vector_to(origin_);
    }
    return found;
}

void TouchingFinder::add_circles(std::vector<TouchingCircle>& found, const BoxTree& tree, double by_first,
                                 double by_second) const {
    const CircleSearch search(first_, second_, by_first, by_second, size_);
    for (std::size_t i = 0; i < stretches_of_first_.size(); ++i) {
        const SmoothStretch& stretch = stretches_of_first_[i];
        tree.each_near(box_of(offset_of(stretch, by_first), stretch), 0.0, 0, [&](std::size_t j) {
            const SmoothStretch& other = stretches_of_second_[j];
            const bool are_neighbors = is_one_ && other.run == stretch.run && i <= j + 1 && j <= i + 1;
            if (are_neighbors) return;
            const auto circle = search.from(stretch, other);
            const double apart = circle ? robust_length(circle->on_second - circle->on_first) : 0.0;
            if (apart > offset_accuracy * size_) found.push_back(*circle);
        });
    }
}

}  // namespace batten::core
