/// Degrees that the compiler knows, so that it unrolls the loops over them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "core/base/degree_range.h"

namespace batten::core {

template <std::size_t P>
using KnownDegree = std::integral_constant<std::size_t, P>;

/// The largest number of local points of a degree: of a KnownDegree or, where it is only known later, of any.
template <class Degree>
inline constexpr std::size_t most_local_points = max_degree + 1;
template <std::size_t P>
inline constexpr std::size_t most_local_points<KnownDegree<P>> = P + 1;

/// What `use` returns for degree p, handed over as a KnownDegree where it is at most `Most`: one of the usual.
template <std::size_t Most = 5, class Use>
auto with_known_degree(std::size_t p, Use use) {
    if constexpr (Most == 0)
        return use(p);
    else
        return p == Most ? use(KnownDegree<Most>()) : with_known_degree<Most - 1>(p, use);
}

/// The levels 1, 2, ... up to `most` and to p, each as a KnownDegree where p is one, as long as `use` of one is true.
template <std::size_t P, class Use>
void while_level(KnownDegree<P>, std::size_t most, Use use) {
    [&]<std::size_t... K>(std::index_sequence<K...>) {
        ((K < most && use(KnownDegree<K + 1>())) && ...);
    }
    (std::make_index_sequence<P>());
}
template <class Use>
void while_level(std::size_t p, std::size_t most, Use use) {
    for (std::size_t k = 1; k <= std::min(most, p) && use(k); ++k) continue;
}

/// `use` of all those levels.
template <class Degree, class Use>
void for_each_level(Degree p, std::size_t most, Use use) {
    while_level(p, most, [&](auto k) {
        use(k);
        return true;
    });
}

}  // namespace batten::core
