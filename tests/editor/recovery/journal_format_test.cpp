#include "app/editor/recovery/journal_format.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace batten::editor {
namespace {

struct Sample {
    std::string journal{journal_head()};
    std::vector<std::size_t> ends;  // of the records
};

JournalFacts facts_of(std::size_t i) {
    return {"/home/ann/wave.json", core::FileStamp{1, 2, 3, 4, 5}, 1'800'000'000 + static_cast<std::int64_t>(i), i};
}

std::string delta_of(std::size_t i) {
    return std::string(10 * i, static_cast<char>('a' + i));
}

Sample sample() {
    Sample sample;
    RecordWriter writer;
    for (std::size_t i = 0; i < 5; ++i) {
        sample.journal += writer.written(facts_of(i), delta_of(i));
        sample.ends.push_back(sample.journal.size());
    }
    return sample;
}

// How many records are read, each of which must be the one that was written.
std::size_t records_in(const std::string& journal) {
    RecordReader reader(journal);
    std::size_t count = 0;
    for (; const auto record = reader.next(); ++count) {
        EXPECT_EQ(record->facts.file, facts_of(count).file);
        EXPECT_EQ(record->facts.stamp, facts_of(count).stamp);
        EXPECT_EQ(record->facts.seconds, facts_of(count).seconds);
        EXPECT_EQ(record->facts.edit_count, count);
        EXPECT_EQ(record->delta, delta_of(count));
    }
    return count;
}

TEST(JournalFormat, reads_what_was_written) {
    EXPECT_EQ(records_in(sample().journal), 5U);
    EXPECT_EQ(records_in(""), 0U);
    EXPECT_EQ(records_in(std::string(journal_head())), 0U);
}

TEST(JournalFormat, keeps_what_is_before_a_torn_end) {
    const Sample whole = sample();
    for (std::size_t size = 0; size <= whole.journal.size(); ++size) {
        const auto expected = static_cast<std::size_t>(
            std::count_if(whole.ends.begin(), whole.ends.end(), [&](std::size_t end) { return end <= size; }));
        EXPECT_EQ(records_in(whole.journal.substr(0, size)), expected) << size;
        EXPECT_EQ(records_in(whole.journal.substr(0, size) + std::string(100, '\xff')), expected) << size;
        // Records of before, once more.
        const std::size_t end = expected == 0 ? journal_head().size() : whole.ends[expected - 1];
        const std::string doubled = whole.journal.substr(0, end) + whole.journal.substr(journal_head().size());
        EXPECT_EQ(records_in(doubled), expected == 0 ? 5 : expected) << size;
    }
}

TEST(JournalFormat, keeps_what_is_before_a_changed_byte) {
    const Sample whole = sample();
    for (std::size_t place = 0; place < whole.journal.size(); ++place)
        for (const char bits : {'\x01', '\x80', '\xff'}) {
            std::string changed = whole.journal;
            changed[place] = static_cast<char>(changed[place] ^ bits);
            const auto expected = static_cast<std::size_t>(
                std::count_if(whole.ends.begin(), whole.ends.end(), [&](std::size_t end) { return end <= place; }));
            EXPECT_EQ(records_in(changed), place < journal_head().size() ? 0 : expected) << place;
        }
}

TEST(JournalFormat, goes_on_after_a_record_that_came_to_nothing) {
    RecordWriter writer;
    std::string journal(journal_head());
    journal += writer.written(facts_of(0), delta_of(0));
    static_cast<void>(writer.written(facts_of(3), delta_of(3)));
    writer.take_back();
    journal += writer.written(facts_of(1), delta_of(1));
    EXPECT_EQ(records_in(journal), 2U);
}

}  // namespace
}  // namespace batten::editor
