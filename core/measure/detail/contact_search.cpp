#include "core/measure/detail/contact_search.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>

#include "core/curve/control_box.h"
#include "core/measure/detail/onward_pieces.h"
#include "core/measure/detail/piece_contact.h"

namespace batten::core {

namespace {

// Pieces smaller than this part of everything are not halved any more.
const double smallest_piece = std::ldexp(1.0, -22);

// After so many parts of one pair of pieces what is still undecided is left so.
constexpr std::size_t most_visits = 20'000;

// And after so much work for all pairs, less than a second for a few pieces: evaluations, each counted as the square of
// its points.
constexpr double most_work = 1e8;
constexpr double most_work_for_each_piece = 3e5;

// What steps of the search cost at most, in evaluations.
constexpr double cost_of_visit = 10.0;
constexpr double cost_of_overlap = 400.0;
constexpr double cost_of_probes = 500.0;
constexpr double cost_of_cluster = 3000.0;

constexpr int most_pair_halvings = 40;

// Places on both pieces, between the ends of an interval on which they seem to coincide, where they have to.
constexpr int overlap_probes = 9;

// An interval on which pieces coincide is longer than this part of a piece.
constexpr double shortest_overlap = 1e-6;

// Clusters longer than this part of a piece are intervals.
constexpr double longest_touch = 1e-2;

Vector chord_of(const ContactPiece& piece) {
    return piece.shadow.back() - piece.shadow.front();
}

double middle(const ContactPiece& piece) {
    return piece.shares.lower + 0.5 * piece.shares.length();
}

bool contains(Interval interval, double share) {
    const double slack = 1e-9 * interval.length() + 1e-14;
    return interval.lower - slack <= share && share <= interval.upper + slack;
}

// Where the chords of both parts meet, as a first guess.
ShareContact guess(const ContactPiece& a, const ContactPiece& b) {
    const Vector of_a = chord_of(a);
    const Vector of_b = chord_of(b);
    const Vector between = b.shadow.front() - a.shadow.front();
    const double determinant = cross(of_a, of_b);
    const double on_a = cross(between, of_b) / determinant;
    const double on_b = cross(between, of_a) / determinant;
    if (!std::isfinite(on_a) || !std::isfinite(on_b)) return {middle(a), middle(b)};
    return {a.shares.lower + std::clamp(on_a, 0.0, 1.0) * a.shares.length(),
            b.shares.lower + std::clamp(on_b, 0.0, 1.0) * b.shares.length()};
}

bool are_neighbors(Interval a, Interval b) {
    const double slack = std::max(a.length(), b.length());
    return a.lower <= b.upper + slack && b.lower <= a.upper + slack;
}

FoundContact point_contact(std::size_t first, std::size_t second, ShareContact at, bool is_tangent) {
    const PiecePlace on_first{first, at.first};
    const PiecePlace on_second{second, at.second};
    return {on_first, on_first, on_second, on_second, is_tangent};
}

// Whether all of the piece lies farther than `distance` on one side of `point`, seen along `axis`, a vector of
// length 1.
bool is_beyond(const PieceMotion& piece, Point point, Vector axis, double distance) {
    double least = std::numeric_limits<double>::infinity();
    double greatest = -least;
    for (const HomogeneousPoint& control : piece.points()) {
        const double height = dot(axis, project(control) - point);
        least = std::min(least, height);
        greatest = std::max(greatest, height);
    }
    return least > distance || greatest < -distance;
}

// Whether the point may be on the piece, as far as the strips along the axes and the chord tell.
bool may_be_on(const PieceMotion& piece, Point point, double tolerance) {
    const Vector chord = project(piece.points().back()) - project(piece.points().front());
    const double size = length(chord);
    return !is_beyond(piece, point, {1.0, 0.0}, tolerance) && !is_beyond(piece, point, {0.0, 1.0}, tolerance) &&
           !(size > 0.0 && is_beyond(piece, point, turned_left(chord) / size, tolerance));
}

// How many ends of one piece may be on the other one.
int ends_that_may_meet(const PieceMotion& a, const PieceMotion& b, double tolerance) {
    int count = 0;
    for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)})
        for (const HomogeneousPoint& end : {one->points().front(), one->points().back()})
            count += may_be_on(*other, project(end), tolerance) ? 1 : 0;
    return count;
}

// Whether the pieces run along each other from `begin` to `end`.
bool coincide_between(const PieceMotion& a, const PieceMotion& b, ShareContact begin, ShareContact end,
                      double tolerance) {
    const double along = end.second - begin.second;
    if (end.first - begin.first < shortest_overlap || std::abs(along) < shortest_overlap) return false;
    double previous = begin.second;
    for (int k = 1; k <= overlap_probes; ++k) {
        const double share = static_cast<double>(k) / (overlap_probes + 1);
        const Point point = a.at(begin.first + share * (end.first - begin.first)).position;
        double s = foot_near(b, point, begin.second + share * along);
        if (distance(b.at(s).position, point) > tolerance) s = foot(b, point);
        const bool goes_on = along > 0.0 ? previous < s && s < end.second : end.second < s && s < previous;
        if (!goes_on || distance(b.at(s).position, point) > tolerance) return false;
        previous = s;
    }
    return true;
}

