#include <gtest/gtest.h>

#include <cmath>

#include "render/picture_mesh.h"

namespace batten::render {
namespace {

const PixelBox screen{{0.0, 0.0}, {400.0, 300.0}};

Polyline wave(int count, Color color) {
    Polyline result;
    result.width_px = 3.0F;
    result.color = color;
    for (int i = 0; i < count; ++i) {
        const double x = 380.0 * i / (count - 1);
        result.points.push_back(Pixel(10.0 + x, 150.0 + 80.0 * std::sin(x / 60.0)));
    }
    return result;
}

TEST(StrokeMesh, smooth_curve_costs_two_vertices_and_two_triangles_a_point_and_as_much_an_end) {
    Mesh<StrokeVertex> mesh;
    append_stroke(mesh, wave(200, rgb(0xFFFFFF)), screen, 1.0);
    EXPECT_EQ(mesh.vertices.size(), 404U);
    EXPECT_EQ(mesh.indices.size(), 201U * 6U);
}

TEST(StrokeMesh, single_line_costs_four_vertices) {
    Mesh<StrokeVertex> mesh;
    append_stroke(mesh, {{{10, 10}, {300, 40}}, rgb(0xFFFFFF), 1.0F, 0.0F, 0.0F, false}, screen, 1.0);
    EXPECT_EQ(mesh.vertices.size(), 4U);
    EXPECT_EQ(mesh.indices.size(), 6U);
}

TEST(StrokeMesh, translucent_curve_that_always_advances_is_harmless) {
    Mesh<StrokeVertex> mesh;
    EXPECT_EQ(append_stroke(mesh, wave(200, faded(rgb(0xFFFFFF), 0.5)), screen, 1.0), StrokeOverlap::harmless);
    Polyline bow;
    bow.color = faded(rgb(0xFFFFFF), 0.5);
    for (int i = 0; i <= 50; ++i) {
        const double angle = 3.0 * i / 50.0;
        bow.points.push_back(Pixel(200.0 + 90.0 * std::cos(angle), 150.0 + 90.0 * std::sin(angle)));
    }
    EXPECT_EQ(append_stroke(mesh, bow, screen, 1.0), StrokeOverlap::harmless);
    bow.points.insert(bow.points.end(), {Pixel(110, 100), Pixel(110, 20), Pixel(190, 20), Pixel(190, 290)});
    EXPECT_EQ(append_stroke(mesh, bow, screen, 1.0), StrokeOverlap::darkens);
}

TEST(StrokeMesh, closed_convex_translucent_line_is_harmless) {
    Mesh<StrokeVertex> mesh;
    Marker marker;
    marker.center = {100.0F, 100.0F};
    marker.radius_px = 12.0F;
    marker.outline = faded(rgb(0xFFFFFF), 0.5);
    marker.outline_px = 1.5F;
    marker.dash_px = 3.0F;
    EXPECT_EQ(append_stroke(mesh, dashed_ring(marker, 1.0), screen, 1.0), StrokeOverlap::harmless);
}

TEST(StrokeMesh, leaves_out_what_is_not_seen) {
    Mesh<StrokeVertex> mesh;
    Polyline far = wave(200, rgb(0xFFFFFF));
    for (Pixel& point : far.points) point.y += 1000.0F;
    append_stroke(mesh, far, screen, 1.0);
    EXPECT_TRUE(mesh.vertices.empty());
}

TEST(StrokeMesh, vertices_stay_near_the_screen) {
    Mesh<StrokeVertex> mesh;
    Polyline leg;
    leg.color = rgb(0xFFFFFF);
    leg.points = {{-1e7F, 3e6F}, {200.0F, 150.0F}, {9e6F, 1e7F}, {1e7F, -1e7F}, {-1e7F, -9e6F}};
    append_stroke(mesh, leg, screen, 1.0);
    ASSERT_FALSE(mesh.vertices.empty());
    for (const StrokeVertex& vertex : mesh.vertices) {
        EXPECT_GT(vertex.position_px.x, -10.0F);
        EXPECT_LT(vertex.position_px.x, 410.0F);
        EXPECT_GT(vertex.position_px.y, -10.0F);
        EXPECT_LT(vertex.position_px.y, 310.0F);
    }
}

TEST(StrokeMesh, invisible_lines_cost_nothing) {
    Mesh<StrokeVertex> mesh;
    append_stroke(mesh, wave(10, Color{255, 255, 255, 0}), screen, 1.0);
    append_stroke(mesh, Polyline{}, screen, 1.0);
    EXPECT_TRUE(mesh.vertices.empty());
}

TEST(FillMesh, costs_two_vertices_and_a_triangle_a_side) {
    Mesh<FillVertex> mesh;
    append_fill(mesh, {{{10, 10}, {100, 20}, {90, 80}, {30, 90}, {5, 40}}, rgb(0xFFFFFF)}, screen, 1.0);
    EXPECT_EQ(mesh.vertices.size(), 10U);
    EXPECT_EQ(mesh.indices.size(), 15U);
}

TEST(FillMesh, polygon_without_area_adds_nothing) {
    Mesh<FillVertex> mesh;
    append_fill(mesh, {{{10, 10}, {100, 20}}, rgb(0xFFFFFF)}, screen, 1.0);
    append_fill(mesh, {{{10, 10}, {20, 10}, {30, 10}}, rgb(0xFFFFFF)}, screen, 1.0);
    append_fill(mesh, {{{10, 10}, {10, 10}, {10, 10}, {10, 10}}, rgb(0xFFFFFF)}, screen, 1.0);
    EXPECT_TRUE(mesh.vertices.empty());
}

TEST(MarkerMesh, dashes_of_a_ring_go_around_a_whole_number_of_times) {
    Marker marker;
    marker.radius_px = 10.0F;
    marker.dash_px = 3.0F;
    const Polyline ring = dashed_ring(marker, 1.0);
    double around = 0.0;
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
        const Pixel leg = ring.points[(i + 1) % ring.points.size()] - ring.points[i];
        around += std::hypot(leg.x, leg.y);
    }
    EXPECT_NEAR(around, 2.0 * 3.14159265358979 * 10.0, 0.2);
    EXPECT_NEAR(around / (ring.dash_px + ring.gap_px), 10.0, 1e-4);
}

TEST(PictureMesh, joins_commands_of_one_kind_and_skips_labels) {
    DrawList list;
    const Marker disc{{50, 50}, MarkerShape::disc, 5.0F, rgb(0xFF0000), {}, 0.0F, 0.0F};
    list.add(wave(20, rgb(0xFFFFFF)));
    list.add(Label{{10, 10}, "P_{0}", rgb(0xFFFFFF), 13.0F, Anchor::left, LabelFont::text});
    list.add(wave(30, rgb(0xFFFFFF)));
    list.add(disc);
    list.add(disc);
    list.add(wave(20, rgb(0xFFFFFF)));
    PictureMesh picture;
    build_picture(picture, list, {400, 300}, 1.0);
    ASSERT_EQ(picture.runs.size(), 3U);
    EXPECT_EQ(picture.runs[0].count, (21U + 31U) * 6U);
    EXPECT_EQ(picture.runs[1].kind, RunKind::marker);
    EXPECT_EQ(picture.runs[1].count, 12U);
    EXPECT_EQ(picture.runs[2].first, (21U + 31U) * 6U);
}

TEST(PictureMesh, darkening_lines_are_painted_one_by_one) {
    DrawList list;
    Polyline hairpin{{{10, 10}, {90, 10}, {20, 12}}, faded(rgb(0xFFFFFF), 0.5), 3.0F, 0.0F, 0.0F, false};
    list.add(hairpin);
    list.add(hairpin);
    PictureMesh picture;
    build_picture(picture, list, {400, 300}, 1.0);
    ASSERT_EQ(picture.runs.size(), 2U);
    EXPECT_EQ(picture.runs[0].kind, RunKind::stroke_once);
    EXPECT_EQ(picture.runs[1].kind, RunKind::stroke_once);
}

}  // namespace
}  // namespace batten::render
