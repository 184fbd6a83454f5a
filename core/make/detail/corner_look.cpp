#include "core/make/detail/corner_look.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace batten::core {

namespace {

constexpr std::size_t unknowns = 5;
using Row = std::array<double, unknowns>;

// The coefficients of the functions in a row with the least errors.
class SmallFit {
  public:
    void add(const Row& row, Vector place) {
        for (std::size_t i = 0; i < unknowns; ++i) {
            for (std::size_t j = 0; j <= i; ++j) normal_[i][j] += row[i] * row[j];
            right_[i] += row[i] * place;
        }
        squares_ += dot(place, place);
    }

    struct Solution {
        std::array<Vector, unknowns> coefficients;
        double errors;
    };

    std::optional<Solution> solve() const {
        std::array<Row, unknowns> a = normal_;
        std::array<Vector, unknowns> x = right_;
        for (std::size_t i = 0; i < unknowns; ++i) {
            if (!(a[i][i] > 1e-10 * normal_[i][i])) return std::nullopt;
            for (std::size_t k = i + 1; k < unknowns; ++k) {
                const double share = a[k][i] / a[i][i];
                for (std::size_t j = i + 1; j <= k; ++j) a[k][j] -= share * a[j][i];
                x[k] -= share * x[i];
            }
        }
        for (std::size_t i = unknowns; i-- > 0;) {
            for (std::size_t j = i + 1; j < unknowns; ++j) x[i] -= a[j][i] * x[j];
            x[i] /= a[i][i];
        }
        double errors = squares_;
        for (std::size_t i = 0; i < unknowns; ++i) errors -= dot(x[i], right_[i]);
        return Solution{x, std::max(errors, 0.0)};
    }

  private:
    std::array<Row, unknowns> normal_{};  // its lower triangle
    std::array<Vector, unknowns> right_{};
    double squares_ = 0.0;
};

// Where an arc leads that turns by `turn` within `reach` before and behind: in proportion to the line halfway between
// both legs, and across it.
struct RoundedLegs {
    double turn;
    double reach;

    Row row(double s) const {
        const double half = 0.5 * turn;
        const double size = std::abs(s);
        const double scale = reach / half;
        if (size >= reach) return {1.0, std::copysign(scale * std::tan(half) + size - reach, s), s * s, size, s * size};
        const double angle = s / scale;
        return {1.0, scale * std::sin(angle) / std::cos(half), s * s,
                reach + scale * (std::cos(half) - std::cos(angle)) / std::sin(half), s * size};
    }
};

}  // namespace

double CornerLook::variance() const {
    return errors / (2.0 * std::max(1.0, count - static_cast<double>(unknowns)));
}

template <class RowAt>
std::optional<CornerLook> CornerLooks::look(double station, RowAt row_at) const {
    const auto first = std::ranges::lower_bound(samples_, station - arm_, {}, &StrokeSample::station);
    SmallFit fit;
    CornerLook look;
    for (auto sample = first; sample != samples_.end() && sample->station <= station + arm_; ++sample) {
        fit.add(row_at((sample->station - station) / arm_), sample->place - first->place);
        look.count += 1.0;
    }
    const auto found = fit.solve();
    if (!found) return std::nullopt;
    look.errors = found->errors;
    look.turn = std::abs(angle_between(found->coefficients[1] - found->coefficients[3],
                                       found->coefficients[1] + found->coefficients[3]));
    return look;
}

std::optional<CornerLook> CornerLooks::sharp(double station, double lost) const {
    return look(station, [&](double t) {
        t += std::copysign(lost / arm_, t);
        return Row{1.0, t, t * t, std::abs(t), t * std::abs(t)};
    });
}

std::optional<CornerLook> CornerLooks::rounded(double station, double turn, double radius) const {
    const RoundedLegs legs{turn, 0.5 * turn * radius / arm_};
    return look(station, [&](double t) { return legs.row(t); });
}

std::optional<CornerLook> CornerLooks::smooth(double station) const {
    return look(station, [](double t) { return Row{1.0, t, t * t, t * t * t, t * t * t * t}; });
}

}  // namespace batten::core
