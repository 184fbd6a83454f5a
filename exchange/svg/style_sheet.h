/// The style sheets of an SVG file, as far as their selectors are simple.
#pragma once

#include <list>
#include <pugixml.hpp>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "exchange/notes.h"
#include "exchange/svg/css.h"

namespace batten::exchange {

/// Rules for an element by its name, by one of its classes, by its id, by its name and one of these, and for all.
class StyleSheet {
  public:
    /// Takes the rules of the element `style`, unless they are for printers or in another language than CSS. What is
    /// not read, and may change what is, is told in `notes`. Cost O(n).
    void add(const pugi::xml_node& style, Notes& notes);

    /// Tells of a style sheet outside of the file, of which nothing is read.
    void leave_out_file(Notes& notes);

    /// Hands each value for `element` to `declaration`, in no order. Cost O(words of its class and values).
    void read(const pugi::xml_node& element, const CssDeclaration& declaration) const;

    /// Whether a rule that is not read sets a font, in whose size lengths can be said, or may do so.
    bool leaves_out_fonts() const { return leaves_out_fonts_; }

  private:
    void leave_out_rule(std::string_view rule, std::string_view block, Notes& notes);
    void add_rule(std::string_view selectors, std::string_view declarations, Notes& notes);

    std::list<std::string> texts_{};  // which the values are parts of
    std::unordered_map<std::string, std::vector<std::pair<SvgProperty, CssValue>>> values_{};  // by selector
    std::size_t value_count_ = 0;
    std::uint32_t rule_count_ = 0;
    bool leaves_out_fonts_ = false;
};

}  // namespace batten::exchange
