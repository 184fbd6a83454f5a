#include "app/editor/scene/figure_title.h"

#include <algorithm>
#include <array>
#include <utility>

#include "app/editor/scene/text_size.h"
#include "render/first_sign.h"
#include "render/prose.h"

namespace batten::editor {

namespace {

constexpr double title_margin = 16.0;  // left and right
constexpr double title_space = 21.5;   // above and below all lines together
constexpr double title_line = 1.25;    // of the size of the letters
constexpr double largest_title = 18.0;

/// As many lines as a title of letters of such sizes may have.
struct TitleSetting {
    std::size_t most_lines = 1;
    double largest = largest_title;
    double smallest = largest_title;
};
constexpr std::array title_settings{TitleSetting{1, largest_title, 15.0}, TitleSetting{2, largest_title, 13.0},
                                    TitleSetting{3, 15.0, 11.0}, TitleSetting{6, 12.0, 9.0}};

/// What has no blank in it, or has it in a formula.
struct TitleWord {
    std::string text;
    double width = 0.0;  ///< of letters of size 1
    bool has_formula = false;
    bool begins_line = false;
};

double title_width(std::string_view prose) {
    return text_size(render::prose_label(prose), 1.0, render::LabelFont::bold).x;
}

/// Gathers words one sign after another.
class TitleWords {
  public:
    void add_line(std::string_view line) {
        begins_line_ = true;
        for (const render::ProsePart& part : render::prose_parts(line)) {
            if (part.is_formula)
                add_formula(part.text);
            else
                for (const char sign : part.text) add(sign);
        }
        end_word();
    }

    std::vector<TitleWord> take() { return std::move(words_); }

  private:
    void add_formula(std::string_view formula) {
        word_.text.append(1, '$').append(formula).append(1, '$');
        word_.has_formula = true;
    }

    void add(char sign) {
        // Tabulators and other signs that nobody sees.
        if (static_cast<unsigned char>(sign) <= ' ') return end_word();
        word_.text += sign;
    }

    void end_word() {
        if (word_.text.empty()) return;
        word_.width = title_width(word_.text);
        word_.begins_line = std::exchange(begins_line_, false);
        words_.push_back(std::exchange(word_, {}));
    }

    std::vector<TitleWord> words_;
    TitleWord word_;
    bool begins_line_ = false;
};

std::vector<TitleWord> title_words(std::string_view title) {
    TitleWords words;
    while (!title.empty()) {
        const std::string_view line = title.substr(0, title.find('\n'));
        words.add_line(line);
        title.remove_prefix(std::min(line.size() + 1, title.size()));
    }
    return words.take();
}

/// Lines no longer than `room`, filled one after another.
class TitleLines {
  public:
    TitleLines(double room, std::size_t most_lines) : room_(room), most_lines_(most_lines), gap_(title_width(" ")) {}

    /// Returns false where it does not fit.
    bool add(const TitleWord& word) {
        if (lines_.empty() || word.begins_line || used_ + gap_ + word.width > room_) {
            begin_line();
        } else {
            lines_.back() += ' ';
            used_ += gap_;
        }
        if (word.width > room_) return !word.has_formula && add_parts(word.text);
        lines_.back() += word.text;
        used_ += word.width;
        return lines_.size() <= most_lines_;
    }

    std::vector<std::string> take() { return std::move(lines_); }

  private:
    bool add_parts(std::string_view word) {
        while (!word.empty() && lines_.size() <= most_lines_) {
            const std::string_view sign = render::first_sign(word);
            const double width = title_width(sign);
            if (used_ + width > room_) begin_line();
            lines_.back() += sign;
            used_ += width;
            word.remove_prefix(sign.size());
        }
        return lines_.size() <= most_lines_;
    }

    void begin_line() {
        lines_.emplace_back();
        used_ = 0.0;
    }

    double room_;
    std::size_t most_lines_;
    double gap_;
    std::vector<std::string> lines_;
    double used_ = 0.0;
};

std::optional<std::vector<std::string>> title_lines(const std::vector<TitleWord>& words, double room,
                                                    std::size_t most_lines) {
    TitleLines lines(room, most_lines);
    for (const TitleWord& word : words)
        if (!lines.add(word)) return std::nullopt;
    return lines.take();
}

/// As many lines as in `room`, none of them much longer than the others.
std::vector<std::string> balanced_lines(const std::vector<TitleWord>& words, double room,
                                        std::vector<std::string> lines) {
    constexpr int halvings = 10;
    double least = 0.0;
    double most = room;
    for (int k = 0; k < halvings; ++k) {
        const double middle = 0.5 * (least + most);
        auto narrower = title_lines(words, middle, lines.size());
        (narrower ? most : least) = middle;
        if (narrower) lines = *std::move(narrower);
    }
    return lines;
}

}  // namespace

double FigureTitle::pitch() const {
    return title_line * size;
}

double FigureTitle::height() const {
    constexpr double one_line = title_space + title_line * largest_title;
    return lines.empty() ? 0.0 : one_line + static_cast<double>(lines.size() - 1) * pitch();
}

std::optional<FigureTitle> fitted_title(std::string_view title, double width, double most_height) {
    const std::vector<TitleWord> words = title_words(title);
    if (words.empty()) return FigureTitle{};
    const double room = width - 2.0 * title_margin;
    for (const TitleSetting& setting : title_settings)
        for (double size = setting.largest; size >= setting.smallest; size -= 1.0) {
            auto lines = title_lines(words, room / size, setting.most_lines);
            if (!lines || static_cast<double>(lines->size()) * title_line * size > most_height) continue;
            return FigureTitle{balanced_lines(words, room / size, *std::move(lines)), size};
        }
    return std::nullopt;
}

}  // namespace batten::editor
