#include "app/editor/words/nearest_name.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/base/ascii.h"

namespace batten::editor {

namespace {

constexpr std::size_t letters_for_a_slip = 3;
constexpr std::size_t least_beginning = 3;

// How many slips lead from `a` to `b`.
std::size_t slips_between(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before_last(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::swap(before_last, last);
        std::swap(last, row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
            const bool is_swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (is_swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
        }
    }
    return row[b.size()];
}

// The slips from `typed` to `name`, both in small letters; none where there are too many.
std::optional<std::size_t> slips_to(std::string_view typed, std::string_view name) {
    const std::size_t most = name.size() / letters_for_a_slip;
    if (typed.size() >= least_beginning && name.starts_with(typed)) return std::min(most, name.size() - typed.size());
    if (typed.size() > name.size() + most || name.size() > typed.size() + most) return std::nullopt;
    const std::size_t slips = slips_between(typed, name);
    return slips <= most ? std::optional(slips) : std::nullopt;
}

}  // namespace

std::optional<std::string> nearest_name(std::string_view typed, std::span<const std::string> names) {
    const std::string small = core::in_small_letters(typed);
    std::optional<std::string> nearest;
    std::size_t fewest = 0;
    for (const std::string& name : names) {
        const std::optional<std::size_t> slips = slips_to(small, core::in_small_letters(name));
        if (!slips || (nearest && *slips >= fewest)) continue;
        nearest = name;
        fewest = *slips;
    }
    return nearest;
}

}  // namespace batten::editor
