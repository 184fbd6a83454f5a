#include "exchange/csv_writer.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/base/number_text.h"
#include "core/curve/knot_analysis.h"
#include "core/evaluate/evaluate.h"
#include "exchange/written_curves.h"

namespace batten::exchange {

namespace {

constexpr int order = 2;  // of the derivatives

struct Place {
    double u = 0.0;
    core::Side side = core::Side::right;

    bool operator<(const Place& other) const { return std::tie(u, side) < std::tie(other.u, other.side); }
};

// Knots inside the domain where a derivative may jump.
std::vector<double> jumps_of(const core::Curve& curve) {
    const core::Interval domain = curve.domain();
    std::vector<double> jumps;
    for (const core::DistinctKnot& knot : core::distinct_knots(curve.knots()))
        if (knot.continuity < order && knot.value > domain.lower && knot.value < domain.upper)
            jumps.push_back(knot.value);
    return jumps;
}

std::vector<Place> places_on(const core::Curve& curve, std::size_t samples) {
    const core::Interval domain = curve.domain();
    const std::vector<double> jumps = jumps_of(curve);
    std::vector<Place> places{{domain.lower, core::Side::right}, {domain.upper, core::Side::left}};
    for (std::size_t i = 1; i + 1 < samples; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(samples - 1);
        const double u = (1.0 - share) * domain.lower + share * domain.upper;
        if (!std::ranges::binary_search(jumps, u)) places.push_back({u, core::Side::right});
    }
    for (const double u : jumps) places.insert(places.end(), {{u, core::Side::left}, {u, core::Side::right}});
    std::sort(places.begin(), places.end());
    return places;
}

// A cell that reads back whatever the name has in it.
std::string cell_of(const std::string& name) {
    if (name.find_first_of(",;\"\n\r\t#") == std::string::npos) return name;
    std::string cell = "\"";
    for (const char c : name) cell.append(c == '"' ? 2 : 1, c);
    cell.push_back('"');
    return cell;
}

void append_cell(std::string& row, std::optional<double> value) {
    row.push_back(',');
    if (value && std::isfinite(*value)) core::append_shortest_text(row, *value);
}

void append_row(std::string& text, const std::string& name, const core::Curve& curve, Place place) {
    const core::Jet jet = core::derivatives_at(curve, place.u, order, place.side);
    text.append(name);
    for (const double value : {place.u, jet.point.x, jet.point.y, jet[1].x, jet[1].y, jet[2].x, jet[2].y})
        append_cell(text, value);
    append_cell(text, core::curvature_at(curve, place.u, place.side));
    text.push_back('\n');
}

}  // namespace

core::FileResult<Exported> write_csv(const core::Document& document, const WriteOptions& options) {
    return visible_curves(document).map([&](const std::vector<const core::DocumentCurve*>& entries) {
        Notes notes;
        note_losses(notes, document, {.periodic = true});
        Exported exported{"curve,u,x,y,x',y',x'',y'',curvature\n",
                          {.left_out = notes.sentences(), .holds_samples = true}};
        for (const core::DocumentCurve* entry : entries)
            for (const Place& place : places_on(*entry->curve, options.samples))
                append_row(exported.text, cell_of(entry->name), *entry->curve, place);
        return exported;
    });
}

}  // namespace batten::exchange
