#include "app/editor/state/kept_joints.h"

#include <algorithm>
#include <map>

#include "app/editor/state/point_hues.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

using core::JointMark;

bool is_inner_knot(const core::Curve& curve, double u) {
    const core::Interval domain = curve.domain();
    if (curve.is_periodic() && u == domain.lower) return true;
    return domain.lower < u && u < domain.upper && curve.knots().multiplicity(u) > 0;
}

bool is_reversed(const core::Curve& old, const core::Curve& now) {
    const auto a = old.control_points();
    const auto b = now.control_points();
    return old.degree() == now.degree() && old.knots().stored().size() == now.knots().stored().size() &&
           std::equal(a.begin(), a.end(), b.rbegin(), b.rend()) && !std::ranges::equal(a, b);
}

// Where the knot u of `old` is in `now`: the same one by its number where there are as many, else by its value.
double moved_knot(const core::Curve& old, const core::Curve& now, double u) {
    const auto before = old.knots().stored();
    const auto after = now.knots().stored();
    if (old.degree() != now.degree() || before.size() != after.size() || old.is_periodic() != now.is_periodic())
        return u;
    const auto [first, end] = std::equal_range(before.begin(), before.end(), u);
    if (first == end) return u;
    auto index = static_cast<std::size_t>((first - before.begin()) + (end - first) / 2);
    if (is_reversed(old, now)) index = before.size() - 1 - index;
    return after[index];
}

// What of a curve's marks goes with it from `old` to its present curve.
void follow_knots(const core::Curve& old, core::DocumentCurve& entry) {
    for (core::KnotMark& mark : entry.joints.knots) mark.u = moved_knot(old, *entry.curve, mark.u);
    std::ranges::sort(entry.joints.knots, {}, &core::KnotMark::u);
    if (!is_reversed(old, *entry.curve)) return;
    for (core::EndMark& mark : entry.joints.ends)
        mark.end = mark.end == core::CurveEnd::start ? core::CurveEnd::end : core::CurveEnd::start;
    std::ranges::reverse(entry.joints.ends);
}

// The entry of `before` that `after.curves[i]` was: at its place, else with its curve, else of its name.
const core::DocumentCurve* old_entry(const core::Document& before, const core::Document& after, std::size_t i) {
    if (before.curves.size() == after.curves.size() && before.curves[i].name == after.curves[i].name)
        return &before.curves[i];
    for (const core::DocumentCurve& entry : before.curves)
        if (entry.curve == after.curves[i].curve) return &entry;
    const auto found = core::index_of_curve(before, after.curves[i].name);
    return found ? &before.curves[*found] : nullptr;
}

bool is_new_knot_mark(const core::DocumentCurve* old, const core::KnotMark& mark) {
    return old != nullptr && mark_of_knot(*old, mark.u) != mark.mark;
}

bool is_new_end_mark(const core::DocumentCurve* old, const core::EndMark& mark) {
    return old != nullptr && std::ranges::find(old->joints.ends, mark) == old->joints.ends.end();
}

// What was added to the domain of `old`; empty where nothing was.
core::Interval added_part(const core::Curve& old, const core::Curve& now) {
    const core::Interval before = old.domain();
    const core::Interval after = now.domain();
    if (after.lower == before.lower && after.upper > before.upper) return {before.upper, after.upper};
    if (after.upper == before.upper && after.lower < before.lower) return {after.lower, before.lower};
    return {};
}

// The knot of `now` that u of `joined` became, where that curve is the part `added`, run through as before or not.
std::optional<double> joined_knot(const core::Curve& joined, const core::Curve& now, core::Interval added, double u,
                                  bool is_reversed) {
    constexpr double rounding = 1e-9;
    const core::Interval domain = joined.domain();
    const double share = (is_reversed ? domain.upper - u : u - domain.lower) / domain.length();
    const double wanted = added.lower + share * added.length();
    const auto knots = now.knots().stored();
    const auto above = std::ranges::lower_bound(knots, wanted - rounding * added.length());
    if (above == knots.end() || *above > wanted + rounding * added.length()) return std::nullopt;
    return *above;
}

// The marks of a curve that was joined to another one; none where its knots cannot be told in it.
std::optional<std::vector<core::KnotMark>> joined_marks(const core::DocumentCurve& joined, const core::Curve& now,
                                                        core::Interval added) {
    for (const bool is_reversed : {false, true}) {
        std::vector<core::KnotMark> marks;
        const core::Interval domain = joined.curve->domain();
        bool has_all = true;
        for (const double u : joined.curve->knots().stored())
            has_all = has_all && (!domain.contains(u) || joined_knot(*joined.curve, now, added, u, is_reversed));
        if (!has_all) continue;
        for (const core::KnotMark& mark : joined.joints.knots)
            marks.push_back({*joined_knot(*joined.curve, now, added, mark.u, is_reversed), mark.mark});
        return marks;
    }
    return std::nullopt;
}

