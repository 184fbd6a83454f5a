#include "core/evaluate/evaluator.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "core/curve/detail/known_degree.h"
#include "core/evaluate/detail/homogeneous_jet.h"

namespace batten::core {

namespace {

// By Horner's rule.
template <class Degree>
Point polynomial_point(const TaylorPiece& piece, Degree p, double t) {
    const double* c = piece.point() + 2 * p;
    Vector sum(c[0], c[1]);
    for (std::size_t k = p; k-- > 0;) {
        c -= 2;
        sum = {sum.x * t + c[0], sum.y * t + c[1]};
    }
    return tip_of(sum);
}

template <class Degree>
Point rational_point(const TaylorPiece& piece, Degree p, double t) {
    const double* c = piece.terms() + 3 * (p - 1);
    Vector sum(c[0], c[1]);
    double weight = c[2];
    for (std::size_t k = p; k-- > 1;) {
        c -= 3;
        sum = {sum.x * t + c[0], sum.y * t + c[1]};
        weight = weight * t + c[2];
    }
    const double share = t / (weight * t + 1.0);
    return Point(piece.point()[0], piece.point()[1]) + share * sum;
}

Point point_on_piece(const TaylorPiece& piece, double u) {
    const double t = piece.at(u);
    return with_known_degree(piece.p, [&](auto p) {
        return piece.is_rational ? rational_point(piece, p, t) : polynomial_point(piece, p, t);
    });
}

// A value of w C and of w.
struct WeightedVector {
    Vector vector{};
    double weight = 0.0;
};

WeightedVector operator*(double factor, const WeightedVector& v) {
    return {factor * v.vector, factor * v.weight};
}

WeightedVector operator+(const WeightedVector& a, const WeightedVector& b) {
    return {a.vector + b.vector, a.weight + b.weight};
}

// Term k of a piece: of C or of w C, seen from c_0, and of w.
void read_term(const TaylorPiece& piece, std::size_t k, Vector& term) {
    const double* c = piece.point() + 2 * k;
    term = k == 0 ? Vector(0.0, 0.0) : Vector(c[0], c[1]);
}

void read_term(const TaylorPiece& piece, std::size_t k, WeightedVector& term) {
    // Term 0 is not kept; a pointer to where it would be must not be formed.
    if (k == 0) {
        term = {{0.0, 0.0}, 1.0};
        return;
    }
    const double* c = piece.terms() + 3 * (k - 1);
    term = {{c[0], c[1]}, c[2]};
}

// The sum of all terms and its derivatives by t, each divided by the factorial of its order: Horner's rule again and
// again, as the sums that it goes through are the coefficients of a quotient by t less this t.
template <class Term, std::size_t Count, class Degree>
std::array<Term, Count> sums_at(const TaylorPiece& piece, Degree p, double t, std::size_t count) {
    std::array<Term, Count> sums{};
    for (std::size_t k = p + 1; k-- > 0;) {
        for (std::size_t i = count - 1; i > 0; --i) sums[i] = t * sums[i] + sums[i - 1];
        Term term;
        read_term(piece, k, term);
        sums[0] = t * sums[0] + term;
    }
    return sums;
}

template <std::size_t Count, class Degree>
Jet polynomial_jet(const TaylorPiece& piece, Degree p, double t, std::size_t order) {
    const std::size_t last = std::min<std::size_t>(order, p);
    const auto sums = sums_at<Vector, Count>(piece, p, t, std::min(Count, std::max<std::size_t>(last + 1, 3)));
    Jet jet{.point = Point(piece.point()[0], piece.point()[1]) + sums[0]};
    double factor = 1.0;
    for (std::size_t k = 1; k <= last; ++k) {
        factor *= static_cast<double>(k) * piece.scale();
        jet.derivatives.push_back(factor * sums[k]);
    }
    while (jet.derivatives.size() < order) jet.derivatives.push_back(Vector(0.0, 0.0));
    return jet;
}

template <std::size_t Count, class Degree>
Jet rational_jet_of_piece(const TaylorPiece& piece, Degree p, double t, std::size_t order) {
    const std::size_t last = std::min<std::size_t>(order, p);
    const auto sums = sums_at<WeightedVector, Count>(piece, p, t, std::min(Count, std::max<std::size_t>(last + 1, 3)));
    HomogeneousJet seen{.point = sums[0].vector, .weight = sums[0].weight};
    double factor = 1.0;
    for (std::size_t k = 1; k <= last; ++k) {
        factor *= static_cast<double>(k) * piece.scale();
        seen.derivatives.push_back(factor * sums[k].vector);
        seen.weights.push_back(factor * sums[k].weight);
    }
    return {Point(piece.point()[0], piece.point()[1]) + seen.point / seen.weight, shadow_derivatives(seen, order)};
}

template <std::size_t Count>
Jet jet_on_piece(const TaylorPiece& piece, double u, std::size_t order) {
    const double t = piece.at(u);
    return with_known_degree(piece.p, [&](auto p) {
        return piece.is_rational ? rational_jet_of_piece<Count>(piece, p, t, order)
                                 : polynomial_jet<Count>(piece, p, t, order);
    });
}

Jet jet_on_piece(const TaylorPiece& piece, double u, std::size_t order) {
    return order <= 2 ? jet_on_piece<3>(piece, u, order) : jet_on_piece<max_degree + 1>(piece, u, order);
}

}  // namespace

Evaluator::Evaluator(Curve curve)
    : curve_(std::move(curve)), pieces_(TaylorExpander(curve_).all_pieces()), finder_(std::move(pieces_.joints)) {
    const Interval domain = curve_.domain();
    start_ = core::point_at(curve_, domain.lower, Side::right);
    end_ = core::point_at(curve_, domain.upper, Side::left);
}

Point Evaluator::point_at(double u, Side side) const {
    if (!finder_.has_inside(u)) {
        const double inside = curve_.knots().into_domain(u, side);
        if (!finder_.has_inside(inside)) return inside == curve_.domain().lower ? start_ : end_;
        u = inside;
    }
    const TaylorPiece piece = pieces_[finder_.interval_at(u, side)];
    return piece.is_sharp() ? point_on_piece(piece, u) : core::point_at(curve_, u, side);
}

Jet Evaluator::derivatives_at(double u, int order, Side side) const {
    assert(order >= 0);
    const double inside = finder_.has_inside(u) ? u : curve_.knots().into_domain(u, side);
    if (!finder_.has_inside(inside)) return core::derivatives_at(curve_, u, order, side);
    const TaylorPiece piece = pieces_[finder_.interval_at(inside, side)];
    return piece.is_sharp() ? jet_on_piece(piece, inside, static_cast<std::size_t>(order))
                            : core::derivatives_at(curve_, inside, order, side);
}

}  // namespace batten::core
