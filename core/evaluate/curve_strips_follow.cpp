#include <algorithm>
#include <span>
#include <utility>

#include "core/evaluate/curve_strips.h"

namespace batten::core {

namespace {

// Adds the spans first..last as far as there are any in the domain.
void add_spans(std::vector<std::size_t>& spans, std::size_t first, std::size_t last, const Curve& curve) {
    const auto p = static_cast<std::size_t>(curve.degree());
    for (std::size_t s = std::max(first, p); s <= last && s + p + 1 < curve.knots().size(); ++s) spans.push_back(s);
}

}  // namespace

// The spans on which the other curve, of the same degree and number of knots, differs, ascending.
std::vector<std::size_t> CurveStrips::changed_spans(const Curve& other) const {
    const auto p = static_cast<std::size_t>(curve_->degree());
    const std::size_t n = curve_->control_points().size();
    std::vector<std::size_t> spans;
    const std::span<const double> knots = curve_->knots().values();
    if (knots.data() != other.knots().values().data())
        for (std::size_t k = 0; k < knots.size(); ++k)
            if (knots[k] != other.knots()[k]) add_spans(spans, k < p ? 0 : k - p, k + p, *curve_);
    std::size_t done = 0;  // the spans of the last point that differs end here
    for (std::size_t i = 0; i < n; ++i) {
        if (curve_->control_points()[i] == other.control_points()[i] && curve_->weights()[i] == other.weights()[i])
            continue;
        add_spans(spans, std::max(i, done), i + p, *curve_);
        done = i + p + 1;
        for (std::size_t j = i + n; j < span_end(); j += n) add_spans(spans, j, j + p, *curve_);
    }
    if (!std::is_sorted(spans.begin(), spans.end())) std::sort(spans.begin(), spans.end());
    spans.erase(std::unique(spans.begin(), spans.end()), spans.end());
    return spans;
}

// Contains the curve over these spans: their control points.
Box CurveStrips::box_of(std::span<const std::size_t> spans) const {
    const auto points = curve_->control_points();
    const auto p = static_cast<std::size_t>(curve_->degree());
    Box box;
    for (const std::size_t s : spans)
        for (std::size_t i = s - p; i <= s; ++i) box.include(points[i % points.size()]);
    return box;
}

void CurveStrips::follow(std::shared_ptr<const Curve> curve) {
    if (curve == curve_) return;
    const bool is_alike = curve->degree() == curve_->degree() && curve->is_periodic() == curve_->is_periodic();
    if (is_alike && curve->knots().size() == curve_->knots().size()) return follow_points(std::move(curve));
    if (!is_alike || curve->is_periodic() || !follow_renumbered(curve)) make_anew(std::move(curve));
}

void CurveStrips::make_anew(std::shared_ptr<const Curve> curve) {
    CurveStrips anew(std::move(curve));
    anew.span_count_ += span_count_;
    anew.stretch_count_ += stretch_count_;
    anew.change_.number = change_.number + 1;
    *this = std::move(anew);
}

void CurveStrips::follow_points(std::shared_ptr<const Curve> curve) {
    std::vector<std::size_t> spans = changed_spans(*curve);
    const Box before = box_of(spans);
    curve_ = std::move(curve);
    for (std::size_t k = 0; k < spans.size();) {
        const std::size_t stretch = stretch_spans_.stretch_of(spans[k]);
        const ItemRange range = stretch_spans_[stretch];
        const auto rest = std::span<const std::size_t>(spans).subspan(k);
        const auto changed =
            rest.first(static_cast<std::size_t>(std::ranges::lower_bound(rest, range.end) - rest.begin()));
        k += changed.size();
        if (changed.size() == range.size()) {
            // All of it is another: it is looked at closely again where that is asked for.
            renew(stretch);
            continue;
        }
        stretches_.replace(stretch, strip_of_stretch(stretch));
        if (!open_[stretch]) continue;
        for (const std::size_t s : changed) {
            const std::size_t i = s - range.first;
            open_[stretch]->parts[i] = parts_of_span(s);
            open_[stretch]->spans.replace(i, open_[stretch]->parts[i].front().strip);
        }
    }
    change_ = {change_.number + 1, false, false, std::move(spans), before};
}

// The spans that depend on what differs lie in one or a few stretches; those after it only get other numbers.
bool CurveStrips::follow_renumbered(const std::shared_ptr<const Curve>& curve) {
    const std::size_t p = first_span();
    const std::size_t n = curve_->control_points().size();
    const CommonEnds knots = common_ends(curve_->knots().values(), curve->knots().values());
    CommonEnds points = common_ends(curve_->control_points(), curve->control_points());
    const CommonEnds weights = common_ends(curve_->weights(), curve->weights());
    points = {std::min(points.ahead, weights.ahead), std::min(points.behind, weights.behind)};
    const Difference of_knots = difference(knots, curve_->knots().size(), curve->knots().size());
    const Difference of_points = difference(points, n, curve->control_points().size());
    const std::size_t first = std::max(p, std::min(of_knots.first - std::min(of_knots.first, p + 1), of_points.first));
    const std::size_t end_of_old = std::min(std::max(of_knots.end_of_old, of_points.end_of_old) + p + 1, span_end());
    const ItemRange old_spans{first, end_of_old};
    const ItemRange spans{first, end_of_old + curve->knots().size() - curve_->knots().size()};
    if (!stretch_spans_.exchange(old_spans, spans)) return false;
    const Box before = box_of(old_spans.numbers());
    curve_ = curve;
    for (std::size_t k = stretch_spans_.stretch_of(first); k <= stretch_spans_.stretch_of(spans.end - 1); ++k) renew(k);
    change_ = {change_.number + 1, false, true, spans.numbers(), before};
    return true;
}

// Puts the strip of the stretch in its place and closes it.
void CurveStrips::renew(std::size_t stretch) {
    stretches_.replace(stretch, strip_of_stretch(stretch));
    if (!open_[stretch]) return;
    open_[stretch].reset();
    --open_count_;
}

}  // namespace batten::core
