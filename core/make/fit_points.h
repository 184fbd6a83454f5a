/// Points that a curve is made to pass, kept so that they can be moved, added and taken out afterward.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/names.h"
#include "core/make/parametrization.h"

namespace batten::core {

/// Which curve passes the points.
enum class FitKind {
    c2,     ///< cubic, C2: of all curves over the parameters the one with the least integral of |C''|^2
    local,  ///< cubic, C1: a point that moves moves two spans on either side of it and nothing else
    fair    ///< degree 5, C4: the one with the least integral of |C'''|^2, the change of curvature
};

/// What the curve does at a point.
enum class FitJoint {
    smooth,          ///< as smooth as its kind is
    tangent,         ///< it leaves along the handle, C1
    corner,          ///< nothing is asked for
    straight,        ///< it goes straight on to the next point, and comes in along that line
    corner_straight  ///< it goes straight on to the next point, from a corner
};

struct FitPoint {
    Point place{};
    FitJoint joint = FitJoint::smooth;
    /// Of a joint with a given tangent: C' is 3 handles by the mean length of the spans beside it, so that between even
    /// spans the handle ends where that of a cubic Bézier piece does.
    Vector handle{};

    bool operator==(const FitPoint&) const = default;
};

struct FitPoints {
    std::vector<FitPoint> points{};
    /// One for each point, ascending, and one more, for the way back, where the curve is closed.
    std::vector<double> parameters{};
    FitKind kind = FitKind::c2;
    Parametrization parametrization = Parametrization::chordal;  ///< by which parameters are made when points change
    bool closed = false;

    bool operator==(const FitPoints&) const = default;
};

/// What the points of a fit are, without their places.
struct FitForm {
    FitKind kind = FitKind::c2;
    Parametrization parametrization = Parametrization::chordal;
    bool closed = false;
};

/// Smooth points at `places`; the parameters begin at 0, and a step of them is 1, the distance of two points or its
/// square root, as the parametrization says. Errors: data_points_too_few (2; 3 when closed); data_point_not_finite;
/// unless uniform, points_coincide.
[[nodiscard]] Result<FitPoints> fit_points_at(std::span<const Point> places, const FitForm& form);

/// Whether a curve can be made of `fit`: the errors of fit_points_at; those of check_parameters; vector_not_finite for
/// a handle.
[[nodiscard]] Result<void> check_fit_points(const FitPoints& fit);

/// With point `i` at `place`. The parameters are made anew, but of the local kind only that of the point itself: it
/// divides the part between its neighbors as their distances are, and at an end its span changes as its length does; of
/// the first point of a closed curve both ends of the period do, which stays as long.
/// Errors: fit_point_index_out_of_range; those of fit_points_at.
[[nodiscard]] Result<FitPoints> move_fit_point(const FitPoints& fit, std::size_t i, Point place);

/// With a smooth point at `place` that has the number `i`, at most the count of points; straight where it parts a
/// straight line. Parameters and errors as above. At an end of the local kind the new span is as long, for its chord,
/// as the one beside it.
[[nodiscard]] Result<FitPoints> insert_fit_point(const FitPoints& fit, std::size_t i, Point place);

/// Without point `i`. Errors as above.
[[nodiscard]] Result<FitPoints> delete_fit_point(const FitPoints& fit, std::size_t i);

/// With `joint` at point `i`; its handle counts where the tangent is given. Errors: fit_point_index_out_of_range;
/// vector_not_finite.
[[nodiscard]] Result<FitPoints> set_fit_joint(const FitPoints& fit, std::size_t i, FitJoint joint, Vector handle = {});

/// The same points in another form, with parameters made anew. Errors: those of fit_points_at.
[[nodiscard]] Result<FitPoints> set_fit_form(const FitPoints& fit, const FitForm& form);

/// The mean length of the spans beside point `i` of valid `fit`, by which a handle is divided.
double span_beside(const FitPoints& fit, std::size_t i);

/// The derivative C'(u_i) that the handle of point `i` asks for, and the handle for a derivative.
Vector derivative_of_handle(const FitPoints& fit, std::size_t i);
Vector handle_of_derivative(const FitPoints& fit, std::size_t i, Vector derivative);

template <>
struct Names<FitKind> {
    static constexpr std::array table{Named{FitKind::c2, "c2", "C²"}, Named{FitKind::local, "local", "local"},
                                      Named{FitKind::fair, "fair", "fair"}};
};

template <>
struct Names<FitJoint> {
    using enum FitJoint;
    static constexpr std::array table{Named{smooth, "smooth", "smooth"}, Named{tangent, "tangent", "tangent given"},
                                      Named{corner, "corner", "corner"}, Named{straight, "straight", "straight"},
                                      Named{corner_straight, "corner-straight", "corner, then straight"}};
};

}  // namespace batten::core
