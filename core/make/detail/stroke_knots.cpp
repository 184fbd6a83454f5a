#include "core/make/detail/stroke_knots.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace batten::core {

namespace {

double samples_between(const Stroke& stroke, double from, double to) {
    const auto first = std::ranges::lower_bound(stroke.samples, from, {}, &StrokeSample::station);
    const auto end = std::ranges::upper_bound(stroke.samples, to, {}, &StrokeSample::station);
    return static_cast<double>(std::max<std::ptrdiff_t>(0, end - first));
}

}  // namespace

StrokeBreaks even_breaks(const Stroke& stroke, std::vector<double> corners, double span) {
    std::vector<double> ends = corners;
    if (!stroke.is_closed || corners.empty()) ends.insert(ends.begin(), 0.0);
    ends.push_back(stroke.is_closed ? ends.front() + stroke.length : stroke.length);
    const double least = stroke.is_closed && ends.size() < 4 ? 3.0 : 1.0;
    StrokeBreaks breaks{.stations = {ends.front()}, .corners = std::move(corners), .is_closed = stroke.is_closed};
    for (std::size_t k = 1; k < ends.size(); ++k) {
        const double length = ends[k] - ends[k - 1];
        const double most = samples_between(stroke, ends[k - 1], ends[k]);
        const double count = std::max(least, std::min(std::round(length / span), most));
        for (double j = 1.0; j < count; j += 1.0) breaks.stations.push_back(ends[k - 1] + length * j / count);
        breaks.stations.push_back(ends[k]);
    }
    return breaks;
}

StrokeBreaks without(const StrokeBreaks& breaks, std::vector<double> gone) {
    std::ranges::sort(gone);
    StrokeBreaks left{.corners = breaks.corners, .is_closed = breaks.is_closed};
    std::ranges::set_difference(breaks.stations, gone, std::back_inserter(left.stations));
    return left;
}

Result<KnotVector> knots_over(const StrokeBreaks& breaks) {
    std::vector<double> knots;
    const std::size_t at_end = breaks.is_closed ? 1 : 4;
    for (const double station : breaks.stations) {
        std::size_t times = std::ranges::binary_search(breaks.corners, station) ? 3 : 1;
        if (station == breaks.stations.back() || (!breaks.is_closed && station == breaks.stations.front()))
            times = at_end;
        knots.insert(knots.end(), times, station);
    }
    return breaks.is_closed ? KnotVector::make_periodic(3, std::move(knots)) : KnotVector::make(3, std::move(knots));
}

}  // namespace batten::core
