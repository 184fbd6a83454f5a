#include "contest.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace batten::bench {

namespace {

double largest_of(const Numbers& numbers) {
    double largest = 0.0;
    for (const double number : numbers) largest = std::max(largest, std::abs(number));
    return largest;
}

}  // namespace

Contest::Contest(std::string work, double items, double tolerance)
    : work_(std::move(work)), items_(items), tolerance_(tolerance) {}

void Contest::check_agreement() const {
    if (entries_.empty()) return;
    const Numbers expected = entries_.front().answer();
    const double allowed = tolerance_ * largest_of(expected);
    for (const Entry& entry : entries_) {
        const Numbers found = entry.answer();
        bool agrees = found.size() == expected.size();
        for (std::size_t i = 0; agrees && i < found.size(); ++i) agrees = std::abs(found[i] - expected[i]) <= allowed;
        if (!agrees) throw std::runtime_error(work_ + ": " + entry.library + " has another answer");
    }
}

void Contest::announce() const {
    for (const Entry& entry : entries_)
        benchmark::RegisterBenchmark((work_ + "/" + entry.library).c_str(), entry.timed);
}

}  // namespace batten::bench
