#include "app/ui/frame_areas.h"

#include <gtest/gtest.h>

namespace batten::ui {
namespace {

editor::View presenting(bool has_plots) {
    editor::View view;
    view.is_presenting = true;
    view.overlays.show(editor::Overlay::curvature_plot, has_plots);
    view.overlays.show(editor::Overlay::speed_plot, has_plots);
    return view;
}

TEST(FrameAreas, a_projector_is_for_the_curve_unless_plots_were_asked_for) {
    // 36 hundredths of 1080, and half of it.
    EXPECT_LE(arrange({1920, 1080}, presenting(false), 1.5, false).dock.size_px.y, 389.0);
    const FrameAreas areas = arrange({1920, 1080}, presenting(true), 1.5, false);
    EXPECT_GE(areas.dock.size_px.y, 500.0);
    EXPECT_LE(areas.dock.size_px.y, 540.0);
    EXPECT_DOUBLE_EQ(areas.canvas.size_px.y + areas.dock.size_px.y + areas.status_bar.size_px.y, 1080.0);
}

}  // namespace
}  // namespace batten::ui
