#include "exchange/svg/native_copy.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/base/byte_hash.h"
#include "core/document/native_file.h"
#include "exchange/svg/viewport.h"

namespace batten::exchange {

namespace {

constexpr const char* copy_name = "batten:document";
constexpr const char* curves_mark = "curves";
constexpr const char* looks_mark = "looks";
constexpr const char* page_mark = "page";
constexpr const char* losses_mark = "losses";
constexpr const char* styles_mark = "styles";  // which the first versions did not write

// Tells an edit from none; nobody gains by deceiving it.
class Fingerprint {
  public:
    void add(std::string_view bytes) {
        hash_ = core::hash_of(bytes, hash_);
        hash_ = core::hash_of(std::string_view("\0", 1), hash_);
    }

    void add(std::uint64_t number) {
        std::array<char, sizeof(number)> bytes{};
        for (char& byte : bytes) {
            byte = static_cast<char>(number & 0xffU);
            number >>= 8U;
        }
        hash_ = core::hash_of({bytes.data(), bytes.size()}, hash_);
    }

    // 0 and -0 are one.
    void add(double value) { add(std::bit_cast<std::uint64_t>(value + 0.0)); }

    std::string text() const { return fmt::format("{:016x}", hash_); }

  private:
    std::uint64_t hash_ = core::hash_of_no_bytes;
};

std::string fingerprint_of_curves(const SvgDrawing& drawing) {
    Fingerprint fingerprint;
    for (const core::DocumentCurve& entry : drawing.curves) {
        fingerprint.add(static_cast<std::uint64_t>(entry.curve->degree()));
        for (const double knot : entry.curve->knots().values()) fingerprint.add(knot);
        for (const core::Point point : entry.curve->control_points()) {
            fingerprint.add(point.x);
            fingerprint.add(point.y);
        }
        for (const double weight : entry.curve->weights()) fingerprint.add(weight);
    }
    return fingerprint.text();
}

std::string fingerprint_of_looks(const SvgDrawing& drawing) {
    Fingerprint fingerprint;
    for (const core::DocumentCurve& entry : drawing.curves) {
        fingerprint.add(entry.name);
        fingerprint.add(entry.color ? core::color_text(*entry.color) : std::string());
        fingerprint.add(static_cast<std::uint64_t>(entry.visible ? 1 : 0));
        // Which files of this program do not have.
        if (entry.locked) fingerprint.add(std::string_view("locked"));
        if (drawing.has_layers) fingerprint.add(entry.group);
    }
    return fingerprint.text();
}

// In numbers, since other programs write them in other ways.
std::string fingerprint_of_page(const pugi::xml_node& svg) {
    const Page page = page_of(svg);
    Fingerprint fingerprint;
    for (const double value : {page.viewport.left, page.viewport.top, page.viewport.width, page.viewport.height})
        fingerprint.add(value);
    const core::DocumentUnits units = page.units.value_or(core::DocumentUnits{.scale = 0.0});
    fingerprint.add(static_cast<std::uint64_t>(units.unit));
    fingerprint.add(units.scale);
    return fingerprint.text();
}

std::string fingerprint_of(const std::vector<std::string>& sentences) {
    Fingerprint fingerprint;
    for (const std::string& sentence : sentences) fingerprint.add(sentence);
    return fingerprint.text();
}

// Whether each visible curve of the document is one of the drawing, which a torn one is not.
bool take_looks(core::Document& document, const SvgDrawing& drawing) {
    std::vector<core::DocumentCurve*> visible;
    for (core::DocumentCurve& entry : document.curves)
        if (entry.visible) visible.push_back(&entry);
    if (visible.size() != drawing.curves.size()) return false;
    for (std::size_t i = 0; i < visible.size(); ++i) {
        visible[i]->name = drawing.curves[i].name;
        visible[i]->color = drawing.curves[i].color;
        visible[i]->visible = drawing.curves[i].visible;
        visible[i]->locked = visible[i]->locked || drawing.curves[i].locked;
        if (drawing.has_layers && !drawing.curves[i].group.empty()) visible[i]->group = drawing.curves[i].group;
    }
    return true;
}

NativeCopy left_out_since(const char* sentence) {
    return {.told = {sentence}};
}

}  // namespace

void embed_document(pugi::xml_node svg, const core::Document& document) {
    const SvgDrawing drawing = drawing_of(svg, {});
    pugi::xml_node copy = svg.prepend_child("metadata").append_child(copy_name);
    copy.append_attribute(curves_mark) = fingerprint_of_curves(drawing).c_str();
    copy.append_attribute(looks_mark) = fingerprint_of_looks(drawing).c_str();
    copy.append_attribute(page_mark) = fingerprint_of_page(svg).c_str();
    copy.append_attribute(losses_mark) = fingerprint_of(drawing.told()).c_str();
    copy.append_attribute(styles_mark) = fingerprint_of(drawing.looks.sentences()).c_str();
    copy.append_child(pugi::node_pcdata).set_value(core::format_document(document).c_str());
}

NativeCopy native_copy(const pugi::xml_node& svg, const SvgDrawing& drawing) {
    const pugi::xml_node copy = svg.child("metadata").child(copy_name);
    if (!copy) return {};
    const auto has_mark = [&](const char* name, const std::string& wanted) {
        return copy.attribute(name).value() == wanted;
    };
    constexpr const char* other_drawing =
        "the document that Batten put into the file is left out, since another program has changed what is drawn";
    auto document = core::parse_document(copy.child_value());
    if (!document || !has_mark(curves_mark, fingerprint_of_curves(drawing))) return left_out_since(other_drawing);
    if (!has_mark(page_mark, fingerprint_of_page(svg)))
        return left_out_since(
            "the document that Batten put into the file is left out, since another program has changed the page");
    NativeCopy found{.document = *std::move(document)};
    if (!has_mark(looks_mark, fingerprint_of_looks(drawing))) {
        if (!take_looks(*found.document, drawing)) return left_out_since(other_drawing);
        found.told.emplace_back(
            "names, colors, layers, locks and what is hidden are as another program has changed them");
    }
    if (const auto told = drawing.told(); !has_mark(losses_mark, fingerprint_of(told)))
        found.told.insert(found.told.end(), told.begin(), told.end());
    if (copy.attribute(styles_mark) && !has_mark(styles_mark, fingerprint_of(drawing.looks.sentences())))
        found.looks = drawing.looks.sentences();
    return found;
}

}  // namespace batten::exchange
