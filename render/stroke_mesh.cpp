#include "render/stroke_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "render/clip.h"

namespace batten::render {
namespace {

constexpr double shortest_segment_px = 0.01;  // shorter ones have no usable direction after rounding to float
constexpr double most_excess_px = 0.1;        // by which a mitre may stick out of the round joint
// The outermost coverage, too little to show. Without it a 1 px line along a row of pixels touches no pixels beside
// that row.
constexpr double unseen_px = 1.0 / 256.0;
constexpr float without_end = 1e9F;

glm::dvec2 left_of(glm::dvec2 direction) {
    return {-direction.y, direction.x};
}

double cross(glm::dvec2 a, glm::dvec2 b) {
    return a.x * b.y - a.y * b.x;
}

/// A point of the line with the segment that starts there.
struct Node {
    glm::dvec2 position{};
    double along = 0.0;
    glm::dvec2 direction{};
    double length = 0.0;
};

struct Style {
    double half_width = 0.5;
    double reach = 1.0;  // from the center line to where the coverage is 0
    double half_dash = 1.0;
    double period = 1.0;
    Color color;
};

bool is_dashed(const Polyline& line) {
    return line.dash_px > 0.0F && line.gap_px > 0.0F;
}

Style style_of(const Polyline& line, double scale) {
    const double width = std::max(0.0, line.width_px * scale);
    Style style;
    style.half_width = 0.5 * std::max(width, 1.0);
    style.reach = style.half_width + 0.5 - unseen_px;
    style.color = faded(line.color, std::min(width, 1.0));
    if (is_dashed(line)) {
        style.half_dash = 0.5 * line.dash_px * scale;
        style.period = (static_cast<double>(line.dash_px) + line.gap_px) * scale;
    }
    return style;
}

/// The points in framebuffer pixels without those that fall on their predecessor; a closed line repeats its first one.
std::vector<glm::dvec2> distinct_points(const Polyline& line, double scale) {
    std::vector<glm::dvec2> points;
    points.reserve(line.points.size() + 1);
    const auto add = [&](Pixel pixel) {
        const glm::dvec2 point = glm::dvec2(pixel) * scale;
        if (points.empty() || glm::distance(points.back(), point) >= shortest_segment_px) points.push_back(point);
    };
    for (const Pixel pixel : line.points) add(pixel);
    if (line.is_closed && points.size() > 1) {
        if (glm::distance(points.front(), points.back()) < shortest_segment_px) points.pop_back();
        points.push_back(points.front());
    }
    return points;
}

/// The nodes of all segments; the last node keeps the direction of the last segment.
std::vector<Node> nodes_through(const std::vector<glm::dvec2>& points) {
    std::vector<Node> nodes;
    nodes.reserve(points.size());
    double along = 0.0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const glm::dvec2 leg = points[i + 1] - points[i];
        const double length = glm::length(leg);
        nodes.push_back({points[i], along, leg / length, length});
        along += length;
    }
    const glm::dvec2 direction = nodes.empty() ? glm::dvec2(1.0, 0.0) : nodes.back().direction;
    nodes.push_back({points.back(), along, direction, 0.0});
    return nodes;
}

/// How far the direction of a line swings.
struct Turning {
    double total = 0.0;  // sum of the absolute angles at the joints
    double range = 0.0;  // from the heading most to the left to the one most to the right
};

Turning turning_of(const std::vector<Node>& nodes, bool is_closed) {
    const auto angle = [](const Node& a, const Node& b) {
        return std::atan2(cross(a.direction, b.direction), glm::dot(a.direction, b.direction));
    };
    Turning turning;
    double heading = 0.0;
    double least = 0.0;
    double most = 0.0;
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
        const double turn = angle(nodes[i - 1], nodes[i]);
        heading += turn;
        least = std::min(least, heading);
        most = std::max(most, heading);
        turning.total += std::abs(turn);
    }
    turning.range = most - least;
    if (is_closed) turning.total += std::abs(angle(nodes.back(), nodes.front()));
    return turning;
}

