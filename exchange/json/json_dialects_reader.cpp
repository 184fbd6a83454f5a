#include "exchange/json/json_dialects_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "exchange/collector.h"
#include "exchange/json/homogeneous.h"
#include "exchange/json/json_members.h"
#include "exchange/refusal.h"

namespace batten::exchange {

namespace {

using core::CurveDefinition;

constexpr core::PluralPattern ends_repeated{
    "the first and the last knot of the curve at {place}, which the file does not have and the curve does not depend "
    "on, were made equal to their neighbors",
    "the first and the last knot of {count} curves, which the file does not have and the curves do not depend on, were "
    "made equal to their neighbors"};

constexpr const char* rest_of_list =
    "the entry at {place} of the list of curves is no object; it and what follows it was left out";

// What one object says, and what there is to tell of it.
struct Found {
    CurveDefinition definition{};
    bool has_heights = false;
    bool has_repeated_ends = false;
    double error = 0.0;
};

using ReadObject = Found (*)(JsonMembers& members);

void take_points(Found& found, JsonMembers& members, const char* name) {
    JsonPoints points = members.points(name);
    found.definition.points = std::move(points.points);
    found.has_heights = points.has_heights;
}

int degree_in(JsonMembers& members) {
    return members.whole_number("degree", core::min_degree, core::max_degree);
}

Found nurbs_python_curve(JsonMembers& members) {
    Found found;
    found.definition.degree = degree_in(members);
    found.definition.knots = members.numbers("knotvector");
    JsonMembers points(members.inside("control_points"));
    take_points(found, points, "points");
    found.definition.weights = points.optional_numbers("weights");
    members.note(points.defect());
    return found;
}

// One point of a flat list, of which the last number is a weight by which the others are multiplied. The error is what
// dividing loses.
void take_homogeneous(Found& found, std::span<const double> numbers) {
    const double w = numbers.back();
    const core::Point point{numbers[0] / w, numbers[1] / w};
    found.definition.points.push_back(point);
    found.definition.weights.push_back(w);
    const double error = std::hypot(quotient_error(point.x, w, numbers[0]), quotient_error(point.y, w, numbers[1]));
    found.error = std::max(found.error, error);
}

Found tinyspline_curve(JsonMembers& members) {
    Found found;
    found.definition.degree = degree_in(members);
    found.definition.knots = members.numbers("knots");
    constexpr int most_dimension = 4;
    const auto dimension = static_cast<std::size_t>(members.whole_number("dimension", 2, most_dimension));
    const bool is_homogeneous = members.flag("homogeneous");
    const std::vector<double> numbers = members.numbers("control_points");
    if (numbers.size() % dimension != 0)
        members.note(core::sentence(
            "the length of \"control_points\" is {count}, which is no multiple of the dimension {dimension}",
            {{"count", numbers.size()}, {"dimension", dimension}}));
    if (is_homogeneous && dimension == 2) members.note("homogeneous points must have the dimension 3 or 4");
    if (!members.defect().empty()) return found;
    const std::size_t coordinates = is_homogeneous ? dimension - 1 : dimension;
    for (std::size_t i = 0; i < numbers.size(); i += dimension) {
        const std::span<const double> point = std::span(numbers).subspan(i, dimension);
        if (is_homogeneous)
            take_homogeneous(found, point);
        else
            found.definition.points.emplace_back(point[0], point[1]);
        for (std::size_t k = 2; k < coordinates; ++k) found.has_heights = found.has_heights || point[k] != 0.0;
    }
    return found;
}

// How often the front of `knots` is repeated in it.
template <class Iterator>
std::size_t run_length(Iterator begin, Iterator end) {
    return static_cast<std::size_t>(std::find_if(begin, end, [&](double u) { return u != *begin; }) - begin);
}

// The ends are repeated, unless too many knots would be equal; then they are as far outside as the next one is inside.
void add_end_knots(std::vector<double>& knots, int degree) {
    const std::size_t most = static_cast<std::size_t>(degree) + 1;
    const std::size_t at_front = run_length(knots.begin(), knots.end());
    const std::size_t at_back = run_length(knots.rbegin(), knots.rend());
    const double first =
        at_front < most || at_front == knots.size() ? knots.front() : 2.0 * knots.front() - knots[at_front];
    const double last = at_back < most || at_back == knots.size()
                            ? knots.back()
                            : 2.0 * knots.back() - *(knots.rbegin() + static_cast<std::ptrdiff_t>(at_back));
    knots.insert(knots.begin(), first);
    knots.push_back(last);
}

Found rhino_curve(JsonMembers& members) {
    Found found;
    CurveDefinition& definition = found.definition;
    definition.degree = degree_in(members);
    definition.knots = members.numbers("knots");
    definition.weights = members.optional_numbers("weights");
    take_points(found, members, "points");
    const std::size_t needed = definition.points.size() + static_cast<std::size_t>(definition.degree) - 1;
    if (definition.points.size() > static_cast<std::size_t>(definition.degree) && definition.knots.size() != needed)
        members.note(core::sentence(
            "the number of knots is {found}; for {points} control points of degree {degree} Rhino-style has {needed}, "
            "points + degree − 1, while other formats have {full}, points + degree + 1",
            {{"found", definition.knots.size()},
             {"points", definition.points.size()},
             {"degree", definition.degree},
             {"needed", needed},
             {"full", needed + 2}}));
    if (!members.defect().empty() || definition.knots.empty()) return found;
    const auto clamped = static_cast<std::size_t>(definition.degree);
    found.has_repeated_ends = run_length(definition.knots.begin(), definition.knots.end()) < clamped ||
                              run_length(definition.knots.rbegin(), definition.knots.rend()) < clamped;
    add_end_knots(definition.knots, definition.degree);
    return found;
}

// How often each knot occurs.
std::vector<std::size_t> multiplicities_in(JsonMembers& members, std::size_t knot_count) {
    const std::vector<double> numbers = members.numbers("multiplicities");
    std::vector<std::size_t> multiplicities;
    for (const double number : numbers) {
        if (!(number >= 1.0 && number <= core::max_degree + 1 && std::trunc(number) == number))
            members.note(core::sentence("a multiplicity must be a whole number from 1 to {most}",
                                        {{"most", core::max_degree + 1}}));
        else
            multiplicities.push_back(static_cast<std::size_t>(number));
    }
    if (numbers.size() != knot_count)
        members.note(
            core::sentence("the number of multiplicities is {found} and that of knots {count}; each knot must "
                           "have one",
                           {{"found", numbers.size()}, {"count", knot_count}}));
    return multiplicities;
}

// A period begins with the last of the knots at its seam, as poles are counted there.
Found opencascade_curve(JsonMembers& members) {
    Found found;
    CurveDefinition& definition = found.definition;
    definition.degree = degree_in(members);
    definition.weights = members.optional_numbers("weights");
    definition.periodic = members.flag("periodic");
    take_points(found, members, "poles");
    const std::vector<double> knots = members.numbers("knots");
    std::vector<std::size_t> multiplicities = multiplicities_in(members, knots.size());
    if (std::ranges::adjacent_find(knots, std::greater_equal<>()) != knots.end())
        members.note(R"("knots" must increase; equal ones are counted in "multiplicities")");
    if (!members.defect().empty() || knots.empty()) return found;
    if (definition.periodic && multiplicities.front() != multiplicities.back())
        members.note("the first and the last multiplicity of a periodic curve must be equal");
    if (definition.periodic) multiplicities.front() = 1;
    const std::size_t sum = std::accumulate(multiplicities.begin(), multiplicities.end(), std::size_t{0});
    const std::size_t needed =
        definition.points.size() + 1 + (definition.periodic ? 0U : static_cast<std::size_t>(definition.degree));
    if (sum != needed)
        members.note(
            core::sentence("the multiplicities add up to {sum}, but there must be {needed} knots: points + degree + 1, "
                           "or for a periodic "
                           "curve, whose first knot counts once, points + 1",
                           {{"sum", sum}, {"needed", needed}}));
    if (sum != needed) return found;
    for (std::size_t i = 0; i < knots.size(); ++i)
        definition.knots.insert(definition.knots.end(), multiplicities[i], knots[i]);
    return found;
}

void add_curve(Collector& collector, const JsonValue& object, ReadObject read, const PlaceText& place) {
    constexpr std::string_view what{};  // a curve
    if (collector.is_full()) return collector.leave_out_more(place);
    JsonMembers members(object);
    Found found = read(members);
    MadeCurve made =
        members.defect().empty() ? make_curve(std::move(found.definition)) : tl::unexpected(members.defect());
    if (collector.add(std::move(made), members.name(), what, place) == nullptr) return;
    collector.note_error(found.error);
    if (found.has_heights) collector.note_heights(what, place);
    if (found.has_repeated_ends) collector.notes().add(ends_repeated, place);
}

// The first entry that is a number or a row of them.
std::optional<std::size_t> first_number(const JsonList& list) {
    return list.numbers.empty() ? list.first_odd : std::optional<std::size_t>(0);
}

// All curves of `value`, which is one or a list of them, at `place`: empty for the top of the file.
core::FileResult<Imported> read_curves(const JsonValue& value, ReadObject read, const std::string& place) {
    Collector collector;
    const JsonList* list = value.list();
    if (list == nullptr) add_curve(collector, value, read, [&] { return place.empty() ? "the top" : place; });
    if (list != nullptr)
        for (std::size_t i = 0; i < list->items.size(); ++i)
            add_curve(collector, list->items[i], read, [&] { return fmt::format("{}/{}", place, i); });
    if (const auto odd = list == nullptr ? std::nullopt : first_number(*list))
        collector.notes().add({rest_of_list, rest_of_list}, [&] { return fmt::format("{}/{}", place, *odd); });
    return std::move(collector).finish("there are no curves in this file");
}

core::FileResult<Imported> read_list_of_curves(std::string_view text, ReadObject read) {
    return parse_json_tree(text).and_then([&](const JsonValue& tree) {
        const JsonValue* curves = tree.member("curves");
        return curves == nullptr ? read_curves(tree, read, "") : read_curves(*curves, read, "/curves");
    });
}

}  // namespace

core::FileResult<Imported> read_nurbs_python(std::string_view text) {
    return parse_json_tree(text).and_then([](const JsonValue& tree) -> core::FileResult<Imported> {
        const JsonValue* shape = tree.member("shape");
        const JsonValue* data = shape == nullptr ? nullptr : shape->member("data");
        if (data == nullptr)
            return refused_file(R"(the member "shape" with "data" is missing, which every file of NURBS-Python has)");
        return read_curves(*data, nurbs_python_curve, "/shape/data");
    });
}

core::FileResult<Imported> read_tinyspline(std::string_view text) {
    return read_list_of_curves(text, tinyspline_curve);
}

core::FileResult<Imported> read_rhino(std::string_view text) {
    return read_list_of_curves(text, rhino_curve);
}

core::FileResult<Imported> read_opencascade(std::string_view text) {
    return read_list_of_curves(text, opencascade_curve);
}

}  // namespace batten::exchange
