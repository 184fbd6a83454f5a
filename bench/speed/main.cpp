/// Times Batten beside its peers. The arguments are Google Benchmark's.
#include <iostream>

#include "works.h"

int main(int argc, char** argv) {
    using namespace batten::bench;
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    Contests contests;
    for (const auto add : {add_sorted_samples, add_random_point, add_derivatives, add_basis, add_insert_knot,
                           add_refine, add_bezier_pieces, add_elevate, add_nearest, add_interpolate, add_arc_length})
        add(contests);
    try {
        for (const Contest& contest : contests) contest.check_agreement();
    } catch (const std::exception& disagreement) {
        std::cerr << disagreement.what() << '\n';
        return 1;
    }
    for (const Contest& contest : contests) contest.announce();
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
