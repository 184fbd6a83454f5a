#include "exchange/svg/drawing.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <memory>
#include <span>
#include <unordered_map>
#include <utility>

#include "core/base/utf8.h"
#include "exchange/svg/basic_shapes.h"
#include "exchange/svg/conditions.h"
#include "exchange/svg/frame.h"
#include "exchange/svg/look.h"
#include "exchange/svg/losses.h"
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
    return std::string(core::utf8_front(name, most_bytes));
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

// A map of the page, in px, as one of its viewBox, which `shown` puts onto the page.
PlaneMap in_view_box(const PlaneMap& map, const PlaneMap& shown) {
    if (map == PlaneMap()) return map;
    const auto& [x, y, last] = shown.rows;
    const PlaneMap back{.rows = {{{1.0 / x[0], 0.0, -x[2] / x[0]}, {0.0, 1.0 / y[1], -y[2] / y[1]}, last}},
                        .pivot = {0.0, 0.0}};
    return chained(back, chained(map, shown));
}

// What surrounds an element.
struct Surroundings {
    PlaneMap map{};
    Viewport viewport{};
    std::shared_ptr<const SvgFrame> frame{};
    SvgStyle style{};
    SvgLook look{};
    std::string layer{};  // of Inkscape; empty where there is none
    bool is_locked = false;
    std::size_t depth = 0;
};

class Walk {
  public:
    Walk(const xml_node& svg, Notes left_out) : svg_(svg), prefix_(prefix_of(svg)), names_(core::Document()) {
        drawing_.left_out = std::move(left_out);
        index_ids();
    }

    SvgDrawing drawing() && {
        const SvgProperties properties(svg_, sheet_);
        FontSizes font = font_within(properties, {});
        font.root = font.own;
        const Page page = page_of(svg_, font);
        drawing_.units = page.units;
        const auto is_part = [&](SvgProperty size) { return properties.in_style(size).ends_with('%'); };
        if (!is_part(SvgProperty::width) && !is_part(SvgProperty::height)) tell_styled_size(svg_, properties);
        Surroundings around{.map = page.map, .viewport = page.viewport};
        around.style = around.style.within(properties);
        around.look = around.look.within(properties);
        if (const auto map = transform_of(properties, page.viewport))
            around.map = chained(page.map, in_view_box(*map, inner_viewport(svg_, page.viewport).map));
        else
            tell_change(svg_loss::wrong_transform, name_of_element(svg_));
        visit_children(svg_, around);
        group_by_layers();
        if (svg_.attribute("viewBox") || svg_.attribute("width")) drawing_.looks.add(svg_loss::page);
        return std::move(drawing_);
    }

