/// A document: several named curves and how they are looked at. A plain value; copying it is cheap.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/curve/curve.h"
#include "core/document/guide.h"
#include "core/document/joint_marks.h"
#include "core/document/picture.h"
#include "core/document/symmetry.h"
#include "core/document/units.h"

namespace batten::core {

struct FitPoints;

/// A color as it stands in the file, "#4c7fe0".
struct DocumentColor {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    bool operator==(const DocumentColor&) const = default;
};

/// The text of a color, and the color of a text; none where it is of another form.
std::string color_text(DocumentColor color);
std::optional<DocumentColor> color_of_text(std::string_view text);

/// One curve of a document with what belongs to it but not to its mathematics.
struct DocumentCurve {
    std::string name;
    std::shared_ptr<const Curve> curve;  ///< never null in a document
    std::optional<DocumentColor> color;  ///< none: the theme's curve color
    bool visible = true;
    bool locked = false;
    Tears tears = Tears::refuse;         ///< whether edits may tear the curve
    std::vector<std::size_t> pinned{};   ///< control points that edits of the shape leave where they are; ascending
    std::optional<Symmetry> symmetry{};  ///< of which other curves it is an image; none for most
    JointMarks joints{};                 ///< that edits keep
    std::string unknown_members;         ///< members that this version does not know, as a JSON object; empty if none
    /// Which color of a palette each control point has, where that is not the one of its index; files do not have it.
    std::shared_ptr<const std::vector<std::uint8_t>> point_hues{};
    std::shared_ptr<const FitPoints> fit{};  ///< of which the curve is made (core/make/fit_points.h); null for others
    std::string unknown_fit_members{};       ///< likewise, of the fit points
    std::string group{};                     ///< the name that all curves of its group have; empty where it is in none
};

/// Whether edits may tear the curve of `entry`: where the switch says so, and where it is torn already.
Tears tears_of(const DocumentCurve& entry);

/// How the document was last looked at; not part of undo.
struct DocumentView {
    std::optional<double> parameter;
    std::optional<std::vector<std::string>> overlays;
    std::map<std::string, std::string> notation;  ///< choices by name, as the program that shows it knows them
    std::string unknown_members;
    bool operator==(const DocumentView&) const = default;
};

/// What a file holds.
struct Document {
    std::string title;        ///< shown where the document is offered; may be empty
    std::string description;  ///< one sentence saying what to try; may be empty
    std::vector<DocumentCurve> curves;
    std::size_t active = 0;                ///< index of the curve that edits go to; 0 when there is none
    std::vector<Picture> pictures;         ///< below the curves, the first one lowest
    std::vector<Guide> guides;             ///< lines that points are put on
    std::optional<DocumentUnits> units{};  ///< of its lengths; none: they are plain numbers
    DocumentView view;
    std::string unknown_members;
    std::size_t lost_fits = 0;  ///< how many curves of its file had fit points that do not give them; not written

    const DocumentCurve* active_curve() const { return active < curves.size() ? &curves[active] : nullptr; }
};

/// The index of the first curve called `name`; none where there is none.
std::optional<std::size_t> index_of_curve(const Document& document, const std::string& name);

/// The index of the curve that a person means by `text`: the first one of that name, else the one of that number,
/// counted from 0; none where there is neither.
std::optional<std::size_t> curve_meant_by(const Document& document, const std::string& text);

/// "'wave', 'circle'", or "none".
std::string quoted_names(const Document& document);

/// A name that no curve of `document` has: `wish` itself ("curve" when it is empty), else its first free successor:
/// "wave 2" after "wave", "wave 3" after "wave 2".
std::string unused_name(const Document& document, const std::string& wish);

/// The same for many curves that are added one after another. Cost O(log n) for each.
class FreeNames {
  public:
    explicit FreeNames(const Document& document);

    /// The unused name for `wish`, which from now on is in use.
    std::string take(const std::string& wish);

  private:
    std::set<std::string> used_;
    std::map<std::string, std::size_t> next_numbers_;  // no number below is free, by the name without it
};

}  // namespace batten::core
