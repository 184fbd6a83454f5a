// What is typed where a number or several are wanted.

#include "app/editor/fields/expression.h"

#include <cmath>

#include "tests/fuzz/target.h"

namespace batten::fuzz {

void run(std::string_view bytes) {
    const core::DocumentUnits units;
    const auto number = editor::parse_expression(bytes, editor::ExpressionUnit::degrees, &units);
    require(number ? std::isfinite(*number) : !number.error().empty(), "it is a number or refused");
    const auto numbers = editor::parse_expressions(bytes, &units);
    if (numbers)
        for (const double value : *numbers) require(std::isfinite(value), "numbers are finite");
    (void)editor::parse_expression(editor::typed_over(bytes, "2"));
}

}  // namespace batten::fuzz
