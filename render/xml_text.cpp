#include "render/xml_text.h"

namespace batten::render {

namespace {

/// What stands for a sign that has a meaning of its own; nothing for one that may not stand there.
std::string entity_of(char sign) {
    switch (sign) {
        case '&':
            return "&amp;";
        case '<':
            return "&lt;";
        case '>':
            return "&gt;";
        case '"':
            return "&quot;";
        case '\t':
        case '\n':
            return {sign};
        default:
            return static_cast<unsigned char>(sign) < ' ' ? std::string() : std::string(1, sign);
    }
}

}  // namespace

std::string xml_text(std::string_view text) {
    std::string result;
    for (const char sign : text) result += entity_of(sign);
    return result;
}

}  // namespace batten::render
