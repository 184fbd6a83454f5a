#include "exchange/json/json_tree.h"

#include <algorithm>

#include "core/base/sentence.h"
#include "core/document/json_walk.h"

namespace batten::exchange {

namespace {

constexpr std::size_t most_values = 2'000'000;  // beside numbers in lists
constexpr std::size_t longest_row = 4;

class TreeMaker : public core::JsonListener {
  public:
    JsonValue& tree() { return tree_; }

    bool scalar(core::JsonScalar value) override;
    bool begin_list() override { return enter(true); }
    bool end_list() override;
    bool begin_object() override { return enter(false); }
    bool end_object() override;
    bool name(std::string name) override;
    std::string refusal() const override;

  private:
    // A list or an object whose end is not read yet.
    struct Open {
        bool is_list;
        JsonList list{};
        JsonValue::Object object{};
    };

    bool enter(bool is_list);
    bool add(JsonValue value);
    bool add_number(double value);
    bool add_row(const std::vector<double>& row);

    JsonValue tree_;
    std::vector<Open> open_;
    std::size_t value_count_ = 0;
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

bool TreeMaker::scalar(core::JsonScalar value) {
    if (const double* const number = std::get_if<double>(&value)) return add_number(*number);
    return add(JsonValue(std::move(value)));
}

std::string TreeMaker::refusal() const {
    return core::sentence("there are more than {most} texts, lists and objects, the most that is read",
                          {{"most", most_values}});
}

bool TreeMaker::enter(bool is_list) {
    open_.push_back({is_list});
    return true;
}

bool TreeMaker::add(JsonValue value) {
    if (++value_count_ > most_values) return false;
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

bool TreeMaker::end_list() {
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

bool TreeMaker::name(std::string name) {
    open_.back().object.emplace_back(std::move(name), JsonValue());
    return true;
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
    TreeMaker maker;
    return core::walk_json(text, maker).map([&] { return std::move(maker.tree()); });
}

}  // namespace batten::exchange
