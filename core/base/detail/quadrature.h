/// Integrates functions to the accuracy of doubles.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/geometry.h"

namespace batten::core {

namespace gauss_kronrod {

/// The positive nodes on [-1, 1] and their weights, beside the one in the middle; the odd ones are those of Gauss's
/// rule. Source: QUADPACK, QK21.
inline constexpr std::array<double, 10> nodes{0.995657163025808080735527280689003, 0.973906528517171720077964012084452,
                                              0.930157491355708226001207180059508, 0.865063366688984510732096688423493,
                                              0.780817726586416897063717578345042, 0.679409568299024406234327365114874,
                                              0.562757134668604683339000099272694, 0.433395394129247190799265943165784,
                                              0.294392862701460198131126603103866, 0.148874338981631210884826001129720};
inline constexpr std::array<double, 10> weights{
    0.011694638867371874278064396062192, 0.032558162307964727478818972459390, 0.054755896574351996031381300244580,
    0.075039674810919952767043140916190, 0.093125454583697605535065465083366, 0.109387158802297641899210590325805,
    0.123491976262065851077958109585166, 0.134709217311473325928054001771707, 0.142775938577060080797094273138717,
    0.147739104901338491374841515972068};
inline constexpr std::array<double, 5> gauss_weights{
    0.066671344308688137593568809893332, 0.149451349150580593145863396957658, 0.219086362515982043995534934228163,
    0.269266719309996355091226921569469, 0.295524224714752870173815619188769};

}  // namespace gauss_kronrod

/// The integral of a function over one interval by two rules.
template <class Value>
struct RulePair {
    Interval interval;
    Value kronrod{};  ///< by 21 points, exact for polynomials of degree 31
    Value gauss{};    ///< by 10 of them, exact for degree 19
};

/// Both rules applied to `function`, which is called inside the interval only.
template <class Value, class Function>
RulePair<Value> integrate_once(const Function& function, Interval interval) {
    const double half = 0.5 * interval.length();
    const double middle = interval.lower + half;
    // Differences from the middle are summed up, so that a constant is integrated to the last digit.
    const Value center = function(middle);
    RulePair<Value> result{interval, interval.length() * center, interval.length() * center};
    for (std::size_t i = 0; i < gauss_kronrod::nodes.size(); ++i) {
        const double step = half * gauss_kronrod::nodes[i];
        const Value difference = (function(middle - step) - center) + (function(middle + step) - center);
        result.kronrod += (half * gauss_kronrod::weights[i]) * difference;
        if (i % 2 == 1) result.gauss += (half * gauss_kronrod::gauss_weights[i / 2]) * difference;
    }
    return result;
}

/// Halves `interval` until `is_accurate` holds for both rules on every part, or no double lies between its ends, or 60
/// times; calls `take` with the parts in order.
template <class Value, class Function, class IsAccurate, class Take>
void integrate_adaptively(const Function& function, Interval interval, const IsAccurate& is_accurate, const Take& take,
                          int depth = 0) {
    const auto rules = integrate_once<Value>(function, interval);
    const double middle = interval.lower + 0.5 * interval.length();
    const bool is_divisible = depth < 60 && interval.lower < middle && middle < interval.upper;
    if (!is_divisible || is_accurate(rules)) return take(rules);
    integrate_adaptively<Value>(function, {interval.lower, middle}, is_accurate, take, depth + 1);
    integrate_adaptively<Value>(function, {middle, interval.upper}, is_accurate, take, depth + 1);
}

}  // namespace batten::core
