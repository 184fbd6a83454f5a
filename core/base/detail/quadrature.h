/// Integrates functions to the accuracy of doubles.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
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
    Value rest{};     ///< what the last rounding took from `kronrod`, where that is known
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

/// How far from each end of `interval` the rules do not look.
inline double unseen_length(Interval interval) {
    return 0.5 * (1.0 - gauss_kronrod::nodes.front()) * interval.length();
}

/// An interval of one of several functions.
struct PieceRange {
    std::size_t piece = 0;
    Interval interval;
};

/// What the rules say of a range.
template <class Value>
struct IntegratedPart {
    std::size_t piece = 0;
    RulePair<Value> rules;
    double error = 0.0;  ///< how far the longer rule may be off; infinite where that cannot be told
};

/// So many parts of so many ranges are halved at most. A smooth piece needs a few halvings and a pole beside it some
/// dozens; where rounding is all that is left no number is enough.
constexpr std::size_t most_divisions(std::size_t ranges) {
    return 1000 + 8 * ranges;
}

/// Integrates over the ranges by `rules_of(piece, interval)`: halves the part with the largest error until
/// `is_enough(error, sum)` of it, or most_divisions are done; parts between whose ends no double lies stay whole.
/// `error_of(piece, rules)` gives the error of a part. Returns the parts in order. Source: Piessens et al. 1983,
/// QUADPACK, QAG.
template <class Value, class RulesOf, class ErrorOf, class IsEnough>
std::vector<IntegratedPart<Value>> integrate_by_rules(std::span<const PieceRange> ranges, const RulesOf& rules_of,
                                                      const ErrorOf& error_of, const IsEnough& is_enough) {
    using Part = IntegratedPart<Value>;
    const auto has_less_error = [](const Part& a, const Part& b) { return a.error < b.error; };
    const auto part_of = [&](std::size_t piece, Interval interval) {
        const auto rules = rules_of(piece, interval);
        const double error = error_of(piece, rules);
        return Part{piece, rules, std::isnan(error) ? std::numeric_limits<double>::infinity() : error};
    };
    Value sum{};
    std::vector<Part> done;
    done.reserve(ranges.size());
    for (const PieceRange& range : ranges) {
        done.push_back(part_of(range.piece, range.interval));
        sum += done.back().rules.kronrod;
    }
    const auto is_done = [&](const Part& part) { return is_enough(part.error, sum); };
    if (std::all_of(done.begin(), done.end(), is_done)) return done;
    const auto first_open = std::stable_partition(done.begin(), done.end(), is_done);
    std::vector<Part> open(first_open, done.end());
    done.erase(first_open, done.end());
    std::make_heap(open.begin(), open.end(), has_less_error);
    for (std::size_t i = 0; i < most_divisions(ranges.size()) && !open.empty(); ++i) {
        if (is_enough(open.front().error, sum)) break;
        std::pop_heap(open.begin(), open.end(), has_less_error);
        const Part part = open.back();
        open.pop_back();
        const Interval whole = part.rules.interval;
        const double middle = whole.lower + 0.5 * whole.length();
        if (!(whole.lower < middle && middle < whole.upper)) {
            done.push_back(part);
            continue;
        }
        sum -= part.rules.kronrod;
        for (const Interval half : {Interval{whole.lower, middle}, Interval{middle, whole.upper}}) {
            open.push_back(part_of(part.piece, half));
            sum += open.back().rules.kronrod;
            std::push_heap(open.begin(), open.end(), has_less_error);
        }
    }
    done.insert(done.end(), open.begin(), open.end());
    std::sort(done.begin(), done.end(), [](const Part& a, const Part& b) {
        return std::pair(a.piece, a.rules.interval.lower) < std::pair(b.piece, b.rules.interval.lower);
    });
    return done;
}

/// The same with integrate_once of `function(piece, t)`.
template <class Value, class Function, class ErrorOf, class IsEnough>
std::vector<IntegratedPart<Value>> integrate_adaptively(std::span<const PieceRange> ranges, const Function& function,
                                                        const ErrorOf& error_of, const IsEnough& is_enough) {
    const auto rules_of = [&](std::size_t piece, Interval interval) {
        return integrate_once<Value>([&](double t) { return function(piece, t); }, interval);
    };
    return integrate_by_rules<Value>(ranges, rules_of, error_of, is_enough);
}

}  // namespace batten::core
