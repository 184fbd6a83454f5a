#include "core/shape/detail/chains.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/curve/control_box.h"
#include "core/evaluate/evaluate.h"

namespace batten::core {

namespace {

// How far from a vertex its edges are put in order, beside the shortest of them.
constexpr double ring_share = 1e-3;

constexpr int most_ring_halvings = 60;

// An edge at one of its two vertices.
struct VertexRay {
    std::size_t edge = 0;  // index of a kept edge
    bool leaves = true;
    double angle = 0.0;
};

class ChainWalk {
  public:
    ChainWalk(const CutCurves& graph, std::span<const ChainEdge> edges)
        : graph_(graph), edges_(edges), rays_(graph.vertices.size()), next_(edges.size()), has_before_(edges.size()) {
        for (std::size_t k = 0; k < edges.size(); ++k) {
            rays_[end_of(k, false)].push_back({k, true});
            rays_[end_of(k, true)].push_back({k, false});
        }
        for (std::size_t v = 0; v < rays_.size(); ++v) pair_at(v);
    }

    std::vector<Chain> chains() {
        std::vector<Chain> found;
        for (std::size_t k = 0; k < edges_.size(); ++k)
            if (has_before_[k] == 0) found.push_back(chain_from(k, false));
        for (std::size_t k = 0; k < edges_.size(); ++k)
            if (is_taken_[k] == 0) found.push_back(chain_from(k, true));
        return found;
    }

  private:
    const CutEdge& edge(std::size_t k) const { return graph_.edges[edges_[k].line]; }

    std::size_t end_of(std::size_t k, bool is_arrival) const {
        return edges_[k].is_forward == is_arrival ? edge(k).to : edge(k).from;
    }

    void pair_at(std::size_t v) {
        std::vector<VertexRay>& rays = rays_[v];
        if (rays.size() == 2 && rays[0].leaves != rays[1].leaves) {
            const std::size_t arriving = rays[0].leaves ? 1 : 0;
            follow(rays[arriving].edge, rays[1 - arriving].edge);
            return;
        }
        sort_around(v);
        // Counter-clockwise: after one that leaves comes the inside, and then the one that arrives.
        std::vector<std::size_t> open;
        std::vector<char> is_done(rays.size());
        for (std::size_t turn = 0; turn < 2 * rays.size(); ++turn) {
            const std::size_t r = turn % rays.size();
            if (is_done[r] != 0) continue;
            if (rays[r].leaves) {
                if (turn < rays.size()) open.push_back(r);
            } else if (!open.empty()) {
                follow(rays[r].edge, rays[open.back()].edge);
                is_done[r] = is_done[open.back()] = 1;
                open.pop_back();
            }
        }
    }

    void follow(std::size_t before, std::size_t after) {
        next_[before] = after;
        has_before_[after] = 1;
    }

    void sort_around(std::size_t v) {
        double ring = graph_.size;
        for (const VertexRay& ray : rays_[v]) {
            const Vector extent = control_box(edge(ray.edge).arc).size();
            ring = std::min(ring, ring_share * std::max(extent.x, extent.y));
        }
        for (VertexRay& ray : rays_[v]) {
            const bool is_at_start = ray.leaves == edges_[ray.edge].is_forward;
            const Vector away = place_on_ring(edge(ray.edge).arc, is_at_start, ring) - graph_.vertices[v];
            ray.angle = std::atan2(away.y, away.x);
        }
        std::sort(rays_[v].begin(), rays_[v].end(),
                  [](const VertexRay& a, const VertexRay& b) { return a.angle < b.angle; });
    }

    // A place of the arc about that far from one of its ends.
    static Point place_on_ring(const Curve& arc, bool is_at_start, double ring) {
        const auto [lower, upper] = arc.domain();
        double near = is_at_start ? lower : upper;
        double far = is_at_start ? upper : lower;
        const Point vertex = point_at(arc, near);
        for (int k = 0; k < most_ring_halvings; ++k) {
            const double middle = 0.5 * near + 0.5 * far;
            (distance(point_at(arc, middle), vertex) > ring ? far : near) = middle;
        }
        return point_at(arc, far);
    }

    Chain chain_from(std::size_t start, bool is_closed) {
        Chain chain{{}, is_closed};
        for (std::optional<std::size_t> k = start; k && is_taken_[*k] == 0; k = next_[*k]) {
            is_taken_[*k] = 1;
            chain.edges.push_back(edges_[*k]);
        }
        return chain;
    }

    const CutCurves& graph_;
    std::span<const ChainEdge> edges_;
    std::vector<std::vector<VertexRay>> rays_;  // at each vertex
    std::vector<std::optional<std::size_t>> next_;
    std::vector<char> has_before_;
    std::vector<char> is_taken_ = std::vector<char>(edges_.size());
};

}  // namespace

std::vector<Chain> chains_of(const CutCurves& graph, std::span<const ChainEdge> edges) {
    return ChainWalk(graph, edges).chains();
}

}  // namespace batten::core
