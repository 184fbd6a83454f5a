// Measures the painter: the time from a draw list to finished pixels, and how much of it the processor spends on
// triangles.
#include <glad/gl.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>
#include <vector>

#include "render/picture_mesh.h"
#include "tests/render/offscreen.h"

namespace {

using namespace batten::render;
using Clock = std::chrono::steady_clock;

constexpr glm::ivec2 size_px{1440, 900};

double microseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

struct Times {
    double best_us = 0.0;
    double median_us = 0.0;
    double processor_us = 0.0;  // the least that all threads took together: hardly disturbed by other programs
};

/// The times of one call out of many.
template <typename Function>
Times measure(Function function) {
    constexpr std::size_t calls = 200;
    std::vector<double> times;
    std::clock_t least_ticks = std::numeric_limits<std::clock_t>::max();
    for (std::size_t i = 0; i < calls; ++i) {
        const std::clock_t first_tick = std::clock();
        const Clock::time_point start = Clock::now();
        function();
        times.push_back(microseconds_since(start));
        least_ticks = std::min(least_ticks, std::clock() - first_tick);
    }
    std::sort(times.begin(), times.end());
    return {times.front(), times[calls / 2], 1e6 * static_cast<double>(least_ticks) / CLOCKS_PER_SEC};
}

Polyline line(std::vector<Pixel> points, float width_px, Color color) {
    return {std::move(points), color, width_px, 0.0F, 0.0F, false};
}

Pixel on_curve(double t) {
    return Pixel(80.0 + 1280.0 * t, 450.0 + 300.0 * std::sin(9.0 * t));
}

DrawList grid() {
    DrawList list;
    for (int i = 0; i < 18; ++i) {
        const float x = 40.5F + 80.0F * static_cast<float>(i);
        list.add(line({{x, 0.0F}, {x, 900.0F}}, 1.0F, rgb(0x1D2027)));
    }
    for (int i = 0; i < 12; ++i) {
        const float y = 20.5F + 75.0F * static_cast<float>(i);
        list.add(line({{0.0F, y}, {1440.0F, y}}, 1.0F, rgb(0x262A33)));
    }
    return list;
}

DrawList curve(Color color) {
    std::vector<Pixel> points;
    for (int i = 0; i < 200; ++i) points.push_back(on_curve(i / 199.0));
    DrawList list;
    list.add(line(points, 3.0F, color));
    return list;
}

DrawList loop(Color color) {
    std::vector<Pixel> points;
    for (int i = 0; i < 200; ++i) {
        const double u = i / 199.0 * 6.28;
        points.emplace_back(720.0 + 600.0 * std::sin(2.0 * u), 450.0 + 350.0 * std::sin(3.0 * u));
    }
    DrawList list;
    list.add(line(points, 3.0F, color));
    return list;
}

DrawList polygon() {
    DrawList list;
    std::vector<Pixel> points;
    for (int i = 0; i < 8; ++i)
        points.emplace_back(80.0F + 180.0F * static_cast<float>(i), i % 2 == 0 ? 800.0F : 120.0F);
    list.add(Polyline{points, rgb(0x5F6878), 1.5F, 6.0F, 4.0F, false});
    return list;
}

DrawList markers() {
    DrawList list;
    for (int i = 0; i < 40; ++i) {
        const MarkerShape shape = i % 3 == 0 ? MarkerShape::diamond : MarkerShape::disc;
        list.add(Marker{on_curve(i / 39.0), shape, 6.5F, rgb(0xE69F00), rgb(0x14161B), 1.5F, 0.0F});
    }
    return list;
}

DrawList hull() {
    DrawList list;
    list.add(Fill{{{260, 120}, {900, 90}, {1100, 600}, {700, 800}, {300, 500}}, {90, 169, 255, 26}});
    return list;
}

DrawList line_quads(int count) {
    DrawList list;
    for (int i = 0; i < count; ++i) {
        const Pixel from(14 * (i % 100) + 10, 9 * (i / 100 % 100) + 5);
        list.add(line({from, from + Pixel(9.0F, 5.0F)}, 1.5F, rgb(0xF1F4F9)));
    }
    return list;
}

DrawList joined(const std::vector<DrawList>& lists) {
    DrawList all;
    for (const DrawList& list : lists)
        all.commands.insert(all.commands.end(), list.commands.begin(), list.commands.end());
    return all;
}

void report(GlPainter& painter, const Viewport& viewport, const char* name, const DrawList& list) {
    PictureMesh picture;
    const Times mesh = measure([&] { build_picture(picture, list, viewport.size_px, 1.0); });
    const Times paint = measure([&] {
        painter.paint(list, viewport, rgb(0x14161B), 1.0F);
        glFinish();
    });
    const std::size_t triangles =
        (picture.fills.indices.size() + picture.strokes.indices.size() + picture.markers.indices.size()) / 3;
    std::printf("%-36s %8.0f %8.0f %8.0f %8.0f %9zu %5zu\n", name, paint.best_us, paint.median_us, paint.processor_us,
                mesh.best_us, triangles, picture.runs.size());
}

}  // namespace

int main() {
    const batten::test::OffscreenContext context;
    auto painter = GlPainter::make();
    if (!painter) {
        std::fprintf(stderr, "%s\n", painter.error().c_str());
        return 1;
    }
    const batten::test::OffscreenTarget target(size_px);
    const Viewport viewport = target.viewport();
    const Color white = rgb(0xF1F4F9);
    std::printf("%s, %d x %d\n\n", reinterpret_cast<const char*>(glGetString(GL_RENDERER)), size_px.x, size_px.y);
    std::printf("%-36s %8s %8s %8s %8s %9s %5s\n", "microseconds a frame", "best", "median", "cpu", "mesh", "triangles",
                "runs");
    report(*painter, viewport, "nothing: only cleared", {});
    report(*painter, viewport, "grid, 30 lines", grid());
    report(*painter, viewport, "curve, 200 points", curve(white));
    report(*painter, viewport, "translucent curve", curve(faded(white, 0.35)));
    report(*painter, viewport, "curve crossing itself", loop(white));
    report(*painter, viewport, "translucent curve crossing itself", loop(faded(white, 0.35)));
    report(*painter, viewport, "dashed polygon, 7 legs", polygon());
    report(*painter, viewport, "40 markers", markers());
    report(*painter, viewport, "hull, 400,000 pixels", hull());
    report(*painter, viewport, "frame: grid, curve, polygon, markers",
           joined({grid(), curve(white), polygon(), markers()}));
    report(*painter, viewport, "frame with hull and ghost",
           joined({grid(), hull(), loop(faded(white, 0.35)), curve(white), polygon(), markers()}));
    report(*painter, viewport, "10,000 line quads", line_quads(10000));
    return pending_gl_error().empty() ? 0 : 1;
}
