#include "core/measure/detail/sign_runs.h"

#include <bit>
#include <cmath>
#include <optional>

namespace batten::core {

namespace {

constexpr int deepest_halving = 48;

// Parts of a polynomial are looked at so often at most: every zero takes a way down, and there are few whose way is
// long.
constexpr std::size_t most_looks(std::size_t degree) {
    return 150 + 4 * degree;
}

constexpr int most_newton_steps = 120;
constexpr int most_derivatives = 8;
constexpr double smallest_step = 0.25 * std::numeric_limits<double>::epsilon();

// Runs of definite sign between two zeros that are shorter than this, as part of the whole, are rounding.
constexpr double shortest_run = 1e-11;

// A run between two zeros has values of more than so many errors.
constexpr double definite_in_errors = 128.0;

// Coefficients at either end that may be zero before a piece is looked at more closely.
constexpr std::size_t most_end_zeros = 2;

int sign_of(double value, double error) {
    if (std::abs(value) <= error || std::isnan(value)) return 0;
    return value < 0.0 ? -1 : 1;
}

// What the coefficients say about the signs of a polynomial on its interval.
struct Verdict {
    std::size_t leading = 0;   // coefficients that may be zero, at the beginning
    std::size_t trailing = 0;  // and at the end
    int first_sign = 0;
    int last_sign = 0;
    bool is_clear = false;  // what lies between has at most one change of sign

    bool vanishes() const { return first_sign == 0; }
};

Verdict judge(const Bernstein& a) {
    const std::size_t count = a.values.size();
    const auto sign = [&](std::size_t k) { return sign_of(a.values[k], a.errors[k]); };
    Verdict verdict;
    while (verdict.leading < count && sign(verdict.leading) == 0) ++verdict.leading;
    if (verdict.leading == count) return verdict;
    while (sign(count - 1 - verdict.trailing) == 0) ++verdict.trailing;
    verdict.first_sign = sign(verdict.leading);
    verdict.last_sign = sign(count - 1 - verdict.trailing);
    int changes = 0;
    int zeros = 0;
    int previous = verdict.first_sign;
    verdict.is_clear = true;
    for (std::size_t k = verdict.leading + 1; k + verdict.trailing < count; ++k) {
        const int next = sign(k);
        zeros = next == 0 ? zeros + 1 : 0;
        if (next * previous < 0) ++changes;
        // A doubtful coefficient does no harm only between two of different sign.
        const bool is_harmless = next != 0 || sign(k + 1) * previous < 0;
        if (zeros > 1 || changes > 1 || !is_harmless) verdict.is_clear = false;
        if (next != 0) previous = next;
    }
    return verdict;
}

// The one zero in (0, 1) of a polynomial with one change of sign, by Newton's iteration in a bracket that shrinks.
double enclosed_zero(const Bernstein& a, int sign_before) {
    const Bernstein slope = derivative(a);
    Interval bracket{0.0, 1.0};
    double t = 0.5;
    for (int i = 0; i < most_newton_steps; ++i) {
        const double value = value_at(a, t);
        if (value == 0.0) return t;
        (value * sign_before > 0.0 ? bracket.lower : bracket.upper) = t;
        const double step = value / value_at(slope, t);
        if (std::abs(step) <= smallest_step || bracket.length() <= smallest_step) return t;
        const double next = t - step;
        t = bracket.lower < next && next < bracket.upper ? next : bracket.lower + 0.5 * bracket.length();
    }
    return t;
}

class SignSearch {
  public:
    SignSearch(std::vector<Bernstein> forms, const Expression& expression)
        : forms_(std::move(forms)), expression_(expression) {
        const std::size_t degree = expression_(forms_).degree();
        depth_of_doubt_ = static_cast<int>(std::bit_width(degree)) / 2 + 1;
        looks_left_ = most_looks(degree);
    }

    std::vector<SignRun> run() {
        search(forms_, {0.0, 1.0}, 0);
        join_across_rounding();
        if (runs_.size() > 1)
            for (std::size_t i = 0; i < runs_.size(); ++i)
                if (runs_[i].sign == 0 && !is_enclosed(runs_[i])) settle(i);
        return std::move(runs_);
    }

