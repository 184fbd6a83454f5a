/// Compares answers with the reference results and keeps the score.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/core/golden_cases.h"

namespace batten::core::golden {

/// Collects the errors of one file. When destroyed it prints one line, "golden FILE: N cases, worst error E (allowed
/// A)".
class Tally {
  public:
    explicit Tally(std::string file) : file_(std::move(file)) {}
    Tally(const Tally&) = delete;
    Tally& operator=(const Tally&) = delete;
    ~Tally();

    void count_case() { ++case_count_; }

    /// Records one relative error and fails the test, naming `name`, where it is above what is allowed.
    void add(const std::string& quantity, double error, double allowed, const std::string& name);

  private:
    struct Worst {
        double error = 0.0;
        double allowed = 0.0;
    };

    std::string file_;
    int case_count_ = 0;
    std::vector<std::string> quantities_;
    std::map<std::string, Worst> worst_;
};

}  // namespace batten::core::golden
