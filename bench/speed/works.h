/// The works that are timed, one file each.
#pragma once

#include "contest.h"

namespace batten::bench {

using Contests = std::vector<Contest>;

void add_sorted_samples(Contests& contests);
void add_random_point(Contests& contests);
void add_derivatives(Contests& contests);
void add_basis(Contests& contests);
void add_insert_knot(Contests& contests);
void add_refine(Contests& contests);
void add_bezier_pieces(Contests& contests);
void add_elevate(Contests& contests);
void add_nearest(Contests& contests);
void add_interpolate(Contests& contests);
void add_arc_length(Contests& contests);
void add_text(Contests& contests);
void add_intersect(Contests& contests);
void add_offset(Contests& contests);
void add_fit(Contests& contests);

}  // namespace batten::bench
