#include "exchange/svg/native_copy.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <string>
#include <utility>

#include "core/document/native_file.h"
#include "exchange/svg/drawing.h"

namespace batten::exchange {

namespace {

constexpr const char* copy_name = "batten:document";
constexpr const char* mark_name = "drawn";

// FNV-1a of 64 bits, which tells an edit from none; nobody gains by deceiving it.
class Fingerprint {
  public:
    void add(std::string_view bytes) {
        for (const char c : bytes) add_byte(static_cast<unsigned char>(c));
        add_byte(0);
    }

    void add(std::uint64_t number) {
        for (int shift = 0; shift < 64; shift += 8) add_byte(static_cast<unsigned char>(number >> shift));
    }

    // 0 and -0 are one.
    void add(double value) { add(std::bit_cast<std::uint64_t>(value + 0.0)); }

    std::string text() const { return fmt::format("{:016x}", hash_); }

  private:
    void add_byte(unsigned char byte) { hash_ = (hash_ ^ byte) * 0x100000001b3U; }

    std::uint64_t hash_ = 0xcbf29ce484222325U;
};

std::string fingerprint_of(std::span<const core::DocumentCurve> curves) {
    Fingerprint fingerprint;
    for (const core::DocumentCurve& entry : curves) {
        fingerprint.add(entry.name);
        fingerprint.add(entry.color ? core::color_text(*entry.color) : std::string());
        fingerprint.add(static_cast<std::uint64_t>(entry.curve->degree()));
        fingerprint.add(static_cast<std::uint64_t>(entry.visible ? 1 : 0));
        for (const double knot : entry.curve->knots().values()) fingerprint.add(knot);
        for (const core::Point point : entry.curve->control_points()) {
            fingerprint.add(point.x);
            fingerprint.add(point.y);
        }
        for (const double weight : entry.curve->weights()) fingerprint.add(weight);
    }
    return fingerprint.text();
}

}  // namespace

void embed_document(pugi::xml_node svg, const core::Document& document) {
    pugi::xml_node copy = svg.prepend_child("metadata").append_child(copy_name);
    copy.append_attribute(mark_name) = fingerprint_of(drawing_of(svg).curves).c_str();
    copy.append_child(pugi::node_pcdata).set_value(core::format_document(document).c_str());
}

NativeCopy native_copy(const pugi::xml_node& svg, std::span<const core::DocumentCurve> drawn) {
    const pugi::xml_node copy = svg.child("metadata").child(copy_name);
    if (!copy) return {};
    if (copy.attribute(mark_name).value() != fingerprint_of(drawn)) return {.is_there = true};
    auto document = core::parse_document(copy.child_value());
    if (!document) return {.is_there = true};
    return {.is_there = true, .document = *std::move(document)};
}

}  // namespace batten::exchange
