#include "core/measure/arc_length.h"

#include <cassert>

#include "core/base/detail/unit_interval.h"
#include "core/base/double_double.h"
#include "core/curve/control_box.h"
#include "core/measure/detail/piece_integral.h"

namespace batten::core {

namespace {

// A part whose error is less than this share of the whole length is done.
constexpr double enough_of_length = 1e-15;

constexpr double length_rounding = 8.0 * std::numeric_limits<double>::epsilon();
// By so much of the longest that is possible rounding may exceed the bounds.
constexpr double length_slack = 1e-12;

constexpr double sharp = 1e-6;

constexpr int most_length_steps = 60;

// So many spans are measured at a time: a long curve then takes little more memory than its numbers.
constexpr std::size_t most_spans_at_once = 4096;

// The error of the longer rule, which converges much faster than the shorter one that it is compared with.
double error_of(const RulePair<double>& rules) {
    const double size = std::abs(rules.kronrod);
    if (size == 0.0) return 0.0;
    const double share = 200.0 * std::abs(rules.kronrod - rules.gauss) / size;
    return size * std::min(1.0, share * std::sqrt(share));
}

// Pieces, and the plain ones of them as powers.
struct Pieces {
    std::span<const PieceMotion> motions;
    std::span<const SpeedForm> forms;

    const PieceMotion* begin() const { return motions.data(); }
    const PieceMotion* end() const { return motions.data() + motions.size(); }
};

std::vector<SpeedForm> forms_of(std::span<const PieceMotion> motions) {
    return {motions.begin(), motions.end()};
}

// Of a plain piece: from its middle.
double from_middle(HalfPlace place) {
    return place.is_second() ? 0.5 + place.offset : place.offset - 0.5;
}

Vector velocity_at(const Pieces& pieces, HalfPlace place) {
    const SpeedForm& form = pieces.forms[place.piece()];
    return form.is_plain() ? form.velocity(from_middle(place)) : core::velocity_at(pieces.motions, place);
}

double speed_at(const Pieces& pieces, HalfPlace place) {
    return robust_length(velocity_at(pieces, place));
}

RulePair<double> rules_of(const Pieces& pieces, std::size_t half, Interval offsets) {
    const SpeedForm& form = pieces.forms[half / 2];
    if (!form.is_plain())
        return integrate_once<double>([&](double at) { return speed_at(pieces, {half, at}); }, offsets);
    RulePair<double> rules = form.rules({from_middle({half, offsets.lower}), from_middle({half, offsets.upper})});
    rules.interval = offsets;
    return rules;
}

// The speed has a corner where the curve comes to a stop and turns back. Where that is nearer to an end of a part than
// the rules look, they do not see it; the direction at the end does.
double unseen_error(const Pieces& pieces, std::size_t half, Interval interval) {
    if (pieces.forms[half / 2].goes_onward()) return 0.0;
    const double reach = unseen_length(interval);
    double error = 0.0;
    for (const auto& [end, inside] :
         {std::pair(interval.lower, interval.lower + reach), std::pair(interval.upper, interval.upper - reach)}) {
        const Vector at_end = velocity_at(pieces, {half, end});
        const Vector at_node = velocity_at(pieces, {half, inside});
        if (dot(at_end / robust_length(at_end), at_node) < 0.0)
            error += reach * (robust_length(at_end) + robust_length(at_node));
    }
    return error;
}

// Plain pieces are one range, of the first half, whose offsets go on to 1.
std::vector<PieceRange> ranges_of(const Pieces& pieces, Interval wanted) {
    std::vector<PieceRange> ranges;
    ranges.reserve(pieces.forms.size());
    for (std::size_t i = 0; i < pieces.forms.size(); ++i) {
        const Interval interval = pieces.motions[i].interval();
        if (interval.upper <= wanted.lower || interval.lower >= wanted.upper) continue;
        if (!pieces.forms[i].is_plain()) {
            add_ranges(ranges, pieces.motions, i, wanted);
            continue;
        }
        const Interval offsets{to_unit(interval, interval.clamp(wanted.lower)),
                               to_unit(interval, interval.clamp(wanted.upper))};
        // The speed of a rational piece is seldom seen by one rule.
        const double parting = pieces.forms[i].is_rational() ? offsets.clamp(0.5) : offsets.upper;
        if (offsets.lower < parting) ranges.push_back({2 * i, {offsets.lower, parting}});
        if (parting < offsets.upper) ranges.push_back({2 * i, {parting, offsets.upper}});
    }
    return ranges;
}

// The parts of the ranges, on which the rules are as accurate as they should be, or as can be. The whole of which the
// ranges are a part is about `times` as long.
std::vector<IntegratedPart<double>> parts_of(const Pieces& pieces, std::span<const PieceRange> ranges,
                                             double times = 1.0) {
    return integrate_by_rules<double>(
        ranges, [&](std::size_t half, Interval offsets) { return rules_of(pieces, half, offsets); },
        [&](std::size_t half, const RulePair<double>& rules) {
            return error_of(rules) + unseen_error(pieces, half, rules.interval);
        },
        [times](double error, double sum) { return !(error > enough_of_length * times * sum); });
}

Integral sum_of(std::span<const IntegratedPart<double>> parts) {
    Integral total;
    DoubleDouble sum;
    for (const IntegratedPart<double>& part : parts) {
        sum = sum + DoubleDouble(part.rules.kronrod, part.rules.rest);
        total.error += part.error;
    }
    total.value = sum.rounded();
    total.error += length_rounding * total.value;
    return total;
}

Point shadow(const HomogeneousPoint& point) {
    return point.z == 1.0 ? tip_of(plane_part(point)) : project(point);
}

// What the length between two parameters lies between, and what rounding may make of it.
struct LengthBounds {
    Interval bounds{0.0, 0.0};
    double rounding = 0.0;
};

// The length is at least that of the pieces' chords and at most that of their control polygons. Rounding of the Bézier
// points, which are seen from one origin, may change each leg by twice the rounding of a point, which is half a unit of
// each coordinate.
LengthBounds bounds_of_length(const Pieces& pieces, Interval wanted) {
    LengthBounds found;
    double farthest_sum = 0.0;
    for (const PieceMotion& piece : pieces) {
        const Interval interval = piece.interval();
        if (interval.upper <= wanted.lower || interval.lower >= wanted.upper) continue;
        const Point begin = shadow(piece.points().front());
        double farthest = std::max(std::abs(begin.x), std::abs(begin.y));
        Point before = begin;
        for (const HomogeneousPoint& point : piece.points().subspan(1)) {
            const Point next = shadow(point);
            found.bounds.upper += robust_length(next - before);
            farthest = std::max({farthest, std::abs(next.x), std::abs(next.y)});
            before = next;
        }
        farthest_sum += static_cast<double>(piece.points().size() - 1) * farthest;
        const bool is_whole = wanted.lower <= interval.lower && interval.upper <= wanted.upper;
        found.bounds.lower += is_whole ? robust_length(before - begin)
                                       : robust_length(piece.at(to_unit(interval, wanted.upper)).position -
                                                       piece.at(to_unit(interval, wanted.lower)).position);
    }
    found.rounding = 2.0 * std::numeric_limits<double>::epsilon() * farthest_sum;
    return found;
}

// What cannot be the length gives way to what it is known to lie between.
Integral within(Interval bounds, Integral found) {
    const double slack = length_slack * bounds.upper;
    if (bounds.lower - slack <= found.value && found.value <= bounds.upper + slack) return found;
    return {bounds.lower + 0.5 * bounds.length(), 0.5 * bounds.length() + slack};
}

Integral sum_over(const Pieces& pieces, Interval wanted, std::span<const IntegratedPart<double>> parts) {
    Integral found = sum_of(parts);
    const auto [bounds, rounding] = bounds_of_length(pieces, wanted);
    found.error += rounding;
    return within(bounds, found);
}

// A curve seen from its middle, between whose parameters lengths are asked for.
class MeasuredCurve {
  public:
    explicit MeasuredCurve(const Curve& curve) : curve_(seen_from(curve, middle_of(curve))) {}