  private:
    void search(const std::vector<Bernstein>& forms, Interval where, int depth) {
        const Bernstein value = expression_(forms);
        const Verdict verdict = judge(value);
        const bool is_deep = depth >= depth_of_doubt_;
        if (verdict.vanishes() && is_deep) return append_run(runs_, {where, 0});
        const bool may_end_so = is_deep || std::max(verdict.leading, verdict.trailing) <= most_end_zeros;
        if (!verdict.vanishes() && verdict.is_clear && may_end_so) return add_clear(value, verdict, where);
        if (depth == deepest_halving || looks_left_ == 0) return append_run(runs_, {where, 0});
        --looks_left_;
        std::vector<Bernstein> left;
        std::vector<Bernstein> right;
        for (const Bernstein& form : forms) {
            auto both = halves(form);
            left.push_back(std::move(both.first));
            right.push_back(std::move(both.second));
        }
        const double half = where.lower + 0.5 * where.length();
        search(left, {where.lower, half}, depth + 1);
        search(right, {half, where.upper}, depth + 1);
    }

    void add_clear(const Bernstein& value, const Verdict& verdict, Interval where) {
        if (verdict.leading > 0) append_run(runs_, {{where.lower, where.lower}, 0});
        double from = where.lower;
        if (verdict.first_sign != verdict.last_sign) {
            const double t = where.lower + enclosed_zero(value, verdict.first_sign) * where.length();
            append_run(runs_, {{from, t}, verdict.first_sign});
            append_run(runs_, {{t, t}, 0});
            enclosed_.push_back(t);
            from = t;
        }
        append_run(runs_, {{from, where.upper}, verdict.last_sign});
        if (verdict.trailing > 0) append_run(runs_, {{where.upper, where.upper}, 0});
    }

    void join_across_rounding() {
        std::vector<SignRun> joined;
        for (std::size_t i = 0; i < runs_.size(); ++i) {
            SignRun run = runs_[i];
            const bool is_between_zeros = run.sign != 0 && i > 0 && i + 1 < runs_.size();
            if (is_between_zeros && is_doubtful(run.where)) run.sign = 0;
            append_run(joined, run);
        }
        runs_ = std::move(joined);
    }

    bool is_enclosed(const SignRun& run) const {
        return run.where.length() == 0.0 &&
               std::find(enclosed_.begin(), enclosed_.end(), run.where.lower) != enclosed_.end();
    }

    // Around a multiple zero the sign is definite here and there by no more than a few errors.
    bool is_doubtful(Interval where) const {
        if (where.length() < shortest_run) return true;
        const Bernstein value = value_over(where);
        for (std::size_t k = 0; k < value.values.size(); ++k)
            if (std::abs(value.values[k]) > definite_in_errors * value.errors[k]) return false;
        return true;
    }

    // Gives run i, on which the expression is as good as zero, its one place. An analytic function that vanishes on
    // less than everything has a zero there, of some multiplicity.
    void settle(std::size_t i) {
        const bool is_first = i == 0;
        const bool is_last = i + 1 == runs_.size();
        const Interval doubt = runs_[i].where;
        double t = doubt.lower + 0.5 * doubt.length();
        if (is_first) t = 0.0;
        if (is_last) t = 1.0;
        if (!is_first && !is_last) t = place_of_zero(i).value_or(t);
        runs_[i].where = {t, t};
        if (!is_first) runs_[i - 1].where.upper = t;
        if (!is_last) runs_[i + 1].where.lower = t;
    }

