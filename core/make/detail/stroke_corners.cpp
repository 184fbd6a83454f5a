#include "core/make/detail/stroke_corners.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>

#include "core/make/detail/corner_look.h"

namespace batten::core {

namespace {

constexpr double degree_angle = std::numbers::pi / 180.0;

// What turns by less within so much to both sides is not suspected of a corner.
constexpr double suspected_turn = 35.0 * degree_angle;
constexpr double suspected_arm = 10.0;

// A corner turns by so much at least, and is so far from others.
constexpr double least_corner_turn = 45.0 * degree_angle;
constexpr double apart = 10.0;

// How far is looked to both sides: as far as a corner or an arc explains what is there.
constexpr std::array arms{60.0, 44.0, 32.0, 23.0, 16.0, 11.0};
constexpr double most_unexplained = 1.5;
constexpr double least_share_of_arm = 0.3;

// How far from where it is suspected a corner may be.
constexpr double search_reach = 5.0;

// So much of the way the samples may leave out on both sides of a corner, by passing its tip.
constexpr std::array losses{0.0, 0.7, 1.4, 2.4};

// Where the stroke turns back by more, its tip is among the samples.
constexpr double turn_with_tip = 150.0 * degree_angle;

// Arcs of these radii are no corners.
constexpr std::array radii{8.0, 11.0, 15.0, 21.0, 30.0};
// Parabolas take a part of what an arc turns.
constexpr double turn_of_arc = 1.2;

// By so many variances a corner must be better than a smooth curve.
constexpr double least_gain = 14.0;

constexpr double least_noise = 0.3;

// One sample for each pixel of the way at most: the mean.
std::vector<StrokeSample> thinned(std::span<const StrokeSample> samples) {
    std::vector<StrokeSample> found;
    double count = 0.0;
    double end = -1.0;
    for (const StrokeSample& sample : samples) {
        if (found.empty() || sample.station >= end) {
            found.push_back({.station = sample.station, .place = sample.place});
            end = sample.station + 1.0;
            count = 1.0;
            continue;
        }
        count += 1.0;
        found.back().station += (sample.station - found.back().station) / count;
        found.back().place += (sample.place - found.back().place) / count;
    }
    return found;
}

// The samples, and of a closed stroke those around the seam on both sides of it.
std::vector<StrokeSample> unrolled(std::span<const StrokeSample> samples, const Stroke& stroke) {
    std::vector<StrokeSample> found(samples.begin(), samples.end());
    if (!stroke.is_closed) return found;
    const double margin = std::min(2.0 * arms.front(), stroke.length);
    const auto add = [&](double from, double to, double shift) {
        for (StrokeSample sample : samples)
            if (from <= sample.station && sample.station <= to) {
                sample.station += shift;
                found.push_back(sample);
            }
    };
    add(stroke.length - margin, stroke.length, -stroke.length);
    add(0.0, margin, stroke.length);
    std::ranges::stable_sort(found, {}, &StrokeSample::station);
    return found;
}

struct StrokeCorner {
    double station = 0.0;
    double lost = 0.0;  // of the way on both sides
};

class CornerSearch {
  public:
    explicit CornerSearch(const Stroke& stroke)
        : stroke_(stroke), own_(thinned(stroke.samples)), samples_(unrolled(own_, stroke)), noise_(noise()) {}

    std::vector<StrokeCorner> corners() const {
        std::vector<StrokeCorner> found;
        for (const double suspect : suspects())
            if (const auto corner = corner_near(suspect); corner && is_apart(found, corner->station))
                found.push_back(*corner);
        std::ranges::sort(found, {}, &StrokeCorner::station);
        return found;
    }

  private:
    // The noise of a coordinate, by what smooth curves leave of most of the stroke.
    double noise() const {
        constexpr double arm = 16.0;
        constexpr double least_count = 7.0;
        constexpr double usual = 0.5;
        const CornerLooks looks(own_, arm);
        std::vector<double> variances;
        double next = arm;
        for (const StrokeSample& sample : own_) {
            if (sample.station < next || sample.station > stroke_.length - arm) continue;
            next = sample.station + arm;
            const auto look = looks.smooth(sample.station);
            if (look && look->count >= least_count) variances.push_back(look->variance());
        }
        if (variances.empty()) return usual;
        const auto middle = variances.begin() + static_cast<std::ptrdiff_t>(variances.size() / 2);
        std::nth_element(variances.begin(), middle, variances.end());
        return std::max(least_noise, std::sqrt(*middle));
    }

    // The mean of what is near, or the way between two samples.
    Vector place_at(double station) const {
        constexpr double reach = 2.0;
        const auto first = std::ranges::lower_bound(samples_, station - reach, {}, &StrokeSample::station);
        Vector sum{};
        double count = 0.0;
        for (auto sample = first; sample != samples_.end() && sample->station <= station + reach; ++sample) {
            sum += sample->place;
            count += 1.0;
        }
        if (count > 1.0) return sum / count;
        const auto above = std::ranges::lower_bound(samples_, station, {}, &StrokeSample::station);
        if (above == samples_.begin()) return above->place;
        if (above == samples_.end()) return samples_.back().place;
        const auto below = above - 1;
        const double way = above->station - below->station;
        const double share = way > 0.0 ? (station - below->station) / way : 0.0;
        return below->place + share * (above->place - below->place);
    }

