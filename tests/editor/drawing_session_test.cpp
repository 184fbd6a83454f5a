// Whole sessions of drawing: what belongs together stays so, and undo goes back to the first bit.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/editor/commands/drawing_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/fit_point_commands.h"
#include "app/editor/commands/joint_mark_commands.h"
#include "app/editor/commands/making_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/snap_commands.h"
#include "app/editor/commands/symmetry_commands.h"
#include "app/editor/session.h"
#include "app/editor/state/symmetry_links.h"
#include "core/edit/transform.h"
#include "core/make/fit_points.h"
#include "core/make/through_points.h"
#include "tests/editor/random_hand.h"
#include "tests/editor/random_session.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

// A mirrored half, which meets the mirror at a right angle above; a mirrored curve through points; three turned images
// of a rational arc; curves through points of the other kinds; guides.
core::Document first_document() {
    Editor editor;
    const std::vector<Command> commands{
        NewCurve{.points = {{0, 2}, {1, 2}, {3, 1}, {2, -1}, {0, -3}}},
        LinkMirror{.center = {0.0, 0.0}, .angle = 90.0, .is_smooth = true},
        ThroughPoints{.points = {{1, 0}, {3, 2}, {5, 1}, {6, 3}}},
        LinkMirror{.center = {0.0, 0.0}, .angle = 90.0, .is_smooth = false},
        AddArc{.center = {-3.0, 1.0}, .radius = 1.0, .start = 30.0, .sweep = 100.0},
        LinkRotation{.turns = 4, .center = {0.0, 0.0}},
        ThroughPoints{
            .points = {{-5, -2}, {-3, -3}, {-1, -2.5}, {-3, -1}}, .kind = core::FitKind::local, .closed = true},
        SetFitJoint{.index = 1, .joint = core::FitJoint::tangent, .handle = core::Vector(0.5, -0.25)},
        ThroughPoints{.points = {{-6, 3}, {-4, 2.5}, {-2, 3.5}, {0, 3}, {2, 3.5}}, .kind = core::FitKind::fair},
        AddGuide{.position = {0.0, 0.5}, .angle = 0.0},
        AddGuide{.position = {-1.0, 0.0}, .angle = 60.0},
    };
    for (const Command& command : commands) EXPECT_TRUE(editor.run(command)) << editor.state().message.text;
    return document(editor);
}

// The bytes of a saved file; which curve is active is not undone.
std::string bytes_of(core::Document document) {
    document.active = 0;
    return core::format_document(document);
}

bool is_finite(const core::Document& document) {
    for (const core::DocumentCurve& entry : document.curves) {
        for (const core::Point point : entry.curve->control_points())
            if (!core::is_finite(point)) return false;
        if (entry.fit == nullptr) continue;
        for (const core::FitPoint& point : entry.fit->points)
            if (!core::is_finite(point.place) || !core::is_finite(point.handle)) return false;
    }
    return true;
}

// The mirror at x = 0 changes a sign, a quarter turn about (0, 0) swaps coordinates; other images by the map.
core::Point image_of(core::Point point, const core::Symmetry& symmetry) {
    const bool is_about_origin = symmetry.center == core::Point(0.0, 0.0);
    if (is_about_origin && !symmetry.turns && symmetry.angle == 90.0 && symmetry.place == 1) return {-point.x, point.y};
    if (is_about_origin && symmetry.turns == std::optional<std::size_t>(4)) {
        for (std::size_t i = 0; i < symmetry.place; ++i) point = {-point.y, point.x};
        return point;
    }
    return core::mapped(map_to_image(symmetry), point);
}

void expect_image(const core::DocumentCurve& original, const core::DocumentCurve& image) {
    const auto points = original.curve->control_points();
    const auto found = image.curve->control_points();
    ASSERT_EQ(points.size(), found.size());
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(found[i], image_of(points[i], *image.symmetry)) << i;
    EXPECT_EQ(original.curve->knots(), image.curve->knots());
    EXPECT_TRUE(std::ranges::equal(original.curve->weights(), image.curve->weights()));
    EXPECT_EQ(original.pinned, image.pinned);
    ASSERT_EQ(original.fit == nullptr, image.fit == nullptr);
    if (original.fit == nullptr) return;
    EXPECT_EQ(original.fit->parameters, image.fit->parameters);
    ASSERT_EQ(original.fit->points.size(), image.fit->points.size());
    for (std::size_t i = 0; i < original.fit->points.size(); ++i)
        EXPECT_EQ(image.fit->points[i].place, image_of(original.fit->points[i].place, *image.symmetry)) << i;
}

