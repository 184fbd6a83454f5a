/// Gathers what a reader finds: the curves, and a bounded number of sentences about what it leaves out.
#pragma once

#include <algorithm>

#include "exchange/notes.h"
#include "exchange/report.h"

namespace batten::exchange {

/// More curves of one file are left out, so that a small file cannot take all memory.
inline constexpr std::size_t most_curves = 100'000;

/// A curve, or a part of a sentence that says why there is none.
using MadeCurve = tl::expected<core::Curve, std::string>;

/// `made` with its error in words.
MadeCurve in_words(core::Result<core::Curve> made);

/// The curve of unchecked data, which may tear; its kind is what its knots say. The sentence about a wrong number of
/// knots names both conventions.
MadeCurve make_curve(core::CurveDefinition definition);

class Collector {
  public:
    core::Document& document() { return document_; }

    /// Adds a visible curve called `wish`, or like it where that name is used; where there is none, notes that the
    /// entity `what`, or a curve where that is empty, at `place` was left out. The pointer, null then, holds until the
    /// next curve comes.
    core::DocumentCurve* add(MadeCurve made, const std::string& wish, std::string_view what, const PlaceText& place);

    /// Whether there is no room for another curve, which then need not be made: `leave_out_more` notes that there was
    /// one.
    bool is_full() const { return document_.curves.size() == most_curves; }
    void leave_out_more(const PlaceText& place);

    /// What happened, in sentences.
    Notes& notes() { return notes_; }

    /// What is lost of the look, likewise.
    Notes& looks() { return looks_; }

    /// Notes that heights of the entity `what`, or of a curve where that is empty, z other than 0, were let go.
    void note_heights(std::string_view what, const PlaceText& place);

    /// Notes that a curve is so far from what the file says, at most.
    void note_error(double error) { largest_error_ = std::max(largest_error_, error); }

    /// All that was gathered; refused where it has no curves, with the first sentence or else `nothing_found`.
    core::FileResult<Imported> finish(const char* nothing_found) &&;

  private:
    core::Document document_;
    core::FreeNames names_{document_};
    Notes notes_;
    Notes looks_;
    double largest_error_ = 0.0;
};

}  // namespace batten::exchange
