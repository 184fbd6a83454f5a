#include "app/editor/state/kept_joints.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "app/editor/state/followed_marks.h"
#include "app/editor/state/old_entries.h"
#include "app/editor/state/point_hues.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

using core::JointMark;

bool has_marks(const core::Document& document) {
    return std::ranges::any_of(document.curves,
                               [](const core::DocumentCurve& entry) { return !entry.joints.is_empty(); });
}

bool is_new_knot_mark(const core::DocumentCurve* old, const core::KnotMark& mark) {
    return old != nullptr && mark_of_knot(*old, mark.u) != mark.mark;
}

bool is_new_end_mark(const core::DocumentCurve* old, const core::EndMark& mark) {
    return old != nullptr && std::ranges::find(old->joints.ends, mark) == old->joints.ends.end();
}

int level_of(JointMark mark) {
    return static_cast<int>(mark);
}

// One edit, from the document before it to the one after, whose marks are kept.
class MarkKeeping {
  public:
    MarkKeeping(const core::Document& before, core::Document& after, bool holds_images)
        : before_(before), after_(after), holds_images_(holds_images) {}

    std::vector<std::string> run() {
        if (!has_marks(before_) && !has_marks(after_)) return {};
        old_ = old_entries(before_, after_);
        if (!is_concerned()) return {};
        for (std::size_t i = 0; i < after_.curves.size(); ++i) follow(i);
        for (const core::DocumentCurve& entry : before_.curves) take_over(entry);
        for (std::size_t i = 0; i < after_.curves.size(); ++i) drop_ends_left(i);
        seat_ends();
        pair_ends();
        drop_marks_without_knots();
        collect();
        keep();
        return sentences();
    }

  private:
    // Which mark stands behind a joint.
    struct Source {
        std::size_t curve = 0;
        double u = 0.0;                       // of a knot
        std::optional<std::size_t> number{};  // of ends
        JointMark mark{};
    };

    // An end that its curve has left.
    struct LeftEnd {
        std::size_t number = 0;
        std::size_t curve = 0;
        bool is_knot = false;  // the place is a knot of the curve now
    };

