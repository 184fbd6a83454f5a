#include "app/editor/words/unknown_curve.h"

#include <vector>

#include "app/editor/words/nearest_name.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

using core::sentence;

constexpr std::size_t most_curves_told = 10;

std::vector<std::string> names_of_curves(const core::Document& document) {
    std::vector<std::string> names;
    for (const core::DocumentCurve& curve : document.curves) names.push_back(curve.name);
    return names;
}

}  // namespace

std::string unknown_curve(const core::Document& document, const std::string& name) {
    const std::vector<std::string> names = names_of_curves(document);
    const core::Place place("name", name);
    if (const auto nearest = nearest_name(name, names))
        return sentence("there is no curve '{name}'; did you mean '{nearest}'?", {place, {"nearest", *nearest}});
    if (names.empty()) return sentence("there is no curve '{name}', and no other one", {place});
    if (names.size() == 1)
        return sentence("there is no curve '{name}'; there is only '{only}', number 0",
                        {place, {"only", names.front()}});
    const core::Place last("last", names.size() - 1);
    if (names.size() <= most_curves_told)
        return sentence("there is no curve '{name}'; there are {names}, with the numbers 0 to {last}",
                        {place, last, {"names", core::quoted_names(document)}});
    core::Document first;
    first.curves.assign(document.curves.begin(), document.curves.begin() + most_curves_told);
    return sentence("there is no curve '{name}'; there are {count}, with the numbers 0 to {last}, first {names}",
                    {place, last, {"count", names.size()}, {"names", core::quoted_names(first)}});
}

}  // namespace batten::editor
