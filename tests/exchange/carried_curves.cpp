#include "tests/exchange/carried_curves.h"

#include "core/make/conics.h"
#include "tests/core/random_curves.h"

namespace batten::exchange {

namespace {

using core::Curve;
using core::CurveDefinition;

Curve made(CurveDefinition definition) {
    definition.tears = core::Tears::allow;
    return core::Curve::make(std::move(definition)).value();
}

// Of these knots, with points and weights that repeat nowhere.
CurveDefinition over(int degree, std::vector<double> knots, double size = 1.0, double offset = 0.0) {
    CurveDefinition definition{.degree = degree, .knots = std::move(knots)};
    const std::size_t count = definition.knots.size() - static_cast<std::size_t>(degree) - 1;
    for (std::size_t i = 0; i < count; ++i) {
        const auto x = static_cast<double>(i);
        definition.points.push_back({offset + size * (x + 0.1), offset + size * (x * x / 7.0 - x)});
        definition.weights.push_back(1.0 + 0.3 * x);
    }
    return definition;
}

CurveDefinition with_multiplicity(int degree, int multiplicity) {
    const auto end = static_cast<std::size_t>(degree) + 1;
    std::vector<double> knots(end, 0.0);
    knots.insert(knots.end(), static_cast<std::size_t>(multiplicity), 0.3);
    knots.insert(knots.end(), end, 1.0);
    return over(degree, std::move(knots));
}

CurveDefinition without_weights(CurveDefinition definition) {
    definition.weights.clear();
    return definition;
}

CurveDefinition periodic(int degree, std::vector<double> period) {
    CurveDefinition definition{.degree = degree, .knots = std::move(period), .periodic = true};
    for (std::size_t i = 0; i + 1 < definition.knots.size(); ++i) {
        definition.points.push_back({static_cast<double>(i % 3), static_cast<double>(i * i % 5)});
        definition.weights.push_back(1.0 + static_cast<double>(i));
    }
    return definition;
}

std::vector<CarriedCurve> chosen_curves() {
    const std::vector<double> clamped{0, 0, 0, 0, 0.25, 0.5, 1, 1, 1, 1};
    std::vector<CarriedCurve> curves{{"polynomial", made(without_weights(over(3, clamped)))},
                                     {"rational", made(over(3, clamped))},
                                     {"unclamped", made(over(3, {0, 1, 2, 3, 4, 5.5, 6, 7}))},
                                     {"tiny domain", made(over(2, {0, 0, 0, 1e-9, 2e-9, 2e-9, 2e-9}))},
                                     {"line", made(over(1, {0, 0, 1, 1}))},
                                     {"polyline", made(without_weights(over(1, {0, 0, 1, 2, 3, 3})))},
                                     {"far", made(over(3, clamped, 1.0, 1e6))},
                                     {"huge", made(over(3, clamped, 1e150))},
                                     {"tiny", made(over(3, clamped, 1e-150))},
                                     {"periodic", made(periodic(3, {0, 1, 2, 3.5, 4, 5, 6}))},
                                     {"uneven period", made(periodic(2, {0, 0.1, 0.1, 0.7, 1.3}))},
                                     {"short period", made(periodic(3, {0, 0.3, 1}))},
                                     {"circle", core::circle({1.0, 2.0}, 3.0).value()},
                                     {"torn", made(with_multiplicity(3, 4))}};
    for (const int degree : {1, 2, 3, 5, 25})
        for (int multiplicity = 1; multiplicity <= degree; ++multiplicity)
            curves.push_back({"degree " + std::to_string(degree) + " multiplicity " + std::to_string(multiplicity),
                              made(with_multiplicity(degree, multiplicity))});
    return curves;
}

}  // namespace

std::vector<CarriedCurve> carried_curves(int random_count) {
    std::vector<CarriedCurve> curves = chosen_curves();
    constexpr std::uint32_t seed = 12;
    core::RandomCurves random(seed);
    for (int i = 0; i < random_count; ++i) curves.push_back({"random " + std::to_string(i), random.curve()});
    return curves;
}

core::Document document_of(const Curve& curve, const std::string& name) {
    return document_of(std::vector<CarriedCurve>{{name, curve}});
}

core::Document document_of(const std::vector<CarriedCurve>& curves) {
    core::Document document;
    for (const CarriedCurve& carried : curves) {
        core::DocumentCurve entry;
        entry.name = carried.name;
        entry.curve = std::make_shared<const Curve>(carried.curve);
        document.curves.push_back(std::move(entry));
    }
    return document;
}

}  // namespace batten::exchange
