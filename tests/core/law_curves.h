/// Curves of every sort for the laws, drawn with rapidcheck, which looks for the simplest one that breaks a law.
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <string>

#include "core/curve/curve.h"

namespace batten::core {

/// Called by rapidcheck for a curve that breaks a law.
void showValue(const Curve& curve, std::ostream& stream);

}  // namespace batten::core

namespace batten::core::laws {

/// Where every law has to hold.
enum class Setting {
    plain,
    far_away,       ///< a million units from the origin
    close_knots,    ///< some knots 1e-9 apart
    long_domain,    ///< knots a billion apart
    close_and_long  ///< some knots 1e-9 and some a billion apart
};

/// What may be drawn.
struct Sort {
    int most_degree = max_degree;
    bool open = true;
    bool periodic = true;
    bool unclamped = true;
    bool rational = true;
};

/// Draws a curve: degree 1 to 25, up to 8 knots inside with multiplicities 1 to p, ends clamped or not, weights from
/// 1/4 to 8 or all 1, or periodic with a seam of multiplicity 1 to p. Never periodic where knots are close and the
/// domain is long: the repetitions of a period could not be told apart. To be called inside a property.
Curve draw_curve(Setting setting, Sort sort = {});

/// Draws a parameter: in a span chosen first, so that short spans are not missed, at a knot or at an end.
double draw_parameter(const Curve& curve);

/// Draws a parameter as above where one knot more fits.
double draw_insertable_parameter(const Curve& curve);

/// Draws a whole number in [lower, upper].
int draw_whole(int lower, int upper);

/// Draws a number in [lower, upper], out of 256 equally spaced ones.
double draw_number(double lower, double upper);

/// The unit of rounding of the curve's coordinates: 2^-53 of the largest one.
double unit_of(const Curve& curve);

/// The largest distance of the two curves at equal parameters in the domain of `a`, seen from both sides, at knots and
/// between them.
double largest_distance(const Curve& a, const Curve& b);

/// Checks `law`, a function of the setting, in every setting.
template <class Law>
void check_everywhere(const std::string& text, Law law) {
    struct Case {
        Setting setting;
        const char* where;
    };
    for (const Case& c :
         {Case{Setting::plain, ""}, Case{Setting::far_away, ", far from the origin"},
          Case{Setting::close_knots, ", with knots 1e-9 apart"}, Case{Setting::long_domain, ", in a domain of 1e9"},
          Case{Setting::close_and_long, ", with knots 1e-9 apart in a domain of 1e9"}})
        EXPECT_TRUE(rc::check(text + c.where, [&] { law(c.setting); })) << text << c.where;
}

}  // namespace batten::core::laws
