#include "core/document/detail/fit_member.h"

#include <algorithm>
#include <cmath>

#include "core/base/sentence.h"
#include "core/curve/control_box.h"
#include "core/make/through_points.h"

namespace batten::core {

namespace {

// What stands in the file, list by list.
struct FitMembers {
    std::vector<Point> points;
    std::vector<FitJoint> joints;
    std::vector<Point> handles;
};

void note_count(ObjectReader& reader, const char* member, std::size_t found, std::size_t expected) {
    if (found == 0 || found == expected) return;
    reader.note(FileError{reader.place(member),
                          sentence({.one = "one item was found; there must be {expected}, one for each point",
                                    .many = "{count} items were found; there must be {expected}, one for each point"},
                                   found, {{"expected", expected}})});
}

std::vector<FitPoint> points_of(const FitMembers& members) {
    std::vector<FitPoint> points;
    points.reserve(members.points.size());
    for (const Point place : members.points) points.push_back({place});
    for (std::size_t i = 0; i < members.joints.size(); ++i) points[i].joint = members.joints[i];
    for (std::size_t i = 0; i < members.handles.size(); ++i) points[i].handle = vector_to(members.handles[i]);
    return points;
}

// Where in the object the error sits.
std::string place_of_error(const ObjectReader& reader, const CurveError& error) {
    switch (error.code) {
        case CurveErrorCode::data_points_too_few:
            return reader.place("points");
        case CurveErrorCode::data_point_not_finite:
            return place_in(reader.place("points"), error.index);
        case CurveErrorCode::parameter_count_mismatch:
            return reader.place("parameters");
        case CurveErrorCode::parameters_not_increasing:
            return place_in(reader.place("parameters"), error.index);
        default:
            return reader.place("handles");
    }
}

bool are_near(std::span<const double> a, std::span<const double> b, double tolerance) {
    return std::ranges::equal(a, b, [tolerance](double x, double y) { return std::abs(x - y) <= tolerance; });
}

}  // namespace

FileResult<FitMember> read_fit(Json& value, const std::string& pointer) {
    ObjectReader reader(value, pointer);
    FitPoints fit;
    FitMembers members;
    reader.required("kind", fit.kind);
    reader.optional("parametrization", fit.parametrization);
    reader.optional("closed", fit.closed);
    reader.required("points", members.points);
    reader.required("parameters", fit.parameters);
    reader.optional("joints", members.joints);
    reader.optional("handles", members.handles);
    note_count(reader, "joints", members.joints.size(), members.points.size());
    note_count(reader, "handles", members.handles.size(), members.points.size());
    if (reader.error()) return tl::unexpected(*reader.error());
    fit.points = points_of(members);
    if (const auto check = check_fit_points(fit); !check)
        return tl::unexpected(FileError{place_of_error(reader, check.error()), describe(check.error())});
    return FitMember{std::move(fit), reader.unknown_members()};
}

Json json_of_fit(const FitPoints& fit) {
    FitMembers members;
    Json joints = Json::array();
    bool has_joints = false;
    bool has_handles = false;
    for (const FitPoint& point : fit.points) {
        members.points.push_back(point.place);
        members.handles.push_back(tip_of(point.handle));
        joints.push_back(name_of(point.joint));
        has_joints = has_joints || point.joint != FitJoint::smooth;
        has_handles = has_handles || point.handle != Vector(0.0, 0.0);
    }
    Json object = Json::object();
    object["kind"] = name_of(fit.kind);
    object["parametrization"] = name_of(fit.parametrization);
    object["closed"] = fit.closed;
    object["points"] = packed(std::span<const Point>(members.points));
    object["parameters"] = packed(std::span<const double>(fit.parameters));
    if (has_joints) object["joints"] = std::move(joints);
    if (has_handles) object["handles"] = packed(std::span<const Point>(members.handles));
    return object;
}

bool is_curve_of(const FitPoints& fit, const Curve& curve) {
    constexpr double share = 1e-6;
    const auto made = through_points(fit);
    if (!made || made->degree() != curve.degree() || made->is_periodic() != curve.is_periodic() || curve.is_rational())
        return false;
    const Vector size = control_box(curve).size();
    const double tolerance = share * std::max(size.x, size.y);
    return are_near(made->knots().values(), curve.knots().values(), share * curve.domain().length()) &&
           std::ranges::equal(made->control_points(), curve.control_points(),
                              [tolerance](Point a, Point b) { return distance(a, b) <= tolerance; });
}

}  // namespace batten::core
