#include "exchange/dxf/dxf_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/measure/closing.h"
#include "exchange/dxf/dxf_tables.h"
#include "exchange/written_curves.h"

namespace batten::exchange {

namespace {

// What every drawing has around its layers and entities: groups, code and value, with commas between them. Handles, in
// hexadecimal, are the values of 5, 105, 330, 340 and 350.
constexpr std::string_view before_layers =
    "0 SECTION, 2 TABLES, 0 TABLE, 2 VPORT, 5 9, 330 0, 100 AcDbSymbolTable, 70 0, 0 ENDTAB, "
    "0 TABLE, 2 LTYPE, 5 2, 330 0, 100 AcDbSymbolTable, 70 3, "
    "0 LTYPE, 5 12, 330 2, 100 AcDbSymbolTableRecord, 100 AcDbLinetypeTableRecord, 2 ByBlock, 70 0, 3 , "
    "72 65, 73 0, 40 0, "
    "0 LTYPE, 5 13, 330 2, 100 AcDbSymbolTableRecord, 100 AcDbLinetypeTableRecord, 2 ByLayer, 70 0, 3 , "
    "72 65, 73 0, 40 0, "
    "0 LTYPE, 5 14, 330 2, 100 AcDbSymbolTableRecord, 100 AcDbLinetypeTableRecord, 2 Continuous, 70 0, "
    "3 Solid line, 72 65, 73 0, 40 0, 0 ENDTAB, 0 TABLE, 2 LAYER, 5 3, 330 0, 100 AcDbSymbolTable";

constexpr std::string_view between_layers_and_entities =
    "0 ENDTAB, 0 TABLE, 2 STYLE, 5 4, 330 0, 100 AcDbSymbolTable, 70 1, "
    "0 STYLE, 5 15, 330 4, 100 AcDbSymbolTableRecord, 100 AcDbTextStyleTableRecord, 2 Standard, 70 0, 40 0, "
    "41 1, 50 0, 71 0, 42 2.5, 3 txt, 4 , 0 ENDTAB, 0 TABLE, 2 VIEW, 5 1, 330 0, 100 AcDbSymbolTable, 70 0, "
    "0 ENDTAB, 0 TABLE, 2 UCS, 5 C, 330 0, 100 AcDbSymbolTable, 70 0, 0 ENDTAB, "
    "0 TABLE, 2 APPID, 5 6, 330 0, 100 AcDbSymbolTable, 70 1, "
    "0 APPID, 5 16, 330 6, 100 AcDbSymbolTableRecord, 100 AcDbRegAppTableRecord, 2 ACAD, 70 0, 0 ENDTAB, "
    "0 TABLE, 2 DIMSTYLE, 5 7, 330 0, 100 AcDbSymbolTable, 70 1, 100 AcDbDimStyleTable, "
    "0 DIMSTYLE, 105 17, 330 7, 100 AcDbSymbolTableRecord, 100 AcDbDimStyleTableRecord, 2 Standard, 70 0, "
    "0 ENDTAB, 0 TABLE, 2 BLOCK_RECORD, 5 8, 330 0, 100 AcDbSymbolTable, 70 2, "
    "0 BLOCK_RECORD, 5 10, 330 8, 100 AcDbSymbolTableRecord, 100 AcDbBlockTableRecord, 2 *Model_Space, 340 0, "
    "0 BLOCK_RECORD, 5 11, 330 8, 100 AcDbSymbolTableRecord, 100 AcDbBlockTableRecord, 2 *Paper_Space, 340 0, "
    "0 ENDTAB, 0 ENDSEC, 0 SECTION, 2 BLOCKS, "
    "0 BLOCK, 5 18, 330 10, 100 AcDbEntity, 8 0, 100 AcDbBlockBegin, 2 *Model_Space, 70 0, 10 0, 20 0, 30 0, "
    "3 *Model_Space, 1 , 0 ENDBLK, 5 19, 330 10, 100 AcDbEntity, 8 0, 100 AcDbBlockEnd, "
    "0 BLOCK, 5 1A, 330 11, 100 AcDbEntity, 67 1, 8 0, 100 AcDbBlockBegin, 2 *Paper_Space, 70 0, 10 0, 20 0, "
    "30 0, 3 *Paper_Space, 1 , 0 ENDBLK, 5 1B, 330 11, 100 AcDbEntity, 67 1, 8 0, 100 AcDbBlockEnd, 0 ENDSEC, "
    "0 SECTION, 2 ENTITIES";

constexpr std::string_view after_entities =
    "0 ENDSEC, 0 SECTION, 2 OBJECTS, "
    "0 DICTIONARY, 5 A, 330 0, 100 AcDbDictionary, 281 1, 3 ACAD_GROUP, 350 B, "
    "0 DICTIONARY, 5 B, 330 A, 100 AcDbDictionary, 281 1, 0 ENDSEC, 0 EOF";

constexpr unsigned first_free_handle = 0x20;

// Groups one after the other.
class Groups {
  public:
    void add(int code, std::string_view value) {
        fmt::format_to(std::back_inserter(text_), "{:>3}\n{}\n", code, value);
    }
    void add(int code, std::size_t value) { add(code, std::to_string(value)); }
    void add_number(int code, double value) {
        fmt::format_to(std::back_inserter(text_), "{:>3}\n", code);
        core::append_shortest_text(text_, value);
        text_.push_back('\n');
    }
    void add_new_handle() { add(5, fmt::format("{:X}", next_handle_++)); }

