/// Degrees that the compiler knows, so that it unrolls what loops over them.
#pragma once

#include <cstddef>
#include <type_traits>

namespace batten::core {

/// What `work` makes of the degree: of a constant where it is from 1 to 5, else of a number.
template <class Work>
auto with_constant_degree(std::size_t p, Work work) {
    switch (p) {
        case 1:
            return work(std::integral_constant<std::size_t, 1>());
        case 2:
            return work(std::integral_constant<std::size_t, 2>());
        case 3:
            return work(std::integral_constant<std::size_t, 3>());
        case 4:
            return work(std::integral_constant<std::size_t, 4>());
        case 5:
            return work(std::integral_constant<std::size_t, 5>());
        default:
            return work(p);
    }
}

}  // namespace batten::core
