#include "core/evaluate/blossom_labels.h"

#include <fmt/format.h>

#include <cassert>

#include "core/base/number_text.h"
#include "core/curve/knot_analysis.h"
#include "core/evaluate/evaluate.h"

namespace batten::core {

namespace {

// The arguments as words, knot k told by `word_of`.
template <class WordOf>
std::string joined(const BlossomLabel& label, WordOf word_of) {
    std::vector<std::string> words;
    for (std::size_t k = 0; k < label.knots.size(); ++k) words.push_back(word_of(k));
    words.insert(words.end(), label.parameter_count, "t");
    return fmt::format("{}", fmt::join(words, " "));
}

}  // namespace

BlossomLabel control_point_label(const KnotVector& knots, std::size_t i) {
    assert(i + static_cast<std::size_t>(knots.degree()) + 1 < knots.size());
    return de_boor_label(knots, i, 0);
}

BlossomLabel de_boor_label(const KnotVector& knots, std::size_t i, std::size_t r) {
    const auto p = static_cast<std::size_t>(knots.degree());
    assert(r <= p && i + p - r < knots.size());
    const auto values = knots.values().subspan(i + 1, p - r);
    return {.first_knot = i + 1, .knots = {values.begin(), values.end()}, .parameter_count = r};
}

std::vector<double> arguments_of(const BlossomLabel& label, double t) {
    std::vector<double> arguments = label.knots;
    arguments.insert(arguments.end(), label.parameter_count, t);
    return arguments;
}

std::string symbolic_text(const BlossomLabel& label) {
    return joined(label, [&](std::size_t k) { return fmt::format("u{}", label.first_knot + k); });
}

std::string value_text(const BlossomLabel& label) {
    return joined(label, [&](std::size_t k) { return shortest_text(label.knots[k]); });
}

std::vector<GrevillePoint> greville_points(const Curve& curve) {
    const std::vector<double> abscissae = greville_abscissae(curve.knots());
    std::vector<GrevillePoint> points;
    points.reserve(abscissae.size());
    for (std::size_t i = 0; i < abscissae.size(); ++i)
        points.push_back({abscissae[i], curve.control_points()[i], point_at(curve, abscissae[i])});
    return points;
}

}  // namespace batten::core
