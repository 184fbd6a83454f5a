/// Times Batten beside its peers. The arguments are Google Benchmark's; or one alone, a folder, into which go the
/// inputs and answers that a library of another language is compared on.
#include <iostream>
#include <optional>

#include "works.h"

int main(int argc, char** argv) {
    using namespace batten::bench;
    benchmark::Initialize(&argc, argv);
    const std::optional<std::filesystem::path> folder = argc == 2 ? std::optional(argv[1]) : std::nullopt;
    if (!folder && benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    Contests contests;
    for (const auto add : {add_sorted_samples, add_random_point, add_derivatives, add_basis, add_insert_knot,
                           add_refine, add_bezier_pieces, add_elevate, add_nearest, add_interpolate, add_arc_length,
                           add_intersect, add_offset, add_fit, add_text})
        add(contests);
    try {
        for (const Contest& contest : contests) {
            contest.check_agreement();
            if (folder) contest.write_shared(*folder);
        }
    } catch (const std::exception& disagreement) {
        std::cerr << disagreement.what() << '\n';
        return 1;
    }
    if (folder) return 0;
    for (const Contest& contest : contests) contest.announce();
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
