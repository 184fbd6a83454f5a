#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "app/editor/scene/canvas_scene.h"
#include "app/editor/scene/plot_scene.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

/// Random but valid things to draw, the same ones every time.
class SceneMaker {
  public:
    explicit SceneMaker(unsigned seed) : random_(seed) {}

    EditorState state() {
        EditorState state = test::scene_state(valid_definition());
        const core::Curve& curve = *state.active_curve();
        state.view.camera.scale = std::pow(10.0, between(-9.0, 15.0));
        state.view.camera.size_px = {std::floor(between(1.0, 3000.0)), std::floor(between(1.0, 2000.0))};
        state.view.camera.center = center(curve);
        state.view.interface_scale = between(0.5, 3.0);
        for (std::size_t i = 0; i < overlay_count; ++i) state.view.overlays.show(static_cast<Overlay>(i), chance(0.7));
        state.view.parameter = curve.domain().lower + between(-0.2, 1.2) * curve.domain().length();
        if (chance(0.3)) state.view.level = whole(0, 8);
        if (chance(0.5)) state.view.plot_range = plot_range(curve.domain());
        state.hover = hover(curve);
        if (chance(0.3)) state.selection = {{0}, static_cast<std::size_t>(whole(0, 4))};
        if (chance(0.3)) state.ghost = Ghost{state.shown().curves[0].curve, 1.0};
        return state;
    }

    CanvasMode mode() {
        switch (whole(0, 4)) {
            case 0:
                return BoxSelecting{{between(-1e9, 1e9), 3.0}, {5.0, between(-100.0, 100.0)}, {}};
            case 1: {
                DrawingCurve drawing;
                for (int k = whole(0, 5); k > 0; --k)
                    drawing.points.push_back({between(-1e6, 1e6), between(-1.0, 1.0)});
                return drawing;
            }
            default:
                return CanvasIdle{};
        }
    }

    double between(double lower, double upper) { return std::uniform_real_distribution(lower, upper)(random_); }

  private:
    int whole(int lower, int upper) { return std::uniform_int_distribution(lower, upper)(random_); }
    bool chance(double probability) { return between(0.0, 1.0) < probability; }

    /// Some knots have no domain.
    core::CurveDefinition valid_definition() {
        for (;;) {
            core::CurveDefinition wish = definition();
            if (core::Curve::make(wish)) return wish;
        }
    }

    core::CurveDefinition definition() {
        core::CurveDefinition curve;
        curve.degree = whole(1, 7);
        curve.periodic = chance(0.3);
        const int count = curve.periodic ? whole(2, 12) : curve.degree + 1 + whole(0, 9);
        const double size = std::pow(10.0, between(-8.0, 12.0));
        const bool has_weights = chance(0.5);
        for (int i = 0; i < count; ++i) {
            curve.points.push_back({size * between(-1.0, 1.0), chance(0.1) ? 0.0 : size * between(-1.0, 1.0)});
            if (has_weights) curve.weights.push_back(std::pow(10.0, between(-4.0, 4.0)));
        }
        if (chance(0.1)) curve.points[1] = curve.points[0];
        curve.knots = curve.periodic ? period(count) : open_knots(curve.degree, count);
        return curve;
    }

    /// Increasing by random steps, so that no knot is multiple.
    std::vector<double> period(int count) {
        std::vector<double> knots{between(-5.0, 5.0)};
        for (int i = 0; i < count; ++i) knots.push_back(knots.back() + std::pow(10.0, between(-6.0, 1.0)));
        return knots;
    }

    /// Ends of multiplicity 1 to p+1, inner knots of multiplicity 1 to p.
    std::vector<double> open_knots(int degree, int count) {
        const auto wanted = static_cast<std::size_t>(count + degree + 1);
        std::vector<double> knots(static_cast<std::size_t>(chance(0.5) ? degree + 1 : 1), between(-5.0, 5.0));
        while (knots.size() < wanted) {
            const double next = knots.back() + std::pow(10.0, between(-6.0, 1.0));
            for (int k = whole(1, degree); k > 0 && knots.size() < wanted; --k) knots.push_back(next);
        }
        return knots;
    }

    core::Point center(const core::Curve& curve) {
        const core::Point point = curve.control_points()[0];
        if (chance(0.6)) return point;
        return {between(-1e6, 1e6), between(-1e-3, 1e-3)};
    }

    core::Interval plot_range(core::Interval domain) {
        const double middle = domain.lower + between(-0.1, 1.1) * domain.length();
        const double half = domain.length() * std::pow(10.0, between(-9.0, 0.0));
        return {middle - half, middle + half};
    }

    Hover hover(const core::Curve& curve) {
        const auto some = static_cast<std::size_t>(whole(0, 6));
        switch (whole(0, 10)) {
            case 0:
                return HoveredPoint{some % curve.control_points().size()};
            case 1:
                return HoveredKnot{some};
            case 2:
                return HoveredSpan{curve.knots().span_at(curve.domain().lower)};
            case 3:
                return HoveredCell{some % 3, some / 3};
            case 4:
                return HoveredCurve{curve.domain().lower};
            case 5:
                return HoveredLeg{some};
            case 6:
                return HoveredBasis{some % curve.control_points().size()};
            case 7:
                return HoveredWeightRing{some % curve.control_points().size()};
            case 8:
                return HoveredHodograph{some % 2 + 1, some, {}};
            case 9:
                return HoveredLifted{std::nullopt, curve.domain().upper};
            default:
                return HoveredNothing{};
        }
    }

    std::mt19937 random_;
};

TEST(SceneFuzz, every_number_of_every_picture_is_finite_and_near_the_picture) {
    for (unsigned seed = 1; seed <= 1500; ++seed) {
        SCOPED_TRACE(seed);
        SceneMaker maker(seed);
        const EditorState state = maker.state();
        const CanvasMode mode = maker.mode();
        // The margin of the pen, a period of a dash, and the rounding of floats.
        const double margin = 80.0 * state.view.interface_scale;
        EXPECT_EQ(test::faults_of(test::canvas_picture(state, mode), state.view.camera.size_px, margin),
                  std::vector<std::string>{});
        const glm::dvec2 dock{maker.between(400.0, 2000.0), maker.between(160.0, 800.0)};
        EXPECT_EQ(test::faults_of(test::plot_picture(state, PlotIdle{}, dock), dock, margin),
                  std::vector<std::string>{});
    }
}

}  // namespace
}  // namespace batten::editor
