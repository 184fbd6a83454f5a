#include "tests/core/golden_cases.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

namespace batten::core::golden {

namespace {

std::string folder() {
    const char* chosen = std::getenv("BATTEN_GOLDEN");
    return chosen != nullptr && *chosen != '\0' ? chosen : BATTEN_GOLDEN_DEFAULT;
}

}  // namespace

std::vector<nlohmann::json> cases(const std::string& file) {
    std::ifstream stream(folder() + "/" + file);
    if (!stream) throw std::runtime_error("cannot read " + folder() + "/" + file);
    return nlohmann::json::parse(stream).at("cases").get<std::vector<nlohmann::json>>();
}

std::vector<Point> points_of(const nlohmann::json& points) {
    std::vector<Point> result;
    for (const auto& point : points) result.emplace_back(point.at(0).get<double>(), point.at(1).get<double>());
    return result;
}

Curve curve_of(const nlohmann::json& members) {
    return Curve::make({.degree = members.at("degree").get<int>(),
                        .knots = members.at("knots").get<std::vector<double>>(),
                        .points = points_of(members.at("points")),
                        .weights = members.value("weights", std::vector<double>{}),
                        .tears = Tears::allow})
        .value();
}

bool is_hard(const Curve& curve) {
    const auto [least, most] = std::minmax_element(curve.weights().begin(), curve.weights().end());
    return curve.degree() > 10 || *most / *least > 1e3;
}

double largest_coordinate(std::span<const Point> points) {
    double largest = 0.0;
    for (const Point& point : points) largest = std::max({largest, std::abs(point.x), std::abs(point.y)});
    return largest;
}

double largest_difference(std::span<const Point> a, std::span<const Point> b) {
    if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        largest = std::max({largest, std::abs(a[i].x - b[i].x), std::abs(a[i].y - b[i].y)});
    return largest;
}

double largest_difference(std::span<const double> a, std::span<const double> b) {
    if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

double relative(double error, double scale) {
    if (error == 0.0) return 0.0;
    return scale > 0.0 ? error / scale : std::numeric_limits<double>::infinity();
}

}  // namespace batten::core::golden
