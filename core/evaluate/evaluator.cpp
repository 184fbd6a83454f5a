#include "core/evaluate/evaluator.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "core/evaluate/detail/taylor_samples.h"

namespace batten::core {

namespace {

// By Horner's rule. A degree known to the compiler unrolls the loop.
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

template <class Degree>
Point point_of_degree(const TaylorPiece& piece, Degree p, double u) {
    const double t = (u - piece.middle()) * piece.scale();
    return piece.is_rational ? rational_point(piece, p, t) : polynomial_point(piece, p, t);
}

template <std::size_t P>
using Known = std::integral_constant<std::size_t, P>;

Point point_on_piece(const TaylorPiece& piece, double u) {
    switch (piece.p) {
        case 1:
            return point_of_degree(piece, Known<1>(), u);
        case 2:
            return point_of_degree(piece, Known<2>(), u);
        case 3:
            return point_of_degree(piece, Known<3>(), u);
        case 4:
            return point_of_degree(piece, Known<4>(), u);
        case 5:
            return point_of_degree(piece, Known<5>(), u);
        default:
            return point_of_degree(piece, piece.p, u);
    }
}

}  // namespace

Evaluator::Evaluator(Curve curve) : curve_(std::move(curve)), pieces_(taylor_pieces(curve_)) {
    const Interval domain = curve_.domain();
    start_ = core::point_at(curve_, domain.lower, Side::right);
    end_ = core::point_at(curve_, domain.upper, Side::left);
    const std::size_t parts = 2 * pieces_.count();
    parts_per_unit_ = std::min(static_cast<double>(parts) / domain.length(), std::numeric_limits<double>::max());
    last_pieces_.resize(part_at(domain.upper) + 2);
    std::size_t piece = 0;
    for (std::size_t part = 0; part < last_pieces_.size(); ++part) {
        while (piece + 1 < pieces_.count() && part_at(pieces_.joints[piece + 1]) < part) ++piece;
        last_pieces_[part] = static_cast<std::uint32_t>(piece);
    }
}

// Rounded as it may be, it never falls where u rises; so what begins in an earlier part begins before u.
std::size_t Evaluator::part_at(double u) const {
    return static_cast<std::size_t>((u - pieces_.joints.front()) * parts_per_unit_);
}

std::size_t Evaluator::piece_at(double u, Side side) const {
    const std::vector<double>& joints = pieces_.joints;
    const std::size_t part = part_at(u);
    std::size_t piece = last_pieces_[part];
    std::size_t end = last_pieces_[part + 1] + 1;
    while (end - piece > 8) {
        const std::size_t middle = piece + (end - piece) / 2;
        (joints[middle] <= u ? piece : end) = middle;
    }
    while (piece + 1 < end && joints[piece + 1] <= u) ++piece;
    return side == Side::left && joints[piece] == u && piece > 0 ? piece - 1 : piece;
}

Point Evaluator::point_at(double u, Side side) const {
    if (!is_inside(u)) {
        const double inside = curve_.knots().into_domain(u, side);
        if (!is_inside(inside)) return inside == pieces_.joints.front() ? start_ : end_;
        u = inside;
    }
    const TaylorPiece piece = pieces_[piece_at(u, side)];
    return piece.is_sharp() ? point_on_piece(piece, u) : core::point_at(curve_, u, side);
}

// How many of the first `parameters` lie on the piece, of which the first is known to.
std::size_t Evaluator::end_of_run(std::span<const double> parameters, std::size_t piece) const {
    const double lower = pieces_.joints[piece];
    const double upper = pieces_.joints[piece + 1];
    std::size_t end = 1;
    while (end < parameters.size() && lower < parameters[end] && parameters[end] < upper) ++end;
    return end;
}

void Evaluator::points_at(std::span<const double> parameters, std::span<Point> points) const {
    assert(parameters.size() == points.size());
    while (!parameters.empty()) {
        const std::size_t piece = is_inside(parameters[0]) ? piece_at(parameters[0], Side::right) : pieces_.count();
        std::size_t end = 1;
        if (piece < pieces_.count() && pieces_[piece].is_sharp()) {
            end = end_of_run(parameters, piece);
            sample_piece(pieces_[piece], parameters.first(end), points.data());
        } else {
            points[0] = point_at(parameters[0]);
        }
        parameters = parameters.subspan(end);
        points = points.subspan(end);
    }
}

}  // namespace batten::core
