#include "app/cli/divided_words.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "app/cli/operation.h"
#include "app/editor/command_reader.h"

namespace batten::cli {

namespace {

bool is_option(const std::string& word) {
    return word.starts_with("--") || word.starts_with("-o") || word.starts_with("-h");
}

// What an operation needs is seldom called so, and more often left out.
bool names_option(const std::string& word) {
    constexpr std::array<std::string_view, 6> names{"-o", "--output", "--curve", "--json", "-h", "--help"};
    return std::find(names.begin(), names.end(), word) != names.end();
}

bool takes_next_word(const std::string& option) {
    return option == "-o" || option == "--output" || option == "--curve";
}

// Goes through the words and puts each where it belongs.
class Divider {
  public:
    Divider(const std::vector<std::string>& words, bool has_file) : words_(words), misses_file_(has_file) {}

    DividedWords result() {
        while (next_ < words_.size()) take_word();
        return std::move(result_);
    }

  private:
    void take_word() {
        const std::string& word = words_[next_];
        if (misses_file_) return take_before_file();
        if (spec_ != nullptr && given_ < needed_count(*spec_) && !names_option(word)) return take_needed();
        if (word != mark && is_option(word)) return take_option();
        if (const editor::CommandSpec* spec = operation_called(word)) {
            spec_ = spec;
            given_ = 0;
        }
        move_to(result_.operations);
    }

    void take_before_file() {
        const bool is_marked = words_[next_] == mark;
        if (!is_marked && is_option(words_[next_])) return take_option();
        if (is_marked) move_to(result_.options);
        if (next_ < words_.size()) move_to(result_.options);
        misses_file_ = false;
    }

    void take_needed() {
        if (words_[next_] == mark) move_to(result_.operations);
        if (next_ == words_.size()) return;
        given_ += editor::arguments_of_word(*spec_, given_, words_[next_]).size();
        move_to(result_.operations);
    }

    void take_option() {
        const bool takes_next = takes_next_word(words_[next_]);
        // One that lacks its word stays last, or the file would be taken for that.
        if (takes_next && next_ + 1 == words_.size()) return move_to(result_.options);
        move_to_front_options();
        if (takes_next) move_to_front_options();
    }

    void move_to(std::vector<std::string>& list) { list.push_back(words_[next_++]); }

    // Before the file, which may stand behind "--".
    void move_to_front_options() {
        result_.options.insert(result_.options.begin() + static_cast<std::ptrdiff_t>(option_count_++), words_[next_++]);
    }

    const std::vector<std::string>& words_;
    std::size_t next_ = 0;
    bool misses_file_;
    const editor::CommandSpec* spec_ = nullptr;  // the operation that was named last
    std::size_t given_ = 0;                      // how many arguments it has
    std::size_t option_count_ = 0;               // without the file
    DividedWords result_;
};

}  // namespace

DividedWords divided(const std::vector<std::string>& words, bool has_file) {
    return Divider(words, has_file).result();
}

}  // namespace batten::cli
