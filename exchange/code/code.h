/// A curve as text to be pasted into programs and papers.
#pragma once

#include <string>

#include "core/base/names.h"
#include "core/document/document.h"
#include "core/document/file_text.h"

namespace batten::exchange {

enum class CodeLanguage { json, latex, tikz, svg_path, cpp, python, matlab };

struct Code {
    std::string text;    ///< whole lines, but for that of SVG
    double error = 0.0;  ///< no point of the curve is farther from what the text draws; 0: the text is exact
};

/// The curve of `entry` in a language; numbers are the shortest texts that read back to the same doubles. Periodic
/// curves are written wrapped: the first p control points again, and the knots of the domain continued to both sides.
///
/// - json: a document in Batten's own format.
/// - latex: a table of the points and the list of the knots, small fractions as such; needs amsmath.
/// - tikz: a path, exact where the curve is a polynomial of degree 3 at most, else within a hundred thousandth of
///   the larger side of its box; where TeX's numbers do not reach it is moved and scaled, which a comment tells.
/// - svg_path: what stands in the attribute `d`, likewise, with arcs of circles as such; y points down.
/// - cpp: arrays and a function that gives points, C++17.
/// - python: a BSpline of SciPy, or a function where the curve is rational.
/// - matlab: the B-form or, of a rational curve, the rB-form of the Curve Fitting Toolbox.
///
/// Error: the numbers of the curve are beyond what its pieces can be computed with (tikz, svg_path).
core::FileResult<Code> code_of(const core::DocumentCurve& entry, CodeLanguage language);

}  // namespace batten::exchange

namespace batten::core {

template <>
struct Names<exchange::CodeLanguage> {
    using enum exchange::CodeLanguage;
    static constexpr std::array table{Named{json, "json", "JSON"},      Named{latex, "latex", "LaTeX"},
                                      Named{tikz, "tikz", "TikZ"},      Named{svg_path, "svg-path", "SVG path"},
                                      Named{cpp, "cpp", "C++"},         Named{python, "python", "Python"},
                                      Named{matlab, "matlab", "MATLAB"}};
};

}  // namespace batten::core
