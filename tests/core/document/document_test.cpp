#include "core/document/document.h"

#include <gtest/gtest.h>

namespace batten::core {
namespace {

Document with_names(std::initializer_list<const char*> names) {
    Document document;
    for (const char* name : names) {
        DocumentCurve entry;
        entry.name = name;
        document.curves.push_back(entry);
    }
    return document;
}

TEST(Document, free_name_is_kept) {
    EXPECT_EQ(unused_name(Document{}, "wave"), "wave");
    EXPECT_EQ(unused_name(with_names({"wave 2"}), "wave"), "wave");
    EXPECT_EQ(unused_name(with_names({"wave"}), "Wave"), "Wave");
}

TEST(Document, taken_name_gets_the_next_number) {
    EXPECT_EQ(unused_name(with_names({"wave"}), "wave"), "wave 2");
    EXPECT_EQ(unused_name(with_names({"wave", "wave 2"}), "wave"), "wave 3");
    EXPECT_EQ(unused_name(with_names({"wave", "wave 2"}), "wave 2"), "wave 3");
    EXPECT_EQ(unused_name(with_names({"wave", "wave 3"}), "wave"), "wave 2");
}

TEST(Document, number_is_only_what_follows_a_blank) {
    EXPECT_EQ(unused_name(with_names({"T1"}), "T1"), "T1 2");
    EXPECT_EQ(unused_name(with_names({"7"}), "7"), "7 2");
    EXPECT_EQ(unused_name(with_names({" 7"}), " 7"), " 7 2");
}

TEST(Document, names_that_are_taken_are_in_use) {
    FreeNames names(with_names({"wave", "wave 3"}));
    EXPECT_EQ(names.take("wave"), "wave 2");
    EXPECT_EQ(names.take("wave"), "wave 4");
    EXPECT_EQ(names.take("wave 3"), "wave 5");
    EXPECT_EQ(names.take("wave 6"), "wave 6");
    EXPECT_EQ(names.take("wave 2"), "wave 7");
    EXPECT_EQ(names.take(""), "curve");
    EXPECT_EQ(names.take(""), "curve 2");
}

TEST(Document, empty_wish_is_a_curve) {
    EXPECT_EQ(unused_name(Document{}, ""), "curve");
    EXPECT_EQ(unused_name(with_names({"curve"}), ""), "curve 2");
}

TEST(Document, curve_is_meant_by_its_name_before_its_number) {
    const Document document = with_names({"wave", "0", "7", "wave"});
    EXPECT_EQ(curve_meant_by(document, "wave"), 0U);
    EXPECT_EQ(curve_meant_by(document, "0"), 1U);
    EXPECT_EQ(curve_meant_by(document, "1"), 1U);
    EXPECT_EQ(curve_meant_by(document, "7"), 2U);
    EXPECT_EQ(curve_meant_by(document, "3"), 3U);
    for (const char* nobody : {"4", "-1", "+1", "1.0", "1 ", "", "Wave", "99999999999999999999999"})
        EXPECT_EQ(curve_meant_by(document, nobody), std::nullopt) << nobody;
}

TEST(Document, active_curve_is_none_without_curves) {
    EXPECT_EQ(Document{}.active_curve(), nullptr);
    Document document = with_names({"a", "b"});
    document.active = 1;
    EXPECT_EQ(document.active_curve()->name, "b");
}

}  // namespace
}  // namespace batten::core
