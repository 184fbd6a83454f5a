#include "core/make/trace.h"

#include <algorithm>
#include <cmath>

#include "core/make/detail/outline_breaks.h"
#include "core/make/fit.h"

namespace batten::core {

namespace {

constexpr int traced_degree = 3;
constexpr double cut_corner_length = 1.2;  // how far from a corner its rounding is not followed
constexpr std::size_t least_fitted = 5;

/// A curve put together from pieces that begin where the one before ends.
class PieceChain {
  public:
    explicit PieceChain(Point start) : points_{start}, knots_{0.0} {}

    void append_line(Point end) {
        const Point start = points_.back();
        const Vector third = (end - start) / 3.0;
        points_.insert(points_.end(), {start + third, start + 2.0 * third, end});
        end_piece(distance(start, end));
    }

    /// A clamped cubic over [0, 1], which takes `size` of the parameters.
    void append(const Curve& piece, double size) {
        const auto points = piece.control_points();
        points_.insert(points_.end(), points.begin() + 1, points.end());
        const auto knots = piece.knots().stored();
        const double start = knots_.back();
        for (std::size_t i = traced_degree + 1; i + traced_degree + 1 < knots.size(); ++i)
            knots_.push_back(start + size * knots[i]);
        end_piece(start + size - knots_.back());
    }

    /// The whole as a periodic curve; its last point is its first.
    Result<Curve> closed() {
        points_.pop_back();
        return Curve::make({.degree = traced_degree, .knots = knots_, .points = points_, .periodic = true});
    }

  private:
    void end_piece(double size) { knots_.insert(knots_.end(), traced_degree, knots_.back() + size); }

