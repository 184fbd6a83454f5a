/// What the views of a curve's shape measure, kept beside the curve: a frame in which nothing changed measures nothing.
#pragma once

#include <memory>
#include <vector>

#include "app/editor/derived/kept.h"
#include "app/editor/state/probe_line.h"
#include "core/evaluate/evaluate.h"
#include "core/evaluate/quantity_graph.h"
#include "core/measure/curvature.h"
#include "core/measure/intersect_line.h"

namespace batten::editor {

/// Where a part of a curve ends and the next begins.
struct PartEnd {
    double u = 0.0;
    core::Point point{};
};

/// The ends of all parts, the first and the last one too, and how long each part is.
struct EqualParts {
    std::vector<PartEnd> ends;
    double length = 0.0;  ///< of each; only of equal lengths
};

/// Where a curve bends in another way.
struct Bends {
    std::vector<core::Inflection> inflections;
    std::vector<core::CurvatureExtremum> extrema;
};

/// A quantity over a range, and the values between which it is shown.
struct Graph {
    std::vector<core::GraphRun> runs;
    core::Interval values;  ///< with 0; not those near a pole, which would hide all others
};

struct GraphRequest {
    core::Quantity quantity{};
    core::Interval range;
    std::size_t most = 1;  ///< parameters

    bool operator==(const GraphRequest&) const = default;
};

/// How many spans are searched at most, so that a picture of any curve is drawn at once: for bends, for crossings, and
/// for equal lengths.
inline constexpr std::size_t most_bent_spans = 300;
inline constexpr std::size_t most_crossed_spans = 2000;
inline constexpr std::size_t most_measured_spans = 20'000;

class Measured {
  public:
    /// What the line has in common with `curve` and its polygon, complete where it crosses no more than
    /// most_crossed_spans; null where the line's points coincide.
    std::shared_ptr<const core::LineContacts> crossings(const core::Curve& curve, const ProbeLine& line) const;

    /// The bends within `ranges` of the domain, which together should have at most most_bent_spans.
    std::shared_ptr<const Bends> bends(const core::Curve& curve, const std::vector<core::Interval>& ranges) const;

    /// `count` (>= 1) parts of the domain, equal in u, or equal in length; these are none for a curve of more than
    /// most_measured_spans and one whose length cannot be told.
    std::shared_ptr<const EqualParts> equal_steps(const core::Curve& curve, int count) const;
    std::shared_ptr<const EqualParts> equal_lengths(const core::Curve& curve, int count) const;

    std::shared_ptr<const Graph> graph(const core::Curve& curve, const GraphRequest& request) const;

  private:
    template <class Asked>
    struct Question {
        core::Curve curve;
        Asked asked;
    };
    template <class Asked>
    static bool are_same(const Question<Asked>& a, const Question<Asked>& b);
    template <class Asked, class Answer>
    using Answers = Kept<Question<Asked>, Answer, are_same<Asked>>;

    Answers<ProbeLine, core::LineContacts> crossings_;
    Answers<std::vector<core::Interval>, Bends> bends_;
    Answers<int, EqualParts> steps_;
    Answers<int, EqualParts> lengths_;
    Answers<GraphRequest, Graph> curvatures_;
    Answers<GraphRequest, Graph> speeds_;
};

}  // namespace batten::editor
