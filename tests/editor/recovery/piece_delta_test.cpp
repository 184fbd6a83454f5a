#include "app/editor/recovery/piece_delta.h"

#include <gtest/gtest.h>

#include <random>

#include "app/editor/state/same_document.h"
#include "core/edit/point_edit.h"
#include "core/make/fit_points.h"
#include "core/make/through_points.h"
#include "tests/editor/random_session.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

core::DocumentCurve entry_of(std::string name, core::CurveDefinition definition) {
    core::DocumentCurve entry;
    entry.name = std::move(name);
    entry.curve = std::make_shared<const core::Curve>(core::Curve::make(std::move(definition)).value());
    return entry;
}

// A polyline of so many points.
core::CurveDefinition polyline(std::size_t count) {
    core::CurveDefinition definition{.degree = 1};
    for (std::size_t i = 0; i < count; ++i) {
        definition.points.emplace_back(0.5 * static_cast<double>(i), 1.0);
        definition.knots.push_back(static_cast<double>(i));
    }
    definition.knots.insert(definition.knots.begin(), 0.0);
    definition.knots.push_back(definition.knots.back());
    return definition;
}

core::DocumentCurve moved(core::DocumentCurve entry, std::size_t i, core::Point place) {
    entry.curve = std::make_shared<const core::Curve>(core::set_control_point(*entry.curve, i, place).value());
    return entry;
}

// Bit for bit: also the sign of a zero.
void expect_equal(const core::Document& found, const core::Document& expected) {
    EXPECT_TRUE(is_same_document(found, expected));
    EXPECT_EQ(found.active, expected.active);
    const DocumentPieces a = pieces_of(found);
    const DocumentPieces b = pieces_of(expected);
    EXPECT_TRUE(a == b);
}

// A document with everything that one can have.
core::Document full_document() {
    core::Document document;
    document.title = "Wörter\n";
    document.description = std::string("a\0b", 3);
    document.curves.push_back(entry_of("rational", {.degree = 2,
                                                    .knots = {0, 0, 0, 1e-300, 1e300, 1e300, 1e300},
                                                    .points = {{-0.0, 0.0}, {1e6, 0.1}, {1e6 + 1e-9, -1e308}, {3, 4}},
                                                    .weights = {1, 0.5, 1e-12, 1e12}}));
    document.curves.push_back(entry_of("ring", {.degree = 3,
                                                .knots = {0, 1, 2, 4, 5, 6},
                                                .points = {{0, 0}, {2, 0}, {3, 2}, {1, 3}, {-1, 2}},
                                                .periodic = true}));
    document.curves.push_back(entry_of("torn", {.degree = 1,
                                                .knots = {0, 0, 1, 1, 2, 2},
                                                .points = {{0, 0}, {1, 0}, {1, 1}, {2, 1}},
                                                .tears = core::Tears::allow}));
    document.curves.push_back(entry_of("bezier", {.degree = 3,
                                                  .knots = {0, 0, 0, 0, 1, 1, 1, 1},
                                                  .points = {{0, 0}, {1, 2}, {3, 2}, {4, 0}},
                                                  .kind = core::KnotKind::bezier}));
    core::DocumentCurve& ring = document.curves[1];
    ring.color = core::DocumentColor{1, 128, 255};
    ring.visible = false;
    ring.locked = true;
    ring.tears = core::Tears::allow;
    ring.pinned = {0, 4};
    ring.symmetry = core::Symmetry{.group = 3, .place = 1, .turns = 5, .center = {-0.0, 2}, .unknown_members = "{}"};
    ring.joints.knots = {{.u = 0.0, .mark = core::JointMark::curvature, .unknown_members = R"({"a":1})"}};
    ring.unknown_members = R"({"far":[1,2]})";
    ring.point_hues = std::make_shared<const std::vector<std::uint8_t>>(std::vector<std::uint8_t>{4, 3, 2, 1, 0});
    ring.group = "both";
    document.curves[3].joints.ends = {{.end = core::CurveEnd::start, .joint = 7, .mark = core::JointMark::corner}};
    const auto fit = core::fit_points_at(std::vector<core::Point>{{0, 0}, {1, 3}, {2, -1}}, core::FitForm{}).value();
    core::DocumentCurve through;
    through.curve = std::make_shared<const core::Curve>(core::through_points(fit).value());
    through.fit = std::make_shared<const core::FitPoints>(fit);
    through.unknown_fit_members = R"({"b":2})";
    document.curves.push_back(through);
    document.active = 4;
    document.pictures.push_back(
        {.path = "/a/b.png", .width = 3, .height = 4, .rotation = 30.0, .locked = true, .unknown_members = "{}"});
    document.guides.push_back({.point = {1, 2}, .angle = 45.0});
    document.units = core::DocumentUnits{core::LengthUnit::inch, 2.5, "{}"};
    document.view.parameter = 0.25;
    document.view.overlays = {"grid", "polygon"};
    document.view.notation = {{"points", "P"}};
    document.unknown_members = R"({"c":null})";
    return document;
}

