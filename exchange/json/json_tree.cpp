#include "exchange/json/json_tree.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <unordered_set>

#include "core/base/sentence.h"

namespace batten::exchange {

namespace {

using Json = nlohmann::json;

constexpr std::size_t deepest_nesting = 100;
constexpr std::size_t most_members = 1000;
constexpr std::size_t most_values = 2'000'000;  // beside numbers in lists
constexpr std::size_t longest_row = 4;

std::string place_of_byte(std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, byte);
    const auto lines = static_cast<std::size_t>(std::ranges::count(before, '\n'));
    const std::size_t last = before.rfind('\n');
    const std::size_t column = last == std::string_view::npos ? before.size() : before.size() - last - 1;
    return core::sentence("line {line}, column {column}", {{"line", lines + 1}, {"column", column + 1}});
}

class TreeMaker : public nlohmann::json_sax<Json> {
  public:
    explicit TreeMaker(std::string_view text) : text_(text) {}

    JsonValue& tree() { return tree_; }
    const core::FileError& error() const { return error_; }

    bool null() override { return add(JsonValue()); }
    bool boolean(bool value) override { return add(JsonValue(value)); }
    bool number_integer(number_integer_t value) override { return add_number(static_cast<double>(value)); }
    bool number_unsigned(number_unsigned_t value) override { return add_number(static_cast<double>(value)); }
    bool number_float(number_float_t value, const string_t& /*text*/) override { return add_number(value); }
    bool string(string_t& value) override { return add(JsonValue(std::move(value))); }
    bool binary(binary_t& /*value*/) override { return false; }
    bool start_object(std::size_t /*count*/) override { return enter(false); }
    bool start_array(std::size_t /*count*/) override { return enter(true); }
    bool end_object() override;
    bool end_array() override;
    bool key(string_t& name) override;
    bool parse_error(std::size_t byte, const std::string& token, const nlohmann::detail::exception& exception) override;

  private:
    // A list or an object whose end is not read yet.
    struct Open {
        bool is_list;
        JsonList list{};
        JsonValue::Object object{};
        std::unordered_set<std::string> names{};  // of the members, where they are many
    };

    bool enter(bool is_list);
    bool add(JsonValue value);
    bool add_number(double value);
    bool add_row(const std::vector<double>& row);
    bool refuse(core::FileError error);
    static bool is_new_name(Open& open, const std::string& name);

    std::string_view text_;
    JsonValue tree_;
    std::vector<Open> open_;
    std::size_t value_count_ = 0;
    core::FileError error_;
};

std::size_t item_count(const JsonList& list) {
    if (!list.items.empty()) return list.items.size();
    return list.row_length == 0 ? list.numbers.size() : list.numbers.size() / list.row_length;
}

// What is of another sort than the items before it is not kept, and nothing that follows.
bool note_odd(JsonList& list) {
    if (!list.first_odd) list.first_odd = item_count(list);
    return true;
}

bool TreeMaker::refuse(core::FileError error) {
    error_ = std::move(error);
    return false;
}

bool TreeMaker::enter(bool is_list) {
    if (open_.size() == deepest_nesting)
        return refuse(
            {"", core::sentence("lists and objects are nested more than {most} deep", {{"most", deepest_nesting}})});
    open_.push_back({is_list});
    return true;
}

bool TreeMaker::add(JsonValue value) {
    if (++value_count_ > most_values)
        return refuse(
            {"", core::sentence("there are more than {most} texts, lists and objects", {{"most", most_values}})});
    if (open_.empty()) {
        tree_ = std::move(value);
        return true;
    }
    Open& around = open_.back();
    if (!around.is_list) {
        around.object.back().second = std::move(value);
        return true;
    }
    if (!around.list.numbers.empty() || around.list.first_odd) return note_odd(around.list);
    around.list.items.push_back(std::move(value));
    return true;
}

bool TreeMaker::add_number(double value) {
    if (open_.empty() || !open_.back().is_list) return add(JsonValue(value));
    JsonList& list = open_.back().list;
    if (!list.items.empty() || list.row_length > 0 || list.first_odd) return note_odd(list);
    list.numbers.push_back(value);
    return true;
}

bool TreeMaker::add_row(const std::vector<double>& row) {
    JsonList& list = open_.back().list;
    const bool is_first = list.numbers.empty() && list.items.empty() && !list.first_odd;
    if (is_first) list.row_length = row.size();
    if (!list.items.empty() || list.row_length != row.size() || list.first_odd) return note_odd(list);
    list.numbers.insert(list.numbers.end(), row.begin(), row.end());
    return true;
}

bool TreeMaker::end_array() {
    JsonList list = std::move(open_.back().list);
    open_.pop_back();
    const bool is_row = list.row_length == 0 && list.items.empty() && !list.first_odd && !list.numbers.empty() &&
                        list.numbers.size() <= longest_row;
    if (is_row && !open_.empty() && open_.back().is_list) return add_row(list.numbers);
    return add(JsonValue(std::move(list)));
}

bool TreeMaker::end_object() {
    JsonValue::Object object = std::move(open_.back().object);
    open_.pop_back();
    return add(JsonValue(std::move(object)));
}

// A few members are searched faster than a set of them is made.
bool TreeMaker::is_new_name(Open& open, const std::string& name) {
    constexpr std::size_t few_members = 16;
    if (open.object.size() < few_members)
        return std::ranges::find(open.object, name, &JsonValue::Member::first) == open.object.end();
    if (open.names.empty())
        for (const JsonValue::Member& member : open.object) open.names.insert(member.first);
    return open.names.insert(name).second;
}

bool TreeMaker::key(string_t& name) {
    JsonValue::Object& object = open_.back().object;
    if (object.size() == most_members)
        return refuse({"", core::sentence("an object has more than {most} members", {{"most", most_members}})});
    if (!is_new_name(open_.back(), name))
        return refuse({"", core::sentence("the member \"{name}\" occurs twice in one object; every name may occur once",
                                          {{"name", name}})});
    object.emplace_back(std::move(name), JsonValue());
    return true;
}

bool TreeMaker::parse_error(std::size_t byte, const std::string& /*token*/,
                            const nlohmann::detail::exception& exception) {
    // The only error of another kind than syntax is a number beyond the range of doubles.
    const bool is_syntax = dynamic_cast<const Json::parse_error*>(&exception) != nullptr;
    return refuse({place_of_byte(text_, std::max<std::size_t>(byte, 1) - 1),
                   is_syntax ? "this is not JSON; the text is wrong here or ends too early"
                             : "the number is too large; numbers must be finite"});
}

}  // namespace

const JsonList* JsonValue::list() const {
    const auto* found = std::get_if<std::unique_ptr<JsonList>>(&value_);
    return found == nullptr ? nullptr : found->get();
}

const JsonValue::Object* JsonValue::object() const {
    const auto* found = std::get_if<std::unique_ptr<Object>>(&value_);
    return found == nullptr ? nullptr : found->get();
}

const JsonValue* JsonValue::member(std::string_view name) const {
    if (object() == nullptr) return nullptr;
    const auto found = std::ranges::find(*object(), name, &Member::first);
    return found == object()->end() ? nullptr : &found->second;
}

core::FileResult<JsonValue> parse_json_tree(std::string_view text) {
    TreeMaker maker(text);
    if (!Json::sax_parse(text.begin(), text.end(), &maker)) return tl::unexpected(maker.error());
    return std::move(maker.tree());
}

}  // namespace batten::exchange
