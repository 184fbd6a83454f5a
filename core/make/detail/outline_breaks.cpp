#include "core/make/detail/outline_breaks.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace batten::core {

namespace {

constexpr double polygon_distance = 0.3;
constexpr double arm_distance = 0.2;
// Arms of an arc within that distance turn by less over their length, beyond 2 units of radius.
constexpr double corner_turn = 6.0;
constexpr double least_arm = 2.2;
constexpr double least_corner_angle = 0.15;
constexpr double rounded_length = 1.2;  // how far from a corner its rounding reaches
constexpr double cluster_length = 2.5;  // vertices that near belong to one corner
constexpr double side_length = 5.0;     // of a bent side, by which a corner is found
constexpr double corner_shift = 2.5;    // at most from the vertex
constexpr double least_line_length = 10.0;
constexpr double least_side_length = 3.0;   // of a line between corners
constexpr double line_width = 0.25;         // how far points are from a line
constexpr double line_end = 0.12;           // where a point is that far from a line, it has ended
constexpr double side_sagitta = 0.15;       // how far a line between corners may be bent
constexpr double least_arc_sagitta = 0.15;  // what turns less at the ends of an edge may be a bend itself
constexpr double straight_share = 0.3;      // of what an arc would be bent that turns as an edge does at its ends

struct NearLine {
    Point through{0.0, 0.0};
    Vector direction{1.0, 0.0};  ///< of unit length

    double along(Point p) const { return dot(p - through, direction); }
    double beside(Point p) const { return cross(direction, p - through); }
};

/// A contour as something that goes on and on.
class Loop {
  public:
    explicit Loop(const Contour& contour) : points_(contour) {}
    std::size_t size() const { return points_.size(); }
    Point operator[](std::size_t i) const { return points_[i % points_.size()]; }

  private:
    const Contour& points_;
};

/// The point from `first` to `last` farthest from their chord, and how far it is.
std::pair<std::size_t, double> farthest(const Loop& loop, std::size_t first, std::size_t last) {
    const Point a = loop[first];
    const Vector chord = loop[last] - a;
    const double size = length(chord);
    std::pair<std::size_t, double> found{first, 0.0};
    for (std::size_t i = first + 1; i < last; ++i) {
        const Vector v = loop[i] - a;
        const double along = size > 0.0 ? std::clamp(dot(v, chord) / (size * size), 0.0, 1.0) : 0.0;
        const double away = length(v - along * chord);
        if (away > found.second) found = {i, away};
    }
    return found;
}

/// Indices of the vertices after `first`, up to `last` (Douglas and Peucker 1973).
void append_vertices(const Loop& loop, std::size_t first, std::size_t last, std::vector<std::size_t>& vertices) {
    std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
    while (!open.empty()) {
        const auto [from, to] = open.back();
        open.pop_back();
        const auto [middle, away] = farthest(loop, from, to);
        if (away <= polygon_distance) {
            vertices.push_back(to);
        } else {
            open.emplace_back(middle, to);
            open.emplace_back(from, middle);
        }
    }
}

std::size_t farthest_from(const Loop& loop, Point place) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < loop.size(); ++i)
        if (distance(loop[i], place) > distance(loop[best], place)) best = i;
    return best;
}

/// Indices of the vertices of a polygon near the contour, ascending.
std::vector<std::size_t> polygon_of(const Loop& loop) {
    const std::size_t start = farthest_from(loop, loop[0]);
    const std::size_t other = farthest_from(loop, loop[start]);
    const std::size_t middle = other > start ? other : other + loop.size();
    std::vector<std::size_t> vertices{start};
    append_vertices(loop, start, middle, vertices);
    append_vertices(loop, middle, start + loop.size(), vertices);
    vertices.pop_back();
    return vertices;
}

/// The line nearest to the points from `first` to `last`, in their direction.
NearLine line_near(const Loop& loop, std::size_t first, std::size_t last) {
    const auto count = static_cast<double>(last - first + 1);
    Vector sum{0.0, 0.0};
    for (std::size_t i = first; i <= last; ++i) sum += loop[i] - loop[first];
    NearLine line{loop[first] + sum / count, {1.0, 0.0}};
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    for (std::size_t i = first; i <= last; ++i) {
        const Vector v = loop[i] - line.through;
        xx += v.x * v.x;
        xy += v.x * v.y;
        yy += v.y * v.y;
    }
    const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy);
    line.direction = {std::cos(angle), std::sin(angle)};
    if (dot(line.direction, loop[last] - loop[first]) < 0.0) line.direction = -line.direction;
    return line;
}

