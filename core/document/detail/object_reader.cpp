#include "core/document/detail/object_reader.h"

#include <fmt/core.h>

#include "core/base/sentence.h"
#include "core/base/utf8.h"

namespace batten::core {

namespace {

constexpr std::size_t longest_quotation = 60;

// What was found, short enough for a sentence.
std::string quotation(const Json& value) {
    if (value.is_object()) return "an object";
    if (value.is_array())
        return sentence({.one = "a list of one item", .many = "a list of {count} items"}, value.size());
    std::string text = value.dump();
    if (text.size() <= longest_quotation) return text;
    if (!value.is_string()) return text.substr(0, longest_quotation);
    return sentence("a text of {count} bytes", {{"count", text.size() - 2}});
}

}  // namespace

std::string short_name(std::string_view name) {
    if (name.size() <= longest_quotation) return std::string(name);
    return fmt::format("{}…", utf8_front(name, longest_quotation));
}

std::string place_in(std::string_view pointer, std::string_view name) {
    return fmt::format("{}/{}", pointer, short_name(name));
}

std::string place_in(std::string_view pointer, std::size_t index) {
    return fmt::format("{}/{}", pointer, index);
}

FileError missing_member(const std::string& pointer, std::string_view name) {
    return {pointer, sentence("the member \"{name}\" is missing", {{"name", name}})};
}

FileError wrong_value(const std::string& pointer, const Json& found, const std::string& allowed) {
    return {pointer,
            sentence("found {found}, but it must be {allowed}", {{"found", quotation(found)}, {"allowed", allowed}})};
}

FileError wrong_choice(const std::string& pointer, const Json& found, const std::vector<std::string>& names) {
    std::vector<std::string> quoted;
    for (const std::string& name : names) quoted.push_back(fmt::format("\"{}\"", name));
    return wrong_value(pointer, found, listed_as_alternatives(quoted));
}

std::optional<FileError> take(const Json& value, const std::string& pointer, bool& target) {
    if (!value.is_boolean()) return wrong_value(pointer, value, "true or false");
    target = value.get<bool>();
    return std::nullopt;
}

std::optional<FileError> take(const Json& value, const std::string& pointer, double& target) {
    if (!value.is_number()) return wrong_value(pointer, value, "a number");
    target = value.get<double>();
    return std::nullopt;
}

std::optional<FileError> take(const Json& value, const std::string& pointer, std::string& target) {
    if (!value.is_string()) return wrong_value(pointer, value, "a text");
    target = value.get<std::string>();
    return std::nullopt;
}

std::optional<FileError> take(const Json& value, const std::string& pointer,
                              std::map<std::string, std::string>& target) {
    if (!value.is_object()) return wrong_value(pointer, value, "an object");
    for (const auto& [name, member] : value.items())
        if (auto error = take(member, place_in(pointer, name), target[name])) return error;
    return std::nullopt;
}

std::optional<FileError> take(const Json& value, const std::string& pointer, Point& target) {
    if (!value.is_array() || value.size() != 2) return wrong_value(pointer, value, "a list of two numbers, x and y");
    if (auto error = take(value[0], place_in(pointer, 0), target.x)) return error;
    return take(value[1], place_in(pointer, 1), target.y);
}

// The library looks for the name first.
Json& added_member(Json& object, const std::string& name, Json value) {
    using Members = Json::object_t::Container;
    return static_cast<Members&>(object.get_ref<Json::object_t&>()).emplace_back(name, std::move(value)).second;
}

void add_unknown_members(Json& object, const std::string& unknown) {
    const Json members = Json::parse(unknown, nullptr, false);
    if (!members.is_object()) return;
    std::set<std::string> known;
    for (const auto& [name, value] : object.items()) known.insert(name);
    for (const auto& [name, value] : members.items())
        if (!known.contains(name)) added_member(object, name, value);
}

ObjectReader::ObjectReader(Json& object, std::string pointer) : object_(object), pointer_(std::move(pointer)) {
    if (!object_.is_object()) note(wrong_value(pointer_, object_, "an object"));
}

Json* ObjectReader::find(const char* name) {
    if (error_) return nullptr;
    known_.insert(name);
    const auto member = object_.find(name);
    return member == object_.end() ? nullptr : &*member;
}

void ObjectReader::note(std::optional<FileError> error) {
    if (!error_) error_ = std::move(error);
}

std::string ObjectReader::unknown_members() const {
    if (!object_.is_object()) return {};
    Json unknown = Json::object();
    for (const auto& [name, value] : object_.items())
        if (!known_.contains(name)) added_member(unknown, name, value);
    return unknown.empty() ? std::string() : unknown.dump();
}

}  // namespace batten::core
