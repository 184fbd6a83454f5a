#include "tests/core/document/random_document.h"

#include <array>
#include <span>

#include "core/make/through_points.h"

namespace batten::core {

Document random_document(RandomCurves& random) {
    Document document;
    document.title = "Title \"with\" \\ and \n é";
    for (int i = random.whole(0, 4); i > 0; --i) {
        DocumentCurve entry;
        entry.name = random.whole(0, 1) == 0 ? "same" : std::to_string(i);
        entry.curve = std::make_shared<const Curve>(random.curve());
        if (random.whole(0, 1) == 0) entry.color = DocumentColor{0x4c, 0x7f, 0xe0};
        entry.visible = random.whole(0, 1) == 0;
        entry.locked = random.whole(0, 1) == 0;
        if (random.whole(0, 1) == 0) entry.unknown_members = R"({"z":{"deep":[1,[2.5,{}]]},"a":null})";
        document.curves.push_back(entry);
    }
    if (!document.curves.empty())
        document.active = static_cast<std::size_t>(random.whole(0, static_cast<int>(document.curves.size()) - 1));
    if (random.whole(0, 1) == 0) document.view.parameter = random.number(-9.0, 9.0);
    if (random.whole(0, 1) == 0) document.view.overlays = {"polygon", "knots"};
    if (random.whole(0, 1) == 0) document.view.unknown_members = R"({"zoom":1e-12})";
    if (random.whole(0, 1) == 0) document.unknown_members = R"({"author":"nobody","1":[true]})";
    return document;
}

namespace {

bool by_chance(RandomCurves& random) {
    return random.whole(0, 1) == 0;
}

std::size_t below(RandomCurves& random, std::size_t count) {
    return static_cast<std::size_t>(random.whole(0, static_cast<int>(count) - 1));
}

Point random_point(RandomCurves& random) {
    return {random.number(-1e3, 1e3), random.number(-1e3, 1e3)};
}

void make_fit(RandomCurves& random, DocumentCurve& entry) {
    std::vector<Point> places;
    for (int i = random.whole(3, 7); i > 0; --i) places.push_back(random_point(random));
    constexpr std::array kinds{FitKind::c2, FitKind::local, FitKind::fair};
    constexpr std::array parametrizations{Parametrization::uniform, Parametrization::chordal,
                                          Parametrization::centripetal};
    auto fit = fit_points_at(places, {kinds[below(random, 3)], parametrizations[below(random, 3)], by_chance(random)});
    if (!fit) return;
    if (by_chance(random)) fit->points[1].joint = FitJoint::corner;
    if (by_chance(random)) fit->points[0] = {places[0], FitJoint::tangent, {1.5, -2.0}};
    const auto curve = through_points(*fit);
    if (!curve) return;
    entry.curve = std::make_shared<const Curve>(*curve);
    entry.fit = std::make_shared<const FitPoints>(*std::move(fit));
}

void add_marks(RandomCurves& random, DocumentCurve& entry) {
    const std::span<const double> knots = entry.curve->knots().values();
    for (std::size_t i = 0; i < knots.size(); ++i)
        if (is_inner_knot(*entry.curve, knots[i]) && (i == 0 || knots[i] != knots[i - 1]) && by_chance(random))
            entry.joints.knots.push_back({knots[i], JointMark::corner});
    for (std::size_t i = 0; i < entry.curve->control_points().size(); ++i)
        if (random.whole(0, 3) == 0) entry.pinned.push_back(i);
}

std::optional<Symmetry> random_symmetry(RandomCurves& random) {
    const std::size_t turns = 2 + below(random, 5);
    const Symmetry turned{.group = below(random, 3), .place = below(random, turns), .turns = turns};
    const Symmetry mirrored{.place = below(random, 2),
                            .turns = std::nullopt,
                            .center = random_point(random),
                            .angle = random.number(0, 180)};
    return by_chance(random) ? turned : mirrored;
}

Picture random_picture(RandomCurves& random) {
    return {.path = "/tmp/a picture.png",
            .width = random.whole(1, 1000),
            .height = random.whole(1, 1000),
            .position = random_point(random),
            .scale = random.number(1e-3, 10.0),
            .rotation = random.number(-360, 360),
            .opacity = random.number(0.0, 1.0),
            .visible = by_chance(random),
            .locked = by_chance(random),
            .unknown_members = {}};
}

DocumentUnits random_units(RandomCurves& random) {
    constexpr std::array units{LengthUnit::mm, LengthUnit::inch, LengthUnit::px};
    return {units[below(random, 3)], by_chance(random) ? 1.0 : random.number(1e-3, 1e3)};
}

}  // namespace

Document random_rich_document(RandomCurves& random) {
    Document document = random_document(random);
    for (DocumentCurve& entry : document.curves) {
        if (by_chance(random)) make_fit(random, entry);
        if (by_chance(random)) add_marks(random, entry);
        if (by_chance(random)) entry.group = "parts";
        if (by_chance(random)) entry.tears = Tears::allow;
        if (random.whole(0, 3) == 0) entry.symmetry = random_symmetry(random);
    }
    if (by_chance(random)) document.description = "What to try.";
    if (by_chance(random)) document.pictures.push_back(random_picture(random));
    for (int i = random.whole(0, 2); i > 0; --i)
        document.guides.push_back({random_point(random), random.number(0.0, 179.9)});
    if (by_chance(random)) document.units = random_units(random);
    return document;
}

}  // namespace batten::core
