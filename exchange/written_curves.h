/// What writers write of a document.
#pragma once

#include "exchange/notes.h"
#include "exchange/report.h"

namespace batten::exchange {

/// The visible curves of `document`, which must live as long. Refused: there is none, or none at all.
[[nodiscard]] core::FileResult<std::vector<const core::DocumentCurve*>> visible_curves(const core::Document& document);

/// The curve over a full knot vector: itself, and a periodic one with its control points wrapped, over the knots of its
/// unrolled vector; unrolling_error() is how far that is off. No weights where all are 1.
core::CurveDefinition full_definition(const core::Curve& curve);

/// How far the curve over the full knot vector is from a periodic one, at most: the knots outside its domain, whole
/// periods from those inside, may be rounded. 0 where none is. Cost O(n + p^2).
double unrolling_error(const core::Curve& curve);

/// What a format has a place for beside open curves and their names.
struct FormatPlaces {
    bool colors = false;
    bool locks = false;
    bool units = false;
    bool periodic = false;
};

/// Notes the parts of `document` that a format with these places loses: what is hidden, pictures, units, periods, and
/// what only Batten knows.
void note_losses(Notes& notes, const core::Document& document, const FormatPlaces& places);

}  // namespace batten::exchange
