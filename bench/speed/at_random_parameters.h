/// What is computed at one random parameter after the other.
#pragma once

#include "contest.h"
#include "inputs.h"

namespace batten::bench {

inline constexpr std::size_t random_parameter_count = 4096;

/// A run of a contest: `write(u, out)` writes `Width` numbers for each parameter.
template <std::size_t Width, class Write>
auto at_random_parameters(Write write) {
    return [write, parameters = random_parameters(random_parameter_count),
            numbers = Numbers(Width * random_parameter_count)]() mutable -> const Numbers& {
        double* out = numbers.data();
        for (const double u : parameters) {
            write(u, out);
            out += Width;
        }
        return numbers;
    };
}

}  // namespace batten::bench
