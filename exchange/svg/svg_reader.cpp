#include "exchange/svg/svg_reader.h"

#include <algorithm>
#include <pugixml.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/base/sentence.h"
#include "exchange/places.h"
#include "exchange/refusal.h"
#include "exchange/svg/drawing.h"
#include "exchange/svg/entities.h"
#include "exchange/svg/losses.h"
#include "exchange/svg/native_copy.h"

namespace batten::exchange {

namespace {

// Refuses what would take much memory as a tree, or is no text.
core::FileResult<void> check_text(std::string_view text) {
    if (text.starts_with("\x1f\x8b")) return refused_file("this is no XML but what gzip makes of it");
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos)
        return refused_file("there is a zero byte, which no XML has; SVG is read as UTF-8",
                            line_place(line_of(text, zero)));
    const auto count = std::count_if(text.begin(), text.end(), [](char c) { return c == '<' || c == '='; });
    if (static_cast<std::size_t>(count) > most_svg_elements)
        return refused_file(core::sentence("there are more than {most} elements and attributes, the most that are read",
                                           {{"most", most_svg_elements}}));
    return {};
}

// Why a drawing has no curves.
std::string refusal_of_nothing(const SvgDrawing& drawing) {
    const std::vector<std::string> left_out = drawing.left_out.sentences();
    if (left_out.empty()) return "no path and no shape is drawn in this file";
    const bool is_all_hidden = left_out.size() == 1 && drawing.hidden_elements > 0;
    if (is_all_hidden) return core::sentence(svg_loss::all_hidden, drawing.hidden_elements);
    return core::sentence("nothing is read from this file: {reason}", {{"reason", left_out.front()}});
}

}  // namespace

core::FileResult<Imported> read_svg(std::string_view text) {
    if (const auto check = check_text(text); !check) return tl::unexpected(check.error());
    Notes entities;
    tell_entities(text, entities);
    pugi::xml_document file;
    const pugi::xml_parse_result parsed =
        file.load_buffer(text.data(), text.size(), pugi::parse_default | pugi::parse_doctype | pugi::parse_pi);
    if (!parsed)
        return refused_file(core::sentence("this is no XML: {reason}", {{"reason", parsed.description()}}),
                            line_place(line_of(text, static_cast<std::size_t>(parsed.offset))));
    const pugi::xml_node svg = file.document_element();
    if (local_name(svg) != "svg")
        return refused_file(core::sentence("the file is a '{name}'; an 'svg' is needed", {{"name", svg.name()}}));
    SvgDrawing drawing = drawing_of(svg, std::move(entities));
    NativeCopy copy = native_copy(svg, drawing);
    if (copy.document)
        return Imported{.document = *std::move(copy.document),
                        .report = {.left_out = std::move(copy.told), .looks = std::move(copy.looks)}};
    if (drawing.curves.empty()) return refused_file(refusal_of_nothing(drawing));
    Imported imported{.document = {}, .report = {drawing.largest_error, drawing.told(), drawing.looks.sentences()}};
    auto& told = imported.report.left_out;
    told.insert(told.end(), copy.told.begin(), copy.told.end());
    imported.document.curves = std::move(drawing.curves);
    imported.document.units = std::move(drawing.units);
    return imported;
}

}  // namespace batten::exchange
