#include "core/make/detail/cubic_rows.h"

#include "core/base/detail/vectorized.h"

namespace batten::core {

namespace {

using CubicRow = std::array<double, 4>;

// The four functions that do not vanish between the knots b and c, of a <= ... <= f around it, by de Boor's recurrence
// with one division for all of it:
//     N_0 = (c-u)^3 / ((c-b)(c-a')(c-a)), ..., N_3 = (u-b)^3 / ((c-b)(d-b)(e-b))
// Source: The NURBS Book, A2.2.
struct CubicSpan {
    double before_last, before, lower, upper, after, after_next;
};

[[gnu::always_inline]] inline CubicRow cubic_basis(const CubicSpan& at, double u) {
    const double below = u - at.lower;
    const double above = at.upper - u;
    const double width = at.upper - at.lower;
    const double left = (at.upper - at.before) * (at.upper - at.before_last);
    const double right = (at.after - at.lower) * (at.after_next - at.lower);
    const double middle = at.after - at.before;
    const double outer = width * left * right;
    const double share = 1.0 / (outer * middle);
    const double from_left = share * middle * right;  // 1 / (width left)
    const double from_right = share * middle * left;
    const double squared_above = above * above * from_left;
    const double squared_below = below * below * from_right;
    const double linear = share * outer *
                          ((u - at.before) * above * ((at.upper - at.before_last) * from_left) +
                           (at.after - u) * below * ((at.after_next - at.lower) * from_right));
    return {above * squared_above, (u - at.before_last) * squared_above + (at.after - u) * linear,
            (u - at.before) * linear + (at.after_next - u) * squared_below, below * squared_below};
}

}  // namespace

// Whether the site lies beyond the middle knot decides among numbers already read, so that no pass is unlike another.
BATTEN_VECTORIZED void fill_cubic_rows(CubicRows& rows, const CubicRowSource& source, std::size_t begin,
                                       std::size_t end) {
    auto& [c0, c1, c2, c3, c4] = rows.coefficients;
    const auto [knots, sites, x, y] = source;
    BATTEN_INDEPENDENT
    for (std::size_t i = begin; i < end; ++i) {
        const double* const k = knots + i;
        const double* const px = x + i;
        const double* const py = y + i;
        const double u = sites[i];
        const bool is_beyond = k[2] <= u;
        const auto either = [&](double one, double other) { return is_beyond ? other : one; };
        const CubicSpan at{either(k[-1], k[0]), either(k[0], k[1]), either(k[1], k[2]),
                           either(k[2], k[3]),  either(k[3], k[4]), either(k[4], k[5])};
        const CubicRow basis = cubic_basis(at, u);
        c0[i] = either(basis[0], 0.0);
        c1[i] = either(basis[1], basis[0]);
        c2[i] = either(basis[2], basis[1]);
        c3[i] = either(basis[3], basis[2]);
        c4[i] = either(0.0, basis[3]);
        rows.x[i] =
            c0[i] * (px[0] - px[-2]) + c1[i] * (px[0] - px[-1]) + c3[i] * (px[0] - px[1]) + c4[i] * (px[0] - px[2]);
        rows.y[i] =
            c0[i] * (py[0] - py[-2]) + c1[i] * (py[0] - py[-1]) + c3[i] * (py[0] - py[1]) + c4[i] * (py[0] - py[2]);
    }
}

}  // namespace batten::core
