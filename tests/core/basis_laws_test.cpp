/// Laws of the basis functions, on curves of every sort.
#include <cmath>
#include <numeric>

#include "core/edit/point_edit.h"
#include "core/evaluate/basis.h"
#include "core/evaluate/evaluate.h"
#include "tests/core/law_curves.h"

namespace batten::core::laws {

namespace {

Side draw_side() {
    return *rc::gen::element(Side::right, Side::left);
}

// Each of the p levels multiplies by two quotients whose sum is 1 but for three roundings, and rounds a product and a
// sum; p additions come last. So no sum is farther from 1 than 6 p units of 2^-53, and these do not all have one sign.
double allowed_in_sum(const Curve& curve) {
    return 2 * (1 + curve.degree()) * std::ldexp(1.0, -53);
}

}  // namespace

TEST(BasisLaws, partition_of_unity) {
    check_everywhere("the basis functions sum to 1", [](Setting setting) {
        const Curve curve = draw_curve(setting);
        const auto values = basis_functions(curve.knots(), draw_parameter(curve), 0, draw_side()).derivatives[0];
        RC_ASSERT(std::abs(std::accumulate(values.begin(), values.end(), 0.0) - 1.0) <= allowed_in_sum(curve));
    });
}

// The derivatives of a constant: zero relative to their own size, with the same rounding.
TEST(BasisLaws, derivatives_sum_to_zero) {
    check_everywhere("derivatives of the basis functions sum to 0", [](Setting setting) {
        const Curve curve = draw_curve(setting);
        const int order = draw_whole(1, std::min(curve.degree(), 3));
        const auto values =
            basis_functions(curve.knots(), draw_parameter(curve), order, draw_side()).derivatives.back();
        double size = 0.0;
        for (const double value : values) size += std::abs(value);
        RC_ASSERT(std::abs(std::accumulate(values.begin(), values.end(), 0.0)) <= size * allowed_in_sum(curve));
    });
}

TEST(BasisLaws, positivity) {
    check_everywhere("basis functions are positive inside their span and nowhere negative", [](Setting setting) {
        const Curve curve = draw_curve(setting);
        const KnotVector& knots = curve.knots();
        const double u = draw_parameter(curve);
        const BasisValues basis = basis_functions(knots, u);
        const bool is_inside = knots[basis.span] < u && u < knots[basis.span + 1];
        // With knots 1e-9 and 1e9 apart a function of degree 25 may be too small to be a double.
        const bool may_vanish = setting == Setting::close_and_long || setting == Setting::close_knots;
        for (const double value : basis.derivatives[0]) {
            RC_ASSERT(value >= 0.0);
            if (is_inside && !may_vanish) RC_ASSERT(value > 0.0);
        }
    });
}

TEST(BasisLaws, local_support) {
    check_everywhere("basis functions vanish outside u_i..u_{i+p+1}", [](Setting setting) {
        const Curve curve = draw_curve(setting, {.periodic = false});
        const KnotVector& knots = curve.knots();
        const auto p = static_cast<std::size_t>(curve.degree());
        const double u = draw_parameter(curve);
        const BasisValues basis = basis_functions(knots, u);
        for (std::size_t i = 0; i < curve.control_points().size(); ++i) {
            const double value = basis_function(knots, i, u);
            if (u < knots[i] || u > knots[i + p + 1]) RC_ASSERT(value == 0.0);
            if (i < basis.span - p || i > basis.span) RC_ASSERT(value == 0.0);
        }
    });
}

// No rounding is allowed for: points that a control point does not act on keep every bit.
TEST(BasisLaws, a_control_point_moves_its_support_only) {
    check_everywhere("a control point acts on p+1 spans only", [](Setting setting) {
        const Curve curve = draw_curve(setting, {.periodic = false});
        const auto p = static_cast<std::size_t>(curve.degree());
        const auto i = static_cast<std::size_t>(draw_whole(0, static_cast<int>(curve.control_points().size()) - 1));
        const double u = draw_parameter(curve);
        const std::size_t span = curve.knots().span_at(u);
        RC_PRE(i < span - p || i > span);
        const Curve moved = set_control_point(curve, i, curve.control_points()[i] + Vector(3, -5)).value();
        const Curve heavier = set_weight(curve, i, 3 * curve.weights()[i]).value();
        RC_ASSERT(point_at(moved, u) == point_at(curve, u));
        RC_ASSERT(derivatives_at(moved, u, 2) == derivatives_at(curve, u, 2));
        RC_ASSERT(point_at(heavier, u) == point_at(curve, u));
    });
}

}  // namespace batten::core::laws
