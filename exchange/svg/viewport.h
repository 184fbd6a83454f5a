/// What an svg element says of sizes: its viewBox, its width and height, and lengths in it.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string_view>

#include "core/document/units.h"
#include "core/edit/plane_map.h"
#include "exchange/svg/style.h"

namespace batten::exchange {

/// A length as it is written: "12", "3mm", "50%".
struct SvgLength {
    double value = 0.0;
    std::string_view unit{};  ///< empty where there is none

    /// In px; `whole` stands for 100% where it is not 0, which means that it is not known. None for units that need a
    /// font or a window.
    std::optional<double> in_px(double whole) const;
};

/// None where the text is no length.
std::optional<SvgLength> read_length(std::string_view text);

/// In px; none where the file does not say.
struct FontSizes {
    static constexpr double medium = 16.0;  ///< where nothing is said

    std::optional<double> own = medium;
    std::optional<double> root = medium;

    /// With what an element says of its own font, which its children have, too: lengths, % and medium are known.
    FontSizes within(const SvgProperties& properties) const;
};

/// Where an svg element puts what is in it.
struct Viewport {
    double left = 0.0;
    double top = 0.0;
    double width = 0.0;   ///< of what is in it, of which lengths in % are parts; 0 where the file does not say
    double height = 0.0;  ///< likewise

    FontSizes font{};

    /// The length of attribute `name`, which is along x ("x", "width", "cx", ...), y or neither; `missing` where there
    /// is none, or something else ("auto"). None where the file does not say how long it is: parts of what has no size,
    /// units of a window or of a font's letters, and sums of these.
    std::optional<double> length(const pugi::xml_node& element, const char* name,
                                 std::optional<double> missing = 0.0) const;
};

/// The outermost svg element.
struct Page {
    Viewport viewport{};
    core::PlaneMap map{};  ///< to the plane: coordinates stay, but y goes up
    std::optional<core::DocumentUnits> units{};
};

/// Coordinates of the document are those of the viewBox. y is counted up from the line `batten:baseline` where the
/// file has it, as ours do; else from the lower edge. Lengths have the unit of the width or height, px where these are
/// in sizes of `font`, which is that of `svg`.
Page page_of(const pugi::xml_node& svg, const FontSizes& font = {});

/// The map of an svg or symbol element inside, which stands in a box of `outer`; and its viewport.
struct InnerViewport {
    Viewport viewport{};
    core::PlaneMap map{};
    core::Box box{};          ///< where it stands in `outer`; empty where the file does not say its size
    bool is_empty = false;    ///< its box has the size 0, so that nothing is drawn
    bool is_unknown = false;  ///< the file does not say where its box is, or how large where that counts
};
InnerViewport inner_viewport(const pugi::xml_node& element, const Viewport& outer);

/// The same for one that `use` repeats, whose width and height are those of the box where it has them.
InnerViewport inner_viewport(const pugi::xml_node& element, const pugi::xml_node& use, const Viewport& outer);

}  // namespace batten::exchange
