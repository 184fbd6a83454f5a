#include "tests/core/golden.h"

#include <gtest/gtest.h>

#include <iostream>

namespace batten::core::golden {

void Tally::add(const std::string& quantity, double error, double allowed, const std::string& name) {
    EXPECT_LE(error, allowed) << file_ << ", case " << name << ": " << quantity;
    if (!worst_.contains(quantity)) quantities_.push_back(quantity);
    Worst& worst = worst_[quantity];
    worst.allowed = allowed;
    // Not std::max, which would drop a NaN.
    if (!(error <= worst.error)) worst.error = error;
}

Tally::~Tally() {
    EXPECT_GT(case_count_, 0) << file_;
    std::cout << "golden " << file_ << ": " << case_count_ << " cases";
    const char* separator = ", worst error ";
    for (const std::string& quantity : quantities_) {
        std::cout << separator << worst_[quantity].error << " (allowed " << worst_[quantity].allowed << ") in "
                  << quantity;
        separator = "; ";
    }
    std::cout << '\n';
}

}  // namespace batten::core::golden