    // Where the stroke turns a lot, the sharpest turn of its surroundings first.
    std::vector<double> suspects() const {
        struct Turn {
            double station;
            double angle;
        };
        std::vector<Turn> turns;
        const double margin = stroke_.is_closed ? -1.0 : 3.0;
        for (const StrokeSample& sample : own_) {
            const double s = sample.station;
            if (s <= margin || s >= stroke_.length - margin) continue;
            const Vector here = place_at(s);
            const double angle =
                std::abs(angle_between(here - place_at(s - suspected_arm), place_at(s + suspected_arm) - here));
            if (angle > suspected_turn) turns.push_back({s, angle});
        }
        std::vector<double> found;
        const auto is_sharpest = [&](std::size_t k) {
            for (std::size_t i = k; i-- > 0 && turns[k].station - turns[i].station < apart;)
                if (turns[i].angle >= turns[k].angle) return false;
            for (std::size_t i = k + 1; i < turns.size() && turns[i].station - turns[k].station < apart; ++i)
                if (turns[i].angle > turns[k].angle) return false;
            return true;
        };
        for (std::size_t k = 0; k < turns.size(); ++k)
            if (is_sharpest(k)) found.push_back(turns[k].station);
        return found;
    }

    bool is_apart(const std::vector<StrokeCorner>& others, double station) const {
        return std::ranges::none_of(others, [&](const StrokeCorner& other) {
            const double way = std::abs(station - other.station);
            return std::min(way, stroke_.is_closed ? stroke_.length - way : way) < apart;
        });
    }

    struct Sharpest {
        StrokeCorner corner{};
        CornerLook look{};
    };

    static std::optional<Sharpest> sharpest(const CornerLooks& looks, double suspect) {
        std::optional<Sharpest> best;
        const auto consider = [&](double station, double lost) {
            const auto look = looks.sharp(station, lost);
            if (look && (!best || look->errors < best->look.errors)) best = Sharpest{{station, lost}, *look};
        };
        for (double way = -search_reach; way <= search_reach; way += 1.0) consider(suspect + way, losses[1]);
        if (!best) return best;
        const double middle = best->corner.station;
        for (const double way : {-0.5, 0.0, 0.5})
            for (const double lost : losses) consider(middle + way, lost);
        return best;
    }

    static double least_errors_rounded(const CornerLooks& looks, const Sharpest& sharp) {
        const double turn = std::clamp(turn_of_arc * sharp.look.turn, 0.5, 2.6);
        double least = std::numeric_limits<double>::infinity();
        for (const double radius : radii)
            for (const double way : {-5.0, -3.0, -1.5, 0.0, 1.5, 3.0, 5.0})
                if (const auto look = looks.rounded(sharp.corner.station + way, turn, radius))
                    least = std::min(least, look->errors);
        return least;
    }

    // The corner near `suspect`, if it is one.
    std::optional<StrokeCorner> corner_near(double suspect) const {
        for (const double arm : arms) {
            const double room = least_share_of_arm * arm;
            if (!stroke_.is_closed && (suspect < room || stroke_.length - suspect < room)) continue;
            const CornerLooks looks(around(suspect, arm), arm);
            const auto smooth = looks.smooth(suspect);
            const auto sharp = sharpest(looks, suspect);
            if (!smooth || !sharp) continue;
            const double rounded = least_errors_rounded(looks, *sharp);
            CornerLook best = sharp->look;
            best.errors = std::min(best.errors, rounded);
            const double unexplained = best.variance() / (noise_ * noise_);
            if (unexplained > most_unexplained * most_unexplained && arm != arms.back()) continue;
            const double variance = std::max(noise_ * noise_, best.variance());
            const bool is_corner = sharp->look.turn >= least_corner_turn && sharp->look.errors <= rounded &&
                                   smooth->errors - sharp->look.errors > least_gain * variance;
            if (!is_corner) return std::nullopt;
            StrokeCorner corner = sharp->corner;
            if (sharp->look.turn > turn_with_tip) corner.lost = 0.0;
            if (stroke_.is_closed) corner.station -= stroke_.length * std::floor(corner.station / stroke_.length);
            return corner;
        }
        return std::nullopt;
    }

    std::vector<StrokeSample> around(double station, double arm) const {
        const double reach = arm + 2.0 * search_reach;
        const auto first = std::ranges::lower_bound(samples_, station - reach, {}, &StrokeSample::station);
        const auto end = std::ranges::upper_bound(samples_, station + reach, {}, &StrokeSample::station);
        return {first, end};
    }

    const Stroke& stroke_;
    std::vector<StrokeSample> own_;
    std::vector<StrokeSample> samples_;
    double noise_;
};

}  // namespace

std::vector<double> find_corners(Stroke& stroke) {
    const std::vector<StrokeCorner> corners = CornerSearch(stroke).corners();
    std::vector<double> stations;
    double added = 0.0;
    auto sample = stroke.samples.begin();
    for (const StrokeCorner& corner : corners) {
        for (; sample != stroke.samples.end() && sample->station < corner.station; ++sample) sample->station += added;
        stations.push_back(corner.station + added + corner.lost);
        added += 2.0 * corner.lost;
    }
    for (; sample != stroke.samples.end(); ++sample) sample->station += added;
    stroke.length += added;
    return stations;
}

}  // namespace batten::core
