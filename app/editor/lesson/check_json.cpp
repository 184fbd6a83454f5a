#include "app/editor/lesson/check_json.h"

#include <array>
#include <utility>

namespace batten::editor {

namespace {

// In the order of LessonCheck.
constexpr std::array<const char*, std::variant_size_v<LessonCheck>> check_names{
    "degree",           "point-count", "segment-count",  "curve-count", "multiplicity", "continuity",
    "no-interior-knot", "kind",        "passes-through", "circle",      "conic",        "closed",
    "rational",         "weight",      "point-at",       "parameter",   "overlay",      "joined",
    "collinear",        "smoothness",  "clamped",        "crossings",   "convex"};

/// The members of each check, for reading and writing alike: those that it has of all that there are.
template <class Members>
struct Describe {
    Members& members;

    template <class Check>
    void operator()(Check& check) const {
        if constexpr (requires { check.overlay; }) put("overlay", check.overlay);
        if constexpr (requires { check.first; }) put("first", check.first);
        if constexpr (requires { check.second; }) put("second", check.second);
        if constexpr (requires { check.points; }) put("points", check.points);
        if constexpr (requires { check.point; }) put("point", check.point);
        if constexpr (requires { check.knot; }) put("knot", check.knot);
        if constexpr (requires { check.at; }) put("at", check.at);
        if constexpr (requires { check.order; }) put("order", check.order);
        if constexpr (requires { check.end; }) put("end", check.end);
        if constexpr (requires { check.polygon; }) put("polygon", check.polygon);
        if constexpr (requires { check.curve; }) put("curve", check.curve);
        if constexpr (requires { check.of; }) put("of", check.of);
        if constexpr (requires { check.is; }) put("is", check.is);
        if constexpr (requires { check.within; }) members.optional("within", check.within);
    }
    void operator()(PassesThrough& check) const {
        members.optional("point", check.point);
        members.optional("at", check.at);
        members.optional("within", check.within);
    }

  private:
    template <class T>
    void put(const char* name, T& member) const {
        members.required(name, member);
    }
    template <class T>
    void put(const char* name, std::optional<T>& member) const {
        members.optional(name, member);
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
