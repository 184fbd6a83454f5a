#include "exchange/svg/drawing.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <unordered_map>
#include <utility>

#include "exchange/svg/basic_shapes.h"
#include "exchange/svg/path_data.h"
#include "exchange/svg/style.h"
#include "exchange/svg/svg_reader.h"
#include "exchange/svg/transform_text.h"
#include "exchange/svg/viewport.h"

namespace batten::exchange {

namespace {

using core::PlaneMap;
using pugi::xml_node;

std::string_view prefix_of(const xml_node& element) {
    const std::string_view name = element.name();
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? std::string_view() : name.substr(0, colon);
}

// Names that are copied to many curves, or told, are as long as people read them.
std::string shortened(std::string_view name) {
    constexpr std::size_t most_bytes = 120;
    if (name.size() <= most_bytes) return std::string(name);
    std::size_t end = most_bytes;
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80U) --end;
    return std::string(name.substr(0, end));
}

// How much is looked at to draw an element, apart from what is inside its children.
std::size_t bytes_of(const xml_node& element) {
    std::size_t bytes = 0;
    for (const pugi::xml_attribute& attribute : element.attributes())
        bytes += std::strlen(attribute.name()) + std::strlen(attribute.value());
    for (auto child = element.first_child(); child; child = child.next_sibling()) ++bytes;
    for (const xml_node& part : element.child("title").children()) bytes += 1 + std::strlen(part.value());
    return bytes;
}

// What surrounds an element.
struct Surroundings {
    PlaneMap map{};
    Viewport viewport{};
    SvgStyle style{};
    std::size_t depth = 0;
};

class Walk {
  public:
    explicit Walk(const xml_node& svg) : svg_(svg), prefix_(prefix_of(svg)), names_(core::Document()) { index_ids(); }

    SvgDrawing drawing() && {
        const Page page = page_of(svg_);
        drawing_.units = page.units;
        Surroundings around{.map = page.map, .viewport = page.viewport};
        around.style = around.style.within(svg_);
        visit_children(svg_, around);
        return std::move(drawing_);
    }

  private:
    // Without recursion, since this goes as deep as the file does.
    void index_ids() {
        for (xml_node node = svg_; node;) {
            if (const pugi::xml_attribute id = node.attribute("id")) by_id_.try_emplace(id.value(), node);
            most_bytes_ += bytes_of(node);
            if (node.first_child()) {
                node = node.first_child();
                continue;
            }
            while (node && node != svg_ && !node.next_sibling()) node = node.parent();
            node = node && node != svg_ ? node.next_sibling() : xml_node();
        }
    }

    void visit_children(const xml_node& parent, const Surroundings& around) {
        for (const xml_node& child : parent.children()) {
            if (is_full_) return;
            if (child.type() == pugi::node_element && prefix_of(child) == prefix_) visit(child, around);
        }
    }

    void visit(const xml_node& element, const Surroundings& around) {
        if (!may_look_at(element)) return;
        if (around.depth >= most_svg_depth)
            return drawing_.left_out.count(SvgLoss::too_deep, {}, std::to_string(most_svg_depth));
        const std::string_view name = local_name(element);
        if (const auto loss = loss_of(name)) return drawing_.left_out.count(*loss);
        const bool is_container = is_group(name);
        const bool is_drawn = is_container || name == "use" || name == "path" || is_basic_shape(name);
        if (!is_drawn) return;
        if (is_not_displayed(element)) return drawing_.left_out.count(SvgLoss::not_displayed);
        if (is_clipped(element)) drawing_.left_out.count(SvgLoss::clipped);
        const Surroundings inside = within(element, around);
        if (name == "use")
            visit_use(element, inside);
        else if (name == "switch")
            visit_switch(element, inside);
        else if (name == "svg")
            visit_inner(element, inside);
        else if (is_container)
            visit_children(element, inside);
        else
            draw(element, name, inside);
    }

    // What is repeated by `use` is read again each time.
    bool may_look_at(const xml_node& element) {
        if (++visited_ > most_svg_visits) stop(SvgLoss::too_many, most_svg_visits);
        bytes_ += bytes_of(element);
        if (bytes_ > most_bytes_) stop(SvgLoss::too_often, most_svg_repeated_bytes);
        return !is_full_;
    }

    static bool is_group(std::string_view name) {
        return name == "g" || name == "a" || name == "svg" || name == "switch";
    }

    static std::optional<SvgLoss> loss_of(std::string_view name) {
        if (name == "text") return SvgLoss::text;
        if (name == "image") return SvgLoss::image;
        if (name == "foreignObject") return SvgLoss::foreign;
        if (name == "style") return SvgLoss::style_sheet;
        return std::nullopt;
    }

    static bool is_clipped(const xml_node& element) {
        const auto is_set = [&](std::string_view name) {
            const std::string_view value = property_of(element, name);
            return !value.empty() && value != "none";
        };
        return is_set("clip-path") || is_set("mask");
    }

