/// The letters and numbers that a lecture uses. Texts are written with P for points, u for the parameter and U for the
/// knots; what is shown is brought into the notation in one place.
#pragma once

#include <map>
#include <string>

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

/// `text` with the letters of `notation`: P, u and U that stand by themselves, or have an index, become V, t and T.
std::string notated(const std::string& text, const Notation& notation);

/// "1/6" where `value` is such a fraction and `notation` has fractions, else number_text with `digits`.
std::string exact_text(const Notation& notation, double value, int digits = 4);

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