/// Writes the strips of one line.
class StrokeWriter {
  public:
    StrokeWriter(Mesh<StrokeVertex>& mesh, const Style& style, bool is_dashed)
        : mesh_(mesh), style_(style), is_dashed_(is_dashed) {}

    /// Writes a connected part. `is_loop`: its last node lies on its first.
    void write(const std::vector<Node>& nodes, bool is_loop) {
        const Node& front = nodes.front();
        base_ = is_dashed_ ? std::floor(front.along / style_.period) * style_.period : front.along;
        const bool has_gentle_seam = is_loop && is_gentle(nodes[nodes.size() - 2], front);
        if (has_gentle_seam) {
            begin_strip(front, mitre(nodes.back(), front), -without_end);
        } else if (is_loop) {
            begin_cut(front);
            ++sharp_joints_;
        } else {
            begin_round(front);
        }
        for (std::size_t i = 1; i + 1 < nodes.size(); ++i) write_joint(nodes[i - 1], nodes[i]);
        if (has_gentle_seam) {
            add_mitre(nodes.back(), nodes.back(), front);
            end_strip(without_end);
        } else {
            end_round(nodes.back(), nodes.back().direction);
        }
    }

    [[nodiscard]] bool has_sharp_joints() const { return sharp_joints_ > 0; }

  private:
    /// Whether the joint where `before` ends and `at` begins can be mitred: unseen, and without folding on the inner
    /// side.
    [[nodiscard]] bool is_gentle(const Node& before, const Node& at) const {
        const double cosine = glm::dot(before.direction, at.direction);
        if (cosine <= 0.0) return false;
        const double tan_half = std::abs(cross(before.direction, at.direction)) / (1.0 + cosine);
        const double excess = style_.half_width * (std::sqrt(1.0 + tan_half * tan_half) - 1.0);
        return excess <= most_excess_px && style_.reach * tan_half <= 0.5 * std::min(before.length, at.length);
    }

    [[nodiscard]] glm::dvec2 mitre(const Node& before, const Node& at) const {
        const glm::dvec2 a = left_of(before.direction);
        const glm::dvec2 b = left_of(at.direction);
        return (a + b) * (style_.reach / (1.0 + glm::dot(a, b)));
    }

    void write_joint(const Node& before, const Node& at) {
        if (is_gentle(before, at)) {
            add_mitre(at, before, at);
            return;
        }
        end_round(at, before.direction);
        begin_cut(at);
        ++sharp_joints_;
    }

    [[nodiscard]] float local(double along) const { return static_cast<float>(along - base_); }

    void begin_strip(const Node& node, glm::dvec2 offset, float first) {
        strip_ = mesh_.vertices.size();
        first_ = first;
        has_mitre_ = false;
        add_pair(node.position, offset, node.along);
    }

    void begin_round(const Node& node) {
        const Node outer{node.position - node.direction * style_.reach, node.along - style_.reach, node.direction, 0.0};
        begin_strip(outer, across(node.direction), local(node.along));
        round_start_ = node;
    }

    /// The half disc at the end of the strip before fills the joint, so this one starts with a plain cut.
    void begin_cut(const Node& node) { begin_strip(node, across(node.direction), -without_end); }

    /// A mitre at `node`. The first one after a round end is kept from skewing the arc lengths of that end.
    void add_mitre(const Node& node, const Node& before, const Node& after) {
        if (!has_mitre_ && first_ != -without_end) {
            add_pair(round_start_.position, across(round_start_.direction), round_start_.along);
        }
        has_mitre_ = true;
        add_pair(node.position, mitre(before, after), node.along);
    }

    void end_round(const Node& node, glm::dvec2 direction) {
        if (has_mitre_) add_pair(node.position, across(direction), node.along);
        add_pair(node.position + direction * style_.reach, across(direction), node.along + style_.reach);
        end_strip(local(node.along));
    }

    [[nodiscard]] glm::dvec2 across(glm::dvec2 direction) const { return left_of(direction) * style_.reach; }

    void end_strip(float last) {
        for (std::size_t i = strip_; i < mesh_.vertices.size(); ++i) mesh_.vertices[i].last_px = last;
    }

