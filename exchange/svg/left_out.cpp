#include "exchange/svg/left_out.h"

#include <algorithm>

#include "core/base/sentence.h"

namespace batten::exchange {

namespace {

constexpr std::array<core::PluralPattern, svg_loss_count> loss_patterns{{
    {"the path data of '{name}' go wrong at character {detail}; they are read up to there",
     "the data of {count} paths go wrong; they are read up to there, those of '{name}' up to character {detail}"},
    {"'{name}' is left out: {detail}", "{count} curves are left out, the first one, '{name}', because {detail}"},
    {"the transform of '{name}' cannot be read, so it stands where it would without",
     "{count} transforms cannot be read, the first one that of '{name}'; what they belong to stands where it would "
     "without"},
    {"a text is left out; in the program that made it, it can be turned into paths",
     "{count} texts are left out; in the program that made them, they can be turned into paths"},
    {"an image is left out", "{count} images are left out"},
    {"a part that is no SVG is left out", "{count} parts that are no SVG are left out"},
    {"an element that is not displayed is left out", "{count} elements that are not displayed are left out"},
    {"an alternative that viewers do not show for readers of English is left out",
     "{count} alternatives that viewers do not show for readers of English are left out"},
    {"an element of another file is left out: '{name}'; nothing outside this file is read",
     "{count} elements of other files are left out, the first one '{name}'; nothing outside this file is read"},
    {"an element that is used but not there is left out: '{name}'",
     "{count} elements that are used but not there are left out, the first one '{name}'"},
    {"an element that uses itself is left out: '{name}'",
     "{count} elements that use themselves are left out, the first one '{name}'"},
    {"an element that is clipped or masked is read whole",
     "{count} elements that are clipped or masked are read whole"},
    {"a style sheet is not read, so colors may be others, and what it hides or moves is read as if it did not",
     "{count} style sheets are not read, so colors may be others, and what they hide or move is read as if they did "
     "not"},
    {"entities that the file defines are not read", "entities that the file defines are not read"},
    {"elements that are nested more than {detail} deep are left out",
     "elements that are nested more than {detail} deep are left out"},
    {"what follows the first {detail} curves or elements is left out",
     "what follows the first {detail} curves or elements is left out"},
    {"what follows is left out, since 'use' repeats more than {detail} bytes of the file",
     "what follows is left out, since 'use' repeats more than {detail} bytes of the file"},
}};

}  // namespace

void LeftOut::count(SvgLoss loss, const std::string& name, const std::string& detail) {
    Kind& kind = kinds_[static_cast<std::size_t>(loss)];
    if (kind.count++ != 0) return;
    kind.name = name;
    kind.detail = detail;
}

bool LeftOut::is_empty() const {
    return std::all_of(kinds_.begin(), kinds_.end(), [](const Kind& kind) { return kind.count == 0; });
}

std::vector<std::string> LeftOut::sentences() const {
    std::vector<std::string> told;
    for (std::size_t i = 0; i < kinds_.size(); ++i) {
        const Kind& kind = kinds_[i];
        if (kind.count == 0) continue;
        told.push_back(core::filled_as_needed(loss_patterns[i].for_count(kind.count),
                                              {{"count", kind.count}, {"name", kind.name}, {"detail", kind.detail}}));
    }
    return told;
}

}  // namespace batten::exchange
