#include <algorithm>

#include "core/measure/continuity.h"
#include "core/refine/bezier_form.h"
#include "core/refine/degree.h"
#include "core/refine/periodic.h"
#include "core/refine/reparametrize.h"
#include "core/refine/reverse.h"
#include "core/refine/split.h"
#include "core/shape/detail/chains.h"

namespace batten::core {

namespace {

// Edges of one curve that follow one another.
struct CurveRun {
    std::size_t curve = 0;
    std::size_t first = 0;  // edges, in the direction of the curve
    std::size_t last = 0;
    bool is_forward = true;
};

class ChainCurve {
  public:
    ChainCurve(const CutCurves& graph, std::span<const Curve> originals, const Chain& chain)
        : graph_(graph), originals_(originals) {
        for (const ChainEdge& edge : chain.edges) add(edge);
        if (chain.is_closed && runs_.size() > 1 &&
            is_followed(runs_.back(), entry(runs_.front()), runs_.front().is_forward)) {
            CurveRun& first = runs_.front();
            (first.is_forward ? first.first : first.last) = first.is_forward ? runs_.back().first : runs_.back().last;
            runs_.pop_back();
        }
        is_closed_ = chain.is_closed;
    }

    Result<Curve> curve() const {
        if (runs_.size() == 1 && is_whole(runs_.front())) {
            const Curve& whole = originals_[runs_.front().curve];
            return runs_.front().is_forward ? whole : reverse(whole);
        }
        std::vector<Curve> parts;
        int degree = 0;
        for (const CurveRun& run : runs_) {
            auto part = part_of_curve(run);
            if (!part) return refuse(part.error());
            degree = std::max(degree, part->degree());
            parts.push_back(*std::move(part));
        }
        return joined(parts, degree);
    }

  private:
    static std::size_t entry(const CurveRun& run) { return run.is_forward ? run.first : run.last; }

    void add(const ChainEdge& edge) {
        if (!runs_.empty() && is_followed(runs_.back(), edge.line, edge.is_forward)) {
            (edge.is_forward ? runs_.back().last : runs_.back().first) = edge.line;
            return;
        }
        runs_.push_back({graph_.edges[edge.line].curve, edge.line, edge.line, edge.is_forward});
    }

    // Whether the curve goes on from the run to this edge; over its seam only where it is periodic.
    bool is_followed(const CurveRun& run, std::size_t edge, bool is_forward) const {
        if (graph_.edges[edge].curve != run.curve || is_forward != run.is_forward) return false;
        const std::size_t begin = graph_.first_edges[run.curve];
        const std::size_t end = graph_.first_edges[run.curve + 1];
        const bool may_wrap = originals_[run.curve].is_periodic();
        if (is_forward) return run.last + 1 < end ? edge == run.last + 1 : may_wrap && edge == begin;
        return run.first > begin ? edge + 1 == run.first : may_wrap && edge + 1 == end;
    }

    bool is_whole(const CurveRun& run) const {
        const std::size_t begin = graph_.first_edges[run.curve];
        const std::size_t count = graph_.first_edges[run.curve + 1] - begin;
        const std::size_t length = (run.last + count - run.first) % count + 1;
        if (length != count) return false;
        const bool starts_at_seam = run.first == begin;
        return starts_at_seam || originals_[run.curve].is_periodic();
    }

    Result<Curve> part_of_curve(const CurveRun& run) const {
        const Curve& original = originals_[run.curve];
        const double lower = graph_.edges[run.first].range.lower;
        const double upper = graph_.edges[run.last].range.upper;
        const auto part =
            original.is_periodic()
                ? sub_curve(original, lower, upper)
                : to_clamped(original).and_then([&](const Curve& open) { return sub_curve(open, lower, upper); });
        return run.is_forward ? part : part.and_then(reverse);
    }

    // A part so short that it has no place there in the parameter becomes one of length 1.
    static Result<Curve> put_behind(const Curve& part, double end) {
        if (auto shifted = shift_domain(part, end)) return shifted;
        return reparametrize(part, {end, end + 1.0});
    }

    Result<Curve> joined(std::span<const Curve> parts, int degree) const {
        std::optional<CurveDefinition> whole;
        for (const Curve& part : parts) {
            Result<Curve> next = part;
            if (degree > part.degree()) next = elevate_degree(part, degree - part.degree());
            if (next && whole) next = put_behind(*next, whole->knots.back());
            if (!next) return refuse(next.error());
            whole = whole ? concatenated(*std::move(whole), next->definition()) : next->definition();
        }
        if (is_closed_) whole->points.back() = whole->points.front();
        return Curve::make(*std::move(whole));
    }

    const CutCurves& graph_;
    std::span<const Curve> originals_;
    std::vector<CurveRun> runs_{};
    bool is_closed_ = true;
};

}  // namespace

Result<Curve> curve_along(const CutCurves& graph, std::span<const Curve> originals, const Chain& chain) {
    return ChainCurve(graph, originals, chain).curve();
}

}  // namespace batten::core