    // Groups as the lists above have them.
    void add_all(std::string_view list) {
        while (!list.empty()) {
            const std::string_view group = list.substr(0, list.find(", "));
            const std::size_t blank = group.find(' ');
            fmt::format_to(std::back_inserter(text_), "{:>3}\n{}\n", group.substr(0, blank), group.substr(blank + 1));
            list.remove_prefix(std::min(list.size(), group.size() + 2));
        }
    }

    unsigned next_handle() const { return next_handle_; }
    std::string& text() { return text_; }

  private:
    std::string text_;
    unsigned next_handle_ = first_free_handle;
};

// A name without the characters that names of layers cannot have.
std::string layer_name(const std::string& name) {
    constexpr std::string_view forbidden = "<>/\\\":;?*|=,`'";
    std::string layer = name.empty() ? "0" : name;
    std::ranges::replace_if(
        layer, [&](char c) { return (c >= '\0' && c < ' ') || forbidden.find(c) != std::string_view::npos; }, '_');
    return layer;
}

constexpr core::PluralPattern renamed{
    "the name '{place}' has signs that names of layers cannot have, which became _",
    "{count} names have signs that names of layers cannot have, which became _, the first one '{place}'"};

constexpr core::PluralPattern unlocked{
    "the lock of '{place}' was left out, since a curve on its layer is not locked",
    "the locks of {count} curves were left out, since curves on their layers are not locked; the first one is "
    "'{place}'"};

using Entries = std::vector<const core::DocumentCurve*>;

// The keys of the layers of which all curves are locked.
std::set<std::string> locked_layers(const Entries& entries) {
    std::set<std::string> keys;
    for (const core::DocumentCurve* entry : entries)
        if (entry->locked) keys.insert(layer_key(layer_name(entry->name)));
    for (const core::DocumentCurve* entry : entries)
        if (!entry->locked) keys.erase(layer_key(layer_name(entry->name)));
    return keys;
}

void add_layers(Groups& groups, const Entries& entries) {
    constexpr std::size_t locked = 4;
    const std::set<std::string> locked_keys = locked_layers(entries);
    std::set<std::string> keys{"0"};
    std::vector<std::string> names{"0"};
    for (const core::DocumentCurve* entry : entries)
        if (std::string name = layer_name(entry->name); keys.insert(layer_key(name)).second)
            names.push_back(std::move(name));
    groups.add(70, names.size());
    for (const std::string& name : names) {
        groups.add(0, "LAYER");
        groups.add_new_handle();
        groups.add_all("330 3, 100 AcDbSymbolTableRecord, 100 AcDbLayerTableRecord");
        groups.add(2, name);
        groups.add(70, locked_keys.contains(layer_key(name)) ? locked : 0);
        groups.add_all("62 7, 6 Continuous");
    }
}

std::size_t flags_of(const core::Curve& curve) {
    constexpr std::size_t closed = 1;
    constexpr std::size_t periodic = 2;
    constexpr std::size_t rational = 4;
    constexpr std::size_t planar = 8;
    const core::Closing closing = core::closing_of(curve).closing;
    const bool is_periodic = closing == core::Closing::periodic || closing == core::Closing::wrapped;
    return planar + (closing == core::Closing::open ? 0 : closed) + (is_periodic ? periodic : 0) +
           (curve.is_rational() ? rational : 0);
}

void add_color(Groups& groups, core::DocumentColor color) {
    groups.add(420, std::size_t{color.red} << 16U | std::size_t{color.green} << 8U | std::size_t{color.blue});
}

void add_spline(Groups& groups, const core::DocumentCurve& entry) {
    const core::CurveDefinition curve = full_definition(*entry.curve);
    groups.add(0, "SPLINE");
    groups.add_new_handle();
    groups.add_all("330 10, 100 AcDbEntity");
    groups.add(8, layer_name(entry.name));
    if (entry.color) add_color(groups, *entry.color);
    groups.add_all("100 AcDbSpline, 210 0, 220 0, 230 1");
    groups.add(70, flags_of(*entry.curve));
    groups.add(71, static_cast<std::size_t>(curve.degree));
    groups.add(72, curve.knots.size());
    groups.add(73, curve.points.size());
    groups.add_all("74 0, 42 1e-9, 43 1e-10");
    for (const double knot : curve.knots) groups.add_number(40, knot);
    for (const double weight : curve.weights) groups.add_number(41, weight);
    for (const core::Point point : curve.points) {
        groups.add_number(10, point.x);
        groups.add_number(20, point.y);
        groups.add(30, "0");
    }
}

std::string header(const core::Document& document, unsigned next_handle) {
    Groups groups;
    groups.add_all("0 SECTION, 2 HEADER, 9 $ACADVER, 1 AC1021");
    groups.add_all("9 $DWGCODEPAGE, 3 ANSI_1252, 9 $HANDSEED");
    groups.add(5, fmt::format("{:X}", next_handle));
    groups.add(9, "$INSUNITS");
    groups.add(70, document.units ? code_of_units(*document.units).value_or("0") : "0");
    groups.add(0, "ENDSEC");
    return std::move(groups.text());
}

void note_losses_of_layers(Notes& notes, const Entries& entries) {
    const std::set<std::string> locked_keys = locked_layers(entries);
    for (const core::DocumentCurve* entry : entries) {
        const auto name = [entry] { return entry->name; };
        const std::string layer = layer_name(entry->name);
        if (layer != entry->name) notes.add(renamed, name);
        if (entry->locked && !locked_keys.contains(layer_key(layer))) notes.add(unlocked, name);
    }
}

}  // namespace

core::FileResult<Exported> write_dxf(const core::Document& document, const WriteOptions& /*options*/) {
    const auto entries = visible_curves(document);
    if (!entries) return tl::unexpected(entries.error());
    Groups groups;
    groups.add_all(before_layers);
    add_layers(groups, *entries);
    groups.add_all(between_layers_and_entities);
    for (const core::DocumentCurve* entry : *entries) add_spline(groups, *entry);
    groups.add_all(after_entities);
    double largest_error = 0.0;
    for (const core::DocumentCurve* entry : *entries)
        largest_error = std::max(largest_error, unrolling_error(*entry->curve));
    Notes notes;
    note_losses(notes, document, {.colors = true, .locks = true, .units = true, .periodic = true});
    note_losses_of_layers(notes, *entries);
    if (document.units && !code_of_units(*document.units))
        notes.add("the unit of length was left out, since DXF has none of that size; the numbers stay as they are");
    return Exported{header(document, groups.next_handle()) + groups.text(),
                    {.largest_error = largest_error, .left_out = notes.sentences()}};
}

}  // namespace batten::exchange
