/// One piece of work that several libraries do on the same input; their answers are compared before anything is timed.
#pragma once

#include <benchmark/benchmark.h>

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/curve/curve.h"

namespace batten::bench {

using Numbers = std::vector<double>;

/// What most works answer.
struct AsNumbers {
    Numbers operator()(double value) const { return {value}; }
    Numbers operator()(core::Point point) const { return {point.x, point.y}; }
    const Numbers& operator()(const Numbers& numbers) const { return numbers; }
    Numbers operator()(const std::vector<core::Point>& points) const {
        Numbers numbers;
        for (const core::Point& point : points) numbers.insert(numbers.end(), {point.x, point.y});
        return numbers;
    }
};

class Contest {
  public:
    /// Of `work`, "name/parameter:value/...", as Google Benchmark writes them. Times are told for one of `items`.
    /// Answers may differ by `tolerance` of their largest number.
    Contest(std::string work, double items, double tolerance);

    /// `run` does the work once; what it returns is kept from being optimized away, and `read` makes numbers of it.
    template <class Run, class Read = AsNumbers>
    void enter(const std::string& library, Run run, Read read = {}) {
        entries_.push_back({library, [run, read]() mutable { return Numbers(read(run())); },
                            [run, items = items_](benchmark::State& state) mutable {
                                for (auto _ : state) benchmark::DoNotOptimize(run());
                                state.counters["each"] = benchmark::Counter(
                                    items, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
                            }});
    }

    /// An input by its name, for libraries of other languages.
    void share(std::string name, std::span<const double> values);
    void share(std::string name, std::span<const core::Point> points);
    void share(const core::Curve& curve);

    /// Where inputs are shared: writes these and the answer of the first library into the folder "`folder`/work", as
    /// the bytes of doubles.
    void write_shared(const std::filesystem::path& folder) const;

    /// Throws std::runtime_error, naming the work and the library, where an answer is not that of the first library.
    void check_agreement() const;

    /// Hands every entry to Google Benchmark as "work/library".
    void announce() const;

    const std::string& work() const { return work_; }

  private:
    struct Entry {
        std::string library;
        std::function<Numbers()> answer;
        std::function<void(benchmark::State&)> timed;
    };

    std::string work_;
    double items_;
    double tolerance_;
    std::vector<std::pair<std::string, Numbers>> shared_;
    std::vector<Entry> entries_;
};

}  // namespace batten::bench
