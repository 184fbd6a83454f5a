#include "exchange/svg/svg_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <pugixml.hpp>
#include <set>
#include <string>
#include <utility>

#include "core/base/ascii.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/measure/bounds.h"
#include "exchange/refusal.h"
#include "exchange/svg/native_copy.h"
#include "exchange/svg/path_text.h"

namespace batten::exchange {

namespace {

using core::Box;
using core::DocumentCurve;
using core::Point;

bool is_of_id(char c) {
    return core::is_letter(c) || core::is_digit(c) || c == '-' || c == '.';
}

// A name as XML has them, that no other element has.
class Ids {
  public:
    std::string take(const std::string& name) {
        std::string id;
        for (const char c : name) id += is_of_id(c) ? c : '_';
        if (id.empty() || !core::is_letter(id.front())) id.insert(id.begin(), '_');
        std::string free = id;
        for (std::size_t& last = last_[id]; !used_.insert(free).second; free = id + '-' + std::to_string(last))
            last = std::max<std::size_t>(last, 1) + 1;
        return free;
    }

  private:
    std::set<std::string> used_;
    std::map<std::string, std::size_t> last_;  // number behind a name
};

// Without the control characters that XML does not have.
std::string written_name(std::string name) {
    constexpr unsigned char least = 0x20;
    name.erase(std::remove_if(name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < least; }),
               name.end());
    return name;
}

void set_number(pugi::xml_node& element, const char* name, double value) {
    element.append_attribute(name) = core::shortest_text(value).c_str();
}

// The box with a margin, and at least a little of it where the curves are a line or a point.
Box page_box(Box box) {
    constexpr double margin_share = 0.05;
    constexpr double least_share = 1e-6;
    const double side = std::max(box.size().x, box.size().y);
    const double reach =
        std::max({std::abs(box.lower.x), std::abs(box.upper.x), std::abs(box.lower.y), std::abs(box.upper.y)});
    const double margin = side > 0.0 ? std::max(margin_share * side, 1e-9 * reach) : std::max(1.0, least_share * reach);
    box.lower -= {margin, margin};
    box.upper += {margin, margin};
    return box;
}

class SvgFile {
  public:
    SvgFile(const core::Document& document, const Box& box) : svg_(file_.append_child("svg")), box_(box) {
        svg_.append_attribute("xmlns") = "http://www.w3.org/2000/svg";
        svg_.append_attribute("xmlns:batten") = "urn:batten:svg";
        svg_.append_attribute("batten:baseline") = "0";
        const core::Vector size = box.size();
        const std::string view_box =
            fmt::format("{} {} {} {}", core::shortest_text(box.lower.x + 0.0), core::shortest_text(0.0 - box.upper.y),
                        core::shortest_text(size.x), core::shortest_text(size.y));
        if (document.units) {
            set_length("width", size.x, *document.units);
            set_length("height", size.y, *document.units);
        }
        svg_.append_attribute("viewBox") = view_box.c_str();
        lines_ = svg_.append_child("g");
        lines_.append_attribute("fill") = "none";
        lines_.append_attribute("stroke") = "currentColor";
        constexpr double line_share = 1.0 / 300.0;
        set_number(lines_, "stroke-width", std::max(size.x, size.y) * line_share);
    }

    void add(const DocumentCurve& entry, const PathPieces& pieces) {
        pugi::xml_node path = lines_.append_child("path");
        const std::string name = written_name(entry.name);
        path.append_attribute("id") = ids_.take(name).c_str();
        if (entry.color) path.append_attribute("stroke") = core::color_text(*entry.color).c_str();
        path.append_attribute("d") = path_text(pieces).c_str();
        path.append_child("title").append_child(pugi::node_pcdata).set_value(name.c_str());
    }

    void embed(const core::Document& document) { embed_document(svg_, document); }
    void take_out_document() { svg_.remove_child("metadata"); }

    std::string text() const {
        struct : pugi::xml_writer {
            std::string text;
            void write(const void* data, std::size_t size) override {
                text.append(static_cast<const char*>(data), size);
            }
        } writer;
        file_.save(writer, " ", pugi::format_default, pugi::encoding_utf8);
        return std::move(writer.text);
    }

  private:
    void set_length(const char* name, double length, const core::DocumentUnits& units) {
        constexpr std::array<const char*, 3> names{"mm", "in", "px"};
        const std::string text =
            core::shortest_text(length / units.scale) + names[static_cast<std::size_t>(units.unit)];
        svg_.append_attribute(name) = text.c_str();
    }

    pugi::xml_document file_;
    pugi::xml_node svg_;
    pugi::xml_node lines_;
    Box box_;
    Ids ids_;
};

std::optional<Box> box_of_visible(const core::Document& document) {
    std::optional<Box> whole;
    for (const DocumentCurve& entry : document.curves) {
        if (!entry.visible) continue;
        if (!whole) whole.emplace();
        const Box box = core::tight_box(*entry.curve);
        whole->include(box.lower);
        whole->include(box.upper);
    }
    return whole;
}

void tell_losses(const DocumentCurve& entry, const PathPieces& pieces, double tolerance, Report& report) {
    report.largest_error = std::max(report.largest_error, pieces.error);
    if (pieces.error > tolerance)
        report.left_out.push_back(
            core::sentence("'{name}' is within {error} of its cubics, not within the {tolerance} that were wanted",
                           {{"name", entry.name},
                            {"error", core::shortest_text(pieces.error)},
                            {"tolerance", core::shortest_text(tolerance)}}));
    if (entry.curve->is_torn())
        report.left_out.push_back(core::sentence(
            "'{name}' is torn; its parts are one path there, which other programs and edits make several curves",
            {{"name", entry.name}}));
}

}  // namespace

core::FileResult<Exported> write_svg(const core::Document& document, const WriteOptions& options) {
    return write_svg(document, options, core::most_file_bytes);
}

core::FileResult<Exported> write_svg(const core::Document& document, const WriteOptions& options,
                                     std::size_t most_bytes) {
    const std::optional<Box> box = box_of_visible(document);
    if (!box) return refused_file("there is no visible curve to write");
    const double side = std::max(box->size().x, box->size().y);
    if (!std::isfinite(side)) return refused_file("the curves are larger than the numbers of SVG");
    constexpr double tolerance_share = 1e-6;
    const double tolerance = options.tolerance.value_or(side > 0.0 ? tolerance_share * side : tolerance_share);

    SvgFile file(document, page_box(*box));
    Exported exported;
    for (const DocumentCurve& entry : document.curves) {
        if (!entry.visible) continue;
        const PathPieces pieces = path_pieces(*entry.curve, tolerance, Arcs::as_arcs);
        if (!std::isfinite(pieces.error))
            return refused_file(
                core::sentence("'{name}' cannot be written as cubic pieces: numbers on the way are too large",
                               {{"name", entry.name}}));
        tell_losses(entry, pieces, tolerance, exported.report);
        file.add(entry, pieces);
    }
    file.embed(document);
    exported.text = file.text();
    if (exported.text.size() <= most_bytes) return exported;
    file.take_out_document();
    exported.text = file.text();
    if (exported.text.size() > most_bytes)
        return refused_file(core::sentence(
            "the file would have more than the {most} MiB that are read; a larger tolerance makes it smaller",
            {{"most", most_bytes >> 20U}}));
    exported.report.left_out.push_back(core::sentence(
        "the document itself is not in the file, which would have more than the {most} MiB that are read",
        {{"most", most_bytes >> 20U}}));
    return exported;
}

}  // namespace batten::exchange
