#include "core/shape/detail/offset_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/evaluate/evaluator.h"
#include "core/make/interpolate.h"

namespace batten::core {

namespace {

constexpr std::size_t most_samples_of_span = 2048;
constexpr std::size_t first_samples_of_span = 24;
constexpr std::size_t least_samples = 16;
constexpr double most_turn_of_span = 2.0;  // of all samples of a span that turns evenly
constexpr int most_sample_halvings = 40;
constexpr std::size_t most_samples = 400'000;
constexpr std::size_t least_samples_between = 6;
constexpr int most_raw_halvings = 24;
constexpr int most_fit_rounds = 48;
constexpr double fit_noise_in_ulps = 64.0;  // as offset() allows for

// A place of the offset at a parameter.
struct OffsetBreak {
    double u = 0.0;
    OffsetPlace place{};
};

// A place of the offset and how far along it lies.
struct OffsetSample {
    Point point{};
    Vector derivative{};
    double along = 0.0;
};

Side side_inside(const Interval& part, double u) {
    return u >= part.upper ? Side::left : Side::right;
}

// How far rounding may have moved a place of the offset.
double noise_of(Point point) {
    return fit_noise_in_ulps * std::numeric_limits<double>::epsilon() * std::max(std::abs(point.x), std::abs(point.y));
}

class OffsetFit {
  public:
    OffsetFit(const OffsetSource& source, Interval part, double tolerance)
        : source_(source),
          part_(part),
          tolerance_(tolerance),
          is_closed_(source.is_smoothly_closed() && part == source.curve().domain()) {}

    Result<Approximation> fit() {
        const std::size_t spans = source_.breaks_within(part_).size() - 1;
        for (std::size_t count = first_samples_of_span;; count *= 4) {
            if (auto check = take_samples(count); !check) return refuse(check.error());
            if (const double noise = noise_of_samples(); tolerance_ < noise)
                return refuse_computed(
                    {.code = CurveErrorCode::tolerance_not_reached, .value = tolerance_, .lower = noise});
            auto found = fitted();
            const bool is_last = count >= most_samples_of_span || count * spans * 4 > most_samples;
            if (found || is_last) return found;
        }
    }

  private:
    // What their rounding leaves unknown of the offset.
    double noise_of_samples() const {
        double largest = 0.0;
        for (const OffsetSample& sample : samples_) largest = std::max(largest, noise_of(sample.point));
        return largest;
    }

    Result<void> take_samples(std::size_t count) {
        samples_.clear();
        const std::vector<double> breaks = source_.breaks_within(part_);
        for (std::size_t b = 0; b + 1 < breaks.size(); ++b) {
            const double step = (breaks[b + 1] - breaks[b]) / static_cast<double>(count);
            double from = breaks[b];
            for (std::size_t k = 1; k <= count && samples_.size() < most_samples; ++k) {
                const double to = k == count ? breaks[b + 1] : breaks[b] + static_cast<double>(k) * step;
                const auto start = source_.at(from, Side::right);
                const auto end = source_.at(to, side_inside(part_, to));
                if (!start || !end) return refuse(start ? end.error() : start.error());
                if (samples_.empty()) append(*start);
                if (auto check =
                        add_between({from, *start}, {to, *end}, most_turn_of_span / static_cast<double>(count), 0);
                    !check)
                    return check;
                from = to;
            }
        }
        if (samples_.size() < least_samples) return refuse({.code = CurveErrorCode::not_computable});
        return {};
    }

    // Samples behind the first place up to the second, closer where the curve turns.
    Result<void> add_between(const OffsetBreak& from, const OffsetBreak& to, double turn, int depth) {
        const double middle = from.u + 0.5 * (to.u - from.u);
        const bool is_divisible = depth < most_sample_halvings && from.u < middle && middle < to.u;
        if (is_divisible && std::abs(angle_between(from.place.tangent, to.place.tangent)) > turn) {
            const auto place = source_.at(middle, Side::right);
            if (!place) return refuse(place.error());
            const OffsetBreak between{middle, *place};
            return add_between(from, between, turn, depth + 1).and_then([&] {
                return add_between(between, to, turn, depth + 1);
            });
        }
        append(to.place);
        return {};
    }

    // What stands still for a step is one place.
    void append(const OffsetPlace& place) {
        double along = 0.0;
        if (!samples_.empty()) along = samples_.back().along + arc_between(samples_.back(), place);
        if (samples_.empty() || along > samples_.back().along)
            samples_.push_back({place.point, place.derivative, along});
    }

    // The length of a short arc by its chord and the turn between its ends.
    static double arc_between(const OffsetSample& from, const OffsetPlace& to) {
        const double chord = distance(from.point, to.point);
        const double turn = angle_between(from.derivative, to.derivative);
        return std::abs(turn) < 1.0 ? chord * (1.0 + turn * turn / 24.0) : chord;
    }

    Result<Approximation> fitted() {
        const std::size_t last = samples_.size() - 1;
        std::vector<std::size_t> chosen{0, last};
        if (is_closed_) chosen = {0, last / 4, last / 2, 3 * last / 4, last};
        double reached = 0.0;
        for (int round = 0; round < most_fit_rounds; ++round) {
            const auto curve = through(chosen);
            if (!curve) return refuse({.code = CurveErrorCode::not_computable});
            std::vector<std::size_t> finer = chosen;
            reached = 0.0;
            const Evaluator prepared(*curve);
            for (std::size_t k = 0; k + 1 < chosen.size(); ++k) {
                const double error = error_between(prepared, chosen[k], chosen[k + 1]);
                reached = std::max(reached, error);
                if (error > allowed() && std::isfinite(error)) finer.push_back(middle_of(chosen[k], chosen[k + 1]));
            }
            if (reached <= allowed()) return Approximation{*curve, reached};
            // Denser samples are needed.
            if (!std::isfinite(reached)) break;
            std::sort(finer.begin(), finer.end());
            chosen = std::move(finer);
        }
        return refuse_computed({.code = CurveErrorCode::tolerance_not_reached, .value = tolerance_, .lower = reached});
    }