    std::vector<Point> points_;
    std::vector<double> knots_;  // of one period, the seam's multiplicity at its end
};

double length_of(const std::vector<Point>& points) {
    double sum = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) sum += distance(points[i - 1], points[i]);
    return sum;
}

/// The contour from one break to the next, both included.
std::vector<Point> points_between(const Contour& contour, const OutlineBreak& from, const OutlineBreak& to) {
    const std::size_t end = to.index > from.index ? to.index : to.index + contour.size();
    std::vector<Point> points{from.point};
    for (std::size_t i = from.index + 1; i < end; ++i) {
        const Point point = contour[i % contour.size()];
        const bool is_rounded = (from.is_corner && distance(point, from.point) < cut_corner_length) ||
                                (to.is_corner && distance(point, to.point) < cut_corner_length);
        if (!is_rounded && point != points.back()) points.push_back(point);
    }
    if (to.point != points.back()) points.push_back(to.point);
    return points;
}

Result<Approximation> fitted(const std::vector<Point>& points, double tolerance, const OutlineBreak& from,
                             const OutlineBreak& to) {
    const double size = length_of(points);
    EndTangents ends;
    if (from.direction) ends.start = size * *from.direction;
    if (to.direction) ends.end = size * *to.direction;
    auto found = fit_within(points, tolerance,
                            {.degree = traced_degree, .parametrization = Parametrization::chordal, .ends = ends});
    if (found || (!ends.start && !ends.end)) return found;
    return fit_within(points, tolerance, {.degree = traced_degree, .parametrization = Parametrization::chordal});
}

Result<TracedContour> traced_polygon(const std::vector<OutlineBreak>& breaks) {
    CurveDefinition definition{.degree = 1, .knots = {0.0}, .periodic = true};
    for (std::size_t k = 0; k < breaks.size(); ++k) {
        definition.points.push_back(breaks[k].point);
        const double side = distance(breaks[k].point, breaks[(k + 1) % breaks.size()].point);
        definition.knots.push_back(definition.knots.back() + side);
    }
    return Curve::make(std::move(definition)).map([](Curve curve) { return TracedContour{std::move(curve)}; });
}

Result<TracedContour> traced_smooth(const Contour& contour, double tolerance) {
    std::vector<Point> points;
    for (const Point point : contour)
        if (points.empty() || point != points.back()) points.push_back(point);
    if (points.size() > 1 && points.back() == points.front()) points.pop_back();
    return fit_within(points, tolerance, {.degree = traced_degree, .ends = ClosedEnds{}}).map([](Approximation found) {
        return TracedContour{std::move(found.curve), found.error};
    });
}

Result<TracedContour> traced_pieces(const Contour& contour, const std::vector<OutlineBreak>& breaks, double tolerance) {
    PieceChain chain(breaks.front().point);
    double error = 0.0;
    for (std::size_t k = 0; k < breaks.size(); ++k) {
        const OutlineBreak& from = breaks[k];
        const OutlineBreak& to = breaks[(k + 1) % breaks.size()];
        const std::vector<Point> points = points_between(contour, from, to);
        if (from.begins_line || points.size() < least_fitted) {
            if (to.point != from.point) chain.append_line(to.point);
            continue;
        }
        auto piece = fitted(points, tolerance, from, to);
        if (!piece) return tl::unexpected(piece.error());
        chain.append(piece->curve, length_of(points));
        error = std::max(error, piece->error);
    }
    return chain.closed().map([error](Curve curve) { return TracedContour{std::move(curve), error}; });
}

bool is_polygon(const std::vector<OutlineBreak>& breaks) {
    return breaks.size() >= 3 && std::all_of(breaks.begin(), breaks.end(), [](const OutlineBreak& place) {
               return place.is_corner && place.begins_line;
           });
}

GrayImage inverted(GrayImage image) {
    for (std::uint8_t& value : image.values) value = static_cast<std::uint8_t>(255 - value);
    return image;
}

/// Those of enough area, the largest first.
std::vector<Contour> without_speckles(std::vector<Contour> all, double speckle) {
    std::erase_if(all, [&](const Contour& contour) { return std::abs(area_of(contour)) < speckle; });
    std::stable_sort(all.begin(), all.end(),
                     [](const Contour& a, const Contour& b) { return std::abs(area_of(a)) > std::abs(area_of(b)); });
    return all;
}

Result<Trace> traced(const GrayImage& image, const TraceRequest& request, double threshold, const Progress& progress) {
    constexpr double share_of_contours = 0.3;
    std::vector<Contour> outlines =
        without_speckles(contours(image, threshold, part_of(progress, 0.0, share_of_contours)), request.speckle);
    const Progress of_fits = part_of(progress, share_of_contours, 1.0);
    Trace found;
    found.threshold = threshold;
    if (outlines.size() > most_outlines) {
        found.left_out = outlines.size() - most_outlines;
        outlines.resize(most_outlines);
    }
    for (std::size_t k = 0; k < outlines.size(); ++k) {
        auto curve = trace_contour(outlines[k], request.tolerance);
        if (!curve) return tl::unexpected(curve.error());
        found.curves.push_back(std::move(curve->curve));
        found.error = std::max(found.error, curve->error);
        tell(of_fits, k + 1, outlines.size());
    }
    return found;
}

}  // namespace

Result<TracedContour> trace_contour(const Contour& contour, double tolerance) {
    const std::vector<OutlineBreak> breaks = breaks_of(contour);
    if (is_polygon(breaks)) return traced_polygon(breaks);
    if (breaks.size() < 2 && (breaks.empty() || !breaks.front().is_corner)) return traced_smooth(contour, tolerance);
    return traced_pieces(contour, breaks, tolerance);
}

Result<Trace> trace(const GrayImage& image, const TraceRequest& request, const Progress& progress) {
    if (!(request.tolerance > 0.0)) return refuse({.code = CurveErrorCode::tolerance_not_positive});
    const double threshold = request.threshold.value_or(middle_shade(image));
    if (!request.is_inverted) return traced(image, request, threshold, progress);
    auto found = traced(inverted(image), request, 255.0 - threshold, progress);
    if (found) found->threshold = threshold;
    return found;
}

}  // namespace batten::core
