#include "tests/core/law_curves.h"

#include <cmath>
#include <cstdlib>
#include <ostream>

#include "core/curve/knot_analysis.h"
#include "core/evaluate/evaluate.h"
#include "tests/core/golden_cases.h"

namespace batten::core {

void showValue(const Curve& curve, std::ostream& stream) {
    stream.precision(17);
    stream << (curve.is_periodic() ? "periodic" : "open") << " curve of degree " << curve.degree() << " over";
    for (const double u : curve.knots().stored()) stream << ' ' << u;
    stream << " with points";
    for (std::size_t i = 0; i < curve.control_points().size(); ++i) {
        const Point& point = curve.control_points()[i];
        stream << " (" << point.x << ", " << point.y;
        if (curve.is_rational()) stream << "; " << curve.weights()[i];
        stream << ')';
    }
}

namespace laws {

namespace {

// The same cases in every run, and so many of them, unless the caller's environment says otherwise.
const bool is_configured = setenv("RC_PARAMS", "seed=20 max_success=60", 0) == 0;

constexpr double far_offset = 1e6;
constexpr double short_span = 1e-9;
constexpr double long_factor = 1e9;

// The repetitions of a period are sums of knots, and where these are rounded, so is the shape: by 2^-53 of the knots in
// a span of 1e-9. To see what the operations do, such sums are to be exact: a little less than 1e-9 and more than 1e9.
const double exact_short_span = std::ldexp(1.0, -30);
const double exact_long_factor = std::ldexp(1.0, 30);

bool draw_choice() {
    return draw_whole(0, 1) == 1;
}

// The steps between the knots, of length 1/16 to 4 in the plain setting.
class Steps {
  public:
    Steps(Setting setting, bool is_exact) : setting_(setting), is_exact_(is_exact) {}

    double draw() {
        const bool may_be_short =
            setting_ == Setting::close_knots || (setting_ == Setting::close_and_long && !is_long_);
        if (may_be_short && draw_whole(0, 2) > 0) return is_exact_ ? exact_short_span : short_span;
        const double step = draw_whole(1, 64) / 16.0;
        if (setting_ != Setting::long_domain && setting_ != Setting::close_and_long) return step;
        // From here on knots 1e-9 apart would be equal.
        is_long_ = true;
        return (is_exact_ ? exact_long_factor : long_factor) * step;
    }