std::size_t root_of(std::vector<std::size_t>& parents, std::size_t i) {
    while (parents[i] != i) i = parents[i] = parents[parents[i]];
    return i;
}

}  // namespace

ContactPieces contact_pieces(const Curve& curve, Point origin) {
    ContactPieces result;
    for (BezierPiece& piece : onward_pieces(curve, origin)) {
        ContactPiece part(result.motions.size(), {0.0, 1.0}, piece.points);
        result.motions.emplace_back(std::move(piece));
        if (part.size() > 0.0) result.pieces.push_back(std::move(part));
    }
    return result;
}

ContactSearch::ContactSearch(const ContactPieces& first, const ContactPieces& second, double size, double tolerance)
    : first_(first),
      second_(second),
      size_(size),
      tolerance_(tolerance),
      work_left_(most_work +
                 most_work_for_each_piece * static_cast<double>(first.pieces.size() + second.pieces.size())) {}

void ContactSearch::add_pair(const ContactPiece& a, const ContactPiece& b) {
    if (are_apart(a, b, tolerance_)) return;
    if (!are_transversal(a, b) && take_overlap(a, b)) return;
    visits_ = 0;
    search(a, b);
}

void ContactSearch::add_neighbors(const ContactPiece& a, const ContactPiece& b) {
    assert(is_same_curve());
    if (continue_each_other(a, b) || take_overlap(a, b)) return;
    visits_ = 0;
    search_joint(a, b, 0);
}

void ContactSearch::add_alone(const ContactPiece& a) {
    assert(is_same_curve());
    visits_ = 0;
    search_alone(a, 0);
}

// Close to a cusp or corner both branches come as near to each other as one likes, without meeting again.
bool ContactSearch::is_at_joint(const Unresolved& pair) const {
    if (!is_same_curve()) return false;
    const auto& [a, b] = pair;
    const double reach = 4.0 * std::max(a.shares.length(), b.shares.length());
    if (a.span == b.span) return b.shares.lower - a.shares.upper <= reach;
    const bool follows = (a.span + 1) % first_.motions.size() == b.span;
    return follows && b.shares.lower + 1.0 - a.shares.upper <= reach;
}

bool ContactSearch::is_small(const ContactPiece& a, const ContactPiece& b) const {
    const bool is_tiny = std::max(a.size(), b.size()) <= smallest_piece * size_;
    return is_tiny || !a.is_divisible() || !b.is_divisible();
}

// Whether so many evaluations can still be made. What seems never to end is left undecided, and so is what lies where
// numbers fail.
bool ContactSearch::affords(double evaluations, const ContactPiece& a, const ContactPiece& b) {
    work_left_ -=
        evaluations * static_cast<double>(a.points.size() * a.points.size() + b.points.size() * b.points.size());
    const bool is_affordable =
        visits_ <= most_visits && work_left_ >= 0.0 && std::isfinite(a.size()) && std::isfinite(b.size());
    is_complete_ = is_complete_ && is_affordable;
    return is_affordable;
}

void ContactSearch::search(const ContactPiece& a, const ContactPiece& b) {
    if (are_apart(a, b, tolerance_)) return;
    if (are_transversal(a, b) && take_crossing(a, b)) return;
    ++visits_;
    if (!affords(cost_of_visit, a, b) || is_small(a, b)) return unresolved_.push_back({a, b});
    if (a.size() >= b.size()) {
        const auto [left, right] = halves(a);
        search(left, b);
        search(right, b);
    } else {
        const auto [left, right] = halves(b);
        search(a, left);
        search(a, right);
    }
}

void ContactSearch::search_joint(const ContactPiece& a, const ContactPiece& b, int depth) {
    if (depth == most_pair_halvings || continue_each_other(a, b) || is_small(a, b)) return;
    if (!affords(cost_of_visit, a, b)) return;
    const auto [a_far, a_near] = halves(a);
    const auto [b_near, b_far] = halves(b);
    search_joint(a_near, b_near, depth + 1);
    search(a_far, b_near);
    search(a_far, b_far);
    search(a_near, b_far);
}

void ContactSearch::search_alone(const ContactPiece& a, int depth) {
    if (depth == most_pair_halvings || a.directions || is_small(a, a) || !affords(cost_of_visit, a, a)) return;
    const auto [left, right] = halves(a);
    search_alone(left, depth + 1);
    search_alone(right, depth + 1);
    if (!continue_each_other(left, right)) search_joint(left, right, depth + 1);
}

bool ContactSearch::take_crossing(const ContactPiece& a, const ContactPiece& b) {
    const auto at = crossing_near(first_.motions[a.span], second_.motions[b.span], guess(a, b), tolerance_);
    if (!at || !contains(a.shares, at->first) || !contains(b.shares, at->second)) return false;
    found_.push_back(point_contact(a.span, b.span, *at, false));
    return true;
}