  private:
    // Without recursion, since this goes as deep as the file does.
    void index_ids() {
        if (svg_.root().child("xml-stylesheet")) sheet_.leave_out_file(drawing_.changed);
        for (xml_node node = svg_; node;) {
            if (const pugi::xml_attribute id = node.attribute("id")) by_id_.try_emplace(id.value(), node);
            most_bytes_ += bytes_of(node);
            if (local_name(node) == "style" && prefix_of(node) == prefix_) sheet_.add(node, drawing_.changed);
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
        if (around.depth >= most_svg_depth) return tell(svg_loss::too_deep, {}, std::to_string(most_svg_depth));
        const std::string_view name = local_name(element);
        if (!is_drawn(name)) return;
        if (!is_for_english_viewers(element)) return tell(svg_loss::for_others);
        if (const auto* const loss = loss_of(name)) return tell(*loss);
        const SvgProperties properties(element, sheet_);
        if (properties[SvgProperty::display] == "none") return skip_hidden();
        if (properties.has(SvgProperty::clip_path) || properties.has(SvgProperty::mask)) tell_change(svg_loss::clipped);
        if (!is_group(name) || name == "svg") tell_styled_size(element, properties);
        const Surroundings inside = within(element, properties, around);
        if (name == "use")
            visit_use(element, inside);
        else if (name == "switch")
            visit_switch(element, inside);
        else if (name == "svg")
            visit_inner(inner_viewport(element, inside.viewport), element, properties, inside);
        else if (is_group(name))
            visit_children(element, inside);
        else
            draw(element, name, inside);
    }

    void skip_hidden() {
        ++drawing_.hidden_elements;
        tell(svg_loss::not_displayed);
    }

    // What is repeated by `use` is read again each time.
    bool may_look_at(const xml_node& element) {
        if (++visited_ > most_svg_visits) stop(svg_loss::too_many, most_svg_visits);
        bytes_ += bytes_of(element);
        if (bytes_ > most_bytes_) stop(svg_loss::too_often, most_svg_repeated_bytes);
        return !is_full_;
    }

    static bool is_group(std::string_view name) {
        return name == "g" || name == "a" || name == "svg" || name == "switch";
    }

    // By viewers.
    static bool is_drawn(std::string_view name) {
        return is_group(name) || name == "use" || name == "path" || is_basic_shape(name) || loss_of(name) != nullptr;
    }

    static const core::PluralPattern* loss_of(std::string_view name) {
        if (name == "text") return &svg_loss::text;
        if (name == "image") return &svg_loss::image;
        return name == "foreignObject" ? &svg_loss::foreign : nullptr;
    }

    Surroundings within(const xml_node& element, const SvgProperties& properties, const Surroundings& around) {
        Surroundings inside = around;
        ++inside.depth;
        inside.style = around.style.within(properties);
        inside.look = around.look.within(properties);
        inside.viewport.font = font_within(properties, around.viewport.font);
        if (std::string_view(element.attribute("sodipodi:insensitive").value()) == "true") inside.is_locked = true;
        if (std::string_view(element.attribute("inkscape:groupmode").value()) == "layer") {
            const std::string name = name_of_element(element);
            inside.layer =
                around.layer.empty()
                    ? name
                    : shortened(core::sentence("{outer} / {inner}", {{"outer", around.layer}, {"inner", name}}));
        }
        if (const auto map = transform_of(properties, around.viewport))
            inside.map = chained(around.map, *map);
        else
            tell_change(svg_loss::wrong_transform, name_of_element(element));
        return inside;
    }

    FontSizes font_within(const SvgProperties& properties, const FontSizes& around) const {
        FontSizes font = around.within(properties);
        if (sheet_.leaves_out_fonts()) font.own.reset();
        return font;
    }

    void visit_inner(const InnerViewport& inner, const xml_node& element, const SvgProperties& properties,
                     Surroundings around) {
        if (inner.is_empty) return;
        if (inner.is_unknown) return tell(svg_loss::unknown_length, name_of_element(element));
        if (!inner.box.is_empty() && properties[SvgProperty::overflow] != "visible")
            around.frame = std::make_shared<SvgFrame>(SvgFrame{inner.box, around.map, around.frame});
        around.map = chained(around.map, inner.map);
        around.viewport = inner.viewport;
        visit_children(element, around);
    }

    // The first one is taken that viewers draw; what is no SVG inside cannot be.
    void visit_switch(const xml_node& element, const Surroundings& around) {
        bool is_taken = false;
        for (const xml_node& child : element.children()) {
            const std::string_view name = local_name(child);
            if (child.type() != pugi::node_element || prefix_of(child) != prefix_ || !is_drawn(name)) continue;
            if (name == "foreignObject") continue;
            const bool is_next = !is_taken && is_for_english_viewers(child);
            if (is_next)
                visit(child, around);
            else
                tell(svg_loss::for_others);
            is_taken = is_taken || is_next;
        }
    }

    void visit_use(const xml_node& use, Surroundings around) {
        const pugi::xml_attribute plain = use.attribute("href");
        const std::string target = plain ? plain.value() : use.attribute("xlink:href").value();
        if (!target.starts_with('#')) return tell(svg_loss::outside, shortened(target));
        const auto found = by_id_.find(std::string_view(target).substr(1));
        if (found == by_id_.end()) return tell(svg_loss::unknown_use, shortened(target));
        const xml_node element = found->second;
        if (std::find(used_.begin(), used_.end(), element) != used_.end())
            return tell(svg_loss::circle, shortened(target));
        const auto x = around.viewport.length(use, "x");
        const auto y = around.viewport.length(use, "y");
        if (!x || !y) return tell(svg_loss::unknown_length, name_of_element(use));
        around.map = chained(around.map, core::translation({*x, *y}));
        used_.push_back(element);
        visit_used(element, use, around);
        used_.pop_back();
    }

    // What has a viewport of its own has the size that `use` says.
    void visit_used(const xml_node& element, const xml_node& use, const Surroundings& around) {
        const std::string_view name = local_name(element);
        if (name != "symbol" && name != "svg") return visit(element, around);
        if (!may_look_at(element)) return;
        const SvgProperties properties(element, sheet_);
        if (properties[SvgProperty::display] == "none") return skip_hidden();
        const Surroundings inside = within(element, properties, around);
        visit_inner(inner_viewport(element, use, inside.viewport), element, properties, inside);
    }

    void draw(const xml_node& element, std::string_view kind, const Surroundings& around) {
        const std::string name = name_of_element(element);
        if (has_unknown_length(element, kind, around.viewport)) return tell(svg_loss::unknown_length, name);
        const std::size_t first = drawing_.curves.size();
        if (has_all_curves_) return tell_further_curves();
        const OutlineSink sink = [&](const Outline& outline) { return add(outline, name, around); };
        const auto fault = kind == "path" ? read_path_data(element.attribute("d").value(), around.map, sink)
                                          : read_basic_shape(element, kind, around.viewport, around.map, sink);
        if (fault)
            tell(kind == "path" ? svg_loss::wrong_path : svg_loss::wrong_points,
                 core::sentence("character {character} of '{name}'", {{"character", *fault + 1}, {"name", name}}));
        if (drawing_.curves.size() > first && around.style.visible) around.look.tell_losses(kind, drawing_.looks);
        const auto drawn = std::span(drawing_.curves).subspan(first);
        if (std::ranges::any_of(
                drawn, [&](const core::DocumentCurve& entry) { return is_cut_off(*entry.curve, around.frame.get()); }))
            tell_change(svg_loss::cut_off, name);
        if (drawing_.curves.size() < first + 2) return;
        for (std::size_t i = first; i < drawing_.curves.size(); ++i) drawing_.curves[i].group = name;
    }

    void tell_further_curves() { tell(svg_loss::too_many_curves, {}, std::to_string(drawing_.curves.size())); }

    bool add(const Outline& outline, const std::string& name, const Surroundings& around) {
        if (drawing_.curves.size() == most_svg_curves) {
            has_all_curves_ = true;
            tell_further_curves();
            return false;
        }
        auto curve = outline.curve();
        if (!curve) {
            tell(svg_loss::refused_curve, name, core::describe(curve.error()));
            return true;
        }
        points_ += curve->control_points().size();
        core::DocumentCurve entry;
        entry.name = names_.take(name);
        entry.curve = std::make_shared<const core::Curve>(*std::move(curve));
        entry.color = around.style.color();
        entry.visible = around.style.visible;
        entry.locked = around.is_locked;
        drawing_.curves.push_back(std::move(entry));
        layers_.push_back(around.layer);
        drawing_.largest_error = std::max(drawing_.largest_error, outline.closing_gap());
        if (points_ <= most_points) return true;
        has_all_curves_ = true;
        tell_further_curves();
        return false;
    }

    // A single layer, which each drawing of Inkscape has, says nothing.
    void group_by_layers() {
        drawing_.has_layers = std::ranges::adjacent_find(layers_, std::ranges::not_equal_to{}) != layers_.end();
        if (!drawing_.has_layers) return;
        for (std::size_t i = 0; i < layers_.size(); ++i)
            if (!layers_[i].empty()) drawing_.curves[i].group = layers_[i];
    }

    void tell_styled_size(const xml_node& element, const SvgProperties& properties) {
        if (properties.has_styled_size()) tell_change(svg_loss::styled_size, name_of_element(element));
    }

    void tell(const core::PluralPattern& loss, const std::string& name = {}, std::string_view reason = {}) {
        drawing_.left_out.add(
            loss, [&] { return name; }, {}, reason);
    }

    void tell_change(const core::PluralPattern& change, const std::string& name = {}) {
        drawing_.changed.add(change, [&] { return name; });
    }

    void stop(const core::PluralPattern& loss, std::size_t most) {
        if (!is_full_) tell(loss, {}, std::to_string(most));
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
    StyleSheet sheet_{};
    std::vector<xml_node> used_;
    std::vector<std::string> layers_;  // of each curve
    std::size_t visited_ = 0;
    std::size_t bytes_ = 0;  // looked at
    std::size_t most_bytes_ = most_svg_repeated_bytes;
    std::size_t points_ = 0;
    bool has_all_curves_ = false;  // that are read
    bool is_full_ = false;
    SvgDrawing drawing_;
};

}  // namespace

std::vector<std::string> SvgDrawing::told() const {
    std::vector<std::string> told = left_out.sentences();
    const std::vector<std::string> further = changed.sentences();
    told.insert(told.end(), further.begin(), further.end());
    return told;
}

std::string_view local_name(const xml_node& element) {
    const std::string_view name = element.name();
    return name.substr(name.find(':') + 1);
}

SvgDrawing drawing_of(const xml_node& svg, Notes left_out) {
    return Walk(svg, std::move(left_out)).drawing();
}

}  // namespace batten::exchange