    Integral integrate(Interval wanted) const {
        const KnotVector& knots = curve_.knots();
        const auto p = static_cast<std::size_t>(curve_.degree());
        const std::size_t end = knots.size() - p - 1;
        const double runs = std::ceil(static_cast<double>(end - p) / static_cast<double>(most_spans_at_once));
        DoubleDouble sum;
        double error = 0.0;
        for (std::size_t first = p; first < end; first += most_spans_at_once) {
            const std::size_t last = std::min(first + most_spans_at_once, end) - 1;
            if (knots[last + 1] <= wanted.lower || knots[first] >= wanted.upper) continue;
            const Integral run = integrate_run(motions_of(curve_, first, last), wanted, runs);
            if (!std::isfinite(run.value)) return run;
            sum = sum + DoubleDouble(run.value);
            error += run.error;
        }
        return {sum.rounded(), error};
    }

  private:
    static Integral integrate_run(const std::vector<PieceMotion>& motions, Interval wanted, double runs) {
        const auto forms = forms_of(motions);
        const Pieces pieces{motions, forms};
        return sum_over(pieces, wanted, parts_of(pieces, ranges_of(pieces, wanted), runs));
    }

    Curve curve_;
};

// How often the period goes into the way from the domain's beginning to `u`, and what is left.
std::pair<double, double> whole_periods(Interval domain, double u) {
    const double count = std::floor((u - domain.lower) / domain.length());
    return {count, domain.clamp(u - count * domain.length())};
}

Integral around(const MeasuredCurve& curve, Interval domain, double from, double to) {
    const auto [first_period, first] = whole_periods(domain, from);
    const auto [last_period, last] = whole_periods(domain, to);
    if (first_period == last_period) return curve.integrate({first, last});
    const Integral whole = curve.integrate(domain);
    const Integral begun = curve.integrate({first, domain.upper});
    const Integral ended = curve.integrate({domain.lower, last});
    const double between = last_period - first_period - 1.0;
    return {begun.value + between * whole.value + ended.value, begun.error + between * whole.error + ended.error};
}

}  // namespace

bool is_sharp(const Integral& integral) {
    return std::isfinite(integral.value) && integral.error <= sharp * integral.value;
}

Integral arc_length(const Curve& curve) {
    return arc_length(curve, curve.domain().lower, curve.domain().upper);
}

Integral arc_length(const Curve& curve, double from, double to) {
    assert(!std::isnan(from) && !std::isnan(to));
    if (to < from) {
        const Integral reverse = arc_length(curve, to, from);
        return {-reverse.value, reverse.error};
    }
    const MeasuredCurve measured(curve);
    const Interval domain = curve.domain();
    const bool is_inside = domain.contains(from) && domain.contains(to);
    if (curve.is_periodic() && !is_inside && std::isfinite(to - from)) return around(measured, domain, from, to);
    return measured.integrate({domain.clamp(from), domain.clamp(to)});
}

ArcLengthTable::ArcLengthTable(const Curve& curve)
    : knots_(curve.knots()), pieces_(motions_of(curve, middle_of(curve))), forms_(forms_of(pieces_)) {
    const Pieces pieces{pieces_, forms_};
    const auto parts = parts_of(pieces, ranges_of(pieces, curve.domain()));
    total_ = sum_over(pieces, curve.domain(), parts);
    double before = 0.0;
    parts_.reserve(parts.size());
    for (const IntegratedPart<double>& part : parts) {
        parts_.push_back({part.piece, part.rules.interval, part.rules.kronrod, before});
        before += part.rules.kronrod;
    }
}

double ArcLengthTable::length_at(double u) const {
    const double inside = knots_.into_domain(u);
    const auto after = std::partition_point(parts_.begin() + 1, parts_.end(), [&](const Part& part) {
        return core::parameter_at(pieces_, {part.half, part.offsets.lower}) <= inside;
    });
    const Part& part = *(after - 1);
    const double offset = offset_of(part, inside);
    if (offset == part.offsets.upper) return part.before + part.length;
    return part.before + length_within(part, offset);
}

double ArcLengthTable::offset_of(const Part& part, double u) const {
    const std::size_t piece = part.half / 2;
    if (forms_[piece].is_plain()) return part.offsets.clamp(to_unit(pieces_[piece].interval(), u));
    const HalfPlace place = place_at(pieces_, piece, u);
    if (place.half == part.half) return part.offsets.clamp(place.offset);
    return place.half < part.half ? part.offsets.lower : part.offsets.upper;
}

double ArcLengthTable::length_within(const Part& part, double offset) const {
    return rules_of({pieces_, forms_}, part.half, {part.offsets.lower, offset}).kronrod;
}

double ArcLengthTable::parameter_at(double s) const {
    assert(!std::isnan(s));
    const double total = parts_.back().before + parts_.back().length;
    const bool goes_round = knots_.is_periodic() && !(0.0 <= s && s <= total) && total > 0.0 && std::isfinite(s);
    const double wanted = std::clamp(goes_round ? s - std::floor(s / total) * total : s, 0.0, total);
    const auto reached = std::partition_point(parts_.begin(), parts_.end() - 1,
                                              [&](const Part& part) { return part.before + part.length < wanted; });
    return core::parameter_at(pieces_, {reached->half, offset_at(*reached, wanted - reached->before)});
}

// Newton's iteration for the integral of the speed, whose derivative is the speed.
double ArcLengthTable::offset_at(const Part& part, double length) const {
    if (length <= 0.0) return part.offsets.lower;
    if (length >= part.length) return part.offsets.upper;
    Interval bracket = part.offsets;
    double at = from_unit(bracket, length / part.length);
    for (int i = 0; i < most_length_steps; ++i) {
        const double excess = length_within(part, at) - length;
        (excess < 0.0 ? bracket.lower : bracket.upper) = at;
        double next = at - excess / speed_at({pieces_, forms_}, {part.half, at});
        if (!(bracket.lower <= next && next <= bracket.upper)) next = bracket.lower + 0.5 * bracket.length();
        // The length up to here is known no better than to the rounding of that of the part.
        const bool is_done = std::abs(excess) <= 0.5 * std::numeric_limits<double>::epsilon() * part.length ||
                             std::abs(next - at) <= 0.5 * std::numeric_limits<double>::epsilon() * std::abs(at);
        at = next;
        if (is_done) break;
    }
    return at;
}

}  // namespace batten::core
