#include "app/editor/state/view_forms.h"

#include "app/editor/lesson/json_members.h"
#include "render/orbit_camera.h"

namespace batten::editor {

namespace {

constexpr const char* forms_name = "forms";
constexpr const char* by_values = "values";
constexpr const char* by_indices = "indices";

LessonJson object_in(const std::string& members) {
    LessonJson json = members.empty() ? LessonJson::object() : LessonJson::parse(members, nullptr, false);
    return json.is_object() ? json : LessonJson::object();
}

/// The member `name`, an object, by `take`.
template <class Take>
void read_part(MemberReader& parent, const LessonJson& json, const char* name, const Take& take) {
    if (!parent.has(name)) return;
    MemberReader reader(json[name], parent.place(name));
    take(reader);
    if (std::optional<Refusal> refusal = reader.error()) parent.fail(*std::move(refusal));
}

void read_line(MemberReader& reader, std::optional<ProbeLine>& target) {
    std::optional<std::vector<core::Point>> points;
    reader.optional("line", points);
    if (reader.error() || !points) return;
    if (points->size() == 2 && is_line({points->front(), points->back()}))
        target = {points->front(), points->back()};
    else
        reader.fail(reader.place("line"), "a list of two different points");
}

void read_shape(MemberReader& reader, ShapeView& shape) {
    reader.optional("comb", shape.comb_factor);
    if (!comb_factors.contains(shape.comb_factor)) reader.fail(reader.place("comb"), "from 1/64 to 64");
    reader.optional("parts", shape.part_count);
    if (shape.part_count < least_part_count || shape.part_count > most_part_count)
        reader.fail(reader.place("parts"), "from 1 to 200");
    read_line(reader, shape.line);
}

void read_map(MemberReader& reader, ShownMap& map) {
    reader.optional("kind", map.kind);
    map.amount = usual_amount(map.kind);
    reader.optional("amount", map.amount);
    if (!amounts_of(map.kind).contains(map.amount))
        reader.fail(reader.place("amount"), "within what is allowed for this map");
}

void read_orbit(MemberReader& reader, Orbit& orbit) {
    reader.optional("yaw", orbit.yaw);
    reader.optional("pitch", orbit.pitch);
    reader.optional("zoom", orbit.zoom);
    const core::Interval pitches{render::OrbitCamera::least_pitch, render::OrbitCamera::greatest_pitch};
    if (!pitches.contains(orbit.pitch)) reader.fail(reader.place("pitch"), "from −π/2 to π/2");
    if (!orbit_zooms.contains(orbit.zoom)) reader.fail(reader.place("zoom"), "from 1/4 to 16");
}

void read_blossoms(MemberReader& reader, bool& are_by_value) {
    std::string blossoms = by_indices;
    reader.optional("blossoms", blossoms);
    are_by_value = blossoms == by_values;
    if (!are_by_value && blossoms != by_indices) reader.fail(reader.place("blossoms"), "indices or values");
}

/// Sets the member where the form is not as it begins, else takes it out.
template <class T>
void keep(LessonJson& json, const char* name, const T& value, bool is_as_it_begins) {
    MemberWriter writer;
    writer.required(name, value);
    if (is_as_it_begins)
        json.erase(name);
    else
        json[name] = writer.take()[name];
}

LessonJson json_of_map(const ShownMap& map) {
    MemberWriter writer;
    writer.required("kind", map.kind);
    writer.required("amount", map.amount);
    return writer.take();
}

LessonJson json_of_orbit(const Orbit& orbit) {
    MemberWriter writer;
    writer.required("yaw", orbit.yaw);
    writer.required("pitch", orbit.pitch);
    writer.required("zoom", orbit.zoom);
    return writer.take();
}

}  // namespace

ViewForms forms_of(const View& view) {
    return {view.shape, view.shown_map, view.orbit, view.blossom_values};
}

void take_forms(View& view, const ViewForms& forms) {
    view.shape = forms.shape;
    view.shown_map = forms.map;
    view.orbit = forms.orbit;
    view.blossom_values = forms.blossom_values;
}

Outcome<ViewForms> read_forms(const std::string& members) {
    const LessonJson json = object_in(members);
    ViewForms forms;
    if (!json.contains(forms_name)) return forms;
    MemberReader reader(json[forms_name], fmt::format("/view/{}", forms_name));
    if (!reader.error()) {
        const LessonJson& object = json[forms_name];
        read_shape(reader, forms.shape);
        read_part(reader, object, "map", [&](MemberReader& part) { read_map(part, forms.map); });
        read_part(reader, object, "orbit", [&](MemberReader& part) { read_orbit(part, forms.orbit); });
        read_blossoms(reader, forms.blossom_values);
    }
    if (std::optional<Refusal> refusal = reader.error()) return tl::unexpected(*std::move(refusal));
    return forms;
}

std::string with_forms(const std::string& members, const ViewForms& forms) {
    const ViewForms begin;
    LessonJson json = object_in(members);
    LessonJson kept = json.contains(forms_name) ? json[forms_name] : LessonJson::object();
    keep(kept, "comb", forms.shape.comb_factor, forms.shape.comb_factor == begin.shape.comb_factor);
    keep(kept, "parts", forms.shape.part_count, forms.shape.part_count == begin.shape.part_count);
    const ProbeLine line = forms.shape.line.value_or(ProbeLine{});
    keep(kept, "line", std::vector<core::Point>{line.first, line.second}, !forms.shape.line);
    keep(kept, "map", json_of_map(forms.map), forms.map == begin.map);
    keep(kept, "orbit", json_of_orbit(forms.orbit), forms.orbit == begin.orbit);
    keep(kept, "blossoms", std::string(by_values), !forms.blossom_values);
    if (kept.empty())
        json.erase(forms_name);
    else
        json[forms_name] = std::move(kept);
    return json.empty() ? std::string() : json.dump();
}

}  // namespace batten::editor
