#include "app/editor/recovery/piece_delta.h"

#include <algorithm>
#include <optional>
#include <unordered_map>

#include "app/editor/recovery/byte_code.h"

namespace batten::editor {

namespace {

// A delta is a list of steps. Each begins with a count: so many curves as they were, from an index on; or 0, and one
// curve that changed from what it came of, whose index is counted from 1.

// Compared in blocks, since most bytes of long arrays are the same.
constexpr std::size_t block_bytes = 4096;

std::size_t common_front(std::string_view a, std::string_view b) {
    const std::size_t most = std::min(a.size(), b.size());
    std::size_t count = 0;
    while (most - count >= block_bytes && a.substr(count, block_bytes) == b.substr(count, block_bytes))
        count += block_bytes;
    while (count < most && a[count] == b[count]) ++count;
    return count;
}

std::size_t common_back(std::string_view a, std::string_view b) {
    const std::size_t most = std::min(a.size(), b.size());
    const auto block_before = [](std::string_view text, std::size_t end) {
        return text.substr(text.size() - end - block_bytes, block_bytes);
    };
    std::size_t count = 0;
    while (most - count >= block_bytes && block_before(a, count) == block_before(b, count)) count += block_bytes;
    while (count < most && a[a.size() - count - 1] == b[b.size() - count - 1]) ++count;
    return count;
}

// Finds for each curve the one before that it most likely came of.
class Origins {
  public:
    explicit Origins(const DocumentPieces& previous) : count_(previous.size()) {
        for (std::size_t i = 0; i < previous.size(); ++i)
            for (const Piece& piece : previous[i])
                if (!piece.bytes.empty()) by_array_.try_emplace(piece.bytes.data(), i);
    }

    // One with which it shares an array, else the one behind that of the curve before it.
    std::optional<std::size_t> next(const CurvePieces& pieces) {
        std::size_t origin = next_;
        for (const Piece& piece : pieces)
            if (const auto found = by_array_.find(piece.bytes.data()); found != by_array_.end()) origin = found->second;
        if (origin >= count_) return std::nullopt;
        next_ = origin + 1;
        return origin;
    }

  private:
    std::unordered_map<const void*, std::size_t> by_array_;
    std::size_t count_;
    std::size_t next_ = 0;
};

void put_change(ByteWriter& writer, const Piece& before, const Piece& after) {
    const std::size_t front = before == after ? after.bytes.size() : common_front(before.bytes, after.bytes);
    const std::size_t back = common_back(before.bytes.substr(front), after.bytes.substr(front));
    const std::string_view middle = after.bytes.substr(front, after.bytes.size() - front - back);
    writer.put_count(front);
    writer.put_count(back);
    writer.put_count(middle.size());
    writer.put_bytes(middle);
}

// The other way round.
Piece taken_change(ByteReader& reader, const Piece& before) {
    const std::uint64_t front = reader.take_count();
    const std::uint64_t back = reader.take_count();
    const std::string_view middle = reader.take_bytes(reader.take_count());
    const std::size_t size = before.bytes.size();
    if (front > size || back > size - front) reader.fail();
    if (!reader.is_good()) return {};
    if (front == size && middle.empty()) return before;
    std::string bytes;
    bytes.reserve(front + middle.size() + back);
    bytes.append(before.bytes.substr(0, front)).append(middle).append(before.bytes.substr(size - back));
    return piece_of(std::move(bytes));
}

class DeltaWriter {
  public:
    explicit DeltaWriter(const DocumentPieces& previous) : previous_(previous), origins_(previous) {}

    void put(const CurvePieces& pieces) {
        const std::optional<std::size_t> origin = origins_.next(pieces);
        if (origin && previous_[*origin] == pieces) return put_same(*origin);
        end_run();
        writer_.put_count(0);
        writer_.put_count(origin ? *origin + 1 : 0);
        const CurvePieces none;
        const CurvePieces& before = origin ? previous_[*origin] : none;
        for (std::size_t k = 0; k < pieces.size(); ++k) put_change(writer_, before[k], pieces[k]);
    }

    std::string take() {
        end_run();
        return writer_.take();
    }

  private:
    void put_same(std::size_t origin) {
        if (run_ > 0 && origin != run_start_ + run_) end_run();
        if (run_ == 0) run_start_ = origin;
        ++run_;
    }
    void end_run() {
        if (run_ == 0) return;
        writer_.put_count(run_);
        writer_.put_count(run_start_);
        run_ = 0;
    }

    const DocumentPieces& previous_;
    Origins origins_;
    ByteWriter writer_;
    std::size_t run_ = 0;  // curves as they were that are not written yet, and the first of them
    std::size_t run_start_ = 0;
};

void take_run(ByteReader& reader, const DocumentPieces& previous, std::uint64_t count, DocumentPieces& next) {
    const std::uint64_t start = reader.take_count();
    if (start > previous.size() || count > previous.size() - start) reader.fail();
    if (!reader.is_good()) return;
    const auto first = previous.begin() + static_cast<std::ptrdiff_t>(start);
    next.insert(next.end(), first, first + static_cast<std::ptrdiff_t>(count));
}

void take_change(ByteReader& reader, const DocumentPieces& previous, DocumentPieces& next) {
    const std::uint64_t origin = reader.take_count();
    if (origin > previous.size()) reader.fail();
    if (!reader.is_good()) return;
    const CurvePieces none;
    const CurvePieces& before = origin > 0 ? previous[origin - 1] : none;
    CurvePieces& pieces = next.emplace_back();
    for (std::size_t k = 0; k < pieces.size(); ++k) pieces[k] = taken_change(reader, before[k]);
}

}  // namespace

std::string delta_between(const DocumentPieces& previous, const DocumentPieces& next) {
    DeltaWriter writer(previous);
    for (const CurvePieces& pieces : next) writer.put(pieces);
    return writer.take();
}

Outcome<DocumentPieces> with_delta(const DocumentPieces& previous, std::string_view delta) {
    DocumentPieces next;
    ByteReader reader(delta);
    while (reader.is_good() && !reader.is_at_end()) {
        const std::uint64_t count = reader.take_count();
        if (count > 0)
            take_run(reader, previous, count, next);
        else
            take_change(reader, previous, next);
    }
    if (!reader.is_good()) return tl::unexpected(Refusal("the journal is damaged"));
    return next;
}

}  // namespace batten::editor
