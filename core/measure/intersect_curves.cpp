#include "core/measure/intersect_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <vector>

#include "core/base/detail/unit_interval.h"
#include "core/curve/control_box.h"
#include "core/evaluate/evaluate.h"
#include "core/evaluate/tangent.h"
#include "core/measure/continuity.h"
#include "core/measure/detail/box_tree.h"
#include "core/measure/detail/contact_search.h"

namespace batten::core {

namespace {

// Points nearer than this part of the size of everything are one.
constexpr double same_point = 1e-13;

// Contacts whose parameters on both curves differ by less than this part of a span are one.
constexpr double same_parameter = 1e-6;

constexpr double parallel = 1e-6;

double size_of(const Box& box) {
    return std::max(box.size().x, box.size().y);
}

double farthest_coordinate(const Box& box) {
    return std::max({std::abs(box.lower.x), std::abs(box.lower.y), std::abs(box.upper.x), std::abs(box.upper.y)});
}

double tolerance_within(const Box& box) {
    return same_point * size_of(box) + 4.0 * std::numeric_limits<double>::epsilon() * farthest_coordinate(box);
}

// One of the two curves, for translating places to parameters and telling whether two are the same.
class Parameters {
  public:
    Parameters(const Curve& curve, const ContactPieces& pieces)
        : curve_(curve), pieces_(pieces), is_closed_(is_closed(curve)) {
        const auto knots = curve.knots().values();
        for (std::size_t i = 0; i + 1 < knots.size(); ++i)
            widest_slack_ = std::max(widest_slack_, same_parameter * (knots[i + 1] - knots[i]));
    }

    bool closes() const { return is_closed_; }

    double at(PiecePlace place) const { return from_unit(pieces_.motions[place.span].interval(), place.share); }

    // The end where the curve closes is its beginning.
    double canonical(double u) const { return is_closed_ && u == curve_.domain().upper ? curve_.domain().lower : u; }

    bool are_same(double a, double b) const {
        const double apart = std::abs(a - b);
        return apart <= slack(a) || (is_closed_ && curve_.domain().length() - apart <= slack(a));
    }

    bool are_within(double u, double lower, double upper) const {
        if (lower > upper) std::swap(lower, upper);
        const double period = is_closed_ ? curve_.domain().length() : 0.0;
        const double margin = slack(u);
        const auto is_inside = [&](double parameter) {
            return lower - margin <= parameter && parameter <= upper + margin;
        };
        return is_inside(u) || is_inside(u - period) || is_inside(u + period);
    }

    bool is_tangent_to(double u, const Curve& other, double v) const {
        for (const Side side : {Side::right, Side::left})
            for (const Side other_side : {Side::right, Side::left}) {
                const auto a = tangent_at(curve_, u, side);
                const auto b = tangent_at(other, v, other_side);
                if (a && b && std::abs(cross(*a, *b)) <= parallel) return true;
            }
        return false;
    }

    // The same place in all periods that touch the domain.
    std::vector<double> copies(double u) const {
        const double period = curve_.domain().length();
        return is_closed_ ? std::vector{u, u - period, u + period} : std::vector{u};
    }

    // Parameters that are the same are no farther apart than this, anywhere.
    double widest_slack() const { return widest_slack_; }

  private:
    double slack(double u) const {
        const std::size_t span = curve_.knots().span_at(u);
        return same_parameter * (curve_.knots()[span + 1] - curve_.knots()[span]);
    }

    const Curve& curve_;
    const ContactPieces& pieces_;
    bool is_closed_;
    double widest_slack_ = 0.0;
};

// Overlaps in the order in which they begin on the first curve, of which those around a parameter are found without a
// look at all of them.
class OverlapIndex {
  public:
    explicit OverlapIndex(std::span<const CurveContact> overlaps) : overlaps_(overlaps) {
        double reach = -std::numeric_limits<double>::infinity();
        for (const CurveContact& overlap : overlaps) {
            reach = std::max(reach, overlap.on_first.upper);
            reaches_.push_back(reach);
        }
    }