    // Whether the curve is not to be changed, because others are its images.
    bool is_image(std::size_t i) const { return holds_images_ && after_.curves[i].symmetry.has_value(); }

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
        if (old_[i] == nullptr || old_[i]->curve == entry.curve) return;
        if (old_[i]->joints.knots == entry.joints.knots) {
            follow_knots(*old_[i]->curve, entry);
            knots_met_ = knots_met_ || entry.joints.knots.size() < old_[i]->joints.knots.size();
        }
        if (old_[i]->joints.ends == entry.joints.ends) follow_ends(*old_[i]->curve, entry);
    }

    // Which curve had the marks of the ends of `after_.curves[i]`: it itself, or of a new one that of which it is made.
    const core::DocumentCurve* origin_of(std::size_t i, const core::EndMark& mark) const {
        if (old_[i] != nullptr) return old_[i];
        const auto found = std::ranges::find_if(before_.curves, [&](const core::DocumentCurve& entry) {
            return std::ranges::find(entry.joints.ends, mark) != entry.joints.ends.end();
        });
        return found == before_.curves.end() ? nullptr : &*found;
    }

    // Whether the end that is marked is the one that was: at its place, or moved there by an edit of its curve.
    bool is_old_end(std::size_t i, const core::EndMark& mark) const {
        const core::DocumentCurve* origin = origin_of(i, mark);
        const core::Curve& now = *after_.curves[i].curve;
        if (origin == nullptr || origin->curve == after_.curves[i].curve || origin->curve->is_periodic()) return true;
        if (origin->fit != nullptr && after_.curves[i].fit != nullptr && old_[i] != nullptr) return true;
        bool is_new = true;
        for (const core::EndMark& old : origin->joints.ends) {
            if (old.joint != mark.joint) continue;
            is_new = false;
            const bool has_parameter =
                core::parameter_of(origin->curve->domain(), old.end) == core::parameter_of(now.domain(), mark.end);
            if (old_[i] != nullptr && old.end == mark.end && has_parameter) return true;
            if (is_reversed(*origin->curve, now) && old.end != mark.end) return true;
            if (is_at_old_place(*origin->curve, old.end, now, mark.end)) return true;
        }
        return is_new;
    }

    // A curve that was cut, or goes on, has other ends than those that were marked.
    void drop_ends_left(std::size_t i) {
        if (after_.curves[i].curve->is_periodic()) return drop_ends_closed(i);
        for (const core::EndMark& mark : std::vector(after_.curves[i].joints.ends))
            if (!is_old_end(i, mark)) left_.push_back({mark.joint, i, drop_end({i, mark.end})});
    }

    // Both ends that were one joint are the seam of a curve that was closed.
    void drop_ends_closed(std::size_t i) {
        core::DocumentCurve& entry = after_.curves[i];
        const std::vector<core::EndMark> ends = std::exchange(entry.joints.ends, {});
        const double seam = entry.curve->domain().lower;
        const bool is_seam = ends.size() == 2 && ends[0].joint == ends[1].joint;
        if (is_seam && !mark_of_knot(entry, seam))
            entry.joints.knots.insert(entry.joints.knots.begin(), {seam, ends[0].mark, {}});
        for (const core::EndMark& mark : ends) left_.push_back({mark.joint, i, is_seam});
    }

    // Where a marked end of a curve is that of another one now, as where curves are joined, that one is marked.
    void seat_ends() {
        const auto before = ends_by_joint(before_);
        const auto after = ends_by_joint(after_);
        for (const auto& [number, pair] : before) {
            if (pair.size() != 2) continue;
            const auto found = after.find(number);
            std::size_t missing = 2 - std::min<std::size_t>(2, found == after.end() ? 0 : found->second.size());
            for (const DocumentEnd& end : pair)
                if (missing > 0 && seat(end, number)) --missing;
        }
    }

    // Whether a curve that has changed ends where `old` was.
    bool seat(DocumentEnd old, std::size_t number) {
        const core::DocumentCurve& owner = before_.curves[old.curve];
        const core::EndMark mark = *mark_of_end(owner, old.end);
        if (owner.curve->is_periodic()) return false;
        for (std::size_t i = 0; i < after_.curves.size(); ++i) {
            core::DocumentCurve& entry = after_.curves[i];
            const bool is_changed = old_[i] == nullptr || old_[i]->curve != entry.curve;
            if (!is_changed || entry.curve->is_periodic()) continue;
            for (const core::CurveEnd end : {core::CurveEnd::start, core::CurveEnd::end}) {
                if (mark_of_end(entry, end) != nullptr || !is_at_old_place(*owner.curve, old.end, *entry.curve, end))
                    continue;
                entry.joints.ends.push_back({end, number, mark.mark, mark.unknown_members});
                std::ranges::sort(entry.joints.ends, {}, &core::EndMark::end);
                return true;
            }
        }
        return false;
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
            for (const core::KnotMark& mark : *marks)
                if (!mark_of_knot(entry, mark.u)) entry.joints.knots.push_back(mark);
            std::ranges::sort(entry.joints.knots, {}, &core::KnotMark::u);
        }
    }

    // Of each number the first two ends belong together, those of older curves first; copies of these, and ends that
    // are left alone, are unmarked.
    void pair_ends() {
        auto ends = ends_by_joint(after_);
        for (const LeftEnd& left : left_) {
            const std::size_t others = ends.contains(left.number) ? ends.at(left.number).size() : 0;
            const bool is_knot = std::ranges::any_of(
                left_, [&](const LeftEnd& other) { return other.number == left.number && other.is_knot; });
            if (others == 1 || (others == 0 && !is_knot)) unknown_.push_back(after_.curves[left.curve].name);
        }
        for (auto& [number, pair] : ends) {
            std::stable_partition(pair.begin(), pair.end(),
                                  [&](const DocumentEnd& end) { return old_[end.curve] != nullptr; });
            const std::size_t kept = pair.size() < 2 ? 0 : 2;
            for (std::size_t k = kept; k < pair.size(); ++k) drop_end(pair[k]);
            if (kept == 2) pairs_[number] = {pair[0], pair[1]};
        }
    }

    // An end that was joined to its other end is a knot now. Whether it is.
    bool drop_end(DocumentEnd end) {
        core::DocumentCurve& entry = after_.curves[end.curve];
        const core::EndMark mark = *mark_of_end(entry, end.end);
        std::erase(entry.joints.ends, mark);
        if (old_[end.curve] == nullptr) return false;
        const double u = core::parameter_of(old_[end.curve]->curve->domain(), end.end);
        if (!core::is_inner_knot(*entry.curve, u) || mark_of_knot(entry, u)) return false;
        entry.joints.knots.push_back({u, mark.mark, mark.unknown_members});
        std::ranges::sort(entry.joints.knots, {}, &core::KnotMark::u);
        return true;
    }

    // Of a curve that was cut each part has the marks of the whole, of which some part keeps those inside it.
    void drop_marks_without_knots() {
        for (std::size_t i = 0; i < after_.curves.size(); ++i) {
            core::DocumentCurve& entry = after_.curves[i];
            for (const core::KnotMark& mark : std::vector(entry.joints.knots)) {
                if (core::is_inner_knot(*entry.curve, mark.u)) continue;
                std::erase(entry.joints.knots, mark);
                if (old_[i] != nullptr) gone_.push_back(mark);
            }
        }
        for (std::size_t i = 0; i < after_.curves.size() && !gone_.empty(); ++i)
            if (old_[i] == nullptr)
                for (const core::KnotMark& mark : after_.curves[i].joints.knots) std::erase(gone_, mark);
    }

    void collect() {
        std::set<std::size_t> groups;
        for (std::size_t i = 0; i < after_.curves.size(); ++i) {
            // One image speaks for all of its group.
            if (is_image(i) && !groups.insert(after_.curves[i].symmetry->group).second) continue;
            for (const core::KnotMark& mark : after_.curves[i].joints.knots)
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
            add({arm_of(after_, pair.first), arm_of(after_, pair.second), level_of(first->mark), is_new},
                {pair.first.curve, 0.0, number, first->mark});
        }
        leave_out_unreached();
    }

    void add(const core::KeptJoint& joint, const Source& source) {
        joints_.push_back(joint);
        sources_.push_back(source);
    }

    // Only curves that have changed, and those that hang together with them, are of concern.
    void leave_out_unreached() {
        std::vector<bool> is_reached;
        for (std::size_t i = 0; i < after_.curves.size(); ++i) is_reached.push_back(is_changed(i));
        for (bool has_grown = true; std::exchange(has_grown, false);)
            for (const core::KeptJoint& joint : joints_) {
                if (is_reached[joint.before.curve] == is_reached[joint.after.curve]) continue;
                is_reached[joint.before.curve] = is_reached[joint.after.curve] = has_grown = true;
            }
        const auto joints = std::exchange(joints_, {});
        const auto sources = std::exchange(sources_, {});
        for (std::size_t k = 0; k < joints.size(); ++k) {
            if (!is_reached[joints[k].before.curve]) continue;
            add(joints[k], sources[k]);
            joints_.back().before.curve = slot_of(joints[k].before.curve);
            joints_.back().after.curve = slot_of(joints[k].after.curve);
        }
    }

    // Where a curve of the document stands among those whose joints are kept.
    std::size_t slot_of(std::size_t i) {
        const auto [slot, is_new] = slots_.emplace(i, curves_.size());
        if (is_new) {
            const core::DocumentCurve& entry = after_.curves[i];
            curves_.push_back({*entry.curve, old_[i] == nullptr ? nullptr : old_[i]->curve, entry.pinned,
                               entry.locked || entry.fit != nullptr || is_image(i)});
        }
        return slot->second;
    }

    void keep() {
        core::KeptJoints kept = core::keep_joints(curves_, joints_);
        for (const auto& [i, slot] : slots_)
            if (kept.curves[slot] != *after_.curves[i].curve)
                replace_curve(after_.curves[i], std::make_shared<const core::Curve>(std::move(kept.curves[slot])));
        for (const std::size_t k : kept.lost) unmark(sources_[k]);
        lost_ = std::move(kept.lost);
    }

    void unmark(const Source& source) {
        const auto symmetry = after_.curves[source.curve].symmetry;
        for (std::size_t i = 0; i < after_.curves.size() && !source.number; ++i) {
            const bool is_same_group = holds_images_ && symmetry && after_.curves[i].symmetry &&
                                       after_.curves[i].symmetry->group == symmetry->group;
            if (i == source.curve || is_same_group)
                std::erase_if(after_.curves[i].joints.knots,
                              [&](const core::KnotMark& mark) { return mark.u == source.u; });
        }
        for (core::DocumentCurve& entry : after_.curves)
            std::erase_if(entry.joints.ends, [&](const core::EndMark& mark) { return mark.joint == source.number; });
    }

    std::vector<std::string> sentences() const {
        std::vector<std::string> told;
        if (!lost_.empty()) told.push_back(sentence_of_lost());
        if (!unknown_.empty())
            told.push_back(
                core::sentence("the marked joints of '{name}' are marked no more", {{"name", unknown_.front()}}));
        if (!gone_.empty())
            told.push_back(core::sentence({.one = "u = {u} is no knot inside a curve any more, and its mark is gone",
                                           .many = "{count} marks are gone, whose knots are inside no curve any more"},
                                          gone_.size(), {{"u", core::shortest_text(gone_.front().u)}}));
        if (knots_met_) told.emplace_back("marked knots that became one keep the mark that asks for least");
        return told;
    }

    std::string sentence_of_lost() const {
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
    bool holds_images_;
    std::vector<LeftEnd> left_;
    std::map<std::size_t, std::pair<DocumentEnd, DocumentEnd>> pairs_;
    std::map<std::size_t, std::size_t> slots_;  // by curves of the document
    std::vector<core::EditedCurve> curves_;
    std::vector<core::KeptJoint> joints_;
    std::vector<Source> sources_;
    std::vector<std::size_t> lost_;
    std::vector<std::string> unknown_;  // curves whose marks found no knots
    bool knots_met_ = false;            // two marked ones are one now
    std::vector<core::KnotMark> gone_;  // whose knots are no joints any more
};

}  // namespace

std::vector<std::string> keep_marked_joints(const core::Document& before, core::Document& after) {
    return MarkKeeping(before, after, false).run();
}

std::vector<std::string> keep_joints_of_images(const core::Document& before, core::Document& after) {
    const bool has_images = std::ranges::any_of(
        after.curves, [](const core::DocumentCurve& entry) { return entry.symmetry && !entry.joints.is_empty(); });
    if (!has_images) return {};
    return MarkKeeping(before, after, true).run();
}

}  // namespace batten::editor
