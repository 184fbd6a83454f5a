#include "exchange/code/code.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/sentence.h"
#include "core/curve/control_box.h"
#include "core/document/native_file.h"
#include "exchange/code/languages.h"
#include "exchange/refusal.h"
#include "exchange/svg/path_text.h"

namespace batten::exchange {

namespace {

constexpr double relative_tolerance = 1e-5;

std::string json_text(const core::DocumentCurve& entry) {
    core::Document document;
    document.curves.push_back(entry);
    return core::format_document(document);
}

core::FileResult<PathPieces> pieces_of(const core::DocumentCurve& entry, Arcs arcs) {
    const core::Box box = core::control_box(*entry.curve);
    const core::Vector sides = box.upper - box.lower;
    const double wanted = relative_tolerance * std::max(sides.x, sides.y);
    PathPieces pieces = path_pieces(*entry.curve, std::max(wanted, std::numeric_limits<double>::min()), arcs);
    if (!std::isfinite(pieces.error))
        return refused_file("its points or weights are too far apart for its pieces to be computed with doubles",
                            core::sentence("curve '{name}'", {{"name", entry.name}}));
    return pieces;
}

}  // namespace

core::FileResult<Code> code_of(const core::DocumentCurve& entry, CodeLanguage language) {
    switch (language) {
        case CodeLanguage::json:
            return Code{json_text(entry)};
        case CodeLanguage::latex:
            return Code{latex_text(entry)};
        case CodeLanguage::cpp:
            return Code{cpp_text(entry)};
        case CodeLanguage::python:
            return Code{python_text(entry)};
        case CodeLanguage::matlab:
            return Code{matlab_text(entry)};
        case CodeLanguage::tikz:
            return pieces_of(entry, Arcs::as_cubics).map([&](const PathPieces& pieces) {
                return Code{tikz_text(entry, pieces), pieces.error};
            });
        case CodeLanguage::svg_path:
            break;
    }
    return pieces_of(entry, Arcs::as_arcs).map([](const PathPieces& pieces) {
        return Code{path_text(pieces), pieces.error};
    });
}

}  // namespace batten::exchange