/// How far the points are bent away from the line over their length, by the parabola nearest to them.
double sagitta(const Loop& loop, std::size_t first, std::size_t last, const NearLine& line) {
    double reach = 0.0;
    for (std::size_t i = first; i <= last; ++i) reach = std::max(reach, std::abs(line.along(loop[i])));
    if (reach == 0.0) return 0.0;
    double count = 0.0;
    double s2 = 0.0;
    double s4 = 0.0;
    double e = 0.0;
    double es2 = 0.0;
    for (std::size_t i = first; i <= last; ++i) {
        const double s = line.along(loop[i]) / reach;
        const double away = line.beside(loop[i]);
        count += 1.0;
        s2 += s * s;
        s4 += s * s * s * s;
        e += away;
        es2 += away * s * s;
    }
    const double determinant = count * s4 - s2 * s2;
    return determinant > 0.0 ? (count * es2 - s2 * e) / determinant : 0.0;
}

/// Finds corners and lines on a polygon near the contour.
class BreakFinder {
  public:
    explicit BreakFinder(const Contour& contour) : loop_(contour) {
        find_vertices();
        edges_.resize(vertices_.size());
        for (std::size_t k = 0; k < vertices_.size(); ++k) edges_[k].is_corner = is_corner_[k];
        for (std::size_t k = 0; k < vertices_.size(); ++k) find_line(k);
    }

    std::vector<OutlineBreak> breaks() const {
        std::vector<OutlineBreak> found;
        for (std::size_t k = 0; k < vertices_.size(); ++k) {
            const Edge& edge = edges_[k];
            if (edge.is_corner)
                found.push_back({corner(k), vertices_[k], true, edge.line && edge.first == vertices_[k]});
            if (edge.line) append_ends(k, found);
        }
        return found;
    }

  private:
    /// The edge from a vertex to the next, and whether that vertex is a corner.
    struct Edge {
        bool is_corner = false;
        std::optional<NearLine> line{};
        std::size_t first = 0;  ///< of the points on the line; the vertex where that is a corner
        std::size_t last = 0;
    };

    std::size_t before(std::size_t k) const { return (k + vertices_.size() - 1) % vertices_.size(); }
    std::size_t after(std::size_t k) const { return (k + 1) % vertices_.size(); }

    /// The index of the vertex at the end of edge `k`, not less than that of its start.
    std::size_t end_of(std::size_t k) const {
        return k + 1 < vertices_.size() ? vertices_[k + 1] : vertices_[0] + loop_.size();
    }
    double edge_length(std::size_t k) const { return distance(loop_[vertices_[k]], loop_[end_of(k)]); }

    /// What leads away from point `i` in a straight line, beyond the rounding of a corner.
    Vector arm(std::size_t i, bool forward) const {
        const auto at = [&](std::size_t steps) { return forward ? i + steps : i + loop_.size() - steps; };
        std::size_t first = 1;
        while (first < loop_.size() / 2 && distance(loop_[at(first)], loop_[i]) < rounded_length) ++first;
        std::size_t good = first;
        std::size_t bad = loop_.size() / 2 + 1;
        const auto is_straight = [&](std::size_t steps) {
            const auto [from, to] = std::minmax({at(first), at(steps)});
            return farthest(loop_, from, to).second <= arm_distance;
        };
        for (std::size_t steps = first + 1; steps < bad; steps += steps - first) {
            if (!is_straight(steps))
                bad = steps;
            else
                good = steps;
        }
        while (good + 1 < bad) {
            const std::size_t middle = (good + bad) / 2;
            (is_straight(middle) ? good : bad) = middle;
        }
        return loop_[at(good)] - loop_[at(first)];
    }

    bool is_corner_at(std::size_t i) const {
        const Vector in = -arm(i, false);
        const Vector out = arm(i, true);
        const double angle = std::abs(angle_between(in, out));
        const double size = std::min(length(in), length(out));
        return size > least_arm && angle > least_corner_angle && angle * (size + rounded_length) > corner_turn;
    }

