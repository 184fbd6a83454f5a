#include "core/document/detail/json_text.h"

#include <cstring>

#include "core/base/sentence.h"
#include "core/document/detail/json_checks.h"
#include "core/document/detail/number_list.h"
#include "core/document/detail/object_reader.h"

namespace batten::core {

namespace {

// Builds the tree and notes the first defect. The numbers of curves it takes from under the library's eyes: that
// stands, when a list begins, behind its bracket, and goes on with what is left of the list.
class TreeBuilder : public JsonChecks {
  public:
    TreeBuilder(TextStream& text, const PointsRead& points_read)
        : JsonChecks(text), text_(text), points_read_(points_read) {}

    Json& tree() { return tree_; }

    bool null() override { return add(nullptr); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(number_integer_t value) override { return add(value); }
    bool number_unsigned(number_unsigned_t value) override { return add(value); }
    bool number_float(number_float_t value, const string_t&) override { return add(value); }
    bool string(string_t& value) override { return add(std::move(value)); }
    bool start_object(std::size_t) override { return open(Json::object()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool start_array(std::size_t) override {
        if (!open(Json::array())) return false;
        if (is_member_of_curve("knots") || is_member_of_curve("weights") || is_member_of_fit("parameters"))
            take_packed(ListItem::number, {});
        if (is_member_of_curve("points")) take_packed(ListItem::pair, teller_of_points());
        if (is_member_of_fit("points") || is_member_of_fit("handles")) take_packed(ListItem::pair, {});
        return true;
    }

    bool key(string_t& name) override {
        if (!add_name(name)) return false;
        open_.back().next_name = std::move(name);
        return true;
    }

  private:
    // A list or an object whose end is not read yet.
    struct Open {
        Json* value;
        std::string name;         // as a member of the object around it
        std::string next_name{};  // of the member that follows
    };

    Json& added(Json value) {
        if (open_.empty()) return tree_ = std::move(value);
        Open& around = open_.back();
        if (around.value->is_object()) return added_member(*around.value, around.next_name, std::move(value));
        around.value->push_back(std::move(value));
        return around.value->back();
    }

    bool add(Json value) {
        if (++value_count_ > most_values) return refuse_values();
        added(std::move(value));
        return true;
    }

    bool refuse_values() {
        return refuse_here(
            sentence("beside the numbers of curves there are more than {most} values, the most that is read",
                     {{"most", most_values}}));
    }

    bool open(Json value) {
        if (++value_count_ > most_values) return refuse_values();
        const std::string name = open_.empty() ? std::string() : open_.back().next_name;
        open_.push_back({&added(std::move(value)), name});
        return enter();
    }

    bool close() {
        open_.pop_back();
        leave();
        return true;
    }

    // Whether the list or object opened at depth 3 is /curves/i/`name`.
    bool is_in_curve(std::string_view name) const {
        return open_[3].name == name && open_[2].value->is_object() && open_[1].name == "curves" &&
               open_[1].value->is_array() && open_[0].value->is_object();
    }

    // Whether what was opened last is /curves/i/`name`, or /curves/i/fit/`name`.
    bool is_member_of_curve(std::string_view name) const { return open_.size() == 4 && is_in_curve(name); }
    bool is_member_of_fit(std::string_view name) const {
        return open_.size() == 5 && open_[4].name == name && open_[3].value->is_object() && is_in_curve("fit");
    }

    NumbersTaken teller_of_points() const {
        if (!points_read_) return {};
        return [this](std::span<const std::uint8_t> bytes) {
            std::vector<Point> points(bytes.size() / sizeof(Point));
            std::memcpy(points.data(), bytes.data(), bytes.size());
            points_read_(points);
        };
    }

    void take_packed(ListItem item, const NumbersTaken& taken) {
        const std::size_t before = text_.position();
        Json items = take_numbers(text_, item, taken);
        note_taken(text_.position() - before);
        if (!items.get_binary().empty()) add(std::move(items));
    }

    TextStream& text_;
    const PointsRead& points_read_;
    std::size_t value_count_ = 0;
    Json tree_;
    std::vector<Open> open_;
};

}  // namespace

FileResult<Json> parse_json(TextStream& text, const PointsRead& points_read) {
    TreeBuilder builder(text, points_read);
    return builder.read(most_other_bytes).map([&] { return std::move(builder.tree()); });
}

}  // namespace batten::core
