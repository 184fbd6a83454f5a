#include "exchange/collector.h"

#include "core/curve/knot_analysis.h"
#include "exchange/refusal.h"
#include "exchange/utf8_text.h"

namespace batten::exchange {

namespace {

constexpr core::PluralPattern refused{"{what} at {place} was left out: {reason}",
                                      "{count} entities {what} were left out, the first at {place}: {reason}"};
constexpr core::PluralPattern refused_curve{"the curve at {place} was left out: {reason}",
                                            "{count} curves were left out, the first at {place}: {reason}"};
constexpr core::PluralPattern too_many{"one curve was left out, since 100000 were read before it",
                                       "{count} curves were left out, since 100000 were read before them"};
constexpr core::PluralPattern heights{
    "{what} at {place} has heights other than 0, which were let go",
    "{count} entities {what} have heights other than 0, the first at {place}, which were let go"};
constexpr core::PluralPattern heights_of_curve{
    "the curve at {place} has heights other than 0, which were let go",
    "{count} curves have heights other than 0, the first at {place}, which were let go"};
static_assert(most_curves == 100'000);

// Also where there is another defect, which is told first.
bool has_full_vector(const core::CurveDefinition& definition) {
    const std::size_t count = definition.points.size();
    const bool is_degree = definition.degree >= core::min_degree && definition.degree <= core::max_degree;
    if (definition.periodic || !is_degree) return true;
    const auto p = static_cast<std::size_t>(definition.degree);
    return count < p + 1 || definition.knots.size() == count + p + 1;
}

std::string wrong_knot_count(const core::CurveDefinition& definition) {
    const std::size_t needed = definition.points.size() + static_cast<std::size_t>(definition.degree) + 1;
    return core::sentence(
        "the number of knots is {found}; for {points} control points of degree {degree} it must be {needed}, points + "
        "degree + 1, while {fewer}, points + degree − 1, is Rhino-style",
        {{"found", definition.knots.size()},
         {"points", definition.points.size()},
         {"degree", definition.degree},
         {"needed", needed},
         {"fewer", needed - 2}});
}

}  // namespace

MadeCurve in_words(core::Result<core::Curve> made) {
    return std::move(made).map_error(core::describe);
}

MadeCurve make_curve(core::CurveDefinition definition) {
    if (!has_full_vector(definition)) return tl::unexpected(wrong_knot_count(definition));
    definition.tears = core::Tears::allow;
    core::Result<core::Curve> curve = core::Curve::make(std::move(definition));
    if (!curve) return in_words(std::move(curve));
    const core::KnotKind kind = core::classify(curve->knots());
    if (kind == core::KnotKind::custom) return *std::move(curve);
    core::CurveDefinition known = curve->definition();
    known.kind = kind;
    known.tears = core::Tears::allow;
    return in_words(core::Curve::make(std::move(known)));
}

core::DocumentCurve* Collector::add(MadeCurve made, const std::string& wish, std::string_view what,
                                    const PlaceText& place) {
    if (!made) {
        notes_.add(what.empty() ? refused_curve : refused, place, what, made.error());
        return nullptr;
    }
    if (is_full()) {
        leave_out_more(place);
        return nullptr;
    }
    core::DocumentCurve entry;
    entry.name = names_.take(utf8_text(wish));
    entry.tears = made->is_torn() ? core::Tears::allow : core::Tears::refuse;
    entry.curve = std::make_shared<const core::Curve>(*std::move(made));
    return &document_.curves.emplace_back(std::move(entry));
}

void Collector::leave_out_more(const PlaceText& place) {
    notes_.add(too_many, place);
}

void Collector::note_heights(std::string_view what, const PlaceText& place) {
    notes_.add(what.empty() ? heights_of_curve : heights, place, what);
}

core::FileResult<Imported> Collector::finish(const char* nothing_found) && {
    Imported imported{std::move(document_),
                      {.largest_error = largest_error_, .left_out = notes_.sentences(), .looks = looks_.sentences()}};
    const std::vector<std::string>& left_out = imported.report.left_out;
    if (imported.document.curves.empty()) return refused_file(left_out.empty() ? nothing_found : left_out.front());
    return imported;
}

}  // namespace batten::exchange
