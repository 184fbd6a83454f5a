#include "app/editor/scene/kept_ink.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/curve/knot_kinds.h"
#include "core/evaluate/curve_strips.h"
#include "core/evaluate/evaluate.h"
#include "core/refine/knot_insertion.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

constexpr glm::ivec2 size{400, 300};

std::shared_ptr<const core::Curve> curve_through(std::vector<core::Point> points) {
    const auto knots = core::make_knots(core::KnotKind::clamped_uniform, 3, points.size()).value();
    return std::make_shared<const core::Curve>(core::Curve::make(knots, std::move(points), {}).value());
}

// Legs all over the picture.
std::vector<core::Point> scattered(std::size_t count) {
    return test::scattered_points(count, {380.0, 280.0});
}

InkPlace place_of(double width_px) {
    return {{.center = {0.0, 0.0}, .scale = 1.0, .size_px = size}, size, {.width_px = width_px}};
}

// The ink of one curve, and how often how much of it was painted.
struct InkOfCurve {
    core::CurveStrips strips;
    InkPlace place;
    KeptInk ink{};
    int paintings = 0;
    std::size_t parts = 0;

    core::ChordRequest request(render::CoverageMap& map, const core::Box& view) const {
        const auto screen = [this](core::Point point) { return render::screen_from_world(place.camera, point); };
        return {0.25, view, [](const core::Strip&) { return false; },
                [&map, screen, this](core::Point a, core::Point b) { map.stroke(screen(a), screen(b), place.style); }};
    }

    const render::CoverageMap& follow(const std::shared_ptr<const core::Curve>& curve, const KeptInk* above = nullptr) {
        strips.follow(curve);
        const core::Box everything{{-1e9, -1e9}, {1e9, 1e9}};
        ink.follow(strips.change(), place, above,
                   {[&](render::CoverageMap& map, const core::Box& view, std::span<const std::size_t> left_out) {
                        ++paintings;
                        strips.visit_chords(request(map, view), curve->domain(), left_out);
                    },
                    [&](render::CoverageMap& map, std::size_t span) {
                        ++parts;
                        strips.visit_span_chords(request(map, everything), span);
                    }});
        return *ink.whole();
    }
};

InkOfCurve ink_of(const std::shared_ptr<const core::Curve>& curve, double width_px) {
    return {core::CurveStrips(curve), place_of(width_px)};
}

// By how much coverage differs at most, where `above` does not cover it.
int difference(const render::CoverageMap& a, const render::CoverageMap& b, const render::CoverageMap* above = nullptr) {
    int largest = 0;
    for (std::size_t i = 0; i < a.values().size(); ++i)
        if (above == nullptr || above->values()[i] < 255)
            largest = std::max(largest, std::abs(a.values()[i] - b.values()[i]));
    return largest;
}

TEST(KeptInk, is_not_painted_again_while_nothing_changes) {
    const auto curve = curve_through(scattered(200));
    InkOfCurve kept = ink_of(curve, 3.0);
    kept.follow(curve);
    kept.follow(curve);
    EXPECT_EQ(kept.paintings, 1);
    kept.place.camera.center.x += 10.3;
    kept.follow(curve);
    EXPECT_EQ(kept.paintings, 2) << "another view";
}

TEST(KeptInk, repaints_only_the_spans_of_a_point_that_is_dragged) {
    std::vector<core::Point> points = scattered(300);
    InkOfCurve kept = ink_of(curve_through(points), 3.0);
    kept.follow(curve_through(points));
    for (int k = 1; k <= 20; ++k) {
        points[150] += core::Vector(3.0 * k, -2.0);
        const auto curve = curve_through(points);
        const render::CoverageMap& whole = kept.follow(curve);
        EXPECT_EQ(kept.paintings, 2) << "once more, where the point was at first";
        EXPECT_EQ(kept.parts, 4U * static_cast<std::size_t>(k));
        InkOfCurve anew = ink_of(curve, 3.0);
        EXPECT_LE(difference(whole, anew.follow(curve)), 1) << k;
    }
}

