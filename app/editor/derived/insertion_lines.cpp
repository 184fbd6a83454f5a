#include "app/editor/derived/insertion_lines.h"

#include <fmt/format.h>

#include "core/base/sentence.h"

namespace batten::editor {

namespace {

constexpr std::size_t most_listed_cells = 5;

std::string list_of(const NamedTriangle& named, const std::vector<core::CellPlace>& places) {
    std::vector<std::string> names;
    for (const core::CellPlace place : places) names.push_back(named.point(place));
    if (names.size() > most_listed_cells) {
        names.erase(names.begin() + 2, names.end() - 1);
        names.insert(names.begin() + 2, "…");
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

constexpr core::PluralPattern replaced_pattern{.one = "u inserted once: {added} take the place of {removed}",
                                               .many = "u inserted {count} times: {added} take the place of {removed}"};
constexpr core::PluralPattern reached_pattern{.one = "u inserted once: the new point is C(u)",
                                              .many = "u inserted {count} times: the new point is C(u)"};

}  // namespace

std::vector<std::string> insertion_lines(const NamedTriangle& named) {
    const core::DeBoorTriangle& triangle = named.triangle;
    const std::size_t last = core::insertion_count(triangle);
    if (last == 0) {
        const core::CellPlace apex = core::origin_of(triangle, {triangle.levels.size() - 1, 0});
        return {core::sentence(
            "u is a knot of multiplicity {multiplicity}: {point} is C(u)",
            {{"multiplicity", named.curve.knots().multiplicity(triangle.u)}, {"point", named.point(apex)}})};
    }
    std::vector<std::string> lines;
    for (std::size_t times = 1; times < last; ++times) {
        const core::InsertionStep step = core::insertion_step(triangle, times);
        lines.push_back(
            core::sentence(replaced_pattern, times,
                           {{"added", list_of(named, step.added)}, {"removed", list_of(named, step.removed)}}));
    }
    lines.push_back(core::sentence(reached_pattern, last));
    return lines;
}

}  // namespace batten::editor
