/// What `eval --basis` prints: the basis functions at a parameter, one by one.
#pragma once

#include <span>
#include <string>
#include <tl/expected.hpp>

#include "app/cli/subcommands.h"
#include "core/curve/curve.h"

namespace batten::cli {

/// The functions of `curve` that do not vanish at each of the parameters, with as many derivatives, from the side and
/// in the form that `options` ask for: N, and beside it R where the curve is rational. The error is the first parameter
/// where a number is too large for a double.
tl::expected<std::string, double> basis_rows(const core::Curve& curve, std::span<const double> parameters,
                                             const EvalOptions& options);

}  // namespace batten::cli