int level_of(JointMark mark) {
    return static_cast<int>(mark);
}

// One edit, from the document before it to the one after, whose marks are kept.
class MarkKeeping {
  public:
    MarkKeeping(const core::Document& before, core::Document& after) : before_(before), after_(after) {
        for (std::size_t i = 0; i < after.curves.size(); ++i) old_.push_back(old_entry(before, after, i));
    }

    std::optional<std::string> run() {
        if (!is_concerned()) return std::nullopt;
        for (std::size_t i = 0; i < after_.curves.size(); ++i) follow(i);
        for (const core::DocumentCurve& entry : before_.curves) take_over(entry);
        pair_ends();
        drop_marks_without_knots();
        collect();
        keep();
        return sentence();
    }

  private:
    // Which mark stands behind a joint.
    struct Source {
        std::size_t curve = 0;
        double u = 0.0;                       // of a knot
        std::optional<std::size_t> number{};  // of ends
        JointMark mark{};
    };

    bool is_changed(std::size_t i) const {
        const core::DocumentCurve& entry = after_.curves[i];
        return old_[i] == nullptr || old_[i]->curve != entry.curve || old_[i]->joints != entry.joints;
    }

    bool is_concerned() const {
        for (std::size_t i = 0; i < after_.curves.size(); ++i)
            if (!after_.curves[i].joints.is_empty() && is_changed(i)) return true;
        return std::ranges::any_of(before_.curves, [&](const core::DocumentCurve& entry) {
            return !entry.joints.is_empty() && before_.curves.size() != after_.curves.size();
        });
    }

    void follow(std::size_t i) {
        core::DocumentCurve& entry = after_.curves[i];
        if (old_[i] == nullptr || old_[i]->curve == entry.curve || old_[i]->joints != entry.joints) return;
        follow_knots(*old_[i]->curve, entry);
    }

    // The marks of a curve that is gone go to the one that it was joined to.
    void take_over(const core::DocumentCurve& gone) {
        if (gone.joints.knots.empty() || std::ranges::find(old_, &gone) != old_.end()) return;
        for (std::size_t i = 0; i < after_.curves.size(); ++i) {
            core::DocumentCurve& entry = after_.curves[i];
            if (old_[i] == nullptr || old_[i]->curve == entry.curve) continue;
            const core::Interval added = added_part(*old_[i]->curve, *entry.curve);
            if (!(added.lower < added.upper)) continue;
            const auto marks = joined_marks(gone, *entry.curve, added);
            if (!marks) {
                unknown_.push_back(gone.name);
                continue;
            }
            entry.joints.knots.insert(entry.joints.knots.end(), marks->begin(), marks->end());
            std::ranges::sort(entry.joints.knots, {}, &core::KnotMark::u);
        }
    }

    // Of each number the first two ends belong together; copies of these, and ends that are left alone, are unmarked.
    void pair_ends() {
        std::map<std::size_t, std::vector<DocumentEnd>> ends;
        for (std::size_t i = 0; i < after_.curves.size(); ++i)
            for (const core::EndMark& mark : after_.curves[i].joints.ends) ends[mark.joint].push_back({i, mark.end});
        for (auto& [number, pair] : ends) {
            const std::size_t kept = pair.size() < 2 ? 0 : 2;
            for (std::size_t k = kept; k < pair.size(); ++k) drop_end(pair[k]);
            if (kept == 2) pairs_[number] = {pair[0], pair[1]};
        }
    }

    // An end that was joined to its other end is a knot now.
    void drop_end(DocumentEnd end) {
        core::DocumentCurve& entry = after_.curves[end.curve];
        const core::EndMark mark = *mark_of_end(entry, end.end);
        std::erase(entry.joints.ends, mark);
        if (old_[end.curve] == nullptr) return;
        const double u = core::parameter_of(old_[end.curve]->curve->domain(), end.end);
        if (!is_inner_knot(*entry.curve, u) || mark_of_knot(entry, u)) return;
        entry.joints.knots.push_back({u, mark.mark});
        std::ranges::sort(entry.joints.knots, {}, &core::KnotMark::u);
    }

    void drop_marks_without_knots() {
        for (core::DocumentCurve& entry : after_.curves) {
            if (entry.curve->is_periodic()) entry.joints.ends.clear();
            std::erase_if(entry.joints.knots,
                          [&](const core::KnotMark& mark) { return !is_inner_knot(*entry.curve, mark.u); });
        }
    }