    /// Corners, one for the vertices that are near together, and between them as few vertices as can be.
    void find_vertices() {
        for (const std::size_t i : polygon_of(loop_)) add_vertex(i, is_corner_at(i));
        merge_ends();
        drop_near_corners();
        drop_spare_vertices();
    }

    void add_vertex(std::size_t i, bool is_corner) {
        const bool is_near = !vertices_.empty() && is_corner && is_corner_.back() &&
                             distance(loop_[i], loop_[vertices_.back()]) < cluster_length;
        if (is_near) {
            vertices_.back() = (vertices_.back() + i) / 2;
        } else {
            vertices_.push_back(i);
            is_corner_.push_back(is_corner);
        }
    }

    void erase_vertex(std::size_t k) {
        vertices_.erase(vertices_.begin() + static_cast<std::ptrdiff_t>(k));
        is_corner_.erase(is_corner_.begin() + static_cast<std::ptrdiff_t>(k));
    }

    /// The last vertex and the first one may be at the same corner.
    void merge_ends() {
        const std::size_t count = vertices_.size();
        const bool is_near = count > 1 && is_corner_.front() && is_corner_.back() &&
                             distance(loop_[vertices_.front()], loop_[vertices_.back()]) < cluster_length;
        if (!is_near) return;
        vertices_.back() = (vertices_.back() + vertices_.front() + loop_.size()) / 2;
        erase_vertex(0);
    }

    void drop_near_corners() {
        for (std::size_t k = 0; k < vertices_.size();) {
            const auto is_corner_near = [&](std::size_t other) {
                return is_corner_[other] && distance(loop_[vertices_[k]], loop_[vertices_[other]]) < cluster_length;
            };
            if (!is_corner_[k] && (is_corner_near(before(k)) || is_corner_near(after(k))))
                erase_vertex(k);
            else
                ++k;
        }
    }

    /// Whether the edges before and after vertex `k` are as good as one; the rounding of corners does not count.
    bool is_straight_without(std::size_t k) const {
        const auto is_near = [&](std::size_t i, std::size_t vertex) {
            return is_corner_[vertex] && distance(loop_[i], loop_[vertices_[vertex]]) < rounded_length;
        };
        std::size_t first = vertices_[before(k)];
        std::size_t last = end_of(k) + (k > 0 ? 0 : loop_.size());
        while (first < last && is_near(first, before(k))) ++first;
        while (last > first && is_near(last, after(k))) --last;
        return farthest(loop_, first, last).second <= polygon_distance;
    }

    void drop_spare_vertices() {
        for (std::size_t k = 0; k < vertices_.size() && vertices_.size() > 2;) {
            if (!is_corner_[k] && is_straight_without(k))
                erase_vertex(k);
            else
                ++k;
        }
    }

    /// The points of edge `k` that are farther from each of its ends than these lengths.
    std::pair<std::size_t, std::size_t> inner_points(std::size_t k, double from_start, double from_end) const {
        std::size_t first = vertices_[k];
        std::size_t last = end_of(k);
        while (first < last && distance(loop_[first], loop_[vertices_[k]]) < from_start) ++first;
        while (last > first && distance(loop_[last], loop_[end_of(k)]) < from_end) --last;
        return {first, last};
    }

    void find_line(std::size_t k) {
        Edge& edge = edges_[k];
        const bool has_corners = edge.is_corner && edges_[after(k)].is_corner;
        const double size = edge_length(k);
        if (size < (has_corners ? least_side_length : least_line_length)) return;
        const double margin = has_corners ? std::min(rounded_length, 0.25 * size) : 0.2 * size;
        const auto [first, last] =
            inner_points(k, edge.is_corner ? std::min(rounded_length, 0.25 * size) : margin,
                         edges_[after(k)].is_corner ? std::min(rounded_length, 0.25 * size) : margin);
        if (last < first + 2) {
            if (has_corners) edge.line = NearLine{loop_[first], (loop_[last] - loop_[first]) / size};
        } else {
            take_line(k, line_near(loop_, first, last), first, last);
        }
        if (!edge.line) return;
        edge.first = edge.is_corner ? vertices_[k] : end_on_line(*edge.line, first, vertices_[k]);
        edge.last = edges_[after(k)].is_corner ? end_of(k) : end_on_line(*edge.line, last, end_of(k));
    }

