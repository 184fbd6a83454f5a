#include "core/make/detail/stroke_samples.h"

#include <algorithm>
#include <cmath>

namespace batten::core {

namespace {

// Samples so near to one another are one place of the way.
constexpr double reach_of_place = 3.0;

// A sample may leave a place for so short and come back.
constexpr std::size_t samples_of_jitter = 3;

// A place counts as so many samples at most, however long the pen rested there.
constexpr double most_weight = 6.0;

// Ends so near to one another are meant to meet, in a stroke that is long beside that.
constexpr double reach_of_closing = 12.0;
constexpr double share_of_closing = 0.15;
constexpr double least_closed_length = 60.0;

// The samples first..end-1, which are one place of the way.
struct PenPlace {
    std::size_t first = 0;
    std::size_t end = 0;
    Vector mean{};
    double station = 0.0;

    double count() const { return static_cast<double>(end - first); }
};

std::vector<Vector> in_pixels(std::span<const Point> points, double pixel) {
    std::vector<Vector> places;
    for (const Point& point : points) {
        const Vector place = (point - points.front()) / pixel;
        if (places.empty() || !(place == places.back())) places.push_back(place);
    }
    return places;
}

// Whether sample `i` is apart from the place only by jitter.
bool returns(std::span<const Vector> samples, std::size_t i, Vector mean) {
    if (length(samples[i] - mean) > 2.0 * reach_of_place) return false;
    const std::size_t end = std::min(samples.size(), i + 1 + samples_of_jitter);
    for (std::size_t k = i + 1; k < end; ++k)
        if (length(samples[k] - mean) <= reach_of_place) return true;
    return false;
}

std::vector<PenPlace> runs_of_places(std::span<const Vector> samples) {
    std::vector<PenPlace> found;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (found.empty() ||
            (length(samples[i] - found.back().mean) > reach_of_place && !returns(samples, i, found.back().mean)))
            found.push_back({.first = i, .end = i, .mean = samples[i]});
        PenPlace& place = found.back();
        ++place.end;
        place.mean += (samples[i] - place.mean) / place.count();
    }
    return found;
}

void add_part(std::vector<PenPlace>& places, std::span<const Vector> samples, std::size_t first, std::size_t end) {
    if (first == end) return;
    PenPlace place{.first = first, .end = end};
    for (std::size_t i = first; i < end; ++i) place.mean += samples[i] / place.count();
    places.push_back(place);
}

// Whether the way nearly turns back at place k, by more than 127 degrees, so that its mean lies beside the tip.
bool turns_sharply(const std::vector<PenPlace>& places, std::size_t k) {
    if (k == 0 || k + 1 == places.size() || places[k].end - places[k].first == 1) return false;
    constexpr double least_cosine = 0.6;
    const Vector ahead = places[k + 1].mean - places[k].mean;
    const Vector back = places[k - 1].mean - places[k].mean;
    return dot(ahead, back) >= least_cosine * length(ahead) * length(back);
}

// The tip of a sharp turn is a place of its own: the sample that is farthest out.
std::vector<PenPlace> with_tips(std::span<const Vector> samples, const std::vector<PenPlace>& places) {
    std::vector<PenPlace> found;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const PenPlace& place = places[k];
        if (!turns_sharply(places, k)) {
            found.push_back(place);
            continue;
        }
        const Vector out = 2.0 * place.mean - places[k - 1].mean - places[k + 1].mean;
        std::size_t tip = place.first;
        for (std::size_t i = place.first; i < place.end; ++i)
            if (dot(samples[i], out) > dot(samples[tip], out)) tip = i;
        add_part(found, samples, place.first, tip);
        add_part(found, samples, tip, tip + 1);
        add_part(found, samples, tip + 1, place.end);
    }
    return found;
}

std::vector<PenPlace> places_of_way(std::span<const Vector> samples) {
    std::vector<PenPlace> places = with_tips(samples, runs_of_places(samples));
    for (std::size_t k = 1; k < places.size(); ++k)
        places[k].station = places[k - 1].station + length(places[k].mean - places[k - 1].mean);
    return places;
}

// How many samples lead once around: up to the one that is nearest to the first; none where the stroke is open.
std::size_t samples_around(std::span<const Vector> samples) {
    double way = 0.0;
    for (std::size_t i = 1; i < samples.size(); ++i) way += length(samples[i] - samples[i - 1]);
    const double reach = std::min(reach_of_closing, share_of_closing * way);
    if (way < least_closed_length || length(samples.back()) > reach) return 0;
    std::size_t nearest = samples.size() - 1;
    double back = 0.0;
    for (std::size_t i = samples.size() - 1; i > 0 && back <= 2.0 * reach; --i) {
        if (length(samples[i]) < length(samples[nearest])) nearest = i;
        back += length(samples[i] - samples[i - 1]);
    }
    return nearest + 1;
}

// How far behind place k, of which it is one, a sample stands along the way.
double offset_along(Vector sample, const std::vector<PenPlace>& places, std::size_t k) {
    const PenPlace& before = places[k == 0 ? k : k - 1];
    const PenPlace& after = places[std::min(k + 1, places.size() - 1)];
    const Vector way = after.mean - before.mean;
    const double size = length(way);
    if (!(size > 0.0)) return 0.0;
    constexpr double room = 0.5 * reach_of_place;
    const double below = k == 0 ? reach_of_place : std::min(room, 0.5 * (places[k].station - before.station));
    const double above =
        k + 1 == places.size() ? reach_of_place : std::min(room, 0.5 * (after.station - places[k].station));
    return std::clamp(dot(sample - places[k].mean, way) / size, -below, above);
}

}  // namespace

Stroke stroke_through(std::span<const Point> points, double pixel, bool may_close) {
    std::vector<Vector> samples = in_pixels(points, pixel);
    const std::size_t around = may_close ? samples_around(samples) : 0;
    if (around > 0) samples.resize(around);
    const std::vector<PenPlace> places = places_of_way(samples);
    Stroke stroke{.is_closed = around > 0};
    for (std::size_t k = 0; k < places.size(); ++k)
        for (std::size_t i = places[k].first; i < places[k].end; ++i)
            stroke.samples.push_back({.station = places[k].station + offset_along(samples[i], places, k),
                                      .place = samples[i],
                                      .weight = std::min(1.0, most_weight / places[k].count())});
    std::ranges::stable_sort(stroke.samples, {}, &StrokeSample::station);
    const double start = stroke.samples.front().station;
    for (StrokeSample& sample : stroke.samples) sample.station -= start;
    stroke.length = stroke.samples.back().station;
    if (stroke.is_closed)
        stroke.length += std::max(1.0, length(stroke.samples.back().place - stroke.samples.front().place));
    return stroke;
}

}  // namespace batten::core
