#include "core/measure/intersect_line.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/curve/control_box.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/continuity.h"
#include "core/measure/detail/piece_forms.h"

namespace batten::core {

namespace {

constexpr double roundoff_of_line = 0.5 * std::numeric_limits<double>::epsilon();

// Distances from the line, as part of the size of curve and segment, that count as none at a joint and at an end.
constexpr double on_line = 1e-12;

// A control point is clearly beside the line where it is farther than so many times what rounding may have moved it:
// then no form of a span can be in doubt of its side.
constexpr double clearly = 64.0;

// The line as seen from the middle of the curve.
class Line {
  public:
    Line(const Curve& curve, Point a, Point b) : curve_(curve), a_(a), chord_(b - a), length_(length(chord_)) {
        normal_ = turned_left(chord_) / length_;
        const Point origin = middle_of(curve);
        const Box box = control_box(curve);
        const double far = std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
        const double reach = length(box.size()) + core::distance(a, origin);
        const double scale = form_scale(curve);
        offset_ = scale * dot(normal_, a - origin);
        // Rounded coordinates move the line and turn it.
        rounding_ = 4.0 * roundoff_of_line * (far + reach) * (1.0 + reach / length_);
        offset_error_ = scale * rounding_;
        tolerance_ = on_line * (reach + length_) + 4.0 * roundoff_of_line * far;
    }

    // The distance from the line, to the left of it positive, times the weight and the scale.
    Bernstein distance(std::span<const Bernstein> forms) const {
        const Bernstein height = sum(scaled(forms[0], normal_.x), scaled(forms[1], normal_.y));
        return difference(height, product(forms[2], constant(offset_, offset_error_)));
    }

    int side_of(Point point) const { return side_of(point, tolerance_); }

    // Of a control point. No more are in the line than the forms of the curve doubt, so that these have no sign which
    // the control points do not have.
    int side_of_corner(Point point) const { return side_of(point, rounding_); }

    // None where it is not clear.
    int clear_side_of_corner(Point point) const { return side_of(point, clearly * rounding_); }

    double along(Point point) const { return dot(point - a_, chord_) / (length_ * length_); }

    // Where a leg from one side to the other passes the line.
    Point on_leg(Point p, Point q) const {
        const double from = dot(normal_, p - a_);
        const double to = dot(normal_, q - a_);
        return p + from / (from - to) * (q - p);
    }

    // Whether a place `along` belongs to the segment.
    bool has(double along) const {
        const double slack = tolerance_ / length_;
        return -slack <= along && along <= 1.0 + slack;
    }

    bool meets_at(double u) const {
        return side_of(point_at(curve_, u, Side::left)) == 0 || side_of(point_at(curve_, u, Side::right)) == 0;
    }

    LineContact contact(Interval where, int before, int after) const {
        const Interval domain = curve_.domain();
        double u = where.lower + 0.5 * where.length();
        if (u > domain.upper) u -= domain.length();
        // At a gap it may be the left side that meets the line.
        const bool is_left = side_of(point_at(curve_, u)) != 0;
        const Point point = point_at(curve_, u, is_left ? Side::left : Side::right);
        const bool is_end = before * after == 0;
        const ContactKind kind = before * after < 0 ? ContactKind::crossing
                                 : is_end           ? ContactKind::ending
                                                    : ContactKind::touching;
        return {where, u, point, along(point), kind};
    }

  private:
    int side_of(Point point, double tolerance) const {
        const double height = dot(normal_, point - a_);
        if (!(std::abs(height) > tolerance)) return 0;
        return height < 0.0 ? -1 : 1;
    }

    const Curve& curve_;
    Point a_;
    Vector chord_;
    double length_;
    Vector normal_{};
    double offset_ = 0.0;
    double rounding_ = 0.0;
    double offset_error_ = 0.0;
    double tolerance_ = 0.0;
};

// A change of side along the polygon, between two control points beside the line with none but such in it between them;
// indices go on past the last one.
LegCrossing crossing_between(const Curve& curve, const Line& line, std::size_t before, std::size_t after) {
    const auto points = curve.control_points();
    const auto corner = [&](std::size_t i) { return points[i % points.size()]; };
    LegCrossing crossing{.leg = before % points.size()};
    crossing.point = after == before + 1 ? line.on_leg(corner(before), corner(after))
                                         : middle(corner(before + 1), corner(after - 1));
    crossing.along = line.along(crossing.point);
    return crossing;
}

// Calls `take(before, after)` for the changes of side along the control polygon, with points on the line left out.
template <class Take>
void visit_polygon_crossings(const Curve& curve, const Line& line, bool is_cyclic, Take take) {
    const auto points = curve.control_points();
    const std::size_t n = points.size();
    std::size_t first = 0;
    while (first < n && line.side_of_corner(points[first]) == 0) ++first;
    if (first == n) return;
    std::size_t before = first;
    int side = line.side_of_corner(points[first]);
    const std::size_t end = is_cyclic ? first + n + 1 : n;
    for (std::size_t i = first + 1; i < end; ++i) {
        const int next = line.side_of_corner(points[i < n ? i : i - n]);
        if (next == 0) continue;
        if (next != side) take(before, i);
        before = i;
        side = next;
    }
}

void find_polygon_crossings(LineContacts& result, const Curve& curve, const Line& line, bool is_cyclic,
                            std::size_t most) {
    visit_polygon_crossings(curve, line, is_cyclic, [&](std::size_t before, std::size_t after) {
        if (result.polygon_crossings++ < most)
            result.on_polygon.push_back(crossing_between(curve, line, before, after));
    });
    std::ranges::stable_sort(result.on_polygon, {}, &LegCrossing::leg);
}

// For each span of the domain the side on which all its control points clearly are, 0 where there is none.
class ClearSpans {
  public:
    ClearSpans(const Curve& curve, const Line& line) : degree_(static_cast<std::size_t>(curve.degree())) {
        const auto points = curve.control_points();
        const std::size_t end = curve.knots().size() - degree_ - 1;
        sides_.reserve(end - degree_);
        std::size_t alike = 0;
        int before = 0;
        for (std::size_t i = 0; i < end; ++i) {
            const int side = line.clear_side_of_corner(points[i < points.size() ? i : i % points.size()]);
            alike = side != 0 && side == before ? alike + 1 : 1;
            before = side;
            if (i >= degree_) sides_.push_back(alike > degree_ ? side : 0);
        }
    }

