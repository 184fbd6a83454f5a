/// Values as bytes and back, for files that only the machine that wrote them reads.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/base/names.h"

namespace batten::editor {

/// `members(code, value)` names the members of a structure to the one or the other; it is found where the type or an
/// overload in this namespace has it, and serves both, so that they cannot differ.
class ByteWriter {
  public:
    template <class... Values>
    void operator()(const Values&... values) {
        (put(values), ...);
    }

    /// Few bytes for small numbers.
    void put_count(std::uint64_t count) {
        constexpr std::uint64_t low_bits = 0x7f;
        constexpr std::uint64_t more = 0x80;
        for (; count > low_bits; count >>= 7U) bytes_.push_back(static_cast<char>((count & low_bits) | more));
        bytes_.push_back(static_cast<char>(count));
    }
    void put_bytes(std::string_view bytes) { bytes_.append(bytes); }

    std::string take() { return std::move(bytes_); }

  private:
    template <class T>
    void put(const T& value) {
        if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>)
            put_bytes({reinterpret_cast<const char*>(&value), sizeof(T)});
        else
            members(*this, value);
    }
    void put(const std::string& text) {
        put_count(text.size());
        put_bytes(text);
    }
    void put(const std::filesystem::path& path) { put(path.native()); }
    template <class T>
    void put(const std::optional<T>& value) {
        put(value.has_value());
        if (value) put(*value);
    }
    template <class T>
    void put(const std::vector<T>& list) {
        put_count(list.size());
        for (const T& item : list) put(item);
    }
    void put(const std::map<std::string, std::string>& map) {
        put_count(map.size());
        for (const auto& [key, value] : map) (*this)(key, value);
    }
    template <class T>
    void put(const std::shared_ptr<const T>& value) {
        put(value != nullptr);
        if (value != nullptr) put(*value);
    }

    std::string bytes_;
};

/// Reads what ByteWriter wrote. After the first thing that cannot be so, all that is read is empty or zero.
class ByteReader {
  public:
    explicit ByteReader(std::string_view bytes) : left_(bytes) {}

    bool is_good() const { return is_good_; }
    bool is_at_end() const { return left_.empty(); }
    std::string_view rest() const { return left_; }

    template <class... Values>
    void operator()(Values&... values) {
        (take(values), ...);
    }

    std::uint64_t take_count() {
        constexpr unsigned most_shift = 63;
        constexpr std::uint64_t low_bits = 0x7f;
        std::uint64_t count = 0;
        for (unsigned shift = 0; shift <= most_shift; shift += 7U) {
            const std::string_view byte = take_bytes(1);
            if (!is_good_) return 0;
            const auto value = static_cast<unsigned char>(byte.front());
            count |= (value & low_bits) << shift;
            if (value <= low_bits) return count;
        }
        fail();
        return 0;
    }
    std::string_view take_bytes(std::uint64_t count) {
        if (count > left_.size()) fail();
        if (!is_good_) return {};
        const std::string_view bytes = left_.substr(0, count);
        left_.remove_prefix(count);
        return bytes;
    }
    void fail() {
        is_good_ = false;
        left_ = {};
    }

  private:
    // How many items follow, each of which takes a byte at least.
    std::size_t take_size() {
        const std::uint64_t count = take_count();
        if (count > left_.size()) fail();
        return is_good_ ? count : 0;
    }
    template <class T>
    void take(T& value) {
        if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>)
            take_plain(value);
        else
            members(*this, value);
    }
    template <class T>
    void take_plain(T& value) {
        std::array<char, sizeof(T)> bytes{};
        const std::string_view found = take_bytes(sizeof(T));
        std::copy(found.begin(), found.end(), bytes.begin());
        if constexpr (std::is_same_v<T, bool>) {
            if (bytes[0] != 0 && bytes[0] != 1) fail();
            value = is_good_ && bytes[0] == 1;
        } else {
            std::memcpy(&value, bytes.data(), sizeof(T));
        }
        if constexpr (core::HasNames<T>)
            if (static_cast<std::size_t>(value) >= core::Names<T>::table.size()) {
                fail();
                value = T{};
            }
    }
    void take(std::string& text) { text = take_bytes(take_count()); }
    void take(std::filesystem::path& path) {
        std::string text;
        take(text);
        path = text;
    }
    template <class T>
    void take(std::optional<T>& value) {
        bool is_there = false;
        take(is_there);
        value.reset();
        if (is_there) take(value.emplace());
    }
    template <class T>
    void take(std::vector<T>& list) {
        list.assign(take_size(), T{});
        for (T& item : list) take(item);
    }
    void take(std::map<std::string, std::string>& map) {
        map.clear();
        for (std::size_t count = take_size(); count > 0; --count) {
            std::string key;
            take(key);
            take(map[key]);
        }
    }
    template <class T>
    void take(std::shared_ptr<const T>& value) {
        bool is_there = false;
        take(is_there);
        value.reset();
        if (!is_there) return;
        auto found = std::make_shared<T>();
        take(*found);
        value = std::move(found);
    }

    std::string_view left_;
    bool is_good_ = true;
};

}  // namespace batten::editor
