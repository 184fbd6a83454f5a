#include "app/editor/state/view_forms.h"

#include <gtest/gtest.h>

namespace batten::editor {
namespace {

std::string refusal_of(const std::string& forms) {
    const Outcome<ViewForms> read = read_forms("{\"forms\": " + forms + "}");
    return read ? "" : read.error();
}

ViewForms other_forms() {
    ViewForms forms;
    forms.shape = {2.5, 12, ProbeLine{{0.1, -2.0}, {3.0, 1e-7}}};
    forms.map = {ShownMapKind::shear, -0.5};
    forms.orbit = {0.7, -0.3, 4.0};
    forms.blossom_values = true;
    return forms;
}

}  // namespace

TEST(ViewForms, are_read_back_as_they_were_written) {
    const ViewForms written = other_forms();
    const Outcome<ViewForms> read = read_forms(with_forms("", written));
    ASSERT_TRUE(read) << read.error();
    EXPECT_EQ(read->shape.comb_factor, 2.5);
    EXPECT_EQ(read->shape.part_count, 12);
    EXPECT_EQ(read->shape.line, written.shape.line);
    EXPECT_EQ(read->map, written.map);
    EXPECT_EQ(read->orbit, written.orbit);
    EXPECT_TRUE(read->blossom_values);
    EXPECT_EQ(with_forms(with_forms("", written), *read), with_forms("", written));
}

TEST(ViewForms, are_written_only_where_they_are_not_as_they_begin) {
    EXPECT_EQ(with_forms("", {}), "");
    ViewForms forms;
    forms.shape.part_count = 7;
    EXPECT_EQ(with_forms("", forms), R"({"forms":{"parts":7}})");
    EXPECT_EQ(with_forms(with_forms("", other_forms()), {}), "") << "back to the beginning";
}

TEST(ViewForms, keep_what_a_later_version_put_there) {
    const std::string later = R"({"shadow":true,"forms":{"comb":2,"depth":3}})";
    EXPECT_EQ(with_forms(later, {}), R"({"shadow":true,"forms":{"depth":3}})");
    const Outcome<ViewForms> read = read_forms(later);
    ASSERT_TRUE(read);
    EXPECT_EQ(with_forms(later, *read), later);
}

TEST(ViewForms, begin_as_they_do_where_there_are_none) {
    for (const char* members : {"", "{}", R"({"shadow": 1})", "[]"}) {
        const Outcome<ViewForms> read = read_forms(members);
        ASSERT_TRUE(read);
        EXPECT_EQ(read->shape.comb_factor, 1.0);
        EXPECT_EQ(read->shape.part_count, 10);
        EXPECT_FALSE(read->shape.line);
        EXPECT_EQ(read->map, ShownMap{});
        EXPECT_EQ(read->orbit, Orbit{});
        EXPECT_FALSE(read->blossom_values);
    }
    EXPECT_EQ(read_forms(R"({"forms": {"map": {"kind": "mirror"}}})")->map, (ShownMap{ShownMapKind::mirror, 90.0}));
}

TEST(ViewForms, are_refused_with_their_place) {
    EXPECT_EQ(refusal_of("3"), "/view/forms: this must be an object");
    EXPECT_EQ(refusal_of(R"({"comb": "long"})"), "/view/forms/comb: this must be a number");
    EXPECT_EQ(refusal_of(R"({"comb": 65})"), "/view/forms/comb: this must be from 1/64 to 64");
    EXPECT_EQ(refusal_of(R"({"comb": 0})"), "/view/forms/comb: this must be from 1/64 to 64");
    EXPECT_EQ(refusal_of(R"({"parts": 1.5})"), "/view/forms/parts: this must be a whole number");
    EXPECT_EQ(refusal_of(R"({"parts": 201})"), "/view/forms/parts: this must be from 1 to 200");
    EXPECT_EQ(refusal_of(R"({"line": [[0, 0]]})"), "/view/forms/line: this must be a list of two different points");
    EXPECT_EQ(refusal_of(R"({"line": [[1, 2], [1, 2]]})"),
              "/view/forms/line: this must be a list of two different points");
    EXPECT_EQ(refusal_of(R"({"line": [[1, 2], [1]]})"), "/view/forms/line/1: this must be a list of two numbers");
    EXPECT_EQ(refusal_of(R"({"map": {"kind": "twist"}})"),
              "/view/forms/map/kind: this must be rotate, scale, stretch, shear, mirror or project");
    EXPECT_EQ(refusal_of(R"({"map": {"kind": "scale", "amount": 9}})"),
              "/view/forms/map/amount: this must be within what is allowed for this map");
    EXPECT_EQ(refusal_of(R"({"orbit": {"pitch": 2}})"), "/view/forms/orbit/pitch: this must be from −π/2 to π/2");
    EXPECT_EQ(refusal_of(R"({"orbit": {"zoom": 0}})"), "/view/forms/orbit/zoom: this must be from 1/4 to 16");
    EXPECT_EQ(refusal_of(R"({"blossoms": "names"})"), "/view/forms/blossoms: this must be indices or values");
}

}  // namespace batten::editor