    std::optional<int> operator()(std::size_t span) const {
        const int side = sides_[span - degree_];
        return side == 0 ? std::nullopt : std::optional(side);
    }

    std::size_t unclear_count() const { return static_cast<std::size_t>(std::ranges::count(sides_, 0)); }

  private:
    std::size_t degree_;
    std::vector<int> sides_;
};

std::size_t count_crossings(std::span<const LineContact> contacts) {
    return static_cast<std::size_t>(std::count_if(contacts.begin(), contacts.end(), [](const LineContact& contact) {
        return contact.kind == ContactKind::crossing;
    }));
}

Result<void> check_line(Point a, Point b) {
    if (length(b - a) > 0.0 && std::isfinite(length(b - a))) return {};
    return refuse({.code = CurveErrorCode::points_coincide, .index = 1, .value = 0.0});
}

bool is_tear(const Curve& curve, double u) {
    const Interval domain = curve.domain();
    return domain.lower < u && u < domain.upper && curve.knots().multiplicity(u) > curve.degree();
}

// The parts of a straight piece in the line that the segment reaches.
std::vector<LineContact> parts_on_segment(const Curve& curve, const Line& line, const LineContact& whole, Point a,
                                          Point b) {
    const Vector aside(a.y - b.y, b.x - a.x);
    std::vector<double> cuts{whole.where.lower, whole.where.upper};
    for (const Point end : {a, b})
        if (const auto across = intersect_line(curve, end, end + aside))
            for (const LineContact& contact : across->contacts)
                for (const double u : {contact.u, contact.u + curve.domain().length()})
                    if (whole.where.lower < u && u < whole.where.upper) cuts.push_back(u);
    std::sort(cuts.begin(), cuts.end());
    std::vector<LineContact> parts;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        LineContact part = line.contact({cuts[i], cuts[i + 1]}, 0, 0);
        part.kind = whole.kind;
        if (line.has(part.along)) parts.push_back(part);
    }
    return parts;
}

}  // namespace

Result<LineContacts> intersect_line(const Curve& curve, Point a, Point b, std::size_t most_spans) {
    if (const auto check = check_line(a, b); !check) return refuse(check.error());
    const Line line(curve, a, b);
    const bool is_cyclic = is_closed(curve);
    LineContacts result;
    find_polygon_crossings(result, curve, line, is_cyclic, most_spans);
    const ClearSpans clear(curve, line);
    result.is_complete = clear.unclear_count() <= most_spans;
    if (!result.is_complete) return result;
    const auto distance = [&](std::span<const Bernstein> forms) { return line.distance(forms); };
    for (const SignEvent& event : sign_events(sign_runs_along(curve, 0, distance, clear), is_cyclic)) {
        if (event.is_jump && is_tear(curve, event.where.lower) && !line.meets_at(event.where.lower)) continue;
        result.contacts.push_back(line.contact(event.where, event.before, event.after));
    }
    result.crossings = count_crossings(result.contacts);
    return result;
}

Result<LineContacts> intersect_segment(const Curve& curve, Point a, Point b) {
    auto all = intersect_line(curve, a, b);
    if (!all) return all;
    const Line line(curve, a, b);
    LineContacts result;
    for (const LineContact& contact : all->contacts) {
        if (contact.where.length() > 0.0) {
            const auto parts = parts_on_segment(curve, line, contact, a, b);
            result.contacts.insert(result.contacts.end(), parts.begin(), parts.end());
        } else if (line.has(contact.along)) {
            result.contacts.push_back(contact);
        }
    }
    result.crossings = count_crossings(result.contacts);
    for (const LegCrossing& crossing : all->on_polygon)
        if (line.has(crossing.along)) result.on_polygon.push_back(crossing);
    result.polygon_crossings = result.on_polygon.size();
    return result;
}

}  // namespace batten::core
