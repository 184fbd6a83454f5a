#include "app/editor/recovery/journal_format.h"

#include <array>
#include <cstring>

#include "app/editor/recovery/byte_code.h"
#include "core/base/byte_hash.h"

namespace batten::editor {

template <class Code, class Facts>
requires std::is_same_v<std::remove_const_t<Facts>, JournalFacts>
void members(Code& code, Facts& facts) {
    auto& [file, stamp, seconds, edit_count] = facts;
    code(file, stamp, seconds, edit_count);
}

template <class Code, class Stamp>
requires std::is_same_v<std::remove_const_t<Stamp>, core::FileStamp>
void members(Code& code, Stamp& stamp) {
    auto& [device, file, size, seconds, nanoseconds] = stamp;
    code(device, file, size, seconds, nanoseconds);
}

namespace {

struct Head {
    std::array<char, 8> name{'b', 'a', 't', 't', 'e', 'n', ' ', 'j'};
    std::uint32_t version = 1;
    std::uint32_t byte_order = 0x01020304;
};
constexpr Head head;

// What stands before each record.
struct RecordHead {
    std::uint64_t size = 0;
    std::uint64_t checksum = 0;
};
static_assert(sizeof(RecordHead) == record_head_bytes);

// Begun from the checksum of what is before.
std::uint64_t checksum_of(std::string_view bytes, std::uint64_t before) {
    return core::hash_of(bytes, core::hash_of_no_bytes ^ before);
}

template <class T>
std::string_view bytes_of(const T& value) {
    return {reinterpret_cast<const char*>(&value), sizeof(T)};
}

}  // namespace

std::string_view journal_head() {
    return bytes_of(head);
}

std::uint64_t record_bytes(std::string_view record_head) {
    RecordHead head_of_record;
    if (record_head.size() < sizeof(RecordHead)) return 0;
    std::memcpy(&head_of_record, record_head.data(), sizeof(RecordHead));
    return head_of_record.size;
}

std::string RecordWriter::written(const JournalFacts& facts, std::string_view delta) {
    ByteWriter writer;
    writer.put_bytes(bytes_of(RecordHead{}));
    writer(facts);
    writer.put_bytes(delta);
    std::string record = writer.take();
    const std::string_view body = std::string_view(record).substr(sizeof(RecordHead));
    checksum_before_ = checksum_;
    checksum_ = checksum_of(body, checksum_);
    const RecordHead record_head{body.size(), checksum_};
    std::memcpy(record.data(), &record_head, sizeof(RecordHead));
    return record;
}

RecordReader::RecordReader(std::string_view journal)
    : left_(journal), is_known_(journal.substr(0, sizeof(Head)) == journal_head()) {
    left_.remove_prefix(is_known_ ? sizeof(Head) : left_.size());
}

std::optional<JournalRecord> RecordReader::next() {
    RecordHead record_head;
    if (left_.size() < sizeof(RecordHead)) return std::nullopt;
    std::memcpy(&record_head, left_.data(), sizeof(RecordHead));
    left_.remove_prefix(sizeof(RecordHead));
    const std::string_view body = left_.substr(0, record_head.size);
    left_.remove_prefix(body.size());
    const std::uint64_t sum = checksum_of(body, checksum_);
    JournalRecord record;
    ByteReader reader(body);
    reader(record.facts);
    if (body.size() != record_head.size || sum != record_head.checksum || !reader.is_good()) {
        left_ = {};
        return std::nullopt;
    }
    checksum_ = sum;
    record.delta = reader.rest();
    return record;
}

}  // namespace batten::editor
