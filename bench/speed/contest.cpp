#include "contest.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

namespace batten::bench {

namespace {

double largest_of(const Numbers& numbers) {
    double largest = 0.0;
    for (const double number : numbers) largest = std::max(largest, std::abs(number));
    return largest;
}

void write(const std::filesystem::path& file, const Numbers& numbers) {
    std::ofstream out(file, std::ios::binary);
    out.exceptions(std::ios::failbit | std::ios::badbit);
    out.write(reinterpret_cast<const char*>(numbers.data()),
              static_cast<std::streamsize>(numbers.size() * sizeof(double)));
}

}  // namespace

Contest::Contest(std::string work, double items, double tolerance)
    : work_(std::move(work)), items_(items), tolerance_(tolerance) {}

void Contest::share(std::string name, std::span<const double> values) {
    shared_.emplace_back(std::move(name), Numbers(values.begin(), values.end()));
}

void Contest::share(std::string name, std::span<const core::Point> points) {
    Numbers numbers;
    for (const core::Point& point : points) numbers.insert(numbers.end(), {point.x, point.y});
    shared_.emplace_back(std::move(name), std::move(numbers));
}

void Contest::share(const core::Curve& curve) {
    share("knots", curve.knots().values());
    share("points", curve.control_points());
}

void Contest::write_shared(const std::filesystem::path& folder) const {
    if (shared_.empty()) return;
    const std::filesystem::path own = folder / work_;
    std::filesystem::create_directories(own);
    for (const auto& [name, numbers] : shared_) write(own / name, numbers);
    write(own / "answer", entries_.front().answer());
}

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
