#include "core/make/contours.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace batten::core {

namespace {

using Histogram = std::array<std::size_t, 256>;

constexpr double white = 255.0;

Histogram histogram_of(const GrayImage& image) {
    Histogram counts{};
    for (const std::uint8_t value : image.values) ++counts[value];
    return counts;
}

// The last shade of the dark class: both classes together have the least variance. A middle one where several do.
std::size_t last_dark(const Histogram& counts) {
    double all = 0.0;
    double sum = 0.0;
    for (std::size_t k = 0; k < counts.size(); ++k) {
        all += static_cast<double>(counts[k]);
        sum += static_cast<double>(k * counts[k]);
    }
    double dark = 0.0;
    double dark_sum = 0.0;
    double best = -1.0;
    std::size_t first = 0;
    std::size_t last = 0;
    for (std::size_t k = 0; k + 1 < counts.size(); ++k) {
        dark += static_cast<double>(counts[k]);
        dark_sum += static_cast<double>(k * counts[k]);
        if (dark == 0.0 || dark == all) continue;
        const double difference = dark_sum / dark - (sum - dark_sum) / (all - dark);
        const double between = dark * (all - dark) * difference * difference;
        if (between > best) {
            best = between;
            first = k;
        }
        if (between == best) last = k;
    }
    return (first + last) / 2;
}

// The shade that half of the pixels from shade `begin` to before `end` are below.
double median(const Histogram& counts, std::size_t begin, std::size_t end) {
    std::size_t all = 0;
    for (std::size_t k = begin; k < end; ++k) all += counts[k];
    std::size_t below = 0;
    for (std::size_t k = begin; k < end; ++k) {
        below += counts[k];
        if (2 * below >= all) return static_cast<double>(k);
    }
    return static_cast<double>(begin);
}

// The four edges of a cell between the middles of pixels.
enum Side : std::uint8_t { top, right, bottom, left };

/// Follows the outlines through the cells of an image.
class Follower {
  public:
    Follower(const GrayImage& image, double threshold)
        : image_(image),
          // No pixel has this shade, so that each is dark or light.
          threshold_(std::clamp(std::floor(threshold), 0.0, white - 1.0) + 0.5),
          is_followed_(image.values.size(), false) {}

    // Outlines that cross row `j` upward for the first time, with dark pixels to their left.
    void follow_row(int j, std::vector<Contour>& found) {
        const std::uint8_t* row = image_.values.data() + place_of(0, j);
        const auto level = static_cast<std::uint8_t>(threshold_);
        for (int i = 0; i < image_.width; ++i) {
            const bool begins = row[i] <= level && (i + 1 == image_.width || row[i + 1] > level);
            if (begins && !is_followed_[place_of(i, j)]) found.push_back(followed_from(i, j));
        }
    }

  private:
    std::size_t place_of(int i, int j) const {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(image_.width) + static_cast<std::size_t>(i);
    }
    double shade(int i, int j) const {
        const bool is_outside = i < 0 || j < 0 || i >= image_.width || j >= image_.height;
        return is_outside ? white : image_.values[place_of(i, j)];
    }
    bool is_dark(int i, int j) const { return shade(i, j) < threshold_; }

    // Where the shade between two pixels is the threshold.
    Point crossing(int i, int j, int next_i, int next_j) const {
        const double from = shade(i, j);
        const double share = (threshold_ - from) / (shade(next_i, next_j) - from);
        return {i + 0.5 + share * (next_i - i), image_.height - (j + 0.5 + share * (next_j - j))};
    }
    Point crossing(int i, int j, Side side) const {
        switch (side) {
            case top:
                return crossing(i, j, i + 1, j);
            case right:
                return crossing(i + 1, j, i + 1, j + 1);
            case bottom:
                return crossing(i, j + 1, i + 1, j + 1);
            case left:
                break;
        }
        return crossing(i, j, i, j + 1);
    }

    // By which side the outline leaves the cell whose upper left pixel is (i, j).
    Side way_out(int i, int j, Side entered) const {
        const std::array dark{is_dark(i, j), is_dark(i + 1, j), is_dark(i + 1, j + 1), is_dark(i, j + 1)};
        const bool is_saddle = dark[0] == dark[2] && dark[1] == dark[3] && dark[0] != dark[1];
        if (is_saddle) {
            const double mean = 0.25 * (shade(i, j) + shade(i + 1, j) + shade(i + 1, j + 1) + shade(i, j + 1));
            // Whether the outlines cut off the upper right and lower left pixel.
            const bool cuts_rising = (mean < threshold_) == dark[0];
            constexpr std::array rising{right, top, left, bottom};
            constexpr std::array falling{left, bottom, right, top};
            return cuts_rising ? rising[entered] : falling[entered];
        }
        for (const Side side : {top, right, bottom, left})
            if (side != entered && dark[side] != dark[(side + 1U) % dark.size()]) return side;
        return entered;
    }

    Contour followed_from(int start_i, int start_j) {
        Contour contour;
        int i = start_i;
        int j = start_j - 1;  // the cell above the row
        Side entered = bottom;
        do {
            contour.push_back(crossing(i, j, entered));
            // An upward crossing with dark pixels to the left.
            if (entered == bottom) is_followed_[place_of(i, j + 1)] = true;
            const Side out = way_out(i, j, entered);
            if (out == top) --j;
            if (out == right) ++i;
            if (out == bottom) ++j;
            if (out == left) --i;
            entered = static_cast<Side>((out + 2) % 4);
        } while (i != start_i || j != start_j - 1 || entered != bottom);
        return contour;
    }

    const GrayImage& image_;
    double threshold_;
    std::vector<bool> is_followed_;
};

}  // namespace

double middle_shade(const GrayImage& image) {
    const Histogram counts = histogram_of(image);
    if (std::count_if(counts.begin(), counts.end(), [](std::size_t count) { return count > 0; }) < 2)
        return 0.5 * white;
    const std::size_t dark = last_dark(counts) + 1;
    return 0.5 * (median(counts, 0, dark) + median(counts, dark, counts.size()));
}

std::vector<Contour> contours(const GrayImage& image, double threshold, const Progress& progress) {
    std::vector<Contour> found;
    Follower follower(image, threshold);
    for (int j = 0; j < image.height; ++j) {
        follower.follow_row(j, found);
        constexpr int rows_between = 64;
        if (j % rows_between == 0) tell(progress, static_cast<std::size_t>(j), static_cast<std::size_t>(image.height));
    }
    return found;
}

double area_of(const Contour& contour) {
    double twice = 0.0;
    for (std::size_t k = 0; k < contour.size(); ++k) {
        const Vector a = contour[k] - contour.front();
        twice += cross(a, contour[(k + 1) % contour.size()] - contour.front());
    }
    return 0.5 * twice;
}

}  // namespace batten::core