TEST(DocumentPieces, give_the_document_back_bit_for_bit) {
    const core::Document document = full_document();
    const auto back = document_of(pieces_of(document));
    ASSERT_TRUE(back) << back.error();
    expect_equal(*back, document);
    EXPECT_EQ(back->curves[1].tears, core::Tears::allow);
    EXPECT_TRUE(std::signbit(back->curves[0].curve->control_points()[0].x));
    EXPECT_EQ(back->curves[3].curve->knots().kind(), core::KnotKind::bezier);
    EXPECT_EQ(*back->curves[1].point_hues, *document.curves[1].point_hues);
    EXPECT_EQ(*back->curves[4].fit, *document.curves[4].fit);
    expect_equal(document_of(pieces_of({})).value(), {});
}

TEST(DocumentPieces, that_are_damaged_are_refused) {
    const DocumentPieces pieces = pieces_of(full_document());
    EXPECT_FALSE(document_of({}));
    std::mt19937 random(3);
    std::size_t refused = 0;
    for (int i = 0; i < 3000; ++i) {
        DocumentPieces damaged = pieces;
        Piece& piece = damaged[random() % damaged.size()][random() % 4];
        std::string bytes(piece.bytes);
        if (bytes.empty()) continue;
        if (i % 3 == 0)
            bytes.resize(random() % bytes.size());
        else
            bytes[random() % bytes.size()] = static_cast<char>(random());
        piece = piece_of(bytes);
        if (!document_of(damaged)) ++refused;  // others are other documents, without harm
    }
    EXPECT_GT(refused, 1000U);
}

TEST(PieceDelta, of_a_point_that_moved_is_small_whatever_the_curve) {
    core::Document before;
    before.curves = {entry_of("long", polyline(1'000'000)), entry_of("short", polyline(3))};
    core::Document after = before;
    after.curves[0] = moved(after.curves[0], 400'000, {-3.25, 7.5});
    const DocumentPieces previous = pieces_of(before);
    EXPECT_GT(delta_between({}, previous).size(), 32'000'000U);
    const std::string delta = delta_between(previous, pieces_of(after));
    EXPECT_LT(delta.size(), 64U);
    const auto next = with_delta(previous, delta);
    ASSERT_TRUE(next);
    expect_equal(document_of(*next).value(), after);
    EXPECT_LT(delta_between(previous, previous).size(), 4U);
}

TEST(PieceDelta, of_curves_that_moved_in_the_list_is_small) {
    core::Document before;
    for (int i = 0; i < 1000; ++i) before.curves.push_back(entry_of("curve " + std::to_string(i), polyline(50)));
    const DocumentPieces previous = pieces_of(before);
    core::Document after = before;
    after.curves.erase(after.curves.begin());
    std::swap(after.curves[10], after.curves[700]);
    after.curves.insert(after.curves.begin() + 500, moved(after.curves[500], 3, {0, 0}));
    const std::string delta = delta_between(previous, pieces_of(after));
    EXPECT_LT(delta.size(), 200U);
    expect_equal(document_of(with_delta(previous, delta).value()).value(), after);
}

TEST(PieceDelta, of_random_sessions_lead_to_the_same_documents) {
    for (unsigned seed = 1; seed <= 6; ++seed) {
        Editor editor;
        open_text(editor, sample_text);
        RandomSession session(seed);
        DocumentPieces written;
        DocumentPieces read;
        for (int i = 0; i < 150; ++i) {
            editor.perform(session.next(editor.state()));
            DocumentPieces next = pieces_of(document(editor));
            const auto told = with_delta(read, delta_between(written, next));
            ASSERT_TRUE(told) << seed << ", " << i;
            read = *told;
            written = std::move(next);
            const auto found = document_of(read);
            ASSERT_TRUE(found) << seed << ", " << i << ": " << found.error();
            expect_equal(*found, document(editor));
            if (HasFailure()) return;
        }
    }
}

TEST(PieceDelta, that_is_damaged_does_no_harm) {
    const DocumentPieces first = pieces_of(full_document());
    core::Document changed = full_document();
    changed.curves.pop_back();
    changed.active = 0;
    changed.curves[0].name = "another";
    const std::string delta = delta_between(first, pieces_of(changed));
    for (std::size_t size = 0; size < delta.size(); ++size) {
        const auto next = with_delta(first, std::string_view(delta).substr(0, size));
        if (next && !next->empty()) static_cast<void>(document_of(*next));
    }
    std::mt19937 random(5);
    for (int i = 0; i < 3000; ++i) {
        std::string damaged = delta;
        for (int k = 0; k < 3; ++k) damaged[random() % damaged.size()] = static_cast<char>(random());
        const auto next = with_delta(first, damaged);
        if (next && !next->empty()) static_cast<void>(document_of(*next));
    }
}

}  // namespace
}  // namespace batten::editor