    // A zero of multiplicity m is a simple one of derivative m-1, sought in a wide surrounding, where it is sharp.
    std::optional<double> place_of_zero(std::size_t i) const {
        const Interval doubt = runs_[i].where;
        const double center = doubt.lower + 0.5 * doubt.length();
        const double room = std::min(center - runs_[i - 1].where.lower, runs_[i + 1].where.upper - center);
        const int first_order = runs_[i - 1].sign == runs_[i + 1].sign ? 1 : 0;
        for (int order = first_order; order <= most_derivatives; order += 2)
            for (double reach = room; reach > doubt.length(); reach *= 0.5) {
                const Interval around{std::max(0.0, center - reach), std::min(1.0, center + reach)};
                if (around.lower == around.upper) break;
                Bernstein value = value_over(around);
                for (int k = 0; k < order; ++k) value = derivative(value);
                const Verdict verdict = judge(value);
                if (!verdict.is_clear || verdict.first_sign == verdict.last_sign) continue;
                const double t = around.lower + enclosed_zero(value, verdict.first_sign) * around.length();
                if (std::abs(t - center) <= doubt.length() + 1e-2 * reach) return t;
            }
        return std::nullopt;
    }

    Bernstein value_over(Interval interval) const {
        std::vector<Bernstein> forms;
        forms.reserve(forms_.size());
        for (const Bernstein& form : forms_) forms.push_back(part(form, interval));
        return expression_(forms);
    }

    std::vector<Bernstein> forms_;
    const Expression& expression_;
    int depth_of_doubt_ = 1;  // from this many halvings on, what may vanish is taken to do so
    std::size_t looks_left_ = 0;
    std::vector<SignRun> runs_;
    std::vector<double> enclosed_;  // simple zeros, already as sharp as can be
};

// The cyclic runs so turned that they begin with one of definite sign; what was before it comes last, a period later.
std::vector<SignRun> turned(std::span<const SignRun> runs) {
    const double period = runs.back().where.upper - runs.front().where.lower;
    std::vector<SignRun> result;
    std::size_t first = 0;
    while (first < runs.size() && runs[first].sign == 0) ++first;
    for (std::size_t k = 0; k <= runs.size(); ++k) {
        SignRun run = runs[(first + k) % runs.size()];
        if (first + k >= runs.size()) run.where = {run.where.lower + period, run.where.upper + period};
        append_run(result, run);
    }
    return result;
}

}  // namespace

std::vector<SignRun> sign_runs(std::vector<Bernstein> forms, const Expression& expression) {
    return SignSearch(std::move(forms), expression).run();
}

std::vector<SignRun> sign_runs(const Bernstein& a) {
    return sign_runs(std::vector{a}, [](std::span<const Bernstein> forms) { return forms.front(); });
}

std::vector<double> roots(const Bernstein& a) {
    std::vector<double> result;
    for (const SignRun& run : sign_runs(a))
        if (run.sign == 0 && run.where.length() == 0.0) result.push_back(run.where.lower);
    return result;
}

void append_run(std::vector<SignRun>& runs, SignRun run) {
    if (!runs.empty() && runs.back().sign == run.sign)
        runs.back().where.upper = run.where.upper;
    else
        runs.push_back(run);
}

std::vector<SignEvent> sign_events(std::span<const SignRun> runs, bool is_cyclic) {
    const bool has_sign = std::any_of(runs.begin(), runs.end(), [](const SignRun& run) { return run.sign != 0; });
    if (!has_sign)
        return runs.empty() ? std::vector<SignEvent>{}
                            : std::vector<SignEvent>{{{runs.front().where.lower, runs.back().where.upper}}};
    const Interval domain{runs.front().where.lower, runs.back().where.upper};
    const auto ordered = is_cyclic ? turned(runs) : std::vector(runs.begin(), runs.end());
    std::vector<SignEvent> events;
    for (std::size_t i = 0; i < ordered.size(); ++i) {
        if (ordered[i].sign == 0)
            events.push_back(
                {ordered[i].where, i > 0 ? ordered[i - 1].sign : 0, i + 1 < ordered.size() ? ordered[i + 1].sign : 0});
        else if (i > 0 && ordered[i - 1].sign != 0)
            events.push_back(
                {{ordered[i].where.lower, ordered[i].where.lower}, ordered[i - 1].sign, ordered[i].sign, true});
    }
    for (SignEvent& event : events)
        if (is_cyclic && event.where.lower >= domain.upper)
            event.where = {event.where.lower - domain.length(), event.where.upper - domain.length()};
    std::sort(events.begin(), events.end(),
              [](const SignEvent& a, const SignEvent& b) { return a.where.lower < b.where.lower; });
    return events;
}

}  // namespace batten::core