  private:
    Setting setting_;
    bool is_exact_;
    bool is_long_ = false;
};

// Appends `count` knots after steps that may be zero.
void add_loose_knots(std::vector<double>& knots, int count, Steps& steps) {
    for (int k = 0; k < count; ++k) knots.push_back(knots.back() + (draw_whole(0, 3) == 0 ? 0.0 : steps.draw()));
}

void add_interior_knots(std::vector<double>& knots, int degree, Steps& steps) {
    const int count = draw_whole(0, 8);
    for (int k = 0; k < count; ++k) {
        const double u = knots.back() + steps.draw();
        const int multiplicity = draw_whole(0, 2) > 0 ? 1 : draw_whole(1, degree);
        knots.insert(knots.end(), static_cast<std::size_t>(multiplicity), u);
    }
}

std::vector<double> draw_open_knots(int degree, Setting setting, bool may_be_unclamped) {
    Steps steps(setting, false);
    std::vector<double> knots{0.0};
    const auto repeats = static_cast<std::size_t>(degree);
    const bool is_loose_below = may_be_unclamped && draw_choice();
    const bool is_loose_above = may_be_unclamped && draw_choice();
    if (is_loose_below)
        add_loose_knots(knots, degree, steps);
    else
        knots.insert(knots.end(), repeats, 0.0);
    add_interior_knots(knots, degree, steps);
    const double end = knots.back() + steps.draw();
    knots.push_back(end);
    if (is_loose_above)
        add_loose_knots(knots, degree, steps);
    else
        knots.insert(knots.end(), repeats, end);
    return knots;
}

std::vector<double> draw_period(int degree, Setting setting) {
    Steps steps(setting, true);
    std::vector<double> knots{0.0};
    if (draw_whole(0, 2) == 0) knots.insert(knots.end(), static_cast<std::size_t>(draw_whole(0, degree - 1)), 0.0);
    add_interior_knots(knots, degree, steps);
    // Two points are the least.
    if (knots.size() < 2) knots.push_back(knots.back() + steps.draw());
    knots.push_back(knots.back() + steps.draw());
    return knots;
}

std::vector<int> draw_wholes(std::size_t count, int upper) {
    return *rc::gen::container<std::vector<int>>(count,
                                                 rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, upper + 1)));
}

std::vector<Point> draw_points(std::size_t count, Setting setting) {
    const Point origin = setting == Setting::far_away ? Point(far_offset, -0.75 * far_offset) : Point{};
    const auto coordinates = draw_wholes(2 * count, 4096);
    // 0, -1, 1, -2, 2..., so that the simplest is 0.
    const auto coordinate = [](int k) { return (k % 2 == 0 ? k / 2 : -(k + 1) / 2) / 256.0; };
    std::vector<Point> points;
    for (std::size_t i = 0; i < count; ++i)
        points.push_back(origin + Vector(coordinate(coordinates[2 * i]), coordinate(coordinates[2 * i + 1])));
    return points;
}

std::vector<double> draw_weights(std::size_t count) {
    std::vector<double> weights;
    for (const int k : draw_wholes(count, 79)) weights.push_back(std::ldexp(1.0 + (k % 16) / 16.0, k / 16 - 2));
    return weights;
}

Curve composed_curve(Setting setting, Sort sort) {
    CurveDefinition definition{.degree = draw_whole(1, sort.most_degree)};
    const bool may_be_periodic = sort.periodic && setting != Setting::close_and_long;
    definition.periodic = may_be_periodic && (!sort.open || draw_whole(0, 2) == 2);
    definition.knots = definition.periodic ? draw_period(definition.degree, setting)
                                           : draw_open_knots(definition.degree, setting, sort.unclamped);
    const auto p = static_cast<std::size_t>(definition.degree);
    const std::size_t count = definition.knots.size() - 1 - (definition.periodic ? 0 : p);
    definition.points = draw_points(count, setting);
    if (sort.rational && draw_choice()) definition.weights = draw_weights(count);
    const auto curve = Curve::make(std::move(definition));
    if (!curve) RC_FAIL(describe(curve.error()));
    return *curve;
}

double composed_parameter(const Curve& curve) {
    const KnotVector& knots = curve.knots();
    const auto p = static_cast<std::size_t>(curve.degree());
    std::vector<std::size_t> spans;
    for (std::size_t s = p; s + p + 1 < knots.size(); ++s)
        if (knots[s] < knots[s + 1]) spans.push_back(s);
    const std::size_t s = spans[static_cast<std::size_t>(draw_whole(0, static_cast<int>(spans.size()) - 1))];
    const int place = draw_whole(0, 64);
    if (place == 64) return knots[s + 1];
    return std::min(knots[s] + (knots[s + 1] - knots[s]) * (place / 64.0), knots[s + 1]);
}

}  // namespace

// The whole range from the first case on; the simple ones come when a case that fails is made simpler.
int draw_whole(int lower, int upper) {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(lower, upper + 1));
}

// Drawn as one value each, so that rapidcheck shows them and not their parts. It keeps these functions for later.
Curve draw_curve(Setting setting, Sort sort) {
    return *rc::gen::exec([=] { return composed_curve(setting, sort); });
}

double draw_parameter(const Curve& curve) {
    return *rc::gen::exec([curve] { return composed_parameter(curve); });
}

double draw_number(double lower, double upper) {
    return lower + (upper - lower) * draw_whole(0, 255) / 255.0;
}

double draw_insertable_parameter(const Curve& curve) {
    const double u = draw_parameter(curve);
    RC_PRE(curve.knots().multiplicity(u) < curve.degree());
    return u;
}

double unit_of(const Curve& curve) {
    return std::ldexp(golden::largest_coordinate(curve.control_points()), -53);
}

double largest_distance(const Curve& a, const Curve& b) {
    constexpr int places_in_span = 7;
    const KnotVector& knots = a.knots();
    const auto p = static_cast<std::size_t>(a.degree());
    double largest = 0.0;
    for (std::size_t s = p; s + p + 1 < knots.size(); ++s) {
        if (knots[s] == knots[s + 1]) continue;
        for (int k = 0; k <= places_in_span; ++k) {
            const double u =
                k == places_in_span ? knots[s + 1] : knots[s] + (knots[s + 1] - knots[s]) * k / places_in_span;
            const Side side = k == places_in_span ? Side::left : Side::right;
            largest = std::max(largest, distance(point_at(a, u, side), point_at(b, u, side)));
        }
    }
    return largest;
}

}  // namespace laws
}  // namespace batten::core
