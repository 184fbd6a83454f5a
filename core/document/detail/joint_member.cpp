#include "core/document/detail/joint_member.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/curve/control_box.h"
#include "core/document/detail/joint_truth.h"

namespace batten::core {

namespace {

constexpr double most_joints = 1e9;

class JointsReader {
  public:
    explicit JointsReader(const Curve& curve) : curve_(curve), size_(robust_length(control_box(curve).size())) {}

    std::optional<FileError> read(Json& object, const std::string& pointer) {
        ObjectReader reader(object, pointer);
        JointMark mark = JointMark::smooth;
        reader.required("mark", mark);
        if (reader.find("end") != nullptr)
            read_end(reader, mark);
        else
            read_knot(reader, mark);
        return reader.error();
    }

    JointMarks take() {
        std::ranges::sort(marks_.knots, {}, &KnotMark::u);
        std::ranges::sort(marks_.ends, {}, &EndMark::end);
        return std::move(marks_);
    }

  private:
    void read_knot(ObjectReader& reader, JointMark mark) {
        double u = 0.0;
        reader.required("u", u);
        if (reader.error()) return;
        if (!is_inner_knot(curve_, u))
            return reader.note(wrong_value(reader.place("u"), *reader.find("u"), "a knot inside the domain"));
        if (!marked_.insert(u).second) return reader.note(FileError{reader.place("u"), "the knot is marked twice"});
        if (const auto allowed = marks_instead(curve_, size_, u, mark))
            return reader.note(wrong_value(reader.place("mark"), name_of(mark), *allowed));
        marks_.knots.push_back({u, mark, reader.unknown_members()});
    }

    void read_end(ObjectReader& reader, JointMark mark) {
        EndMark end{.mark = mark};
        double joint = 0.0;
        reader.required("end", end.end);
        reader.required("joint", joint);
        if (reader.error()) return;
        if (!(joint >= 0.0 && joint <= most_joints && std::trunc(joint) == joint))
            return reader.note(
                wrong_value(reader.place("joint"), *reader.find("joint"), "a whole number from 0 to 1000000000"));
        if (curve_.is_periodic()) return reader.note(FileError{reader.place("end"), "a periodic curve has no ends"});
        if (std::ranges::any_of(marks_.ends, [&](const EndMark& other) { return other.end == end.end; }))
            return reader.note(FileError{reader.place("end"), "the end is marked twice"});
        end.joint = static_cast<std::size_t>(joint);
        end.unknown_members = reader.unknown_members();
        marks_.ends.push_back(std::move(end));
    }

    const Curve& curve_;
    double size_;
    std::set<double> marked_;  // knots
    JointMarks marks_;
};

// A marked end of a curve.
struct EndFound {
    std::size_t curve;
    EndMark mark;
};

FileError untrue_end(const EndFound& end, const Json& objects, const std::string& pointer, const std::string& allowed) {
    const Json& list = objects[end.curve]["joints"];
    std::size_t k = 0;
    while (!list[k].contains("end") || list[k]["end"] != name_of(end.mark.end)) ++k;
    const std::string place = place_in(place_in(place_in(pointer, end.curve), "joints"), k);
    return wrong_value(place_in(place, "mark"), name_of(end.mark.mark), allowed);
}

}  // namespace

FileResult<JointMarks> read_joints(Json& value, const std::string& pointer, const Curve& curve) {
    if (!value.is_array()) return tl::unexpected(wrong_value(pointer, value, "a list of joints"));
    JointsReader reader(curve);
    for (std::size_t k = 0; k < value.size(); ++k)
        if (auto error = reader.read(value[k], place_in(pointer, k))) return tl::unexpected(*std::move(error));
    return reader.take();
}

// Of a number that more ends have than two, as a file may that was written by hand, only two belong together.
std::optional<FileError> check_marked_ends(const std::vector<DocumentCurve>& curves, const Json& objects,
                                           const std::string& pointer) {
    std::map<std::size_t, std::vector<EndFound>> joints;
    for (std::size_t i = 0; i < curves.size(); ++i)
        for (const EndMark& mark : curves[i].joints.ends) {
            std::vector<EndFound>& ends = joints[mark.joint];
            if (ends.size() >= 2) continue;
            ends.push_back({i, mark});
            if (ends.size() < 2) continue;
            for (const EndFound& end : ends)
                if (const auto allowed = marks_instead(*curves[ends[0].curve].curve, ends[0].mark.end, *curves[i].curve,
                                                       mark.end, end.mark.mark))
                    return untrue_end(end, objects, pointer, *allowed);
        }
    return std::nullopt;
}

Json json_of_joints(const JointMarks& marks) {
    Json list = Json::array();
    for (const KnotMark& knot : marks.knots) {
        Json object = Json::object();
        object["u"] = json_number(knot.u);
        object["mark"] = name_of(knot.mark);
        add_unknown_members(object, knot.unknown_members);
        list.push_back(std::move(object));
    }
    for (const EndMark& end : marks.ends) {
        Json object = Json::object();
        object["end"] = name_of(end.end);
        object["joint"] = end.joint;
        object["mark"] = name_of(end.mark);
        add_unknown_members(object, end.unknown_members);
        list.push_back(std::move(object));
    }
    return list;
}

}  // namespace batten::core
