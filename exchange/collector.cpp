#include "exchange/collector.h"

#include "core/curve/knot_analysis.h"
#include "exchange/utf8_text.h"

namespace batten::exchange {

namespace {

constexpr std::size_t most_notes = 40;
constexpr std::size_t longest_what = 40;

constexpr core::PluralPattern refused{"{what} at {place} was left out: {reason}",
                                      "{count} times {what} was left out, first at {place}: {reason}"};
constexpr core::PluralPattern too_many{"one curve was left out, since 100000 were read before it",
                                       "{count} curves were left out, since 100000 were read before them"};
constexpr core::PluralPattern heights{
    "{what} at {place} has heights other than 0, which were let go",
    "{count} times {what} has heights other than 0, first at {place}, which were let go"};
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
        note(refused, what, place, made.error());
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

void Collector::note(const core::PluralPattern& pattern, std::string_view what, const PlaceText& place,
                     std::string_view reason) {
    const std::string name = utf8_text(what.substr(0, longest_what));
    const auto found = note_indices_.find({&pattern, name});
    if (found != note_indices_.end()) {
        ++notes_[found->second].count;
        return;
    }
    if (notes_.size() == most_notes) {
        ++further_notes_;
        return;
    }
    note_indices_[{&pattern, name}] = notes_.size();
    notes_.push_back({&pattern, name, place(), std::string(reason)});
}

void Collector::leave_out_more(const PlaceText& place) {
    note(too_many, {}, place);
}

void Collector::note_heights(std::string_view what, const PlaceText& place) {
    note(heights, what, place);
}

std::vector<std::string> Collector::sentences() const {
    std::vector<std::string> sentences;
    for (const Note& note : notes_)
        sentences.push_back(core::filled_as_needed(
            note.pattern->for_count(note.count),
            {{"what", note.what}, {"place", note.place}, {"reason", note.reason}, {"count", note.count}}));
    if (further_notes_ > 0)
        sentences.push_back(core::sentence({.one = "one more thing of another kind was left out",
                                            .many = "{count} more things of other kinds were left out"},
                                           further_notes_));
    return sentences;
}

core::FileResult<Imported> Collector::finish(const char* nothing_found) && {
    Imported imported{std::move(document_), {.largest_error = largest_error_, .left_out = sentences()}};
    const std::vector<std::string>& left_out = imported.report.left_out;
    if (imported.document.curves.empty())
        return tl::unexpected(core::FileError{"", left_out.empty() ? nothing_found : left_out.front()});
    return imported;
}

}  // namespace batten::exchange
