// A font has outlines of letters, or a sentence.

#include "exchange/font_reader.h"
#include "tests/fuzz/target.h"

namespace batten::fuzz {

void run(std::string_view bytes) {
    const auto letters = exchange::read_glyphs(bytes, {.text = "Lo"});
    require(letters || !letters.error().what.empty(), "a refusal says why");
}

}  // namespace batten::fuzz
