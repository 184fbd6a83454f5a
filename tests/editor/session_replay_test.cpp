// Logs of version 0.1, from before commands were structs, lead to the same documents.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/editor/session.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

using nlohmann::json;

const std::filesystem::path folder = std::filesystem::path(BATTEN_TEST_DATA) / "sessions";

std::vector<std::string> logs() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".jsonl") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

// Numbers agree but for the last digits, in which compilers differ.
void expect_near(const json& found, const json& expected, const std::string& where) {
    ASSERT_EQ(found.is_number(), expected.is_number()) << where;
    if (expected.is_number()) {
        const auto value = expected.get<double>();
        EXPECT_NEAR(found.get<double>(), value, 1e-9 * std::max(1.0, std::abs(value))) << where;
    } else if (expected.is_structured()) {
        ASSERT_EQ(found.size(), expected.size()) << where;
        for (const auto& [key, value] : expected.items()) {
            const json& part = found.is_array() ? found[std::stoul(key)] : found.value(key, json());
            expect_near(part, value, where + "/" + key);
        }
    } else {
        EXPECT_EQ(found, expected) << where;
    }
}

class OldSessions : public ::testing::TestWithParam<std::string> {};

TEST_P(OldSessions, replay_to_the_same_documents) {
    Editor editor;
    ASSERT_TRUE(editor.run(Open{.path = folder / "start.json"}));
    std::ifstream log(folder / (GetParam() + ".jsonl"));
    for (std::string line; std::getline(log, line);) {
        const Outcome<Command> command = parse_command(line, editor.state());
        ASSERT_TRUE(command) << line << ": " << command.error();
        EXPECT_TRUE(editor.run(*command)) << line << ": " << editor.state().message.text;
    }
    const auto expected = core::load_document(folder / (GetParam() + ".end.json"));
    ASSERT_TRUE(expected) << expected.error().sentence();
    expect_near(json::parse(core::format_document(document(editor))), json::parse(core::format_document(*expected)),
                "");
}

INSTANTIATE_TEST_SUITE_P(Logs, OldSessions, ::testing::ValuesIn(logs()), [](const auto& log) {
    std::string name = log.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

}  // namespace
}  // namespace batten::editor
