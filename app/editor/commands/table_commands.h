/// Commands that make a curve from a table of points: pasted, or in a file.
#pragma once

#include <filesystem>
#include <optional>

#include "app/editor/command.h"
#include "core/base/names.h"

namespace batten::editor {

/// What the points of a table are to the curve.
enum class TableUse { through, fit, control };

/// How a curve made from a table begins and ends.
enum class TableEnds {
    open,
    closed,  ///< periodic, smooth where it returns to the first point
    corner   ///< returns to the first point in a corner, as an airfoil does at its trailing edge
};

struct PointsFromTable {
    std::string text;
    TableUse use = TableUse::through;
    std::optional<double> tolerance{};  ///< of a fit; none: a thousandth of the size of the points
    TableEnds ends = TableEnds::open;
    std::optional<std::size_t> x_column{};  ///< counted from 1; none: see core::read_point_table
    std::optional<std::size_t> y_column{};
    static const CommandSpec& spec();
};

struct PointsFromFile {
    std::filesystem::path path;
    TableUse use = TableUse::through;
    std::optional<double> tolerance{};  ///< of a fit; none: a thousandth of the size of the points
    TableEnds ends = TableEnds::open;
    std::optional<std::size_t> x_column{};  ///< counted from 1; none: see core::read_point_table
    std::optional<std::size_t> y_column{};
    static const CommandSpec& spec();
};

/// Asks for a file, and then for what its points are.
struct OpenTable {
    std::optional<std::filesystem::path> path{};  ///< none: asks for one
    static const CommandSpec& spec();
};

/// Asks what the points on the clipboard are.
struct PastePoints {
    static const CommandSpec& spec();
};

/// The name of the file may be that of a table: it ends in .csv, .dat, .tsv or .txt, in any case.
bool is_named_as_table(const std::filesystem::path& path);

}  // namespace batten::editor

namespace batten::core {

template <>
struct Names<editor::TableUse> {
    using enum editor::TableUse;
    static constexpr std::array table{Named{through, "through", "points to go through"},
                                      Named{fit, "fit", "points to be near to"},
                                      Named{control, "control", "control points"}};
};

template <>
struct Names<editor::TableEnds> {
    using enum editor::TableEnds;
    static constexpr std::array table{Named{open, "open", "open"}, Named{closed, "closed", "closed smoothly"},
                                      Named{corner, "corner", "closed with a corner"}};
};

}  // namespace batten::core
