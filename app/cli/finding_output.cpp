#include "app/cli/finding_output.h"

#include <ostream>

#include "core/base/number_text.h"

namespace batten::cli {

void print(std::ostream& out, const editor::Finding& finding) {
    out << "  " << finding.label;
    if (finding.parameter) out << "\tu = " << core::shortest_text(*finding.parameter);
    if (finding.point) out << '\t' << point_text(*finding.point);
    for (const editor::FoundNumber& number : finding.numbers)
        out << "\t" << number.name << " = " << core::shortest_text(number.value);
    if (!finding.note.empty()) out << "\t" << finding.note;
    out << '\n';
}

Json json_of(const editor::Finding& finding) {
    Json result{{"label", finding.label}};
    if (finding.parameter) result["u"] = *finding.parameter;
    if (finding.point) result["point"] = json_of(*finding.point);
    for (const editor::FoundNumber& number : finding.numbers) result[number.name] = json_of(number.value);
    if (!finding.note.empty()) result["note"] = finding.note;
    return result;
}

}  // namespace batten::cli