    Surroundings within(const xml_node& element, const Surroundings& around) {
        Surroundings inside = around;
        ++inside.depth;
        inside.style = around.style.within(element);
        const pugi::xml_attribute transform = element.attribute("transform");
        if (!transform) return inside;
        if (const auto map = read_transform(transform.value()))
            inside.map = chained(around.map, *map);
        else
            drawing_.left_out.count(SvgLoss::wrong_transform, name_of_element(element));
        return inside;
    }

    void visit_inner(const xml_node& element, Surroundings around) {
        const InnerViewport inner = inner_viewport(element, around.viewport);
        around.map = chained(around.map, inner.map);
        around.viewport = inner.viewport;
        visit_children(element, around);
    }

    // The first one that is SVG is taken.
    void visit_switch(const xml_node& element, const Surroundings& around) {
        for (const xml_node& child : element.children())
            if (child.type() == pugi::node_element && local_name(child) != "foreignObject") return visit(child, around);
    }

    void visit_use(const xml_node& use, Surroundings around) {
        const pugi::xml_attribute plain = use.attribute("href");
        const std::string target = plain ? plain.value() : use.attribute("xlink:href").value();
        if (!target.starts_with('#')) return drawing_.left_out.count(SvgLoss::outside, shortened(target));
        const auto found = by_id_.find(std::string_view(target).substr(1));
        if (found == by_id_.end()) return drawing_.left_out.count(SvgLoss::unknown_use, shortened(target));
        const xml_node element = found->second;
        if (std::find(used_.begin(), used_.end(), element) != used_.end())
            return drawing_.left_out.count(SvgLoss::circle, shortened(target));
        const core::Vector offset{around.viewport.length(use, "x"), around.viewport.length(use, "y")};
        around.map = chained(around.map, core::translation(offset));
        used_.push_back(element);
        if (local_name(element) != "symbol")
            visit(element, around);
        else if (may_look_at(element))
            visit_inner(element, around);
        used_.pop_back();
    }

    void draw(const xml_node& element, std::string_view kind, const Surroundings& around) {
        const std::string name = name_of_element(element);
        const std::size_t first = drawing_.curves.size();
        const OutlineSink sink = [&](const Outline& outline) { return add(outline, name, around.style); };
        const auto fault = kind == "path" ? read_path_data(element.attribute("d").value(), around.map, sink)
                                          : read_basic_shape(element, kind, around.viewport, around.map, sink);
        if (fault) drawing_.left_out.count(SvgLoss::wrong_path, name, std::to_string(*fault + 1));
        if (drawing_.curves.size() < first + 2) return;
        for (std::size_t i = first; i < drawing_.curves.size(); ++i) drawing_.curves[i].group = name;
    }

    bool add(const Outline& outline, const std::string& name, const SvgStyle& style) {
        if (drawing_.curves.size() == most_svg_curves) {
            stop(SvgLoss::too_many, most_svg_curves);
            return false;
        }
        auto curve = outline.curve();
        if (!curve) {
            drawing_.left_out.count(SvgLoss::refused_curve, name, core::describe(curve.error()));
            return true;
        }
        points_ += curve->control_points().size();
        core::DocumentCurve entry;
        entry.name = names_.take(name);
        entry.curve = std::make_shared<const core::Curve>(*std::move(curve));
        entry.color = style.color();
        entry.visible = style.visible;
        drawing_.curves.push_back(std::move(entry));
        drawing_.largest_error = std::max(drawing_.largest_error, outline.closing_gap());
        if (points_ > most_points) stop(SvgLoss::too_many, drawing_.curves.size());
        return !is_full_;
    }

    void stop(SvgLoss loss, std::size_t most) {
        if (!is_full_) drawing_.left_out.count(loss, {}, std::to_string(most));
        is_full_ = true;
    }

    // What people see: the label of Inkscape's layers, the title, the id, or what it is.
    static std::string name_of_element(const xml_node& element) {
        const std::array<std::string_view, 3> wishes{element.attribute("inkscape:label").value(),
                                                     element.child("title").child_value(),
                                                     element.attribute("id").value()};
        for (const std::string_view wish : wishes)
            if (!wish.empty()) return shortened(wish);
        return std::string(local_name(element));
    }

    // What `use` can make of a file of allowed size.
    static constexpr std::size_t most_points = 20'000'000;

    const xml_node svg_;
    const std::string_view prefix_;
    std::unordered_map<std::string_view, xml_node> by_id_;
    core::FreeNames names_;
    std::vector<xml_node> used_;
    std::size_t visited_ = 0;
    std::size_t bytes_ = 0;  // looked at
    std::size_t most_bytes_ = most_svg_repeated_bytes;
    std::size_t points_ = 0;
    bool is_full_ = false;
    SvgDrawing drawing_;
};

}  // namespace

std::string_view local_name(const xml_node& element) {
    const std::string_view name = element.name();
    return name.substr(name.find(':') + 1);
}

SvgDrawing drawing_of(const xml_node& svg) {
    return Walk(svg).drawing();
}

}  // namespace batten::exchange
