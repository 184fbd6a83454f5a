#include "core/document/detail/joint_member.h"

#include <algorithm>
#include <cmath>

namespace batten::core {

namespace {

constexpr double most_joints = 1e9;

class JointsReader {
  public:
    explicit JointsReader(const Curve& curve) : curve_(curve) {}

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
        if (std::ranges::any_of(marks_.knots, [&](const KnotMark& other) { return other.u == u; }))
            return reader.note(FileError{reader.place("u"), "the knot is marked twice"});
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
    JointMarks marks_;
};

}  // namespace

FileResult<JointMarks> read_joints(Json& value, const std::string& pointer, const Curve& curve) {
    if (!value.is_array()) return tl::unexpected(wrong_value(pointer, value, "a list of joints"));
    JointsReader reader(curve);
    for (std::size_t k = 0; k < value.size(); ++k)
        if (auto error = reader.read(value[k], place_in(pointer, k))) return tl::unexpected(*std::move(error));
    return reader.take();
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
