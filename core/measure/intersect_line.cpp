#include "core/measure/intersect_line.h"

#include <cmath>

#include "core/curve/control_box.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/continuity.h"
#include "core/measure/detail/piece_forms.h"

namespace batten::core {

namespace {

constexpr double roundoff_of_line = 0.5 * std::numeric_limits<double>::epsilon();

// Distances from the line, as part of the size of curve and segment, that count as none at a joint and at an end.
constexpr double on_line = 1e-12;

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
        offset_error_ = scale * 4.0 * roundoff_of_line * (far + reach) * (1.0 + reach / length_);
        tolerance_ = on_line * (reach + length_) + 4.0 * roundoff_of_line * far;
    }

    // The distance from the line, to the left of it positive, times the weight and the scale.
    Bernstein distance(std::span<const Bernstein> forms) const {
        const Bernstein height = sum(scaled(forms[0], normal_.x), scaled(forms[1], normal_.y));
        return difference(height, product(forms[2], constant(offset_, offset_error_)));
    }

    int side_of(Point point) const {
        const double height = dot(normal_, point - a_);
        if (std::abs(height) <= tolerance_) return 0;
        return height < 0.0 ? -1 : 1;
    }

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
    const Curve& curve_;
    Point a_;
    Vector chord_;
    double length_;
    Vector normal_{};
    double offset_ = 0.0;
    double offset_error_ = 0.0;
    double tolerance_ = 0.0;
};

// The changes of side along the control polygon, with points on the line left out; those within the segment only, if
// asked.
std::size_t polygon_crossings(const Curve& curve, const Line& line, bool is_cyclic, bool within_segment) {
    std::vector<Point> points(curve.control_points().begin(), curve.control_points().end());
    if (is_cyclic) points.insert(points.end(), curve.control_points().begin(), curve.control_points().end());
    const std::size_t end = is_cyclic ? points.size() / 2 : points.size();
    std::size_t count = 0;
    for (std::size_t i = 0; i < end; ++i) {
        std::size_t next = i + 1;
        while (next < points.size() && line.side_of(points[next]) == 0) ++next;
        if (next == points.size() || line.side_of(points[i]) * line.side_of(points[next]) >= 0) continue;
        const bool passes_point = next > i + 1;
        const double along =
            passes_point ? line.along(points[i + 1]) : line.along(line.on_leg(points[i], points[next]));
        if (!within_segment || line.has(along)) ++count;
    }
    return count;
}

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

Result<LineContacts> intersect_line(const Curve& curve, Point a, Point b) {
    if (const auto check = check_line(a, b); !check) return refuse(check.error());
    const Line line(curve, a, b);
    const bool is_cyclic = is_closed(curve);
    const auto distance = [&](std::span<const Bernstein> forms) { return line.distance(forms); };
    LineContacts result;
    for (const SignEvent& event : sign_events(sign_runs_along(curve, 0, distance), is_cyclic)) {
        if (event.is_jump && is_tear(curve, event.where.lower) && !line.meets_at(event.where.lower)) continue;
        result.contacts.push_back(line.contact(event.where, event.before, event.after));
    }
    result.crossings = count_crossings(result.contacts);
    result.polygon_crossings = polygon_crossings(curve, line, is_cyclic, false);
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
    result.polygon_crossings = polygon_crossings(curve, line, is_closed(curve), true);
    return result;
}

}  // namespace batten::core
