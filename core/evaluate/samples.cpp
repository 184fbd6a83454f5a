#include "core/evaluate/samples.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/evaluate/detail/span_block.h"
#include "core/evaluate/detail/taylor_samples.h"
#include "core/evaluate/evaluate.h"

namespace batten::core {

namespace {

// So many points of one span are worth its polynomial.
constexpr std::size_t enough_samples = 4;

// The span of `u`, inside of the domain, found from one that is near.
std::size_t span_from(std::size_t s, const KnotVector& knots, double u) {
    const std::size_t end = knots.size() - static_cast<std::size_t>(knots.degree()) - 1;
    if (u < knots[s]) return knots.span_at(u);
    std::size_t step = 1;
    while (s + step < end && knots[s + step] <= u) {
        s += step;
        step *= 2;
    }
    const std::span<const double> near = knots.values().subspan(s, std::min(step, end - s));
    return s + static_cast<std::size_t>(std::upper_bound(near.begin(), near.end(), u) - near.begin()) - 1;
}

class Sampler {
  public:
    Sampler(const Curve& curve, std::span<const double> parameters, std::span<Point> points)
        : curve_(curve),
          parameters_(parameters),
          points_(points),
          s_(static_cast<std::size_t>(curve.degree())),
          expander_(curve),
          block_(curve) {
        while (curve.knots()[s_] == curve.knots()[s_ + 1]) ++s_;
    }

    void sample_all() {
        for (std::size_t i = 0; i < parameters_.size();) i += sample_from(i);
        flush();
    }

  private:
    std::size_t sample_from(std::size_t i) {
        const double u = parameters_[i];
        const auto [lower, upper] = curve_.domain();
        if (!(lower < u && u < upper)) {
            points_[i] = point_at(curve_, u);
            return 1;
        }
        s_ = span_from(s_, curve_.knots(), u);
        if (i + enough_samples <= parameters_.size()) {
            const double later = parameters_[i + enough_samples - 1];
            if (curve_.knots()[s_] <= later && later < curve_.knots()[s_ + 1]) return sample_piece_from(i);
        }
        add_lone(i);
        return 1;
    }

    // The points from i on of the piece on which the first one lies.
    std::size_t sample_piece_from(std::size_t i) {
        const double u = parameters_[i];
        const TaylorPieces& pieces = expander_.pieces();
        if (pieces.joints.empty() || u < pieces.joints.front() || u >= pieces.joints.back()) {
            expander_.begin_at(s_);
            expander_.add_spans();
            piece_ = 0;
        }
        if (u < pieces.joints[piece_]) piece_ = 0;
        while (u >= pieces.joints[piece_ + 1]) ++piece_;
        if (!pieces[piece_].is_sharp()) {
            add_lone(i);
            return 1;
        }
        return sample_piece(
            pieces[piece_],
            {{pieces.joints[piece_], pieces.joints[piece_ + 1]}, parameters_.subspan(i), points_.subspan(i)});
    }

    // A point that is not worth a polynomial waits for others.
    void add_lone(std::size_t i) {
        block_.read(curve_, s_, lone_count_);
        block_.parameters[lone_count_] = parameters_[i];
        lone_[lone_count_++] = i;
        if (lone_count_ == block_size) flush();
    }

    void flush() {
        if (lone_count_ == 0) return;
        for (std::size_t lane = lone_count_; lane < block_size; ++lane) {
            block_.read(curve_, s_, lane);
            block_.parameters[lane] = parameters_[lone_[lone_count_ - 1]];
        }
        std::array<Point, block_size> found;
        points_of(block_, found);
        for (std::size_t lane = 0; lane < lone_count_; ++lane) {
            const std::size_t i = lone_[lane];
            const bool is_finite = std::isfinite(found[lane].x) && std::isfinite(found[lane].y);
            points_[i] = is_finite ? found[lane] : point_at(curve_, parameters_[i]);
        }
        lone_count_ = 0;
    }

    const Curve& curve_;
    std::span<const double> parameters_;
    std::span<Point> points_;
    std::size_t s_;  // the span of the last point
    TaylorExpander expander_;
    std::size_t piece_ = 0;  // the last one used
    SpanBlock block_;
    std::array<std::size_t, block_size> lone_{};
    std::size_t lone_count_ = 0;
};

}  // namespace

void sample(const Curve& curve, std::span<const double> parameters, std::span<Point> points) {
    assert(parameters.size() == points.size());
    Sampler(curve, parameters, points).sample_all();
}

}  // namespace batten::core
