/// A curve of SISL with an owner.
#pragma once

#include <cstdlib>
#include <memory>
#include <span>

extern "C" {
#include <sisl.h>
}

#include "core/curve/curve.h"

namespace batten::bench {

struct SislDeleter {
    void operator()(SISLCurve* curve) const { freeCurve(curve); }
    void operator()(double* memory) const { std::free(memory); }
};
using SislCurve = std::unique_ptr<SISLCurve, SislDeleter>;
using SislNumbers = std::unique_ptr<double, SislDeleter>;

SislCurve sisl_curve(int degree, std::span<const double> knots, std::span<const core::Point> points,
                     std::span<const double> weights, bool is_rational);
SislCurve sisl_curve(const core::Curve& curve);

}  // namespace batten::bench
