#include "core/edit/detail/offset_error.h"

#include <algorithm>
#include <cmath>

#include "core/base/detail/unit_interval.h"
#include "core/curve/control_box.h"
#include "core/measure/detail/piece_forms.h"

namespace batten::core {

namespace {

constexpr double offset_bound_looseness = 0.01;
constexpr std::size_t least_offset_halvings = 1000;
constexpr std::size_t offset_halvings_of_span = 8;
constexpr double roundoff_of_candidate = 8.0 * std::numeric_limits<double>::epsilon();

// With T the direction of the curve, N its normal and q from the curve to the candidate: (q T)^2 and (q N)^2 - d^2, as
// quotients by what is positive.
struct OffsetErrorPiece {
    Bernstein along;
    Bernstein across;
    Bernstein divisor;
};

// The largest quotient of the coefficients, which bounds that of the polynomials where the divisor's are positive.
double largest_quotient(const Bernstein& dividend, const Bernstein& divisor) {
    double largest = 0.0;
    for (std::size_t k = 0; k < dividend.values.size(); ++k) {
        const double below = divisor.values[k] - divisor.errors[k];
        if (!(below > 0.0)) return std::numeric_limits<double>::infinity();
        largest = std::max(largest, (std::abs(dividend.values[k]) + dividend.errors[k]) / below);
    }
    return largest;
}

// |q N - d| where |(q N)^2 - d^2| <= `across` and q N has the sign of d.
double across_error(double across, double distance) {
    const double square = distance * distance;
    if (across >= square) return std::abs(distance) + std::sqrt(square + across);
    return across / (std::abs(distance) + std::sqrt(square - across));
}

double offset_bound_of(const OffsetErrorPiece& piece, double distance) {
    return std::hypot(std::sqrt(largest_quotient(piece.along, piece.divisor)),
                      across_error(largest_quotient(piece.across, piece.divisor), distance));
}

// The distance at the beginning, less what rounding may have made of it.
double distance_at_begin(const OffsetErrorPiece& piece, double distance) {
    const auto sound = [&](const Bernstein& form) {
        return std::max(0.0, std::abs(form.values.front()) - form.errors.front()) /
               (piece.divisor.values.front() + piece.divisor.errors.front());
    };
    const double across = sound(piece.across);
    const double found = std::hypot(std::sqrt(sound(piece.along)), across_error(across, distance));
    return std::isfinite(found) && across < distance * distance ? found : 0.0;
}

Bernstein squared(const Bernstein& a) {
    return product(a, a);
}

OffsetErrorPiece error_piece(std::span<const Bernstein> curve, std::span<const Bernstein> candidate, double distance) {
    const Bernstein& w = curve[2];
    const Bernstein& v = candidate[2];
    const Bernstein qx = difference(product(w, candidate[0]), product(v, curve[0]));
    const Bernstein qy = difference(product(w, candidate[1]), product(v, curve[1]));
    const Bernstein hx = hodograph_x(curve);
    const Bernstein hy = hodograph_y(curve);
    OffsetErrorPiece piece;
    piece.along = squared(sum(product(qx, hx), product(qy, hy)));
    const Bernstein across = squared(difference(product(hx, qy), product(hy, qx)));
    const Bernstein divisor = product(squared(product(w, v)), sum(squared(hx), squared(hy)));
    piece.across = difference(across, scaled(divisor, distance * distance));
    piece.along = elevated(piece.along, piece.across.degree());
    piece.divisor = elevated(divisor, piece.across.degree());
    return piece;
}

// Of the candidate, as piece_forms has them of the curve.
std::vector<Bernstein> candidate_forms(const BezierPiece& piece, double scale) {
    double far = 0.0;
    for (const HomogeneousPoint& point : piece.points) far = std::max(far, length(plane_part(point)) / point.z);
    std::vector<Bernstein> forms(3);
    for (const HomogeneousPoint& point : piece.points)
        for (int axis = 0; axis < 3; ++axis) {
            const bool is_weight = axis == 2;
            auto& form = forms[static_cast<std::size_t>(axis)];
            form.values.push_back(is_weight ? point.z : scale * point[axis]);
            form.errors.push_back(roundoff_of_candidate * point.z * (is_weight ? 1.0 : scale * far));
        }
    const auto& weights = forms[2].values;
    if (std::ranges::all_of(weights, [&](double w) { return w == weights.front(); }))
        forms[2] = constant(weights.front());
    return forms;
}

class OffsetErrorSearch {
  public:
    explicit OffsetErrorSearch(double distance) : distance_(distance) {}

    void add(const OffsetErrorPiece& piece) {
        put(pieces_.size(), piece);
        pieces_.push_back(piece);
    }

    double run() {
        const std::size_t most = least_offset_halvings + offset_halvings_of_span * pieces_.size();
        for (std::size_t count = 0; count < most && !bounds_.empty(); ++count) {
            if (bounds_.front().value <= (1.0 + offset_bound_looseness) * found_) break;
            std::pop_heap(bounds_.begin(), bounds_.end());
            const std::size_t place = bounds_.back().place;
            bounds_.pop_back();
            const auto along = halves(pieces_[place].along);
            const auto across = halves(pieces_[place].across);
            const auto divisor = halves(pieces_[place].divisor);
            pieces_[place] = {along.first, across.first, divisor.first};
            put(place, pieces_[place]);
            add({along.second, across.second, divisor.second});
        }
        return bounds_.empty() ? 0.0 : bounds_.front().value;
    }

  private:
    struct Bound {
        double value = 0.0;
        std::size_t place = 0;  ///< of its piece

        bool operator<(const Bound& other) const { return value < other.value; }
    };

    void put(std::size_t place, const OffsetErrorPiece& piece) {
        found_ = std::max(found_, distance_at_begin(piece, distance_));
        bounds_.push_back({offset_bound_of(piece, distance_), place});
        std::push_heap(bounds_.begin(), bounds_.end());
    }

    double distance_;
    double found_ = 0.0;
    std::vector<OffsetErrorPiece> pieces_;
    std::vector<Bound> bounds_;  ///< a heap, the largest in front
};

}  // namespace

double offset_error_bound(const Curve& curve, const Curve& candidate, double distance) {
    const double scale = form_scale(curve);
    OffsetErrorSearch search(scale * distance);
    const std::vector<PieceForms> forms = piece_forms(curve, 0);
    auto of_curve = forms.begin();
    for (const BezierPiece& piece : bezier_pieces(seen_from(candidate, middle_of(curve)))) {
        while (of_curve + 1 != forms.end() && of_curve->interval.upper <= piece.interval.lower) ++of_curve;
        const Interval share{to_unit(of_curve->interval, piece.interval.lower),
                             to_unit(of_curve->interval, piece.interval.upper)};
        std::vector<Bernstein> parts;
        parts.reserve(2 * of_curve->forms.size());
        for (const Bernstein& form : of_curve->forms) parts.push_back(part(form, share));
        for (std::size_t k = 0; k < of_curve->forms.size(); ++k) parts.push_back(derivative(parts[k]));
        search.add(error_piece(parts, candidate_forms(piece, scale), scale * distance));
    }
    return search.run() / scale;
}

}  // namespace batten::core
