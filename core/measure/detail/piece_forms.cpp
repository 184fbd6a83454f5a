#include "core/measure/detail/piece_forms.h"

#include <cassert>
#include <cmath>

#include "core/base/detail/unit_interval.h"
#include "core/curve/control_box.h"

namespace batten::core {

namespace {

constexpr double roundoff_of_forms = 0.5 * std::numeric_limits<double>::epsilon();

// Runs of definite sign between zeros that are shorter than this part of their span are rounding at a knot.
constexpr double shortest_run_at_knot = 1e-11;

// How far rounding may have moved the coordinates of Bézier points of weight 1, seen from the middle of the curve: by
// a unit of the original coordinates, and in each of the p levels of the triangle.
double coordinate_error(const Curve& curve, const Curve& seen, std::size_t span) {
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::size_t n = curve.control_points().size();
    double far = 0.0;
    double near = 0.0;
    for (std::size_t i = span - p; i <= span; ++i) {
        const Point original = curve.control_points()[i % n];
        far = std::max({far, std::abs(original.x), std::abs(original.y)});
        near = std::max(near, length(vector_to(seen.control_points()[i % n])));
    }
    return roundoff_of_forms * (far + static_cast<double>(curve.degree() + 4) * near);
}

Bernstein weight_form(const BezierPiece& piece, double relative_error) {
    Bernstein form;
    bool is_constant = true;
    for (const HomogeneousPoint& point : piece.points) {
        form.values.push_back(point.z);
        form.errors.push_back(relative_error * point.z);
        is_constant = is_constant && point.z == piece.points.front().z;
    }
    return is_constant ? constant(piece.points.front().z) : form;
}

Bernstein coordinate_form(const BezierPiece& piece, int axis, double error) {
    Bernstein form;
    for (const HomogeneousPoint& point : piece.points) {
        form.values.push_back(point[axis]);
        form.errors.push_back(error * point.z);
    }
    return form;
}

// The power of two that brings `size` to about 1; 1 where there is none.
double scale_to_one(double size) {
    return size > 0.0 && std::isfinite(size) ? std::ldexp(1.0, -std::ilogb(size)) : 1.0;
}

double size_of(const Curve& curve) {
    const Box box = control_box(curve);
    return std::max(0.5 * box.upper.x - 0.5 * box.lower.x, 0.5 * box.upper.y - 0.5 * box.lower.y);
}

PieceForms forms_of(BezierPiece piece, double error, const HomogeneousPoint& scale, int order) {
    for (HomogeneousPoint& point : piece.points) point *= scale;
    PieceForms result{piece.interval, {}};
    const double weight_error = roundoff_of_forms * static_cast<double>(piece.points.size() + 3);
    result.forms = {coordinate_form(piece, 0, error), coordinate_form(piece, 1, error),
                    weight_form(piece, weight_error)};
    for (int k = 0; k < order; ++k)
        for (int axis = 0; axis < 3; ++axis) result.forms.push_back(derivative(result.forms[result.forms.size() - 3]));
    return result;
}

void join_at_knot(std::vector<SignRun>& runs, Interval last_piece) {
    const std::size_t count = runs.size();
    if (count < 3 || runs[count - 1].sign != 0 || runs[count - 2].sign == 0 || runs[count - 3].sign != 0) return;
    if (runs[count - 2].where.length() > shortest_run_at_knot * last_piece.length()) return;
    runs[count - 3].where.upper = runs[count - 1].where.upper;
    runs.resize(count - 2);
}

// Forms of pieces, seen from the middle of the curve.
class FormMaker {
  public:
    FormMaker(const Curve& curve, int order)
        : curve_(curve), seen_(seen_from(curve, middle_of(curve))), scale_(form_scale(curve)), order_(order) {}

    // Of the non-empty spans among first..last.
    template <class Take>
    void make(std::size_t first, std::size_t last, Take take) const {
        const HomogeneousPoint scale(scale_, scale_, 1.0);
        for (const BezierPiece& piece : bezier_pieces(seen_, first, last))
            take(forms_of(piece, scale_ * coordinate_error(curve_, seen_, piece.span), scale, order_));
    }

  private:
    const Curve& curve_;
    Curve seen_;
    double scale_;
    int order_;
};

// The spans of the domain.
std::pair<std::size_t, std::size_t> span_range(const Curve& curve) {
    const auto p = static_cast<std::size_t>(curve.degree());
    return {p, curve.knots().size() - p - 2};
}

void append_runs_of(std::vector<SignRun>& runs, PieceForms piece, const Expression& expression) {
    for (const SignRun& run : sign_runs(std::move(piece.forms), expression)) {
        append_run(
            runs, {{from_unit(piece.interval, run.where.lower), from_unit(piece.interval, run.where.upper)}, run.sign});
        join_at_knot(runs, piece.interval);
    }
}

// Where the weight is constant, of no higher degree than it has to be.
Bernstein hodograph_along(std::span<const Bernstein> forms, std::size_t axis) {
    Bernstein derivative = product(forms[3 + axis], forms[2]);
    return forms[2].degree() == 0 ? derivative : difference(derivative, product(forms[axis], forms[5]));
}

}  // namespace

double form_scale(const Curve& curve) {
    return scale_to_one(size_of(curve));
}

std::vector<PieceForms> piece_forms(const Curve& curve, int order) {
    assert(order >= 0);
    std::vector<PieceForms> result;
    const auto [first, last] = span_range(curve);
    FormMaker(curve, order).make(first, last, [&](PieceForms forms) { result.push_back(std::move(forms)); });
    return result;
}

void visit_piece_forms(const Curve& curve, int order, const std::function<bool(std::size_t span)>& wanted,
                       const std::function<void(const PieceForms&)>& take) {
    const FormMaker maker(curve, order);
    const auto [first, last] = span_range(curve);
    for (std::size_t s = first; s <= last; ++s)
        if (curve.knots()[s] < curve.knots()[s + 1] && wanted(s)) maker.make(s, s, take);
}

std::vector<SignRun> sign_runs_along(const Curve& curve, int order, const Expression& expression) {
    return sign_runs_along(curve, order, expression, [](std::size_t) { return std::nullopt; });
}

std::vector<SignRun> sign_runs_along(const Curve& curve, int order, const Expression& expression,
                                     const KnownSign& known) {
    const FormMaker maker(curve, order);
    const KnotVector& knots = curve.knots();
    const auto [first, last] = span_range(curve);
    std::vector<SignRun> runs;
    for (std::size_t s = first; s <= last; ++s) {
        if (const std::optional<int> sign = known(s)) {
            if (knots[s] < knots[s + 1]) append_run(runs, {{knots[s], knots[s + 1]}, *sign});
            continue;
        }
        const std::size_t begin = s;
        while (s < last && !known(s + 1)) ++s;
        maker.make(begin, s, [&](PieceForms forms) { append_runs_of(runs, std::move(forms), expression); });
    }
    return runs;
}

Bernstein hodograph_x(std::span<const Bernstein> forms) {
    assert(forms.size() >= 6);
    return hodograph_along(forms, 0);
}

Bernstein hodograph_y(std::span<const Bernstein> forms) {
    assert(forms.size() >= 6);
    return hodograph_along(forms, 1);
}

Bernstein speed_squared(std::span<const Bernstein> forms) {
    const Bernstein x = hodograph_x(forms);
    const Bernstein y = hodograph_y(forms);
    return sum(product(x, x), product(y, y));
}

}  // namespace batten::core
