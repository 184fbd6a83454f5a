#include "core/shape/detail/crossing_tree.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/evaluate/detail/subdivide.h"

namespace batten::core {

namespace {

// A piece of this many slacks through the origin is a point on it.
constexpr double slacks_of_a_point = 4.0;

double along(Point point, RayAxis axis) {
    return axis == RayAxis::x ? point.x : point.y;
}

double across(Point point, RayAxis axis) {
    return axis == RayAxis::x ? point.y : point.x;
}

// Half open, so that a chain through the level of the ray is counted once.
int chord_crossing(Point first, Point last, const Ray& ray) {
    const double level = across(ray.origin, ray.axis);
    const int upward =
        static_cast<int>(across(first, ray.axis) <= level) - static_cast<int>(across(last, ray.axis) <= level);
    return ray.axis == RayAxis::x ? upward : -upward;
}

enum class BoxPlace { aside, beyond, around };

// Where a box lies: not on the ray, on it but not around its origin, or around the origin.
BoxPlace place_of(const Box& box, const Ray& ray) {
    const double level = across(ray.origin, ray.axis);
    const double start = along(ray.origin, ray.axis);
    if (across(box.upper, ray.axis) < level - ray.slack || across(box.lower, ray.axis) > level + ray.slack ||
        along(box.upper, ray.axis) < start - ray.slack)
        return BoxPlace::aside;
    return along(box.lower, ray.axis) > start + ray.slack ? BoxPlace::beyond : BoxPlace::around;
}

bool is_a_point(const Box& box, const Ray& ray) {
    return std::max(box.size().x, box.size().y) <= slacks_of_a_point * ray.slack;
}

// Whether all legs run to the same side across the ray, and steeply, so that the piece meets the ray's line once.
bool is_steep(const PiecePoints& piece, const Ray& ray) {
    double sign = 0.0;
    for (std::size_t i = 1; i < piece.size(); ++i) {
        const Vector leg = project(piece[i]) - project(piece[i - 1]);
        const double rise = across(tip_of(leg), ray.axis);
        if (!(std::abs(along(tip_of(leg), ray.axis)) <= 4.0 * std::abs(rise)) || rise * sign < 0.0) return false;
        if (rise != 0.0) sign = rise;
    }
    return sign != 0.0;
}

std::optional<int> sum_of(std::optional<int> a, std::optional<int> b) {
    return a && b ? std::optional(*a + *b) : std::nullopt;
}

}  // namespace

std::pair<PiecePoints, PiecePoints> halved(const PiecePoints& points, double t) {
    PiecePoints left;
    PiecePoints right = points;
    left.reserve(points.size());
    const std::size_t p = points.size() - 1;
    for (std::size_t level = 0; level <= p; ++level) {
        left.push_back(right.front());
        for (std::size_t i = 0; i + level < p; ++i) right[i] += t * (right[i + 1] - right[i]);
    }
    return {std::move(left), std::move(right)};
}

std::optional<int> ray_crossings(const PiecePoints& piece, const Ray& ray) {
    const Box box = control_box(std::span<const HomogeneousPoint>(piece));
    switch (place_of(box, ray)) {
        case BoxPlace::aside:
            return 0;
        case BoxPlace::beyond:
            return chord_crossing(project(piece.front()), project(piece.back()), ray);
        case BoxPlace::around:
            break;
    }
    if (is_a_point(box, ray)) return std::nullopt;
    const auto [left, right] = halved(piece);
    return sum_of(ray_crossings(left, ray), ray_crossings(right, ray));
}

std::optional<int> ray_crossings_beyond(const PiecePoints& piece, const Ray& ray, bool at_end) {
    if (is_steep(piece, ray)) return 0;
    if (is_a_point(control_box(std::span<const HomogeneousPoint>(piece)), ray)) return std::nullopt;
    const auto [left, right] = halved(piece);
    return at_end ? sum_of(ray_crossings(left, ray), ray_crossings_beyond(right, ray, at_end))
                  : sum_of(ray_crossings_beyond(left, ray, at_end), ray_crossings(right, ray));
}

CrossingTree::CrossingTree(std::vector<Link> links) : links_(std::move(links)), levels_(1) {
    for (const Link& link : links_)
        levels_[0].push_back({control_box(std::span<const HomogeneousPoint>(link.points)), project(link.points.front()),
                              project(link.points.back())});
    while (levels_.back().size() > 1) {
        const std::vector<Node>& below = levels_.back();
        std::vector<Node> joined;
        for (std::size_t i = 0; i < below.size(); i += 2) {
            const Node& last = below[std::min(i + 1, below.size() - 1)];
            Node node{below[i].box, below[i].first, last.last};
            node.box.include(last.box.lower);
            node.box.include(last.box.upper);
            joined.push_back(node);
        }
        levels_.push_back(std::move(joined));
    }
}

std::optional<int> CrossingTree::crossings(const Ray& ray, std::optional<std::size_t> left_out) const {
    return links_.empty() ? 0 : below(levels_.size() - 1, 0, ray, left_out);
}

std::optional<int> CrossingTree::below(std::size_t level, std::size_t i, const Ray& ray,
                                       std::optional<std::size_t> left_out) const {
    const Node& node = levels_[level][i];
    if (level == 0) return links_[i].number == left_out ? 0 : ray_crossings(links_[i].points, ray);
    const BoxPlace place = place_of(node.box, ray);
    if (place == BoxPlace::aside) return 0;
    if (place == BoxPlace::beyond) return chord_crossing(node.first, node.last, ray);
    const bool has_second = 2 * i + 1 < levels_[level - 1].size();
    const auto first = below(level - 1, 2 * i, ray, left_out);
    return has_second ? sum_of(first, below(level - 1, 2 * i + 1, ray, left_out)) : first;
}

}  // namespace batten::core
