/// Reads and writes the members of JSON objects by one description of them.
#pragma once

#include <fmt/core.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/editor/fields/field.h"
#include "core/base/geometry.h"
#include "core/base/names.h"
#include "core/base/sentence.h"

namespace batten::editor {

using LessonJson = nlohmann::ordered_json;

/// Takes the members of an object; after the first error nothing more is taken.
class MemberReader {
  public:
    MemberReader(const LessonJson& object, std::string pointer) : object_(object), pointer_(std::move(pointer)) {
        if (!object.is_object()) fail(pointer_, "an object");
    }

    template <class T>
    void required(const char* name, T& target) {
        if (error_) return;
        if (!object_.contains(name)) {
            error_ = core::sentence("{place}: the member \"{name}\" is missing", {{"place", pointer_}, {"name", name}});
            return;
        }
        optional(name, target);
    }

    template <class T>
    void optional(const char* name, T& target) {
        known_.insert(name);
        if (!error_ && object_.contains(name)) take(object_[name], place(name), target);
    }

    /// Whether there is such a member, which is known from now on.
    bool has(const char* name) {
        known_.insert(name);
        return !error_ && object_.contains(name);
    }

    /// What is wrong, an unknown member among it.
    std::optional<Refusal> finish() {
        if (error_) return error_;
        for (const auto& [name, value] : object_.items())
            if (!known_.contains(name))
                return core::sentence("{place}: this member is not known", {{"place", place(name)}});
        return std::nullopt;
    }

    /// What is wrong with the members taken so far.
    const std::optional<Refusal>& error() const { return error_; }

    void fail(const std::string& place, const char* allowed) {
        if (!error_)
            error_ = core::sentence("{place}: this must be {allowed}", {{"place", place}, {"allowed", allowed}});
    }
    void fail(Refusal refusal) {
        if (!error_) error_ = std::move(refusal);
    }

    std::string place(std::string_view name) const { return fmt::format("{}/{}", pointer_, name); }

  private:
    template <class T>
    void take(const LessonJson& value, const std::string& at, std::optional<T>& target) {
        take(value, at, target.emplace());
    }
    template <class T>
    void take(const LessonJson& value, const std::string& at, std::vector<T>& target) {
        if (!value.is_array()) return fail(at, "a list");
        target.clear();
        for (std::size_t i = 0; i < value.size() && !error_; ++i)
            take(value[i], fmt::format("{}/{}", at, i), target.emplace_back());
    }
    void take(const LessonJson& value, const std::string& at, std::string& target) {
        if (!value.is_string()) return fail(at, "a text");
        target = value.get<std::string>();
    }
    void take(const LessonJson& value, const std::string& at, bool& target) {
        if (!value.is_boolean()) return fail(at, "true or false");
        target = value.get<bool>();
    }
    void take(const LessonJson& value, const std::string& at, double& target) {
        if (!value.is_number()) return fail(at, "a number");
        target = value.get<double>();
    }
    void take(const LessonJson& value, const std::string& at, int& target) {
        if (!value.is_number_integer()) return fail(at, "a whole number");
        target = value.get<int>();
    }
    void take(const LessonJson& value, const std::string& at, std::size_t& target) {
        if (!value.is_number_unsigned()) return fail(at, "a whole number from 0 on");
        target = value.get<std::size_t>();
    }
    void take(const LessonJson& value, const std::string& at, core::Point& target) {
        std::vector<double> numbers;
        take(value, at, numbers);
        if (error_) return;
        if (numbers.size() != 2) return fail(at, "a list of two numbers");
        target = {numbers[0], numbers[1]};
    }
    template <core::HasNames Enum>
    void take(const LessonJson& value, const std::string& at, Enum& target) {
        const std::optional<Enum> found =
            value.is_string() ? core::value_named<Enum>(value.get<std::string>()) : std::nullopt;
        if (found)
            target = *found;
        else
            fail(at, names_text<Enum>().c_str());
    }

    template <core::HasNames Enum>
    static std::string names_text() {
        std::vector<std::string> names;
        for (const auto& entry : core::Names<Enum>::table) names.emplace_back(entry.name);
        return core::listed_as_alternatives(names);
    }

    const LessonJson& object_;
    std::string pointer_;
    std::set<std::string, std::less<>> known_{};
    std::optional<Refusal> error_{};
};

/// Writes members into an object.
class MemberWriter {
  public:
    template <class T>
    void required(const char* name, const T& value) {
        put(name, value);
    }
    template <class T>
    void optional(const char* name, const T& value) {
        put(name, value);
    }

    LessonJson take() { return std::move(object_); }

  private:
    template <class T>
    void put(const char* name, const T& value) {
        object_[name] = json_of(value);
    }
    template <class T>
    void put(const char* name, const std::optional<T>& value) {
        if (value) object_[name] = json_of(*value);
    }
    void put(const char* name, const std::string& value) {
        if (!value.empty()) object_[name] = value;
    }

    template <class T>
    requires(!core::HasNames<T>) static LessonJson json_of(const T& value) { return value; }
    template <core::HasNames Enum>
    static LessonJson json_of(Enum value) {
        return core::name_of(value);
    }
    template <class T>
    static LessonJson json_of(const std::vector<T>& values) {
        LessonJson list = LessonJson::array();
        for (const T& value : values) list.push_back(json_of(value));
        return list;
    }
    static LessonJson json_of(core::Point point) { return LessonJson::array({point.x, point.y}); }
    static LessonJson json_of(double value) {
        constexpr double exact_up_to = 1e15;
        return std::trunc(value) == value && std::abs(value) < exact_up_to
                   ? LessonJson(static_cast<std::int64_t>(value))
                   : LessonJson(value);
    }

    LessonJson object_ = LessonJson::object();
};

}  // namespace batten::editor
