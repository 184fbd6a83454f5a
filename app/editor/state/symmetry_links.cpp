#include "app/editor/state/symmetry_links.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "app/editor/state/fit_curve.h"
#include "app/editor/state/point_hues.h"
#include "app/editor/words/refusal.h"
#include "core/base/sentence.h"
#include "core/curve/control_box.h"
#include "core/edit/transform.h"

namespace batten::editor {

namespace {

// What of the size of a curve counts as rounding when an end lies on a mirror, or meets it at a right angle.
constexpr double rounding = 1e-9;

core::PlaneMap map_by(const core::Symmetry& symmetry, double sign) {
    if (!symmetry.turns)
        return symmetry.place == 0 ? core::PlaneMap{} : core::reflection(symmetry.angle, symmetry.center);
    const double share = static_cast<double>(symmetry.place) / static_cast<double>(*symmetry.turns);
    return core::rotation(sign * 360.0 * share, symmetry.center);
}

// Where a clamped end of a curve lies beside the line of a mirror.
struct End {
    std::size_t end;
    std::size_t inner;  // its neighbor
};

std::vector<End> clamped_ends(const core::Curve& curve) {
    if (curve.is_periodic()) return {};
    std::vector<End> ends;
    const auto knots = curve.knots().values();
    const std::size_t last = curve.control_points().size() - 1;
    if (knots[1] == curve.domain().lower) ends.push_back({0, 1});
    if (knots[knots.size() - 2] == curve.domain().upper) ends.push_back({last, last - 1});
    return ends;
}

// Seen along the line: how far along it, and how far to its left.
struct SeenFromMirror {
    core::Vector along;
    core::Vector across;
    core::Point center;

    explicit SeenFromMirror(const core::Symmetry& mirror) : center(mirror.center) {
        const core::PlaneMap turn = core::rotation(mirror.angle, {0.0, 0.0});
        along = {turn.rows[0][0], turn.rows[1][0]};
        across = {-along.y, along.x};
    }
    double height(core::Point point) const { return core::dot(point - center, across); }
    double place(core::Point point) const { return core::dot(point - center, along); }
    core::Point foot(core::Point point) const { return center + place(point) * along; }
};

bool is_right_angle(const SeenFromMirror& seen, core::Point end, core::Point inner) {
    const double turned = std::abs(seen.place(inner) - seen.place(end));
    return turned <= rounding * core::distance(inner, end);
}

bool runs_along(const SeenFromMirror& seen, core::Point end, core::Point inner) {
    return std::abs(seen.height(inner) - seen.height(end)) <= rounding * core::distance(inner, end);
}

core::Point mended(const SeenFromMirror& seen, core::Point end, core::Point inner) {
    return end + core::dot(inner - end, seen.across) * seen.across;
}

double degrees_between(core::Vector a, core::Vector b) {
    return 180.0 / std::numbers::pi * std::atan2(std::abs(core::cross(a, b)), core::dot(a, b));
}

double size_of(const core::Curve& curve) {
    return core::length(core::control_box(curve).size());
}

// Whether points stand elsewhere by more than rounding.
bool is_elsewhere(const core::Curve& curve, const core::Curve& other) {
    const double tolerance = rounding * size_of(curve);
    return !std::ranges::equal(curve.control_points(), other.control_points(),
                               [&](core::Point a, core::Point b) { return core::distance(a, b) <= tolerance; });
}

// Ends that were on the mirror stay there, and at a right angle to it where they were.
core::Result<core::Curve> with_seams_of(const core::Curve& old, const core::Curve& curve,
                                        const core::Symmetry& mirror) {
    const SeenFromMirror seen(mirror);
    const auto old_points = old.control_points();
    core::CurveDefinition definition = curve.definition();
    const auto old_ends = clamped_ends(old);
    for (const End& now : clamped_ends(curve)) {
        const auto was =
            std::ranges::find_if(old_ends, [&](const End& one) { return (one.end == 0) == (now.end == 0); });
        if (was == old_ends.end()) continue;
        if (std::abs(seen.height(old_points[was->end])) > rounding * size_of(old)) continue;
        core::Point& end = definition.points[now.end];
        core::Point& inner = definition.points[now.inner];
        const bool was_right = is_right_angle(seen, old_points[was->end], old_points[was->inner]);
        end = seen.foot(end);
        if (was_right && curve.degree() > 1) inner = mended(seen, end, inner);
    }
    return core::Curve::make(std::move(definition));
}

std::shared_ptr<const core::FitPoints> image_of_fit(const std::shared_ptr<const core::FitPoints>& fit,
                                                    const core::PlaneMap& map) {
    return fit == nullptr ? nullptr : std::make_shared<const core::FitPoints>(mapped_fit(*fit, map));
}

using Members = std::vector<std::size_t>;

std::map<std::size_t, Members> groups_of(const core::Document& document) {
    std::map<std::size_t, Members> groups;
    for (std::size_t i = 0; i < document.curves.size(); ++i)
        if (document.curves[i].symmetry) groups[document.curves[i].symmetry->group].push_back(i);
    return groups;
}

// The images before the edit, found by group and place.
class OldImages {
  public:
    explicit OldImages(const core::Document& before) {
        for (const core::DocumentCurve& entry : before.curves)
            if (entry.symmetry) images_.emplace(std::pair(entry.symmetry->group, entry.symmetry->place), &entry);
    }

