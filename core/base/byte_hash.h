/// A fingerprint of bytes that stays the same for ever, as it stands in files.
#pragma once

#include <cstdint>
#include <string_view>

namespace batten::core {

inline constexpr std::uint64_t hash_of_no_bytes = 0xcbf29ce484222325;

/// The hash of what has the hash `before` and goes on with `bytes`: FNV-1a of 64 bits (Fowler, Noll and Vo). It tells
/// accidents, not deceivers. Cost O(n).
constexpr std::uint64_t hash_of(std::string_view bytes, std::uint64_t before = hash_of_no_bytes) {
    constexpr std::uint64_t prime = 0x100000001b3;
    for (const char byte : bytes) before = (before ^ static_cast<unsigned char>(byte)) * prime;
    return before;
}

}  // namespace batten::core
