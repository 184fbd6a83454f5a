#include "core/base/byte_hash.h"

#include <gtest/gtest.h>

namespace batten::core {

// The published values for FNV-1a of 64 bits.
TEST(ByteHash, IsThatOfItsAuthors) {
    EXPECT_EQ(hash_of(""), 0xcbf29ce484222325U);
    EXPECT_EQ(hash_of("a"), 0xaf63dc4c8601ec8cU);
    EXPECT_EQ(hash_of("foobar"), 0x85944171f73967e8U);
}

TEST(ByteHash, GoesOnFromWhatIsBefore) {
    EXPECT_EQ(hash_of("bar", hash_of("foo")), hash_of("foobar"));
    EXPECT_NE(hash_of("foo", hash_of("bar")), hash_of("foobar"));
}

}  // namespace batten::core