    // The rest is for what lies between samples.
    double allowed() const { return 0.8 * tolerance_; }

    // Not known where there are too few samples.
    double error_between(const Evaluator& curve, std::size_t first, std::size_t last) const {
        if (last - first < least_samples_between) return Box::infinity;
        double largest = 0.0;
        for (std::size_t k = first + 1; k < last; ++k)
            largest = std::max(largest, distance(curve.point_at(samples_[k].along), samples_[k].point));
        return largest;
    }

    std::size_t middle_of(std::size_t first, std::size_t last) const {
        const double middle = 0.5 * (samples_[first].along + samples_[last].along);
        const auto found = std::partition_point(samples_.begin() + static_cast<std::ptrdiff_t>(first) + 1,
                                                samples_.begin() + static_cast<std::ptrdiff_t>(last) - 1,
                                                [&](const OffsetSample& sample) { return sample.along < middle; });
        return static_cast<std::size_t>(found - samples_.begin());
    }

    static std::optional<Vector> direction(Vector derivative) {
        const double speed = robust_length(derivative);
        return speed > 0.0 ? std::optional(derivative / speed) : std::nullopt;
    }

    Result<Curve> through(const std::vector<std::size_t>& chosen) const {
        std::vector<Point> points;
        InterpolationRequest request{.degree = 3, .ends = ClosedEnds{}};
        for (const std::size_t k : chosen) {
            points.push_back(samples_[k].point);
            request.parameters.push_back(samples_[k].along);
        }
        if (is_closed_)
            points.pop_back();
        else
            request.ends = EndTangents{direction(samples_.front().derivative), direction(samples_.back().derivative)};
        return interpolate(points, request).map([](const Interpolation& found) { return found.curve; });
    }

    const OffsetSource& source_;
    Interval part_;
    double tolerance_;
    bool is_closed_;
    std::vector<OffsetSample> samples_{};
};

class RawOffset {
  public:
    RawOffset(const OffsetSource& source, Interval part, double tolerance)
        : source_(source), part_(part), tolerance_(tolerance) {}

    Result<Curve> curve() {
        const std::vector<double> breaks = source_.breaks_within(part_);
        const auto first = source_.at(part_.lower, Side::right);
        if (!first) return refuse(first.error());
        definition_ = {.degree = 3, .knots = std::vector(4, part_.lower), .points = {first->point}};
        for (std::size_t b = 0; b + 1 < breaks.size(); ++b) {
            const auto start = source_.at(breaks[b], Side::right);
            const auto end = source_.at(breaks[b + 1], Side::left);
            if (!start || !end) return refuse(start ? end.error() : start.error());
            if (auto check = add({breaks[b], *start}, {breaks[b + 1], *end}, 0); !check) return refuse(check.error());
        }
        definition_.knots.push_back(part_.upper);
        return Curve::make(std::move(definition_));
    }

  private:
    static Point hermite(const OffsetBreak& a, const OffsetBreak& b, double t) {
        const double third = (b.u - a.u) / 3.0;
        const Point after = a.place.point + third * a.place.derivative;
        const Point before = b.place.point - third * b.place.derivative;
        const double s = 1.0 - t;
        return a.place.point + 3.0 * s * s * t * (after - a.place.point) + 3.0 * s * t * t * (before - a.place.point) +
               t * t * t * (b.place.point - a.place.point);
    }

    Result<void> add(const OffsetBreak& a, const OffsetBreak& b, int depth) {
        double error = 0.0;
        OffsetBreak middle{a.u + 0.5 * (b.u - a.u), {}};
        for (const double t : {0.25, 0.5, 0.75}) {
            const auto place = source_.at(a.u + t * (b.u - a.u), Side::right);
            if (!place) return refuse(place.error());
            if (t == 0.5) middle.place = *place;
            error = std::max(error, distance(hermite(a, b, t), place->point));
        }
        const bool is_divisible = depth < most_raw_halvings && a.u < middle.u && middle.u < b.u;
        if (error > std::max(tolerance_, noise_of(middle.place.point)) && is_divisible)
            return add(a, middle, depth + 1).and_then([&] { return add(middle, b, depth + 1); });
        const double third = (b.u - a.u) / 3.0;
        definition_.points.push_back(a.place.point + third * a.place.derivative);
        definition_.points.push_back(b.place.point - third * b.place.derivative);
        definition_.points.push_back(b.place.point);
        definition_.knots.insert(definition_.knots.end(), 3, b.u);
        return {};
    }

    const OffsetSource& source_;
    Interval part_;
    double tolerance_;
    CurveDefinition definition_{};
};

}  // namespace

Result<Approximation> fit_offset(const OffsetSource& source, Interval part, double tolerance) {
    return OffsetFit(source, part, tolerance).fit();
}

Result<Curve> raw_offset(const OffsetSource& source, Interval part, double tolerance) {
    return RawOffset(source, part, tolerance).curve();
}

}  // namespace batten::core