TEST(KeptInk, follows_random_edits_as_if_painted_anew) {
    std::vector<core::Point> points = scattered(250);
    InkOfCurve kept = ink_of(curve_through(points), 3.0);
    kept.place.style = {.width_px = 1.5, .dash_px = 6.0, .gap_px = 5.0};
    auto curve = curve_through(points);
    kept.follow(curve);
    for (std::size_t k = 0; k < 60; ++k) {
        if (k % 3 == 2) {
            curve =
                std::make_shared<const core::Curve>(core::insert_knot(*curve, 0.0161 * static_cast<double>(k)).value());
        } else {
            core::CurveDefinition definition = curve->definition();
            definition.points[(37 * (k / 5)) % 250] += core::Vector(7.0, 11.0);
            curve = std::make_shared<const core::Curve>(core::Curve::make(definition).value());
        }
        InkOfCurve anew = ink_of(curve, 3.0);
        anew.place = kept.place;
        EXPECT_LE(difference(kept.follow(curve), anew.follow(curve)), 1) << k;
    }
}

TEST(KeptInk, repaints_few_spans_after_all_points_were_moved) {
    std::vector<core::Point> points = scattered(3000);
    InkOfCurve kept = ink_of(curve_through(points), 3.0);
    kept.follow(curve_through(points));
    for (core::Point& point : points) point += core::Vector(3.0, 5.0);
    kept.follow(curve_through(points));
    EXPECT_EQ(kept.parts, 0U) << "but with all the rest";
    for (int k = 1; k <= 5; ++k) {
        points[150] += core::Vector(3.0, -2.0);
        const auto curve = curve_through(points);
        const render::CoverageMap& whole = kept.follow(curve);
        EXPECT_EQ(kept.parts, 4U * static_cast<std::size_t>(k));
        InkOfCurve anew = ink_of(curve, 3.0);
        EXPECT_LE(difference(whole, anew.follow(curve)), 1) << k;
    }
}

TEST(KeptInk, moves_with_the_view_and_paints_what_comes_into_it) {
    const auto curve = curve_through(scattered(200));
    std::vector<core::Point> thick;
    for (int i = 0; i < 40; ++i) thick.emplace_back(10.0 * i - 195.0, 0.0);
    const auto thick_curve = curve_through(thick);
    InkOfCurve above = ink_of(thick_curve, 60.0);
    InkOfCurve below = ink_of(curve, 3.0);
    above.place.camera.scale = below.place.camera.scale = 1.7;
    for (int k = 0; k < 40; ++k) {
        const int before = below.paintings;
        const glm::dvec2 step((k % 7 - 2) / 1.7, (4 - k % 5) / 1.7);
        above.place.camera.center += step;
        below.place.camera.center += step;
        const render::CoverageMap& upper = above.follow(thick_curve);
        InkOfCurve anew = ink_of(curve, 3.0);
        anew.place = below.place;
        EXPECT_LE(difference(below.follow(curve, &above.ink), anew.follow(curve), &upper), 1) << k;
        if (k > 0) {
            EXPECT_EQ(below.paintings - before, (k % 7 != 2 ? 1 : 0) + (k % 5 != 4 ? 1 : 0)) << "at each edge";
        }
    }
    below.place.camera.center.x += 0.3;
    below.follow(curve, &above.ink);
    InkOfCurve anew = ink_of(curve, 3.0);
    anew.place = below.place;
    EXPECT_LE(difference(*below.ink.whole(), anew.follow(curve), above.ink.whole().get()), 1) << "a part of a pixel";
}

TEST(KeptInk, appears_where_what_was_above_it_moves_away) {
    // Above there is a thick line through the middle; one point of it moves up.
    std::vector<core::Point> thick;
    for (int i = 0; i < 40; ++i) thick.emplace_back(10.0 * i - 195.0, 0.0);
    const auto below_curve = curve_through(scattered(400));
    InkOfCurve above = ink_of(curve_through(thick), 60.0);
    InkOfCurve below = ink_of(below_curve, 3.0);
    for (int k = 0; k < 10; ++k) {
        thick[k < 5 ? 20 : 8].y += 40.0;
        const auto above_curve = curve_through(thick);
        const render::CoverageMap& upper = above.follow(above_curve);
        InkOfCurve anew = ink_of(below_curve, 3.0);
        EXPECT_LE(difference(below.follow(below_curve, &above.ink), anew.follow(below_curve), &upper), 1) << k;
    }
    EXPECT_LE(below.paintings, 4) << "at first, and near each of both points";
}

}  // namespace
}  // namespace batten::editor
