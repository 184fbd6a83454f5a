#include "core/evaluate/whole_basis.h"

#include <algorithm>
#include <vector>

#include "core/curve/detail/trusted.h"

namespace batten::core {

WholeBasis whole_basis(const KnotVector& knots) {
    const std::span<const double> values = knots.values();
    const auto order = static_cast<std::size_t>(knots.degree()) + 1;
    const auto lacking = [&](double end) {
        const auto [first, last] = std::equal_range(values.begin(), values.end(), end);
        return order - static_cast<std::size_t>(last - first);
    };
    const std::size_t below = lacking(values.front());
    const std::size_t above = lacking(values.back());
    std::vector<double> whole(below, values.front());
    whole.insert(whole.end(), values.begin(), values.end());
    whole.insert(whole.end(), above, values.back());
    return {Trusted::knots(knots.degree(), false, KnotKind::custom, std::move(whole)), below};
}

}  // namespace batten::core
