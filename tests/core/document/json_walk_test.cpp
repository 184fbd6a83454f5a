#include "core/document/json_walk.h"

#include <gtest/gtest.h>

namespace batten::core {
namespace {

// Writes down what it is told, up to the text "stop".
class Notes : public JsonListener {
  public:
    std::string told;

    bool scalar(JsonScalar value) override {
        if (const auto* const number = std::get_if<double>(&value)) told += std::to_string(*number) + ' ';
        if (const auto* const flag = std::get_if<bool>(&value)) told += *flag ? "true " : "false ";
        if (std::holds_alternative<std::monostate>(value)) told += "null ";
        const auto* const text = std::get_if<std::string>(&value);
        if (text != nullptr) told += '"' + *text + "\" ";
        return text == nullptr || *text != "stop";
    }
    bool begin_list() override { return add("["); }
    bool end_list() override { return add("]"); }
    bool begin_object() override { return add("{"); }
    bool end_object() override { return add("}"); }
    bool name(std::string name) override { return add(name + ": "); }
    std::string refusal() const override { return "it was told to stop"; }

  private:
    bool add(const std::string& text) {
        told += text;
        return true;
    }
};

std::string refusal_of_text(const std::string& text) {
    Notes notes;
    const auto walked = walk_json(text, notes);
    return walked ? std::string() : walked.error().sentence();
}

TEST(JsonWalk, tells_everything_in_its_order) {
    Notes notes;
    ASSERT_TRUE(walk_json(R"({"a": [1, -2, 2.5, {"b": null}], "c": "d", "e": [true, false]})", notes));
    EXPECT_EQ(notes.told, "{a: [1.000000 -2.000000 2.500000 {b: null }]c: \"d\" e: [true false ]}");
}

TEST(JsonWalk, refuses_what_no_reader_takes_in_the_words_of_documents) {
    EXPECT_EQ(refusal_of_text("[1,\n2"), "line 2, column 2: this is not JSON: unexpected end of input; expected ']'");
    EXPECT_EQ(refusal_of_text("[[1e999]]"), "line 1, column 7: the number is too large; numbers must be finite");
    EXPECT_EQ(refusal_of_text("[{\"a\": 1}, {\"b\": {\"a\": 1},\n  \"b\": 2}]"),
              "line 2, column 5: the member \"b\" occurs twice in one object; every name may occur once");
    EXPECT_EQ(refusal_of_text("\n" + std::string(101, '[')),
              "line 2, column 101: lists and objects are nested more than 100 deep, the most that is read");
    EXPECT_EQ(refusal_of_text(std::string("[1,\0", 4)),
              "line 1, column 4: this is not JSON: there is a zero byte, which no text has");
}

TEST(JsonWalk, ends_where_the_listener_does) {
    EXPECT_EQ(refusal_of_text("[\n  \"stop\", 2"), "line 2, column 8: it was told to stop");
}

}  // namespace
}  // namespace batten::core
