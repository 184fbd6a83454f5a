/// The degrees that curves may have.
#pragma once

namespace batten::core {

inline constexpr int min_degree = 1;
inline constexpr int max_degree = 25;

}  // namespace batten::core