    // Whether `is_meant` holds for one that comes within `margin` of `u`.
    template <class Predicate>
    bool any_around(double u, double margin, const Predicate& is_meant) const {
        const auto begins_behind = [](double place, const CurveContact& overlap) {
            return place < overlap.on_first.lower;
        };
        const auto end = std::upper_bound(overlaps_.begin(), overlaps_.end(), u + margin, begins_behind);
        for (auto i = static_cast<std::size_t>(end - overlaps_.begin()); i > 0 && reaches_[i - 1] >= u - margin; --i)
            if (is_meant(overlaps_[i - 1])) return true;
        return false;
    }

  private:
    std::span<const CurveContact> overlaps_;
    std::vector<double> reaches_;  // how far the overlaps up to each come
};

// Turns what was found piece by piece into contacts of whole curves.
class ContactList {
  public:
    ContactList(const Curve& first, const Parameters& on_first, const Curve& second, const Parameters& on_second)
        : first_(first), second_(second), on_first_(on_first), on_second_(on_second) {}

    void add(const FoundContact& found) {
        CurveContact contact{.on_first = {on_first_.at(found.first_begin), on_first_.at(found.first_end)},
                             .second_begin = on_second_.at(found.second_begin),
                             .second_end = on_second_.at(found.second_end)};
        if (contact.is_overlap()) return overlaps_.push_back(contact);
        contact.on_first.lower = contact.on_first.upper = on_first_.canonical(contact.on_first.lower);
        contact.second_begin = contact.second_end = on_second_.canonical(contact.second_begin);
        points_.push_back(contact);
    }

    std::vector<CurveContact> finish() {
        sort(overlaps_);
        std::vector<CurveContact> contacts = joined_overlaps();
        const OverlapIndex index(overlaps_);
        sort(points_);
        std::vector<CurveContact> points;
        for (const CurveContact& point : points_)
            if (!is_within_overlap(index, point) && !is_known(points, point)) points.push_back(point);
        contacts.insert(contacts.end(), points.begin(), points.end());
        for (CurveContact& contact : contacts) complete(contact);
        sort(contacts);
        return contacts;
    }

  private:
    static void sort(std::vector<CurveContact>& contacts) {
        std::sort(contacts.begin(), contacts.end(), [](const CurveContact& a, const CurveContact& b) {
            return std::pair(a.on_first.lower, a.second_begin) < std::pair(b.on_first.lower, b.second_begin);
        });
    }

    bool are_same(const CurveContact& a, const CurveContact& b) const {
        return on_first_.are_same(a.on_first.lower, b.on_first.lower) &&
               on_first_.are_same(a.on_first.upper, b.on_first.upper) &&
               on_second_.are_same(a.second_begin, b.second_begin) && on_second_.are_same(a.second_end, b.second_end);
    }

    // By the end of a contact on the first curve, its number.
    using Ends = std::multimap<double, std::size_t>;

    // The first of `contacts` that `overlap` continues.
    Ends::iterator continued_by(const CurveContact& overlap, std::span<const CurveContact> contacts, Ends& ends) const {
        auto found = ends.end();
        const double margin = on_first_.widest_slack();
        for (const double begin : on_first_.copies(overlap.on_first.lower)) {
            const auto behind = ends.upper_bound(begin + margin);
            for (auto end = ends.lower_bound(begin - margin); end != behind; ++end) {
                const CurveContact& earlier = contacts[end->second];
                if (on_first_.are_same(earlier.on_first.upper, overlap.on_first.lower) &&
                    on_second_.are_same(earlier.second_end, overlap.second_begin) &&
                    (found == ends.end() || end->second < found->second))
                    found = end;
            }
        }
        return found;
    }

