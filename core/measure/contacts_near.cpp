#include "core/measure/contacts_near.h"

#include <cmath>
#include <utility>

#include "core/measure/intersect_curves.h"

namespace batten::core {

namespace {

constexpr std::size_t most_compared_spans = 16;
constexpr double equal_ends = 1e-12;  // of the domain

struct Part {
    std::size_t owner = 0;
    Curve curve;
};

/// Whether a contact of a curve with itself is where its ends meet.
bool is_seam(const NearContact& contact, Interval domain) {
    const double reach = equal_ends * domain.length();
    return std::abs(contact.u - domain.lower) <= reach && std::abs(contact.v - domain.upper) <= reach;
}

class Collector {
  public:
    Collector(std::span<const NearParts* const> curves, Point place, double reach)
        : curves_(curves), place_(place), reach_(reach) {}

    void take(const Part& a, const Part& b, const CurveContacts& found) {
        for (const CurveContact& contact : found.contacts) {
            if (contact.is_overlap() || distance(contact.point, place_) > reach_) continue;
            NearContact near{a.owner, b.owner, contact.u, contact.v, contact.point};
            if (a.owner == b.owner) {
                if (near.u > near.v) std::swap(near.u, near.v);
                if (is_seam(near, curves_[a.owner]->curve().domain())) continue;
            }
            contacts_.push_back(near);
        }
    }

    std::vector<NearContact> contacts() && { return std::move(contacts_); }

  private:
    std::span<const NearParts* const> curves_;
    Point place_;
    double reach_;
    std::vector<NearContact> contacts_;
};

}  // namespace

std::vector<NearContact> contacts_near(std::span<const NearParts* const> curves, Point place, double distance) {
    std::vector<Part> parts;
    for (std::size_t k = 0; k < curves.size(); ++k) {
        const auto near = curves[k]->parts_near(place, distance, most_compared_spans);
        if (!near) return {};
        for (const Curve& part : *near) parts.push_back({k, part});
        if (parts.size() > most_compared_spans) return {};
    }
    Collector collector(curves, place, distance);
    for (std::size_t a = 0; a < parts.size(); ++a) {
        if (parts[a].curve.degree() > 1) collector.take(parts[a], parts[a], self_intersections(parts[a].curve));
        for (std::size_t b = a + 1; b < parts.size(); ++b)
            collector.take(parts[a], parts[b], intersect_curves(parts[a].curve, parts[b].curve));
    }
    return std::move(collector).contacts();
}

}  // namespace batten::core
