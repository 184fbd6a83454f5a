#include "core/edit/detail/joint_rows.h"

#include <array>
#include <utility>

namespace batten::core {

namespace {

constexpr double dependent = 1e-10;  // what is left of a row that others contain

double dot_of(const std::vector<Vector>& a, const std::vector<Vector>& b) {
    double sum = 0.0;
    for (std::size_t j = 0; j < a.size(); ++j) sum += dot(a[j], b[j]);
    return sum;
}

void add_multiple(std::vector<Vector>& to, double factor, const std::vector<Vector>& from) {
    for (std::size_t j = 0; j < to.size(); ++j) to[j] += factor * from[j];
}

// Makes rows for the points that are free.
class RowMaker {
  public:
    RowMaker(const JointArms& arms, const std::vector<bool>& is_free) : arms_(arms), is_free_(is_free) {}

    // Of a number that depends on both arms by these gradients, for C, C' and C''.
    void add(double miss, const std::array<Vector, 3>& by_before, const std::array<Vector, 3>& by_after) {
        MendRow row{std::vector<Vector>(is_free_.size()), miss};
        for (std::size_t j = 0; j < is_free_.size(); ++j) {
            if (!is_free_[j]) continue;
            const ActingShares& share = arms_.shares()[j];
            for (std::size_t k = 0; k < 3; ++k)
                row.gradients[j] += share.before[k] * by_before[k] + share.after[k] * by_after[k];
        }
        rows_.push_back(std::move(row));
    }

    std::vector<MendRow> take() { return std::move(rows_); }

  private:
    const JointArms& arms_;
    const std::vector<bool>& is_free_;
    std::vector<MendRow> rows_;
};

}  // namespace

std::vector<MendRow> rows_of(const JointArms& arms, const std::vector<Point>& points, const std::vector<bool>& is_free,
                             int level, std::optional<Point> place) {
    RowMaker maker(arms, is_free);
    const ArmJet before = arms.before(points);
    const ArmJet after = arms.after(points);
    for (const Vector axis : {Vector(1.0, 0.0), Vector(0.0, 1.0)}) {
        if (place) maker.add(dot(axis, before.place - *place), {axis}, {});
        if (place && arms.has_two_places()) maker.add(dot(axis, after.place - *place), {}, {axis});
        if (!place && arms.has_two_places()) maker.add(dot(axis, after.place - before.place), {-axis}, {axis});
    }
    if (level >= 1)
        maker.add(cross(before.first, after.first), {Vector{}, -turned_left(after.first)},
                  {Vector{}, turned_left(before.first)});
    if (level >= 2)
        maker.add(curvature_of(after) - curvature_of(before),
                  {Vector{}, -curvature_by_first(before), -curvature_by_second(before)},
                  {Vector{}, curvature_by_first(after), curvature_by_second(after)});
    return maker.take();
}

std::vector<Vector> shortest_moves(std::vector<MendRow> rows, std::size_t count) {
    std::vector<Vector> moves(count);
    std::vector<std::vector<Vector>> done;
    for (MendRow& row : rows) {
        const double size = dot_of(row.gradients, row.gradients);
        const double left = row.miss + dot_of(row.gradients, moves);
        for (const auto& other : done)
            add_multiple(row.gradients, -dot_of(row.gradients, other) / dot_of(other, other), other);
        const double free_size = dot_of(row.gradients, row.gradients);
        if (!(free_size > dependent * dependent * size)) continue;
        add_multiple(moves, -left / free_size, row.gradients);
        done.push_back(std::move(row.gradients));
    }
    return moves;
}

}  // namespace batten::core