    // Parts of the same pieces find the same overlap, and those of neighbors go on in each other.
    std::vector<CurveContact> joined_overlaps() const {
        std::vector<CurveContact> contacts;
        Ends ends;
        for (const CurveContact& overlap : overlaps_) {
            if (!contacts.empty() && are_same(contacts.back(), overlap)) continue;
            std::size_t number = contacts.size();
            if (const auto earlier = continued_by(overlap, contacts, ends); earlier != ends.end()) {
                number = earlier->second;
                contacts[number].on_first.upper = overlap.on_first.upper;
                contacts[number].second_end = overlap.second_end;
                ends.erase(earlier);
            } else {
                contacts.push_back(overlap);
            }
            ends.emplace(overlap.on_first.upper, number);
        }
        return contacts;
    }

    // Piece by piece, so that a double point of coinciding curves is a contact of its own.
    bool is_within_overlap(const OverlapIndex& index, const CurveContact& point) const {
        const auto is_around = [&](const CurveContact& overlap) {
            return on_first_.are_within(point.on_first.lower, overlap.on_first.lower, overlap.on_first.upper) &&
                   on_second_.are_within(point.second_begin, overlap.second_begin, overlap.second_end);
        };
        const std::vector<double> places = on_first_.copies(point.on_first.lower);
        return std::any_of(places.begin(), places.end(),
                           [&](double place) { return index.any_around(place, on_first_.widest_slack(), is_around); });
    }

    // Of points in order of u only neighbors can be the same, and on a closed curve the first ones.
    bool is_known(std::span<const CurveContact> points, const CurveContact& point) const {
        const auto is_far = [&](const CurveContact& other) {
            return !on_first_.are_same(point.on_first.lower, other.on_first.lower);
        };
        const auto is_same = [&](const CurveContact& other) {
            return on_second_.are_same(point.second_begin, other.second_begin);
        };
        const auto last_near = std::find_if(points.rbegin(), points.rend(), is_far);
        const auto first_near = std::find_if(points.begin(), points.end(), is_far);
        return std::any_of(points.rbegin(), last_near, is_same) || std::any_of(points.begin(), first_near, is_same);
    }

    void complete(CurveContact& contact) const {
        contact.u = contact.on_first.lower + 0.5 * contact.on_first.length();
        contact.v = contact.second_begin + 0.5 * (contact.second_end - contact.second_begin);
        contact.point = point_at(first_, contact.u);
        contact.is_tangent = contact.is_overlap() || on_first_.is_tangent_to(contact.u, second_, contact.v);
    }