// Two polynomial pieces that coincide on an interval do so up to an end of one of them, on both sides.
bool ContactSearch::take_overlap(const ContactPiece& a, const ContactPiece& b) {
    if (is_same_curve() && a.span == b.span) return false;
    const PieceMotion& on_a = first_.motions[a.span];
    const PieceMotion& on_b = second_.motions[b.span];
    if (ends_that_may_meet(on_a, on_b, 2.0 * tolerance_) < 2 || !affords(cost_of_overlap, a, b)) return false;
    std::vector<ShareContact> common;
    const auto offer = [&](ShareContact at) {
        if (distance(on_a.at(at.first).position, on_b.at(at.second).position) <= tolerance_) common.push_back(at);
    };
    for (const double end : {0.0, 1.0}) {
        offer({end, foot(on_b, on_a.at(end).position)});
        offer({foot(on_a, on_b.at(end).position), end});
        // Of a piece that closes both ends are the same point.
        for (const double other : {0.0, 1.0}) offer({end, other});
    }
    double longest = 0.0;
    std::pair<ShareContact, ShareContact> ends;
    for (const ShareContact& begin : common)
        for (const ShareContact& end : common)
            if (end.first - begin.first > longest && affords(cost_of_probes, a, b) &&
                coincide_between(on_a, on_b, begin, end, tolerance_)) {
                longest = end.first - begin.first;
                ends = {begin, end};
            }
    if (longest == 0.0) return false;
    const auto& [begin, end] = ends;
    found_.push_back({{a.span, begin.first}, {a.span, end.first}, {b.span, begin.second}, {b.span, end.second}});
    return true;
}

void ContactSearch::take_cluster(std::span<const Unresolved> cluster) {
    if (std::any_of(cluster.begin(), cluster.end(), [&](const Unresolved& pair) { return is_at_joint(pair); })) return;
    const auto by_place = [](const Unresolved& x, const Unresolved& y) {
        return std::pair(x.a.span, x.a.shares.lower) < std::pair(y.a.span, y.a.shares.lower);
    };
    const auto [first, last] = std::minmax_element(cluster.begin(), cluster.end(), by_place);
    const bool is_long = first->a.span == last->a.span && last->a.shares.upper - first->a.shares.lower > longest_touch;
    if (is_long) {
        const bool runs_along = first->b.shares.lower <= last->b.shares.lower;
        found_.push_back({{first->a.span, first->a.shares.lower},
                          {last->a.span, last->a.shares.upper},
                          {first->b.span, runs_along ? first->b.shares.lower : first->b.shares.upper},
                          {last->b.span, runs_along ? last->b.shares.upper : last->b.shares.lower},
                          true});
        return;
    }
    // The two ends of pieces that turn past each other are in the cluster or near it.
    const Unresolved& pair = cluster[cluster.size() / 2];
    if (!affords(cost_of_cluster, pair.a, pair.b)) return;
    Interval range = pair.a.shares;
    for (const Unresolved& other : cluster)
        if (other.a.span == pair.a.span)
            range = {std::min(range.lower, other.a.shares.lower), std::max(range.upper, other.a.shares.upper)};
    const double reach = std::max(1e-3, 2.0 * range.length());
    range = {std::max(0.0, range.lower - reach), std::min(1.0, range.upper + reach)};
    const auto at = touching_near(first_.motions[pair.a.span], second_.motions[pair.b.span],
                                  {middle(pair.a), middle(pair.b)}, range, tolerance_);
    if (at) found_.push_back(point_contact(pair.a.span, pair.b.span, *at, true));
}

std::vector<FoundContact> ContactSearch::finish() {
    visits_ = 0;
    std::vector<std::size_t> parents(unresolved_.size());
    std::iota(parents.begin(), parents.end(), std::size_t{0});
    std::sort(unresolved_.begin(), unresolved_.end(), [](const Unresolved& x, const Unresolved& y) {
        return std::tuple(x.a.span, x.b.span, x.a.shares.lower) < std::tuple(y.a.span, y.b.span, y.a.shares.lower);
    });
    for (std::size_t i = 0; i < unresolved_.size(); ++i)
        for (std::size_t k = i + 1; k < unresolved_.size(); ++k) {
            const auto& [a, b] = unresolved_[i];
            const auto& [c, d] = unresolved_[k];
            if (a.span != c.span || b.span != d.span || !are_neighbors(a.shares, c.shares)) break;
            if (are_neighbors(b.shares, d.shares)) parents[root_of(parents, k)] = root_of(parents, i);
        }
    std::vector<std::vector<Unresolved>> clusters(unresolved_.size());
    for (std::size_t i = 0; i < unresolved_.size(); ++i)
        clusters[root_of(parents, i)].push_back(std::move(unresolved_[i]));
    for (const auto& cluster : clusters)
        if (!cluster.empty()) take_cluster(cluster);
    return std::move(found_);
}

}  // namespace batten::core
