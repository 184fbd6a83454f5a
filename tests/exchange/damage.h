/// Texts that went wrong on their way: some bytes replaced, left out or repeated.
#pragma once

#include <random>
#include <string>

namespace batten::exchange {

class Damage {
  public:
    /// Replaces by one of `bytes`, which has those that mean something.
    Damage(unsigned seed, std::string bytes) : engine_(seed), bytes_(std::move(bytes)) {}

    /// `text`, damaged in one to three places. `text` has 32 bytes or more.
    std::string of(std::string text) {
        for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
            const std::size_t at = below(text.size());
            const std::size_t length = below(9);
            if (below(3) == 0)
                text.erase(at, length);
            else if (below(2) == 0)
                text.insert(at, text, below(text.size()), length);
            else
                text[at] = bytes_[below(bytes_.size())];
        }
        return text;
    }

  private:
    std::size_t below(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(engine_); }

    std::mt19937 engine_;
    std::string bytes_;
};

}  // namespace batten::exchange
