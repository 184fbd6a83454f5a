/// Means of neighboring sites.
#pragma once

#include <cstddef>
#include <span>

namespace batten::core {

/// means[j] = (sites[j] + ... + sites[j+p-1]) / p, as if it were computed in twice the precision and rounded once; in
/// [sites[j], sites[j+p-1]], however close these are. There are means.size() + p - 1 sites or more, p >= 1.
void mean_of_sites(std::span<const double> sites, std::size_t p, std::span<double> means);

}  // namespace batten::core