    const Curve& first_;
    const Curve& second_;
    const Parameters& on_first_;
    const Parameters& on_second_;
    std::vector<CurveContact> overlaps_;
    std::vector<CurveContact> points_;
};

std::vector<Box> boxes_of(std::span<const ContactPiece> pieces) {
    std::vector<Box> boxes;
    for (const ContactPiece& piece : pieces) boxes.push_back(piece.box);
    return boxes;
}

// Enough pieces that the first and the last one have only one end in common.
std::vector<ContactPiece> enough_pieces(std::vector<ContactPiece> pieces) {
    constexpr std::size_t least = 3;
    while (!pieces.empty() && pieces.size() < least) {
        std::vector<ContactPiece> finer;
        for (const ContactPiece& piece : pieces) {
            auto [left, right] = halves(piece);
            finer.push_back(std::move(left));
            finer.push_back(std::move(right));
        }
        pieces = std::move(finer);
    }
    return pieces;
}

// The same contact of a curve with itself, with what comes first on the curve as the first way.
FoundContact first_way_first(FoundContact found, const Parameters& parameters) {
    const auto at = [&](PiecePlace place) { return parameters.canonical(parameters.at(place)); };
    const bool is_point = found.first_begin.share == found.first_end.share;
    const double second = is_point ? at(found.second_begin)
                                   : std::min(parameters.at(found.second_begin), parameters.at(found.second_end));
    if (second >= (is_point ? at(found.first_begin) : parameters.at(found.first_begin))) return found;
    std::swap(found.first_begin, found.second_begin);
    std::swap(found.first_end, found.second_end);
    if (parameters.at(found.first_end) < parameters.at(found.first_begin)) {
        std::swap(found.first_begin, found.first_end);
        std::swap(found.second_begin, found.second_end);
    }
    return found;
}

// Beyond it distances of points, and what they are multiplied by, might be infinite.
constexpr double farthest_safe = std::numeric_limits<double>::max() / 256.0;

constexpr double shrinking = 512.0;

// The curve in another unit, with all its digits; it meets others at the same parameters.
Curve shrunk(const Curve& curve) {
    std::vector<Point> points(curve.control_points().begin(), curve.control_points().end());
    for (Point& point : points) point = {point.x / shrinking, point.y / shrinking};
    return Curve::make(curve.knots(), std::move(points), {curve.weights().begin(), curve.weights().end()}).value();
}

// What was found of shrunk curves, in the unit of the curves themselves.
CurveContacts enlarged(CurveContacts found) {
    for (CurveContact& contact : found.contacts)
        contact.point = {contact.point.x * shrinking, contact.point.y * shrinking};
    return found;
}

}  // namespace

CurveContacts intersect_curves(const Curve& first, const Curve& second, const Progress& progress) {
    const Box box = control_box(first);
    const Box other = control_box(second);
    Box both = box;
    both.include(other.lower);
    both.include(other.upper);
    if (farthest_coordinate(both) > farthest_safe)
        return enlarged(intersect_curves(shrunk(first), shrunk(second), progress));
    const Point origin = middle(both.lower, both.upper);
    const ContactPieces a = contact_pieces(first, origin);
    const ContactPieces b = contact_pieces(second, origin);
    const double tolerance = tolerance_within(both);
    ContactSearch search(a, b, std::min(size_of(box), size_of(other)), tolerance);
    const BoxTree against(boxes_of(b.pieces));
    for (std::size_t i = 0; i < a.pieces.size(); ++i) {
        tell(progress, i, a.pieces.size());
        const ContactPiece& piece = a.pieces[i];
        against.each_near(piece.box, tolerance, 0, [&](std::size_t j) { search.add_pair(piece, b.pieces[j]); });
    }
    const Parameters on_first(first, a);
    const Parameters on_second(second, b);
    ContactList list(first, on_first, second, on_second);
    for (const FoundContact& found : search.finish()) list.add(found);
    return {list.finish(), search.is_complete()};
}

CurveContacts self_intersections(const Curve& curve, const Progress& progress) {
    const Box box = control_box(curve);
    if (farthest_coordinate(box) > farthest_safe) return enlarged(self_intersections(shrunk(curve), progress));
    const ContactPieces all = contact_pieces(curve, middle_of(curve));
    const auto pieces = enough_pieces(all.pieces);
    const Parameters parameters(curve, all);
    const double tolerance = tolerance_within(box);
    ContactSearch search(all, all, size_of(box), tolerance);
    const BoxTree against(boxes_of(pieces));
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        tell(progress, i, pieces.size());
        search.add_alone(pieces[i]);
        against.each_near(pieces[i].box, tolerance, i + 1, [&](std::size_t j) {
            if (j == i + 1)
                search.add_neighbors(pieces[i], pieces[j]);
            else if (parameters.closes() && i == 0 && j + 1 == pieces.size())
                search.add_neighbors(pieces[j], pieces[i]);
            else
                search.add_pair(pieces[i], pieces[j]);
        });
    }
    ContactList list(curve, parameters, curve, parameters);
    for (const FoundContact& found : search.finish()) {
        const FoundContact ordered = first_way_first(found, parameters);
        const bool is_point = ordered.first_begin.share == ordered.first_end.share;
        const bool is_one_place =
            parameters.are_same(parameters.at(ordered.first_begin), parameters.at(ordered.second_begin));
        if (!is_point || !is_one_place) list.add(ordered);
    }
    return {list.finish(), search.is_complete()};
}

}  // namespace batten::core