    // Null for a new one.
    const core::DocumentCurve* same(const core::Symmetry& symmetry) const {
        const auto found = images_.find({symmetry.group, symmetry.place});
        return found == images_.end() ? nullptr : found->second;
    }

  private:
    std::map<std::pair<std::size_t, std::size_t>, const core::DocumentCurve*> images_;
};

void unlink_copies(core::Document& document) {
    std::set<std::pair<std::size_t, std::size_t>> seen;
    for (core::DocumentCurve& entry : document.curves)
        if (entry.symmetry && !seen.emplace(entry.symmetry->group, entry.symmetry->place).second)
            entry.symmetry.reset();
}

bool is_as_it_was(const core::DocumentCurve& old, const core::DocumentCurve& now) {
    return old.curve == now.curve && old.symmetry == now.symmetry && old.pinned == now.pinned && old.fit == now.fit &&
           old.joints.knots == now.joints.knots;
}

// The member that leads; none where the edit changed none of them.
std::optional<std::size_t> leader_of(const OldImages& before, const core::Document& after, const Members& members) {
    std::optional<std::size_t> leader;
    for (const std::size_t i : members) {
        const core::DocumentCurve* old = before.same(*after.curves[i].symmetry);
        if (old != nullptr && is_as_it_was(*old, after.curves[i])) continue;
        if (!leader || i == after.active) leader = i;
    }
    return leader;
}

// Whether the edit had an end elsewhere than the mirror lets it be.
Outcome<bool> follow(const OldImages& before, core::Document& after, const Members& members, std::size_t leader) {
    const core::Symmetry symmetry = *after.curves[leader].symmetry;
    auto original = core::transform(*after.curves[leader].curve, map_from_image(symmetry));
    std::shared_ptr<const core::FitPoints> fit = image_of_fit(after.curves[leader].fit, map_from_image(symmetry));
    const core::DocumentCurve* old = before.same(symmetry);
    bool is_held = false;
    if (original && old != nullptr && !symmetry.turns) {
        const auto old_original = core::transform(*old->curve, map_from_image(*old->symmetry));
        auto seamed = old_original ? with_seams_of(*old_original, *original, symmetry) : original;
        // A curve whose seam had to be mended is not the one through its fit points any more.
        if (seamed && *seamed != *original) fit.reset();
        is_held = seamed && is_elsewhere(*original, *seamed);
        original = std::move(seamed);
    }
    if (!original) return refused(after.units, original.error());
    const std::vector<std::size_t> pinned = after.curves[leader].pinned;
    const std::vector<core::KnotMark> marks = after.curves[leader].joints.knots;
    for (const std::size_t i : members) {
        core::DocumentCurve& entry = after.curves[i];
        auto image = core::transform(*original, map_to_image(*entry.symmetry));
        if (!image) return refused(after.units, image.error());
        // One that is new, as of a file that is added, is what it should be already.
        const bool is_new = before.same(*entry.symmetry) == nullptr;
        if (entry.locked && is_new && !is_elsewhere(*image, *entry.curve)) continue;
        if (entry.locked)
            return tl::unexpected(core::sentence("'{name}' is locked, and it is an image of the curve; unlock it first",
                                                 {{"name", entry.name}}));
        replace_curve(entry, std::make_shared<const core::Curve>(*std::move(image)));
        entry.fit = image_of_fit(fit, map_to_image(*entry.symmetry));
        entry.pinned = pinned;
        entry.joints.knots = marks;
    }
    return is_held;
}

}  // namespace

core::PlaneMap map_to_image(const core::Symmetry& symmetry) {
    return map_by(symmetry, 1.0);
}

core::PlaneMap map_from_image(const core::Symmetry& symmetry) {
    return map_by(symmetry, -1.0);
}

core::Symmetry mapped_symmetry(core::Symmetry symmetry, const core::PlaneMap& map) {
    const core::PlaneMap turn = core::rotation(symmetry.angle, {0.0, 0.0});
    const core::Point ahead = core::mapped(map, symmetry.center + core::Vector(turn.rows[0][0], turn.rows[1][0]));
    symmetry.center = core::mapped(map, symmetry.center);
    if (symmetry.turns) return symmetry;
    const core::Vector way = ahead - symmetry.center;
    // A map that leaves the direction leaves the number, which need not be what atan2 makes of it.
    if (!(std::abs(way.x * turn.rows[1][0] - way.y * turn.rows[0][0]) <= rounding * core::length(way)))
        symmetry.angle = 180.0 / std::numbers::pi * std::atan2(way.y, way.x);
    return symmetry;
}

std::size_t free_group(const core::Document& document) {
    std::size_t group = 0;
    for (const core::DocumentCurve& entry : document.curves)
        if (entry.symmetry) group = std::max(group, entry.symmetry->group + 1);
    return group;
}

Outcome<std::vector<std::string>> keep_symmetry(const core::Document& before, core::Document& after) {
    std::vector<std::string> told;
    unlink_copies(after);
    const OldImages old(before);
    for (const auto& [group, members] : groups_of(after)) {
        if (members.size() == 1) {
            after.curves[members.front()].symmetry.reset();
            continue;
        }
        const auto leader = leader_of(old, after, members);
        if (!leader) continue;
        const auto is_held = follow(old, after, members, *leader);
        if (!is_held) return tl::unexpected(is_held.error());
        if (*is_held)
            told.push_back(
                core::sentence("ends of '{name}' stay on the mirror, and at right angles to it where they were",
                               {{"name", after.curves[*leader].name}}));
    }
    return told;
}

core::Result<SeatedCurve> with_ends_on_mirror(const core::Curve& curve, const core::Symmetry& mirror, double reach,
                                              bool is_smooth) {
    const SeenFromMirror seen(mirror);
    core::CurveDefinition definition = curve.definition();
    std::vector<SeatedEnd> seated;
    for (const End& one : clamped_ends(curve)) {
        core::Point& end = definition.points[one.end];
        core::Point& inner = definition.points[one.inner];
        if (!(std::abs(seen.height(end)) <= reach)) continue;
        SeatedEnd now{one.end == 0 ? core::CurveEnd::start : core::CurveEnd::end, std::abs(seen.height(end))};
        end = seen.foot(end);
        if (is_smooth && !is_right_angle(seen, end, inner)) {
            now.keeps_corner = curve.degree() == 1 || runs_along(seen, end, inner);
            const core::Point old = std::exchange(inner, now.keeps_corner ? inner : mended(seen, end, inner));
            now.turned = now.keeps_corner ? 0.0 : degrees_between(old - end, inner - end);
        }
        seated.push_back(now);
    }
    return core::Curve::make(std::move(definition)).map([&](core::Curve made) {
        return SeatedCurve{std::move(made), std::move(seated)};
    });
}

}  // namespace batten::editor
