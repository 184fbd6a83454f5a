/// How a stroke looks around a station: as two parabolas that meet in a corner, as such with the corner rounded, or as
/// one smooth curve.
#pragma once

#include <optional>
#include <vector>

#include "core/make/detail/penalized_spline.h"

namespace batten::core {

/// What the best curve of a kind leaves of the samples around a station.
struct CornerLook {
    double errors = 0.0;  ///< the sum of squares
    double count = 0.0;   ///< of samples
    double turn = 0.0;    ///< between both legs, in radians, from 0

    /// The variance of a coordinate.
    double variance() const;
};

/// The looks at the samples within `arm` before and behind a station; none where they determine no curve. Cost linear
/// in these samples.
class CornerLooks {
  public:
    /// The samples stand by their stations.
    CornerLooks(std::vector<StrokeSample> samples, double arm) : samples_(std::move(samples)), arm_(arm) {}

    /// With a corner, of which the samples leave out so much on both sides.
    std::optional<CornerLook> sharp(double station, double lost) const;

    /// With an arc of `radius` that turns by `turn`, above 0 and below pi.
    std::optional<CornerLook> rounded(double station, double turn, double radius) const;

    /// A curve of degree 4.
    std::optional<CornerLook> smooth(double station) const;

    double arm() const { return arm_; }

  private:
    template <class RowAt>
    std::optional<CornerLook> look(double station, RowAt row_at) const;

    std::vector<StrokeSample> samples_;
    double arm_;
};

}  // namespace batten::core