    void collect() {
        for (std::size_t i = 0; i < after_.curves.size(); ++i) {
            const core::DocumentCurve& entry = after_.curves[i];
            curves_.push_back({*entry.curve, old_[i] == nullptr ? nullptr : old_[i]->curve, entry.pinned,
                               entry.locked || entry.fit != nullptr});
            for (const core::KnotMark& mark : entry.joints.knots)
                if (mark.mark != JointMark::corner)
                    add({{i, mark.u, core::Side::left},
                         {i, mark.u, core::Side::right},
                         level_of(mark.mark),
                         is_new_knot_mark(old_[i], mark)},
                        {i, mark.u, std::nullopt, mark.mark});
        }
        for (const auto& [number, pair] : pairs_) {
            const core::EndMark* first = mark_of_end(after_.curves[pair.first.curve], pair.first.end);
            const core::EndMark* second = mark_of_end(after_.curves[pair.second.curve], pair.second.end);
            if (first == nullptr || second == nullptr) continue;
            const bool is_new =
                is_new_end_mark(old_[pair.first.curve], *first) || is_new_end_mark(old_[pair.second.curve], *second);
            add({arm_of(pair.first), arm_of(pair.second), level_of(first->mark), is_new},
                {pair.first.curve, 0.0, number, first->mark});
        }
    }

    void add(const core::KeptJoint& joint, const Source& source) {
        joints_.push_back(joint);
        sources_.push_back(source);
    }

    core::JointArm arm_of(DocumentEnd end) const {
        const core::Interval domain = after_.curves[end.curve].curve->domain();
        return {end.curve, core::parameter_of(domain, end.end),
                end.end == core::CurveEnd::end ? core::Side::left : core::Side::right};
    }

    void keep() {
        core::KeptJoints kept = core::keep_joints(curves_, joints_);
        for (std::size_t i = 0; i < kept.curves.size(); ++i)
            if (kept.curves[i] != *after_.curves[i].curve)
                replace_curve(after_.curves[i], std::make_shared<const core::Curve>(std::move(kept.curves[i])));
        for (const std::size_t k : kept.lost) unmark(sources_[k]);
        lost_ = std::move(kept.lost);
    }

    void unmark(const Source& source) {
        if (!source.number)
            std::erase_if(after_.curves[source.curve].joints.knots,
                          [&](const core::KnotMark& mark) { return mark.u == source.u; });
        for (core::DocumentCurve& entry : after_.curves)
            std::erase_if(entry.joints.ends, [&](const core::EndMark& mark) { return mark.joint == source.number; });
    }

    std::optional<std::string> sentence() const {
        if (lost_.empty() && !unknown_.empty())
            return core::sentence("the marked joints of '{name}' are marked no more", {{"name", unknown_.front()}});
        if (lost_.empty()) return std::nullopt;
        if (lost_.size() > 1)
            return core::sentence("{count} marked joints could not be kept, and their marks are gone",
                                  {{"count", lost_.size()}});
        const Source& source = sources_[lost_.front()];
        const core::Place mark("mark", core::title_of(source.mark));
        if (!source.number)
            return core::sentence("the joint at u = {u} could not be kept {mark}, and its mark is gone",
                                  {{"u", core::shortest_text(source.u)}, mark});
        return core::sentence("the joint at an end of '{name}' could not be kept {mark}, and its mark is gone",
                              {{"name", after_.curves[source.curve].name}, mark});
    }

    const core::Document& before_;
    core::Document& after_;
    std::vector<const core::DocumentCurve*> old_;
    std::map<std::size_t, std::pair<DocumentEnd, DocumentEnd>> pairs_;
    std::vector<core::EditedCurve> curves_;
    std::vector<core::KeptJoint> joints_;
    std::vector<Source> sources_;
    std::vector<std::size_t> lost_;
    std::vector<std::string> unknown_;  // curves whose marks found no knots
};

}  // namespace

std::optional<JointMark> mark_of_knot(const core::DocumentCurve& entry, double u) {
    const auto found = std::ranges::lower_bound(entry.joints.knots, u, {}, &core::KnotMark::u);
    return found != entry.joints.knots.end() && found->u == u ? std::optional(found->mark) : std::nullopt;
}

const core::EndMark* mark_of_end(const core::DocumentCurve& entry, core::CurveEnd end) {
    for (const core::EndMark& mark : entry.joints.ends)
        if (mark.end == end) return &mark;
    return nullptr;
}

std::optional<DocumentEnd> partner_of(const core::Document& document, DocumentEnd end) {
    const core::EndMark* own = mark_of_end(document.curves[end.curve], end.end);
    if (own == nullptr) return std::nullopt;
    for (std::size_t i = 0; i < document.curves.size(); ++i)
        for (const core::EndMark& mark : document.curves[i].joints.ends)
            if (mark.joint == own->joint && DocumentEnd{i, mark.end} != end) return DocumentEnd{i, mark.end};
    return std::nullopt;
}

std::size_t free_joint(const core::Document& document) {
    std::size_t number = 0;
    for (const core::DocumentCurve& entry : document.curves)
        for (const core::EndMark& mark : entry.joints.ends) number = std::max(number, mark.joint + 1);
    return number;
}

std::optional<std::string> keep_marked_joints(const core::Document& before, core::Document& after) {
    return MarkKeeping(before, after).run();
}

}  // namespace batten::editor
