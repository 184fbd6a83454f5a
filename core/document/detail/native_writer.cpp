#include <fmt/core.h>

#include <cassert>
#include <cmath>

#include "core/base/number_text.h"
#include "core/document/detail/fit_member.h"
#include "core/document/detail/joint_member.h"
#include "core/document/detail/native_format.h"
#include "core/document/detail/number_list.h"
#include "core/document/detail/object_reader.h"
#include "core/document/native_file.h"

namespace batten::core {

namespace {

Json json_of(const Symmetry& symmetry) {
    Json object = Json::object();
    object["group"] = symmetry.group;
    object["place"] = symmetry.place;
    object["center"] = Json::array({json_number(symmetry.center.x), json_number(symmetry.center.y)});
    if (symmetry.turns)
        object["turns"] = *symmetry.turns;
    else
        object["mirror"] = json_number(symmetry.angle);
    add_unknown_members(object, symmetry.unknown_members);
    return object;
}

Json json_of(const DocumentCurve& entry) {
    const Curve& curve = *entry.curve;
    Json object = Json::object();
    object["name"] = entry.name;
    object["degree"] = curve.degree();
    object["knots"] = packed(curve.knots().stored());
    object["points"] = packed(curve.control_points());
    object["weights"] = packed(curve.weights());
    object["periodic"] = curve.is_periodic();
    object["kind"] = name_of(curve.knots().kind());
    if (tears_of(entry) == Tears::allow) object["tears"] = true;
    if (entry.fit != nullptr) {
        object["fit"] = json_of_fit(*entry.fit);
        add_unknown_members(object["fit"], entry.unknown_fit_members);
    }
    if (entry.color) object["color"] = color_text(*entry.color);
    object["visible"] = entry.visible;
    object["locked"] = entry.locked;
    if (!entry.group.empty()) object["group"] = entry.group;
    if (!entry.pinned.empty()) object["pinned"] = entry.pinned;
    if (!entry.joints.is_empty()) object["joints"] = json_of_joints(entry.joints);
    if (entry.symmetry) object["symmetry"] = json_of(*entry.symmetry);
    add_unknown_members(object, entry.unknown_members);
    return object;
}

Json json_of(const Picture& picture) {
    Json object = Json::object();
    object["path"] = picture.path.generic_string();
    object["width"] = picture.width;
    object["height"] = picture.height;
    object["position"] = Json::array({json_number(picture.position.x), json_number(picture.position.y)});
    object["scale"] = json_number(picture.scale);
    object["rotation"] = json_number(picture.rotation);
    object["opacity"] = json_number(picture.opacity);
    object["visible"] = picture.visible;
    object["locked"] = picture.locked;
    add_unknown_members(object, picture.unknown_members);
    return object;
}

// The active curve by its name, or by its place where an earlier curve has the same name.
Json active_member(const Document& document) {
    const std::string& name = document.curves[document.active].name;
    for (std::size_t i = 0; i < document.active; ++i)
        if (document.curves[i].name == name) return document.active;
    return name;
}

Json json_of(const Guide& guide) {
    Json object = Json::object();
    object["point"] = Json::array({json_number(guide.point.x), json_number(guide.point.y)});
    object["angle"] = json_number(guide.angle);
    add_unknown_members(object, guide.unknown_members);
    return object;
}

Json json_of(const DocumentUnits& units) {
    Json object = Json::object();
    object["unit"] = name_of(units.unit);
    object["scale"] = json_number(units.scale);
    add_unknown_members(object, units.unknown_members);
    return object;
}

Json json_of_view(const Document& document) {
    const DocumentView& view = document.view;
    Json object = Json::object();
    if (view.parameter && std::isfinite(*view.parameter)) object["parameter"] = json_number(*view.parameter);
    if (view.overlays) object["overlays"] = *view.overlays;
    if (!view.notation.empty()) object["notation"] = view.notation;
    if (document.active > 0 && document.active_curve()) object["active"] = active_member(document);
    add_unknown_members(object, view.unknown_members);
    return object;
}

Json json_of(const Document& document) {
    Json object = Json::object();
    object["format"] = format_name;
    object["version"] = format_version;
    if (!document.title.empty()) object["title"] = document.title;
    if (!document.description.empty()) object["description"] = document.description;
    object["curves"] = Json::array();
    for (const DocumentCurve& curve : document.curves) object["curves"].push_back(json_of(curve));
    for (const Picture& picture : document.pictures) object["pictures"].push_back(json_of(picture));
    for (const Guide& guide : document.guides) object["guides"].push_back(json_of(guide));
    if (document.units) object["units"] = json_of(*document.units);
    if (Json view = json_of_view(document); !view.empty()) object["view"] = std::move(view);
    add_unknown_members(object, document.unknown_members);
    return object;
}

// Text that is not UTF-8 cannot stand in JSON; what is wrong in it becomes the replacement character.
std::string text_of_scalar(const Json& value) {
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

bool is_on_one_line(const Json& value) {
    return value.is_array() &&
           std::none_of(value.begin(), value.end(), [](const Json& item) { return item.is_structured(); });
}

// The end of a line and the indent of the next.
std::string line_of(std::size_t indent) {
    return fmt::format("\n{:{}}", "", indent);
}

// Writes a tree as text, and tells how many of the numbers of curves are written.
class TreeWriter {
  public:
    TreeWriter(std::size_t number_count, const Progress& progress) : number_count_(number_count), progress_(progress) {
        constexpr std::size_t usual_length = 20;
        text_.reserve(usual_length * number_count);
    }

    std::string written(const Json& tree) {
        write_value(tree, 0);
        text_ += '\n';
        tell(progress_, 1, 1);
        return std::move(text_);
    }

  private:
    void write_value(const Json& value, std::size_t indent) {
        if (value.is_binary() && packed_item(value) == ListItem::pair)
            write_pairs(value, indent);
        else if (value.is_binary())
            write_numbers(value);
        else if (is_on_one_line(value))
            write_on_one_line(value);
        else if (value.is_structured())
            write_on_lines(value, indent);
        else
            text_ += text_of_scalar(value);
    }

    void write_on_one_line(const Json& list) {
        text_ += '[';
        const char* separator = "";
        for (const Json& item : list) {
            text_ += separator + text_of_scalar(item);
            separator = ", ";
        }
        text_ += ']';
    }

    // Objects and lists of lists: one item a line, so that a changed item is one changed line.
    void write_on_lines(const Json& value, std::size_t indent) {
        const std::string line = line_of(indent + 2);
        text_ += value.is_object() ? '{' : '[';
        const char* separator = "";
        for (const auto& [name, item] : value.items()) {
            text_ += separator + line;
            if (value.is_object()) text_ += fmt::format("{}: ", text_of_scalar(name));
            write_value(item, indent + 2);
            separator = ",";
        }
        if (!value.empty()) text_ += line_of(indent);
        text_ += value.is_object() ? '}' : ']';
    }

    void write_numbers(const Json& list) {
        const std::size_t count = packed_count<double>(list);
        text_ += '[';
        for (std::size_t i = 0; i < count; ++i) {
            text_ += i > 0 ? ", " : "";
            write_number(packed_at<double>(list, i));
        }
        text_ += ']';
    }

    // One pair a line.
    void write_pairs(const Json& list, std::size_t indent) {
        const std::size_t count = packed_count<Point>(list);
        const std::string line = line_of(indent + 2);
        text_ += '[';
        for (std::size_t i = 0; i < count; ++i) {
            const auto pair = packed_at<Point>(list, i);
            if (i > 0) text_ += ',';
            text_ += line;
            text_ += '[';
            write_number(pair.x);
            text_ += ',';
            text_ += ' ';
            write_number(pair.y);
            text_ += ']';
        }
        text_ += line_of(indent);
        text_ += ']';
    }

    void write_number(double number) {
        constexpr std::size_t numbers_between = 65536;
        append_json_text(text_, number);
        if (++numbers_written_ % numbers_between == 0) tell(progress_, numbers_written_, number_count_ + 1);
    }

    std::string text_;
    std::size_t number_count_;
    std::size_t numbers_written_ = 0;
    const Progress& progress_;
};

}  // namespace

std::string format_document(const Document& document, const Progress& progress) {
    std::size_t numbers = 0;
    for (const DocumentCurve& entry : document.curves) {
        assert(entry.curve != nullptr);
        const Curve& curve = *entry.curve;
        numbers += curve.knots().stored().size() + 3 * curve.control_points().size();
    }
    return TreeWriter(numbers, progress).written(json_of(document));
}

}  // namespace batten::core
