#include "exchange/cad/step_check.h"

#include <algorithm>
#include <string>
#include <vector>

#include "core/base/ascii.h"
#include "core/base/sentence.h"
#include "exchange/cad/step_text.h"
#include "exchange/places.h"
#include "exchange/utf8_text.h"

namespace batten::exchange {

namespace {

class StepCheck {
  public:
    explicit StepCheck(std::string_view text) : all_(text), text_(text) {}

    std::optional<core::FileError> defect();

  private:
    bool take_instance();
    bool take_kind();
    bool take_list();
    bool take_value();
    std::optional<core::FileError> wrong_id();
    std::size_t offset_of(StepId id, bool is_instance) const;

    core::FileError defect_at(std::size_t offset, std::string what) const {
        return {line_place(line_of(all_, offset)), std::move(what)};
    }
    std::string quoted_at(std::size_t offset) const {
        constexpr std::size_t longest_quotation = 20;
        return utf8_text(all_.substr(offset, longest_quotation));
    }

    std::string_view all_;
    StepText text_;
    std::size_t value_begin_ = 0;  // of the value that was looked at last
    std::vector<StepId> ids_{};
    std::vector<StepId> named_{};
};

std::optional<core::FileError> StepCheck::defect() {
    constexpr std::string_view head = "ISO-10303-21";
    constexpr std::string_view tail = "END-ISO-10303-21";
    text_.skip_byte_order_mark();
    if (text_.take_word() != head || !text_.take(';'))
        return core::FileError{{}, "this is no STEP file, since it does not begin with ISO-10303-21"};
    bool is_data = false;
    while (text_.next() != '\0') {
        if (text_.take(';')) continue;
        const std::size_t begin = text_.at();
        if (is_data && text_.next() == '#') {
            value_begin_ = begin;
            if (take_instance()) continue;
            if (text_.next() == '\0')
                return defect_at(begin, "the file ends within the instance that begins here; a part is missing");
            return defect_at(value_begin_,
                             core::sentence("found '{found}', which breaks the instance that begins in "
                                            "line {line}",
                                            {{"found", quoted_at(value_begin_)}, {"line", line_of(all_, begin)}}));
        }
        const std::string_view word = text_.take_word();
        if (word == tail) return wrong_id();
        if (is_data && word != "ENDSEC")
            return defect_at(begin, core::sentence("found '{found}' where an instance must begin by its number, as in "
                                                   "#1=",
                                                   {{"found", quoted_at(begin)}}));
        is_data = word == "DATA";
        text_.skip_statement();
    }
    return defect_at(all_.size(),
                     "the file ends without END-ISO-10303-21;, which ends every STEP file; a part is missing");
}

// "#12 = POINT('', (0., 1.));", or of several kinds "#12 = (CURVE() LINE(#3));".
bool StepCheck::take_instance() {
    const auto id = text_.take_id();
    if (!id || !text_.take('=')) return false;
    ids_.push_back(*id);
    if (!text_.take('(')) return take_kind() && text_.take(';');
    while (!text_.take(')'))
        if (!take_kind()) return false;
    return text_.take(';');
}

bool StepCheck::take_kind() {
    text_.next();
    value_begin_ = text_.at();
    return !text_.take_word().empty() && text_.take('(') && take_list();
}

// Values with commas between them, and lists of them, to the end of the list that is open.
bool StepCheck::take_list() {
    std::size_t depth = 1;
    bool may_end = true;  // an empty list has no value
    for (;;) {
        const char first = text_.next();
        value_begin_ = text_.at();
        if (text_.take('(')) {
            ++depth;
            may_end = true;
            continue;
        }
        if (begins_step_word(first)) {  // the type of the list that follows
            text_.take_word();
            if (text_.next() != '(') return false;
            continue;
        }
        if (!(may_end && first == ')') && !take_value()) return false;
        while (text_.take(')'))
            if (--depth == 0) return true;
        if (!text_.take(',')) return false;
        may_end = false;
    }
}

bool StepCheck::take_value() {
    const char first = text_.next();
    if (first == '\'' || first == '"') return text_.take_quoted(first);
    if (first == '$' || first == '*') return text_.take(first);
    if (first == '.') return text_.take('.') && !text_.take_word().empty() && text_.take('.');
    if (first != '#') return text_.take_number();
    const auto id = text_.take_id();
    if (id) named_.push_back(*id);
    return id.has_value();
}

// Two of one number, or none where there should be one.
std::optional<core::FileError> StepCheck::wrong_id() {
    std::sort(ids_.begin(), ids_.end());
    std::sort(named_.begin(), named_.end());
    const auto twice = std::adjacent_find(ids_.begin(), ids_.end());
    if (twice != ids_.end())
        return defect_at(offset_of(*twice, true),
                         core::sentence("two instances have the number #{id}", {{"id", *twice}}));
    const auto missing = std::find_if(named_.begin(), named_.end(),
                                      [&](StepId id) { return !std::binary_search(ids_.begin(), ids_.end(), id); });
    if (missing == named_.end()) return std::nullopt;
    return defect_at(offset_of(*missing, false),
                     core::sentence("the instance #{id}, which is named here, is not in the file; a part is missing",
                                    {{"id", *missing}}));
}

// Where `id` is named first, or the last instance of that number begins.
std::size_t StepCheck::offset_of(StepId id, bool is_instance) const {
    const std::string sign = core::sentence("#{id}", {{"id", id}});
    std::size_t found = 0;
    for (std::size_t at = all_.find(sign); at != std::string_view::npos; at = all_.find(sign, at + 1)) {
        StepText behind(all_.substr(at + sign.size()));
        if (core::is_digit(behind.rest().empty() ? ' ' : behind.rest().front())) continue;
        if (is_instance && behind.next() != '=') continue;
        found = at;
        if (!is_instance) break;
    }
    return found;
}

}  // namespace

std::optional<core::FileError> step_defect(std::string_view text) {
    return StepCheck(text).defect();
}

}  // namespace batten::exchange