    /// The curvature of the polygon at a vertex.
    double bend_at(std::size_t k) const {
        const Vector in = loop_[vertices_[k]] - loop_[vertices_[before(k)]];
        const Vector out = loop_[end_of(k)] - loop_[vertices_[k]];
        return 2.0 * std::abs(angle_between(in, out)) / (length(in) + length(out));
    }

    /// How far an arc of this length would be bent that turns as the polygon does at the ends of edge `k`.
    double arc_sagitta(std::size_t k, double size) const {
        const double at_start = bend_at(edges_[k].is_corner ? after(k) : k);
        const double at_end = bend_at(edges_[after(k)].is_corner ? k : after(k));
        return std::min(at_start, at_end) * size * size / 8.0;
    }

    /// Whether the points are on a line, and an edge that is no side between corners differs from a bend.
    bool is_line(std::size_t k, const NearLine& line, std::size_t first, std::size_t last) const {
        const double bent = std::abs(sagitta(loop_, first, last, line));
        if (edges_[k].is_corner && edges_[after(k)].is_corner) return bent <= side_sagitta;
        const double of_arc = arc_sagitta(k, distance(loop_[first], loop_[last]));
        return of_arc > least_arc_sagitta && bent < straight_share * of_arc;
    }

    void take_line(std::size_t k, const NearLine& line, std::size_t first, std::size_t last) {
        if (!is_line(k, line, first, last)) return;
        for (std::size_t i = first; i <= last; ++i)
            if (std::abs(line.beside(loop_[i])) > line_width) return;
        edges_[k].line = line;
    }

    /// The last point on the line on the way from one that is on it to another.
    std::size_t end_on_line(const NearLine& line, std::size_t from, std::size_t to) const {
        while (from != to) {
            const std::size_t next = from < to ? from + 1 : from - 1;
            if (std::abs(line.beside(loop_[next])) > line_end) break;
            from = next;
        }
        return from;
    }

    /// The line along which edge `k` reaches its end, or its start.
    std::optional<NearLine> side_at(std::size_t k, bool at_end) const {
        if (edges_[k].line) return edges_[k].line;
        const double size = edge_length(k);
        const double far = std::max(size - side_length, std::min(rounded_length, 0.25 * size));
        const double near = std::min(rounded_length, 0.25 * size);
        const auto [first, last] = at_end ? inner_points(k, far, near) : inner_points(k, near, far);
        if (last < first + 2) return std::nullopt;
        return line_near(loop_, first, last);
    }

    /// Where both sides of a corner meet; the vertex where that is elsewhere.
    Point corner(std::size_t k) const {
        const Point vertex = loop_[vertices_[k]];
        const auto in = side_at(before(k), true);
        const auto out = side_at(k, false);
        if (!in || !out) return vertex;
        const double turn = cross(in->direction, out->direction);
        if (std::abs(turn) < 1e-3) return vertex;
        const Point meeting = in->through + cross(out->through - in->through, out->direction) / turn * in->direction;
        return distance(meeting, vertex) <= corner_shift ? meeting : vertex;
    }

    /// The ends of the line on edge `k` that are no corners.
    void append_ends(std::size_t k, std::vector<OutlineBreak>& found) const {
        const Edge& edge = edges_[k];
        const auto place = [&](std::size_t index) {
            return edge.line->through + edge.line->along(loop_[index]) * edge.line->direction;
        };
        if (!edge.is_corner) found.push_back({place(edge.first), edge.first, false, true, edge.line->direction});
        if (!edges_[after(k)].is_corner)
            found.push_back({place(edge.last), edge.last, false, false, edge.line->direction});
    }

    Loop loop_;
    std::vector<std::size_t> vertices_;  // ascending; what comes after the last one is less than one round further
    std::vector<bool> is_corner_;
    std::vector<Edge> edges_;
};

}  // namespace

std::vector<OutlineBreak> breaks_of(const Contour& contour) {
    if (contour.size() < 3) return {};
    return BreakFinder(contour).breaks();
}

}  // namespace batten::core
