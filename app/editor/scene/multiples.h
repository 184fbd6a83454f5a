/// The multiples of a step that are seen along an axis.
#pragma once

namespace batten::editor {

/// A multiple is `index` steps, kept as a double beyond all integers.
struct Multiples {
    double step = 1.0;
    double first = 0.0;
    int count = 0;

    double index(int k) const { return first + k; }
    double value(int k) const { return index(k) * step; }
};

/// Those from `lower` to `upper`; none where doubles are too coarse to tell neighbors apart.
Multiples multiples(double lower, double upper, double step);

/// The least of 1, 2, 5, 10, 20, ... that is at least `least`.
double round_number_from(double least);

}  // namespace batten::editor
