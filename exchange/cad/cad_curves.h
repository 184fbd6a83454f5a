/// Curves of a document as IGES and STEP have them: clamped, in millimeters or inches.
#pragma once

#include "exchange/notes.h"
#include "exchange/report.h"

namespace batten::exchange {

/// One of them.
struct CadCurve {
    std::string name;
    core::Curve curve;   ///< clamped, in the unit of the file
    double error = 0.0;  ///< how far it is from the curve of the document, at most, in the document's coordinates
};

struct CadCurves {
    std::vector<CadCurve> curves{};
    core::LengthUnit unit = core::LengthUnit::mm;  ///< of the file; never px
    double world = 1.0;                            ///< how much of the document's coordinates one unit is
    Notes notes{};
};

/// What becomes of small weights, and of those that differ little.
enum class CadWeights {
    kept,   ///< nothing
    larger  ///< all weights of such a curve are multiplied by a power of two
};

/// The visible curves of `document`, which need not be clamped or in such a unit: what becomes of them is noted. Error:
/// there is none, or none that does not come apart.
[[nodiscard]] core::FileResult<CadCurves> cad_curves(const core::Document& document, CadWeights weights);

/// How far `copy` is from `written`, at most, where both are as a file has them, in the document's coordinates.
double copy_error(const CadCurves& curves, const CadCurve& written, const core::Curve& copy);

}  // namespace batten::exchange
