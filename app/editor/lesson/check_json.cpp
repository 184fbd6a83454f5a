#include "app/editor/lesson/check_json.h"

#include <array>
#include <utility>

namespace batten::editor {

namespace {

// In the order of LessonCheck.
constexpr std::array<const char*, std::variant_size_v<LessonCheck>> check_names{
    "degree",   "point-count",    "segment-count", "curve-count", "multiplicity", "continuity", "no-interior-knot",
    "kind",     "passes-through", "circle",        "conic",       "closed",       "rational",   "weight",
    "point-at", "parameter",      "overlay",       "joined",      "collinear"};

/// The members of each check, for reading and writing alike.
template <class Members>
struct Describe {
    Members& members;

    void operator()(DegreeIs& check) const { members.required("is", check.is); }
    void operator()(PointCountIs& check) const { members.required("is", check.is); }
    void operator()(SegmentCountIs& check) const { members.required("is", check.is); }
    void operator()(CurveCountIs& check) const { members.required("is", check.is); }
    void operator()(MultiplicityIs& check) const {
        members.required("knot", check.knot);
        members.required("is", check.is);
    }
    void operator()(ContinuityIs& check) const {
        members.required("knot", check.knot);
        members.required("is", check.is);
    }
    void operator()(NoInteriorKnot&) const {}
    void operator()(KindIs& check) const { members.required("is", check.is); }
    void operator()(PassesThrough& check) const {
        members.optional("point", check.point);
        members.optional("at", check.at);
        members.optional("within", check.within);
    }
    void operator()(IsCircle& check) const { members.optional("within", check.within); }
    void operator()(ConicIs& check) const { members.required("is", check.is); }
    void operator()(IsClosed&) const {}
    void operator()(IsRational& check) const { members.required("is", check.is); }
    void operator()(WeightIs& check) const {
        members.required("point", check.point);
        members.required("is", check.is);
        members.optional("within", check.within);
    }
    void operator()(PointIsAt& check) const {
        members.required("point", check.point);
        members.required("at", check.at);
        members.optional("within", check.within);
    }
    void operator()(ParameterIs& check) const {
        members.required("is", check.is);
        members.optional("within", check.within);
    }
    void operator()(OverlayIsShown& check) const { members.required("overlay", check.overlay); }
    void operator()(CurvesJoin& check) const {
        members.required("first", check.first);
        members.required("second", check.second);
        members.required("order", check.order);
        members.optional("within", check.within);
    }
    void operator()(PointsAreCollinear& check) const {
        members.required("points", check.points);
        members.optional("within", check.within);
    }
};

template <std::size_t... index>
LessonCheck check_of_kind(std::size_t kind, std::index_sequence<index...>) {
    LessonCheck check;
    static_cast<void>(((index == kind ? (check.emplace<index>(), true) : false) || ...));
    return check;
}

}  // namespace

Outcome<LessonCheck> read_check(const LessonJson& json, const std::string& pointer) {
    MemberReader reader(json, pointer);
    std::string name;
    reader.required("check", name);
    const auto* const found = std::find(check_names.begin(), check_names.end(), name);
    if (found == check_names.end()) {
        const std::vector<std::string> names(check_names.begin(), check_names.end());
        reader.fail(reader.place("check"), core::listed_as_alternatives(names).c_str());
        return tl::unexpected(*reader.finish());
    }
    LessonCheck check = check_of_kind(static_cast<std::size_t>(found - check_names.begin()),
                                      std::make_index_sequence<std::variant_size_v<LessonCheck>>());
    std::visit(Describe<MemberReader>{reader}, check);
    if (std::optional<Refusal> refusal = reader.finish()) return tl::unexpected(*std::move(refusal));
    return check;
}

LessonJson json_of(const LessonCheck& check) {
    MemberWriter writer;
    writer.required("check", std::string(name_of(check)));
    LessonCheck copy = check;
    std::visit(Describe<MemberWriter>{writer}, copy);
    return writer.take();
}

const char* name_of(const LessonCheck& check) {
    return check_names[check.index()];
}

}  // namespace batten::editor
