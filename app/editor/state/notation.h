/// The letters and numbers that a lecture uses. Texts are written with P for points, u for the parameter and U for the
/// knots; what is shown is brought into the notation in one place.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/base/names.h"

namespace batten::editor {

enum class PointLetter { P, V, B, d };
enum class ParameterLetter { u, t };
enum class DegreeOrOrder { degree, order };

/// Which parent a point of the construction has its index from: P_3^1 made of P_2 and P_3, or P_2^1 of the same.
enum class CellNumbering { last, first };

enum class NumberStyle { fractions, decimals };

struct Notation {
    PointLetter points = PointLetter::P;
    ParameterLetter parameter = ParameterLetter::u;
    DegreeOrOrder degree = DegreeOrOrder::degree;  ///< order: k = p + 1 stands beside the degree
    CellNumbering triangles = CellNumbering::last;
    NumberStyle numbers = NumberStyle::fractions;
    bool operator==(const Notation&) const = default;
};

/// `text` in `notation`: P, u and U that stand by themselves, or have an index, become V, t and T, and "degree 3" tells
/// its order, "degree 3 (k = 4)". What stands in quotes is someone's name for something and stays. Once is enough, and
/// twice does no harm.
std::string notated(const std::string& text, const Notation& notation);

/// A number as a lecture writes it. A fraction n/d in lowest terms is written as such
/// - where it is simple: d is 2, 4 or 8 and |n| <= 20, or it is between -1 and 1 and d is 5, 10, 16, 32 or 64;
/// - where `digits` digits would round it, if it is one of small numbers: |n| <= 99 where decimals end (27/320), else
///   |n| <= 999 (8/15, 307/750, 1/720), with d as core::small_fraction has it.
/// All else, and everything where `notation` has decimals, is number_text with `digits`: 2.4, 7.152, 0.216, 12.06.
std::string exact_text(const Notation& notation, double value, int digits = 4);

/// `rounded`, what decimals tell of `value`, or "1/3" where no decimals tell all of a fraction of small numbers.
std::string unrounded_text(const Notation& notation, double value, std::string rounded);

/// Numbers that are read together, as those of a sum or a row: all as fractions where one of them is written so by
/// itself and none of them has |n| > 999, else all with `digits` digits.
std::vector<std::string> exact_texts(const Notation& notation, std::span<const double> values, int digits = 4);

/// The choices by name as they stand in files and settings, and back; what is missing or unknown keeps its default.
std::map<std::string, std::string> names_of(const Notation& notation);
Notation notation_named(const std::map<std::string, std::string>& names);

}  // namespace batten::editor

namespace batten::core {

template <>
struct Names<editor::PointLetter> {
    using enum editor::PointLetter;
    static constexpr std::array table{Named{P, "P", "P"}, Named{V, "V", "V"}, Named{B, "B", "B"}, Named{d, "d", "d"}};
};

template <>
struct Names<editor::ParameterLetter> {
    using enum editor::ParameterLetter;
    static constexpr std::array table{Named{u, "u", "u"}, Named{t, "t", "t"}};
};

template <>
struct Names<editor::DegreeOrOrder> {
    using enum editor::DegreeOrOrder;
    static constexpr std::array table{Named{degree, "degree", "degree p"},
                                      Named{order, "order", "order k beside degree p"}};
};

template <>
struct Names<editor::CellNumbering> {
    using enum editor::CellNumbering;
    static constexpr std::array table{Named{last, "last", "last parent"}, Named{first, "first", "first parent"}};
};

template <>
struct Names<editor::NumberStyle> {
    using enum editor::NumberStyle;
    static constexpr std::array table{Named{fractions, "fractions", "fractions"},
                                      Named{decimals, "decimals", "decimals"}};
};

}  // namespace batten::core
