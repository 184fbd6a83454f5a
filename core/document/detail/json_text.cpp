#include "core/document/detail/json_text.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <set>

#include "core/base/sentence.h"
#include "core/document/detail/number_list.h"
#include "core/document/detail/object_reader.h"

namespace batten::core {

namespace {

// The library says "[...] parse error at line 1, column 2: syntax error while parsing value - invalid literal; last
// read: '[N'". Kept is what was wrong and expected; what was read last may be long and need not be UTF-8.
std::string without_decoration(std::string message) {
    if (const auto dash = message.find(" - "); dash != std::string::npos) message.erase(0, dash + 3);
    const auto last_read = message.find("; last read: '");
    if (last_read != std::string::npos) {
        const auto expected = message.rfind("; expected ");
        const bool is_followed = expected != std::string::npos && expected > last_read;
        message.erase(last_read, is_followed ? expected - last_read : std::string::npos);
    }
    return message;
}

// The stream as the library reads it: a range that ends where the stream does, or where no more may be read.
class StreamIterator {
  public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = char;

    // Without a stream it is the end of every range.
    StreamIterator() = default;

    // `allowance` is of how many bytes may be read.
    StreamIterator(TextStream& text, std::size_t& allowance) : text_(&text), allowance_(&allowance) {}

    char operator*() const { return text_->front(); }
    StreamIterator& operator++() {
        text_->skip(1);
        --*allowance_;
        return *this;
    }
    bool operator==(const StreamIterator& other) const { return is_at_end() == other.is_at_end(); }

  private:
    bool is_at_end() const { return text_ == nullptr || *allowance_ == 0 || text_->is_at_end(); }

    TextStream* text_ = nullptr;
    std::size_t* allowance_ = nullptr;
};

// Builds the tree and notes the first defect. The numbers of curves it takes from under the library's eyes: that
// stands, when a list begins, behind its bracket, and goes on with what is left of the list.
class TreeBuilder : public nlohmann::json_sax<Json> {
  public:
    TreeBuilder(TextStream& text, const PointsRead& points_read) : text_(text), points_read_(points_read) {}

    Json& tree() { return tree_; }
    const FileError& error() const { return error_; }

    bool null() override { return add(nullptr); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(number_integer_t value) override { return add(value); }
    bool number_unsigned(number_unsigned_t value) override { return add(value); }
    bool number_float(number_float_t value, const string_t&) override { return add(value); }
    bool string(string_t& value) override { return add(std::move(value)); }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return enter(Json::object()); }
    bool end_object() override { return leave(); }
    bool end_array() override { return leave(); }

    bool start_array(std::size_t) override {
        if (!enter(Json::array())) return false;
        if (is_member_of_curve("knots") || is_member_of_curve("weights") || is_member_of_fit("parameters"))
            take_packed(ListItem::number, {});
        if (is_member_of_curve("points")) take_packed(ListItem::pair, teller_of_points());
        if (is_member_of_fit("points") || is_member_of_fit("handles")) take_packed(ListItem::pair, {});
        return true;
    }

    bool key(string_t& name) override {
        Open& object = open_.back();
        if (object.names.size() == most_members)
            return refuse_here(
                sentence("an object has more than {most} members, the most that is read", {{"most", most_members}}));
        if (!object.names.insert(name).second)
            return refuse_here(sentence("the member \"{name}\" occurs twice in one object; every name may occur once",
                                        {{"name", short_name(name)}}));
        object.next_name = std::move(name);
        return true;
    }

    bool parse_error(std::size_t byte, const std::string&, const nlohmann::detail::exception& exception) override {
        // Counted from 1, and without what was taken; at the front of an empty text there is no byte.
        const std::string where = text_.line_and_column(bytes_taken_ + std::max<std::size_t>(byte, 1) - 1);
        // The only error of another kind than syntax is a number beyond the range of doubles.
        const bool is_syntax = dynamic_cast<const Json::parse_error*>(&exception) != nullptr;
        if (!is_syntax) return refuse({where, "the number is too large; numbers must be finite"});
        return refuse(
            {where, sentence("this is not JSON: {reason}", {{"reason", without_decoration(exception.what())}})});
    }

  private:
    // A list or an object whose end is not read yet.
    struct Open {
        Json* value;
        std::string name;               // as a member of the object around it
        std::set<std::string> names{};  // of its members
        std::string next_name{};        // of the member that follows
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

    bool enter(Json value) {
        if (++value_count_ > most_values) return refuse_values();
        const std::string name = open_.empty() ? std::string() : open_.back().next_name;
        open_.push_back({&added(std::move(value)), name});
        if (open_.size() <= deepest_nesting) return true;
        return refuse_here(sentence("lists and objects are nested more than {most} deep, the most that is read",
                                    {{"most", deepest_nesting}}));
    }

    bool leave() {
        open_.pop_back();
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
        bytes_taken_ += text_.position() - before;
        if (!items.get_binary().empty()) add(std::move(items));
    }

    // At what was read last.
    bool refuse_here(const std::string& what) {
        return refuse({text_.line_and_column(std::max<std::size_t>(text_.position(), 1) - 1), what});
    }

    bool refuse(FileError found) {
        error_ = std::move(found);
        return false;
    }

    TextStream& text_;
    const PointsRead& points_read_;
    std::size_t bytes_taken_ = 0;
    std::size_t value_count_ = 0;
    Json tree_;
    std::vector<Open> open_;
    FileError error_;
};

}  // namespace

FileResult<Json> parse_json(TextStream& text, const PointsRead& points_read) {
    TreeBuilder builder(text, points_read);
    std::size_t allowance = most_other_bytes;
    const bool is_read = Json::sax_parse(StreamIterator(text, allowance), StreamIterator(), &builder);
    if (text.is_at_end() && text.error()) return tl::unexpected(*text.error());
    if (allowance == 0)
        return tl::unexpected(
            FileError{text.line_and_column(text.position()),
                      sentence("beside the numbers of curves there are more than {most} MiB, the most that is read",
                               {{"most", most_other_bytes >> 20U}})});
    if (!is_read) return tl::unexpected(builder.error());
    return std::move(builder.tree());
}

}  // namespace batten::core
