#include "exchange/svg/entities.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <pugixml.hpp>
#include <set>
#include <string>

#include "exchange/svg/losses.h"
#include "exchange/svg/scanner.h"

namespace batten::exchange {

namespace {

using EntityNames = std::set<std::string, std::less<>>;

constexpr std::string_view entity_start = "<!ENTITY";

// Of a comment, an instruction or a declaration with which `text` begins; what is in quotes ends none.
std::size_t length_of_declaration(std::string_view text) {
    const auto behind = [&](std::string_view end) {
        return std::min(text.find(end, 2), text.size() - end.size()) + end.size();
    };
    if (text.starts_with("<!--")) return behind("-->");
    if (text.starts_with("<?")) return behind("?>");
    std::size_t at = 0;
    for (; at < text.size() && text[at] != '>'; ++at)
        if (text[at] == '"' || text[at] == '\'') at = std::min(text.find(text[at], at + 1), text.size() - 1);
    return at;
}

// The name that a declaration defines, but for those of parameters, which only a DOCTYPE uses.
std::optional<std::string_view> defined_name(std::string_view declaration) {
    if (!declaration.starts_with(entity_start)) return std::nullopt;
    const std::string_view rest = declaration.substr(entity_start.size());
    const std::size_t start = std::min(rest.find_first_not_of(svg_blanks), rest.size());
    const std::string_view name = rest.substr(start, rest.find_first_of(svg_blanks, start) - start);
    if (name.empty() || name == "%") return std::nullopt;
    return name;
}

EntityNames defined_entities(std::string_view doctype) {
    EntityNames names;
    for (std::size_t at = doctype.find('<'); at < doctype.size(); at = doctype.find('<', at)) {
        const std::string_view rest = doctype.substr(at);
        const std::size_t length = length_of_declaration(rest);
        if (const auto name = defined_name(rest.substr(0, length))) names.emplace(*name);
        at += length;
    }
    for (const char* const known : {"amp", "lt", "gt", "apos", "quot"}) names.erase(known);
    return names;
}

std::optional<std::string_view> entity_in(std::string_view text, const EntityNames& names) {
    for (std::size_t at = text.find('&'); at != std::string_view::npos; at = text.find('&', at + 1)) {
        constexpr std::size_t longest = 256;
        const std::string_view rest = text.substr(at + 1, longest);
        const std::string_view name = rest.substr(0, std::min(rest.find(';'), rest.size()));
        if (name.size() < rest.size() && names.contains(name)) return name;
    }
    return std::nullopt;
}

// The first one that `element` has itself.
std::optional<std::string_view> used_entity(const pugi::xml_node& element, const EntityNames& names) {
    for (const pugi::xml_attribute& attribute : element.attributes()) {
        if (std::string_view(attribute.name()).starts_with("xmlns")) continue;
        if (const auto found = entity_in(attribute.value(), names)) return found;
    }
    for (const pugi::xml_node& part : element.children()) {
        if (part.type() != pugi::node_pcdata) continue;
        if (const auto found = entity_in(part.value(), names)) return found;
    }
    return std::nullopt;
}

class EntityWalk : public pugi::xml_tree_walker {
  public:
    EntityWalk(const EntityNames& names, Notes& left_out) : names_(names), left_out_(left_out) {}

    bool for_each(pugi::xml_node& node) override {
        if (const auto name = used_entity(node, names_))
            left_out_.add(svg_loss::entity, [&] { return std::string(*name); });
        return true;
    }

  private:
    const EntityNames& names_;
    Notes& left_out_;
};

}  // namespace

void tell_entities(std::string_view text, Notes& left_out) {
    if (text.find(entity_start) == std::string_view::npos) return;
    // Escapes are left as they stand, since "&amp;a;" is no entity.
    constexpr unsigned int options = (pugi::parse_default | pugi::parse_doctype) & ~pugi::parse_escapes;
    pugi::xml_document file;
    if (!file.load_buffer(text.data(), text.size(), options)) return;
    EntityNames names;
    for (const pugi::xml_node& node : file.children())
        if (node.type() == pugi::node_doctype) names.merge(defined_entities(node.value()));
    if (names.empty()) return;
    EntityWalk walk(names, left_out);
    file.traverse(walk);
}

}  // namespace batten::exchange