void expect_images(const core::Document& document) {
    for (const core::DocumentCurve& original : document.curves) {
        if (!original.symmetry || original.symmetry->place != 0) continue;
        for (const core::DocumentCurve& image : document.curves)
            if (image.symmetry && image.symmetry->group == original.symmetry->group) expect_image(original, image);
    }
}

// The curve passes its fit points at their parameters.
void expect_fits(const core::Document& document) {
    for (const core::DocumentCurve& entry : document.curves) {
        if (entry.fit == nullptr) continue;
        const auto curve = core::through_points(*entry.fit);
        ASSERT_TRUE(curve);
        EXPECT_EQ(curve->knots(), entry.curve->knots()) << entry.name;
    }
}

std::size_t link_count(const core::Document& document) {
    return static_cast<std::size_t>(std::ranges::count_if(
        document.curves, [](const core::DocumentCurve& entry) { return entry.symmetry.has_value(); }));
}

class DrawingSessions : public ::testing::TestWithParam<unsigned> {
  protected:
    DrawingSessions() {
        open_text(editor_, core::format_document(first_document()));
        for (const core::Named<SnapKind>& kind : core::Names<SnapKind>::table)
            editor_.run(SetSnap{.kind = kind.value, .on = true});
    }

    const EditorState& state() const { return editor_.state(); }

    // A command or a gesture; one in a while makes anew what others have unlinked.
    std::string edit() {
        const std::size_t chance = generator_() % 40;
        const std::size_t logged = editor_.log().size();
        if (chance == 0 && link_count(document(editor_)) < 4)
            editor_.run(LinkMirror{.center = {0.0, 0.0}, .angle = 90.0, .is_smooth = true});
        else if (chance == 1)
            editor_.run(ThroughPoints{.points = {{1, -3}, {2.5, -2}, {4, -3.5}}});
        else if (chance < 5)
            editor_.run(
                MarkJoint{.mark = core::Names<core::JointMark>::table[generator_() % 3].value, .u = any_knot()});
        else if (chance < 26)
            hand_.gesture();
        else
            editor_.perform(commands_.next(state()));
        return editor_.log().size() == logged ? "nothing" : format_command(editor_.log().back());
    }

    // Inside the domain of the active curve, or at an end of it.
    double any_knot() {
        const core::DocumentCurve* entry = document(editor_).active_curve();
        if (entry == nullptr) return 0.0;
        const auto [lower, upper] = entry->curve->domain();
        const auto knots = entry->curve->knots().stored();
        return std::clamp(knots[generator_() % knots.size()], lower, upper);
    }

    Editor editor_;
    std::mt19937 generator_{GetParam()};
    RandomSession commands_{GetParam()};
    test::RandomHand hand_{editor_, GetParam()};
};

TEST_P(DrawingSessions, pitfall_14_500_random_edits_with_links_snaps_and_fit_points_undo_to_the_first_document) {
    const core::Document first = document(editor_);
    std::size_t linked = 0;
    std::size_t fitted = 0;
    for (std::size_t i = 0; state().history.undo_count() < 500 && !HasFailure(); ++i) {
        ASSERT_LT(i, 10'000U);
        const core::Document before = document(editor_);
        SCOPED_TRACE(std::to_string(i) + ": " + edit());
        if (has_same_content(before, document(editor_))) continue;
        linked += link_count(document(editor_));
        for (const core::DocumentCurve& entry : document(editor_).curves) fitted += entry.fit != nullptr ? 1U : 0U;
        ASSERT_TRUE(is_finite(document(editor_)));
        expect_images(document(editor_));
        expect_fits(document(editor_));
        if (state().history.undo_count() % 3 == 0) {
            const auto read = core::parse_document(core::format_document(document(editor_)));
            ASSERT_TRUE(read) << read.error().sentence();
            EXPECT_TRUE(is_same_document(*read, document(editor_)));
        }
    }
    EXPECT_GT(linked, 500U);
    EXPECT_GT(fitted, 500U);
    const std::string last_bytes = bytes_of(document(editor_));
    while (state().history.can_undo()) EXPECT_TRUE(editor_.run(Undo{}));
    EXPECT_EQ(bytes_of(document(editor_)), bytes_of(first));
    EXPECT_TRUE(has_same_content(document(editor_), first));
    while (state().history.can_redo()) EXPECT_TRUE(editor_.run(Redo{}));
    EXPECT_EQ(bytes_of(document(editor_)), last_bytes);
}

INSTANTIATE_TEST_SUITE_P(Seeds, DrawingSessions, ::testing::Range(1U, 5U));

}  // namespace
}  // namespace batten::editor
