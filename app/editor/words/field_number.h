/// Numbers in narrow fields: with the digits by which they differ.
#pragma once

#include <functional>
#include <string>

namespace batten::editor {

/// Which digits of a number a field shows.
struct FieldDigits {
    int decimals = 2;        ///< by which the numbers of a column are told apart
    int most_decimals = 17;  ///< shown, where a column has no room for all
    bool is_factor = false;  ///< what counts is its ratio to others: as many digits of a small one as of a large one
    double extent = 0.0;     ///< how far the numbers of a column differ; 0 where that is not known
};

/// `value` as it `fits` the field. A small number that the decimals would blur gets significant digits instead; one
/// that differs from its neighbors in its last digits only has these, behind an ellipsis: "…23.450" for 5500123.45.
/// What does not fit otherwise has fewer digits, at last one and the power of ten.
std::string field_number(double value, const FieldDigits& digits, const std::function<bool(const std::string&)>& fits);

}  // namespace batten::editor
