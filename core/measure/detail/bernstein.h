/// Polynomials in Bernstein form on [0, 1] that know how far rounding may have moved their coefficients.
#pragma once

#include <cassert>
#include <utility>

#include "core/base/detail/short_list.h"
#include "core/base/geometry.h"

namespace batten::core {

/// The polynomial sum_k b_k binomial(n, k) t^k (1-t)^(n-k). Between 0 and 1 it lies between its least and its greatest
/// coefficient and has no more zeros than its coefficients have changes of sign.
struct Bernstein {
    using Coefficients = ShortList<double, 12>;  // products of two or three cubics have no more

    Coefficients values;  ///< b_0..b_n, at least one
    Coefficients errors;  ///< how far each may be from the truth, >= 0, one for each value

    std::size_t degree() const {
        assert(!values.empty() && errors.size() == values.size());
        return values.size() - 1;
    }
};

/// The polynomial of degree 0.
Bernstein constant(double value, double error = 0.0);

/// a b, of the sum of the degrees. Cost O(deg a * deg b). Source: Farouki and Rajan 1988.
Bernstein product(const Bernstein& a, const Bernstein& b);

/// a of a degree that is no less than its own. Cost O(n deg a).
Bernstein elevated(const Bernstein& a, std::size_t degree);

/// a + b and a - b, of the greater of the degrees.
Bernstein sum(const Bernstein& a, const Bernstein& b);
Bernstein difference(const Bernstein& a, const Bernstein& b);

/// factor a.
Bernstein scaled(Bernstein a, double factor);

/// a', of one degree less; 0 for a constant.
Bernstein derivative(const Bernstein& a);

/// a(t). Cost O(n^2). Source: de Casteljau.
double value_at(const Bernstein& a, double t);

/// The two halves of `a`, each over [0, 1] again. Cost O(n^2).
std::pair<Bernstein, Bernstein> halves(const Bernstein& a);

/// The part of `a` between two values of t, 0 <= lower < upper <= 1, over [0, 1] again. Cost O(n^2).
Bernstein part(const Bernstein& a, Interval interval);

}  // namespace batten::core
