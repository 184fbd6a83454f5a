#include "core/shape/detail/edge_winding.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "core/evaluate/detail/subdivide.h"
#include "core/shape/detail/crossing_tree.h"

namespace batten::core {

namespace {

// Shares of the way along a piece at which a line is looked at, one after the other until one is clear.
constexpr std::array looks{0.5, 0.382, 0.618, 0.271, 0.729, 0.167, 0.833};
constexpr std::size_t most_pieces_looked_at = 8;

class SideFinder {
  public:
    SideFinder(const CutCurves& graph, std::span<const std::size_t> sets) : graph_(graph) {
        number_pieces();
        for (std::size_t c = 0; c + 1 < graph.first_edges.size(); ++c) {
            std::vector<CrossingTree::Link> links;
            for (std::size_t e = graph.first_edges[c]; e < graph.first_edges[c + 1]; ++e) append(links, e);
            trees_[sets[c]].emplace_back(std::move(links));
        }
        for (std::size_t c = 0; c + 1 < graph.first_edges.size(); ++c)
            for (std::size_t e = graph.first_edges[c]; e < graph.first_edges[c + 1]; ++e)
                times_[graph.edges[e].line][sets[c]] += graph.edges[e].is_turned ? -1 : 1;
    }

    std::optional<LineSides> of(std::size_t line) const {
        const std::vector<std::size_t> largest = largest_pieces(line);
        for (const double share : looks)
            for (const std::size_t k : largest)
                if (const auto found = seen_from_piece(line, pieces_[line][k], first_pieces_[line] + k, share))
                    return found;
        return std::nullopt;
    }

  private:
    void number_pieces() {
        std::size_t next = 0;
        for (std::size_t e = 0; e < graph_.edges.size(); ++e) {
            first_pieces_.push_back(next);
            pieces_.emplace_back();
            if (graph_.edges[e].line != e) continue;
            for (const BezierPiece& piece : bezier_pieces(graph_.edges[e].arc)) pieces_[e].push_back(piece.points);
            next += pieces_[e].size();
        }
        times_.resize(graph_.edges.size(), WindingPair{});
    }

    // Small pieces may lie near a place where curves touch, and there nothing is clear.
    std::vector<std::size_t> largest_pieces(std::size_t line) const {
        std::vector<std::pair<double, std::size_t>> sizes;
        for (std::size_t k = 0; k < pieces_[line].size(); ++k) {
            const Vector extent = control_box(std::span<const HomogeneousPoint>(pieces_[line][k])).size();
            sizes.emplace_back(-std::max(extent.x, extent.y), k);
        }
        const std::size_t count = std::min(sizes.size(), most_pieces_looked_at);
        std::partial_sort(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(count), sizes.end());
        std::vector<std::size_t> largest;
        for (std::size_t k = 0; k < count; ++k) largest.push_back(sizes[k].second);
        return largest;
    }

    // Edges that coincide have the pieces of one of them, so that they are crossed alike.
    void append(std::vector<CrossingTree::Link>& links, std::size_t e) const {
        const CutEdge& edge = graph_.edges[e];
        const std::size_t count = pieces_[edge.line].size();
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t piece = edge.is_turned ? count - 1 - k : k;
            CrossingTree::Link link{pieces_[edge.line][piece], first_pieces_[edge.line] + piece};
            if (edge.is_turned) std::reverse(link.points.begin(), link.points.end());
            links.push_back(std::move(link));
        }
    }

    std::optional<LineSides> seen_from_piece(std::size_t line, const PiecePoints& piece, std::size_t number,
                                             double share) const {
        const auto [before, after] = halved(piece, share);
        const Point place = project(after.front());
        const Vector along = project(after[1]) - project(before[before.size() - 2]);
        if (!(length(along) > 0.0)) return std::nullopt;
        const RayAxis axis = std::abs(along.x) < std::abs(along.y) ? RayAxis::x : RayAxis::y;
        const Ray ray{place, axis, ray_slack_in_ulps * std::numeric_limits<double>::epsilon() * graph_.size};
        const auto own_before = ray_crossings_beyond(before, ray, true);
        const auto own_after = ray_crossings_beyond(after, ray, false);
        if (!own_before || !own_after) return std::nullopt;
        // The ray leaves to the right of the line, or to the left.
        const bool is_to_right = axis == RayAxis::x ? along.y > 0.0 : along.x < 0.0;
        LineSides sides;
        for (std::size_t set = 0; set < trees_.size(); ++set) {
            int sum = times_[line][set] * (*own_before + *own_after);
            for (const CrossingTree& tree : trees_[set]) {
                const auto crossings = tree.crossings(ray, number);
                if (!crossings) return std::nullopt;
                sum += *crossings;
            }
            sides.left[set] = is_to_right ? sum + times_[line][set] : sum;
            sides.right[set] = is_to_right ? sum : sum - times_[line][set];
        }
        return sides;
    }

    const CutCurves& graph_;
    std::vector<std::vector<PiecePoints>> pieces_{};  // of the lines, by the number of the edge
    std::vector<std::size_t> first_pieces_{};         // the number of the first piece of each line
    std::vector<WindingPair> times_{};                // how often the curves of both sets run along a line
    std::array<std::vector<CrossingTree>, 2> trees_{};
};

}  // namespace

Result<std::vector<LineSides>> sides_of_lines(const CutCurves& graph, std::span<const std::size_t> sets,
                                              const Progress& progress) {
    const SideFinder sides(graph, sets);
    std::vector<LineSides> found(graph.edges.size());
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
        tell(progress, e, graph.edges.size());
        if (graph.edges[e].line != e) continue;
        const auto of_line = sides.of(e);
        if (!of_line) return refuse({.code = CurveErrorCode::shapes_not_decided});
        found[e] = *of_line;
    }
    return found;
}

}  // namespace batten::core