    void add_pair(glm::dvec2 position, glm::dvec2 offset, double along) {
        const std::uint32_t next = mesh_.next_index();
        if (next > strip_) {
            for (const std::uint32_t corner : {next - 2, next - 1, next, next, next - 1, next + 1}) {
                mesh_.indices.push_back(corner);
            }
        }
        add_vertex(position + offset, along, style_.reach);
        add_vertex(position - offset, along, -style_.reach);
    }

    void add_vertex(glm::dvec2 position, double along, double across) {
        mesh_.vertices.push_back({glm::vec2(position), local(along), static_cast<float>(across), first_, 0.0F,
                                  static_cast<float>(style_.half_width), static_cast<float>(style_.half_dash),
                                  static_cast<float>(style_.period), style_.color});
    }

    Mesh<StrokeVertex>& mesh_;
    const Style& style_;
    bool is_dashed_;
    double base_ = 0.0;  // taken off the arc lengths, which would be too large for floats
    std::size_t strip_ = 0;
    float first_ = 0.0F;
    Node round_start_;
    bool has_mitre_ = false;
    int sharp_joints_ = 0;
};

/// The point of the segment of `node` after `fraction` of its length.
Node moved_along(const Node& node, double fraction) {
    const double distance = node.length * fraction;
    return {node.position + node.direction * distance, node.along + distance, node.direction, node.length - distance};
}

/// Writes the parts of the line inside `seen`.
void write_clipped(StrokeWriter& writer, const std::vector<Node>& nodes, const PixelBox& seen) {
    std::vector<Node> part;
    const auto finish = [&] {
        if (part.size() > 1) writer.write(part, false);
        part.clear();
    };
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
        const auto clipped = clip_segment(seen, nodes[i].position, nodes[i + 1].position);
        if (!clipped || clipped->first > 0.0) finish();
        if (!clipped) continue;
        if (part.empty()) part.push_back(moved_along(nodes[i], clipped->first));
        part.back().length = nodes[i].length * (clipped->last - clipped->first);
        part.push_back(clipped->last < 1.0 ? moved_along(nodes[i], clipped->last) : nodes[i + 1]);
        if (clipped->last < 1.0) finish();
    }
    finish();
}

/// Whether the line may cover itself. Where all headings lie within half a turn, the line always advances in some
/// direction and cannot; a closed line that turns just once around is convex.
bool can_meet_itself(const std::vector<Node>& nodes, bool is_closed) {
    const Turning turning = turning_of(nodes, is_closed);
    return is_closed ? turning.total > 2.0 * std::numbers::pi + 1e-3 : turning.range >= std::numbers::pi;
}

}  // namespace

StrokeOverlap append_stroke(Mesh<StrokeVertex>& mesh, const Polyline& line, const PixelBox& visible, double scale) {
    const Style style = style_of(line, scale);
    const std::vector<glm::dvec2> points = distinct_points(line, scale);
    if (points.empty() || style.color.alpha == 0) return StrokeOverlap::harmless;

    const std::vector<Node> nodes = nodes_through(points);
    const bool is_loop = line.is_closed && nodes.size() > 2;
    const double margin = style.reach + 1.0;
    const PixelBox seen{visible.lower_px - margin, visible.upper_px + margin};
    const bool is_all_seen =
        std::all_of(nodes.begin(), nodes.end(), [&](const Node& node) { return seen.contains(node.position); });

    StrokeWriter writer(mesh, style, is_dashed(line));
    if (nodes.size() == 1) {
        if (is_all_seen) writer.write({nodes[0], nodes[0]}, false);
    } else if (is_all_seen) {
        writer.write(nodes, is_loop);
    } else {
        write_clipped(writer, nodes, seen);
    }
    if (style.color.alpha == 255) return StrokeOverlap::harmless;
    const bool has_cut_seam = is_loop && !is_all_seen;
    return writer.has_sharp_joints() || has_cut_seam || can_meet_itself(nodes, is_loop) ? StrokeOverlap::darkens
                                                                                        : StrokeOverlap::harmless;
}

}  // namespace batten::render
