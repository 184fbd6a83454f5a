/// What there is to tell of an SVG file that does not become curves, or other ones.
#pragma once

#include "core/base/sentence.h"

/// Sentences for Notes (notes.h): {place} is the name of the first one.
namespace batten::exchange::svg_loss {

inline constexpr core::PluralPattern wrong_path{
    "the path data go wrong at {place}; they are read up to there",
    "the data of {count} paths go wrong, first at {place}; they are read up to there"};
/// Of a polygon or a polyline.
inline constexpr core::PluralPattern wrong_points{
    "the points go wrong at {place}; they are read up to there",
    "the points of {count} polygons or polylines go wrong, first at {place}; they are read up to there"};
inline constexpr core::PluralPattern refused_curve{"'{place}' is left out: {reason}",
                                                   "{count} curves are left out, first '{place}': {reason}"};
/// Of shapes, `use` and svg elements.
inline constexpr core::PluralPattern unknown_length{
    "'{place}' is left out, since the file does not say how long its lengths are: % of what has no size, units of a "
    "window or of a font",
    "{count} elements are left out, first '{place}', since the file does not say how long their lengths are: % of what "
    "has no size, units of a window or of a font"};
inline constexpr core::PluralPattern wrong_transform{
    "the transform of '{place}' cannot be read, so it stands where it would without",
    "{count} transforms cannot be read, the first one that of '{place}'; what they belong to stands where it would "
    "without"};
inline constexpr core::PluralPattern text{
    "a text is left out; in the program that made it, it can be turned into paths",
    "{count} texts are left out; in the program that made them, they can be turned into paths"};
inline constexpr core::PluralPattern image{"an image is left out", "{count} images are left out"};
inline constexpr core::PluralPattern foreign{"a part that is no SVG is left out",
                                             "{count} parts that are no SVG are left out"};
inline constexpr core::PluralPattern not_displayed{"an element that is not displayed is left out",
                                                   "{count} elements that are not displayed are left out"};
/// Of a file of which nothing else is left.
inline constexpr core::PluralPattern all_hidden{
    "nothing is read from this file, since all that it draws is hidden: an element is not displayed",
    "nothing is read from this file, since all that it draws is hidden: {count} elements are not displayed"};
/// For other languages, or programs with extensions.
inline constexpr core::PluralPattern for_others{
    "an alternative that viewers do not show for readers of English is left out",
    "{count} alternatives that viewers do not show for readers of English are left out"};
inline constexpr core::PluralPattern outside{
    "an element of another file is left out: '{place}'; nothing outside this file is read",
    "{count} elements of other files are left out, the first one '{place}'; nothing outside this file is read"};
inline constexpr core::PluralPattern unknown_use{
    "an element that is used but not there is left out: '{place}'",
    "{count} elements that are used but not there are left out, the first one '{place}'"};
inline constexpr core::PluralPattern circle{
    "an element that uses itself is left out: '{place}'",
    "{count} elements that use themselves are left out, the first one '{place}'"};
inline constexpr core::PluralPattern clipped{"an element that is clipped or masked is read whole",
                                             "{count} elements that are clipped or masked are read whole"};
/// At the edge of an svg element or a symbol inside.
inline constexpr core::PluralPattern cut_off{
    "'{place}' is read whole, though the inner drawing or the symbol that it is in cuts it off",
    "{count} shapes are read whole, first '{place}', though the inner drawings or symbols that they are in cut them "
    "off"};
/// That the file defines itself.
inline constexpr core::PluralPattern entity{
    "'&{place};' is left as it stands, since no entity of a file is expanded; what it says of shapes and colors is "
    "lost",
    "{count} elements have entities of the file, first '&{place};', of which none is expanded; what these say of "
    "shapes and colors is lost"};
inline constexpr core::PluralPattern style_sheet{
    "a style sheet is not read, so colors and lines may be others, and what it hides or moves is read as if it did not",
    "{count} style sheets are not read, so colors and lines may be others, and what they hide or move is read as if "
    "they did not"};
inline constexpr core::PluralPattern style_rule{
    "a style rule is not read: '{place}'; colors and lines may be others, and what it hides or moves is read as if it "
    "did not",
    "{count} style rules are not read, the first one '{place}'; colors and lines may be others, and what they hide or "
    "move is read as if they did not"};
inline constexpr core::PluralPattern styled_size{
    "the style of '{place}' sets a size or a place, which are read as attributes alone",
    "the styles of {count} elements, first of '{place}', set sizes or places, which are read as attributes alone"};
/// Looks that curves do not have.
inline constexpr core::PluralPattern fill{
    "a shape is filled; its outline is read as a line, and the fill is left out",
    "{count} shapes are filled; their outlines are read as lines, and the fills are left out"};
inline constexpr core::PluralPattern pen{
    "the width or the dashes of a line are left out, since all curves are drawn alike but for their colors",
    "the widths or dashes of {count} lines are left out, since all curves are drawn alike but for their colors"};
inline constexpr core::PluralPattern marker{"the markers of a line are left out",
                                            "the markers of {count} lines are left out"};
inline constexpr core::PluralPattern pattern{"a gradient or a pattern is left out",
                                             "{count} gradients or patterns are left out"};
inline constexpr core::PluralPattern opacity{"the opacity or the filter of a shape is left out",
                                             "the opacities or filters of {count} shapes are left out"};
inline constexpr const char* page =
    "the size of the page is left out; a file that is written has a page around its curves";
/// The limit stands in for {reason}.
inline constexpr core::PluralPattern too_many_curves{
    "a path or a shape behind the first {reason} curves is left out, wholly or in part",
    "{count} paths or shapes behind the first {reason} curves are left out, wholly or in part"};
inline constexpr core::PluralPattern too_deep{"elements that are nested more than {reason} deep are left out",
                                              "elements that are nested more than {reason} deep are left out"};
inline constexpr core::PluralPattern too_many{
    "what follows the first {reason} elements is left out, each counted as often as 'use' repeats it",
    "what follows the first {reason} elements is left out, each counted as often as 'use' repeats it"};
inline constexpr core::PluralPattern too_often{
    "what follows is left out, since 'use' repeats more than {reason} bytes of the file",
    "what follows is left out, since 'use' repeats more than {reason} bytes of the file"};

}  // namespace batten::exchange::svg_loss
