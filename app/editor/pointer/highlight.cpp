#include "app/editor/pointer/highlight.h"

#include <algorithm>

#include "app/editor/derived/construction_cells.h"

namespace batten::editor {
namespace {

template <class T>
void sort_without_repeats(std::vector<T>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// Collects what belongs together for one curve. Indices of knots are those of values(), as in the book, until they are
/// added.
class Collector {
  public:
    explicit Collector(const core::Curve& curve)
        : knots_(curve.knots()),
          p_(static_cast<std::size_t>(curve.degree())),
          point_count_(curve.control_points().size()) {}

    Highlight of_point(std::size_t i) {
        if (i >= point_count_) return {};
        add_point(i);
        for (std::size_t k = i; k <= i + p_ + 1; ++k) add_knot(k);
        add_support(i);
        return finished();
    }

    /// The points whose difference of that order begins with point i.
    Highlight of_difference(std::size_t i, std::size_t order) {
        if (!knots_.is_periodic() && i + order >= point_count_) return {};
        for (std::size_t k = i; k <= i + order; ++k) result_.points.push_back(k % point_count_);
        return finished();
    }

    Highlight of_knot(std::size_t stored_index) {
        if (stored_index >= knots_.stored().size()) return {};
        const auto [a, b] = run_around(stored_index + knots_.stored_offset());
        for (std::size_t k = a; k <= b; ++k) add_knot(k);
        if (a > 0) add_part(knots_[a - 1], knots_[a]);
        if (b + 1 < knots_.size()) add_part(knots_[b], knots_[b + 1]);
        if (knots_.is_periodic() && knots_[a] == knots_.domain().lower) add_last_span();
        add_points_between(a, p_ + 1, b);
        return finished();
    }

    Highlight of_cell(const core::DeBoorTriangle& triangle, core::CellPlace place) {
        const core::DeBoorCell& cell = triangle.levels[place.level][place.index];
        for (std::size_t i = cell.index - place.level; i <= cell.index; ++i) result_.points.push_back(i % point_count_);
        if (place.level == 0) return finished();
        add_knot(cell.lower_knot);
        add_knot(cell.upper_knot);
        return finished();
    }

    Highlight of_span(std::size_t s) {
        if (s < p_ || s + 1 >= knots_.size() || !(knots_[s] < knots_[s + 1])) return {};
        add_points_between(s, p_, s);
        add_part(knots_[s], knots_[s + 1]);
        result_.shows_hull = true;
        return finished();
    }

    /// The knots of N_{i,k}, and for k = p all that belongs to its control point.
    Highlight of_basis_cell(std::size_t i, std::size_t k) {
        if (i + k + 1 >= knots_.size()) return {};
        if (k == p_) return of_point(i % point_count_);
        for (std::size_t j = i; j <= i + k + 1; ++j) add_knot(j);
        return finished();
    }

  private:
    struct Run {
        std::size_t first;
        std::size_t last;
    };

    /// The run of equal knots around values()[k]; that of the seam at the lower end of the domain, where it is whole.
    Run run_around(std::size_t k) const {
        if (knots_.is_periodic() && knots_[k] == knots_.domain().upper && k >= point_count_) k -= point_count_;
        Run run{k, k};
        while (run.first > 0 && knots_[run.first - 1] == knots_[k]) --run.first;
        while (run.last + 1 < knots_.size() && knots_[run.last + 1] == knots_[k]) ++run.last;
        return run;
    }

    void add_point(std::size_t i) {
        result_.points.push_back(i);
        result_.basis.push_back(i);
    }

    /// Points first - below .. last, as far as they exist, or round the period.
    void add_points_between(std::size_t first, std::size_t below, std::size_t last) {
        const std::size_t turns = knots_.is_periodic() ? (below / point_count_ + 1) * point_count_ : 0;
        const std::size_t start = first + turns > below ? first + turns - below : 0;
        for (std::size_t i = start; i <= last + turns; ++i) {
            if (knots_.is_periodic())
                add_point(i % point_count_);
            else if (i < point_count_)
                add_point(i);
        }
    }

    /// Stored index of values()[k], which when periodic stands for a whole family of knots.
    void add_knot(std::size_t k) {
        if (!knots_.is_periodic()) {
            result_.knots.push_back(k);
            return;
        }
        const std::size_t turns_ahead = p_ / point_count_ + 1;
        const std::size_t index = (k + turns_ahead * point_count_ - p_) % point_count_;
        result_.knots.push_back(index);
        if (index == 0) result_.knots.push_back(point_count_);
    }

    void add_part(double lower, double upper) {
        const core::Interval domain = knots_.domain();
        lower = std::max(lower, domain.lower);
        upper = std::min(upper, domain.upper);
        if (lower < upper) result_.parts.push_back({lower, upper});
    }

    void add_last_span() {
        const std::size_t s = knots_.span_at(knots_.domain().upper, core::Side::left);
        add_part(knots_[s], knots_[s + 1]);
    }

    void add_support(std::size_t i) {
        const std::size_t width = p_ + 1;
        if (!knots_.is_periodic()) {
            add_part(knots_[i], knots_[i + width]);
            return;
        }
        if (width >= point_count_) {
            add_part(knots_.domain().lower, knots_.domain().upper);
            return;
        }
        const std::size_t first = i < p_ ? i + point_count_ : i;
        add_part(knots_[first], knots_[first + width]);
        if (first + width > p_ + point_count_) add_part(knots_.domain().lower, knots_[first + width - point_count_]);
    }

    Highlight finished() {
        sort_without_repeats(result_.points);
        sort_without_repeats(result_.basis);
        sort_without_repeats(result_.knots);
        return std::move(result_);
    }

    const core::KnotVector& knots_;
    std::size_t p_;
    std::size_t point_count_;
    Highlight result_;
};

/// One case for each hovered thing that lights up others.
struct HighlightOf {
    const EditorState& state;
    const core::Curve& curve;

    Highlight operator()(const HoveredPoint& h) const { return Collector(curve).of_point(h.index); }
    Highlight operator()(const HoveredWeightRing& h) const { return Collector(curve).of_point(h.index); }
    Highlight operator()(const HoveredLifted& h) const {
        return h.index ? Collector(curve).of_point(*h.index) : Highlight{};
    }
    Highlight operator()(const HoveredHodograph& h) const {
        return h.index ? Collector(curve).of_difference(*h.index, h.order) : Highlight{};
    }
    Highlight operator()(const HoveredBasis& h) const { return Collector(curve).of_point(h.index); }
    Highlight operator()(const HoveredKnot& h) const { return Collector(curve).of_knot(h.index); }
    Highlight operator()(const HoveredSpan& h) const { return Collector(curve).of_span(h.span); }
    Highlight operator()(const HoveredBasisCell& h) const {
        return Collector(curve).of_basis_cell(h.function, h.degree);
    }
    Highlight operator()(const HoveredCell&) const {
        const core::DeBoorTriangle triangle = core::de_boor_triangle(curve, state.parameter());
        const auto place = hovered_cell(state, triangle);
        return place ? Collector(curve).of_cell(triangle, *place) : Highlight{};
    }

    template <class Other>
    Highlight operator()(const Other&) const {
        return {};
    }
};

}  // namespace

Highlight highlight(const EditorState& state) {
    const core::Curve* curve = state.active_curve();
    if (curve == nullptr) return {};
    return std::visit(HighlightOf{state, *curve}, state.hover);
}

Highlight highlight_of_point(const core::Curve& curve, std::size_t i) {
    return Collector(curve).of_point(i);
}

}  // namespace batten::editor
