#include "exchange/json/json_members.h"

#include <cmath>

#include "core/base/number_text.h"
#include "core/base/sentence.h"

namespace batten::exchange {

JsonMembers::JsonMembers(const JsonValue& object) : object_(object) {
    if (object.object() == nullptr) note("it is no object");
}

void JsonMembers::note(std::string defect) {
    if (defect_.empty()) defect_ = std::move(defect);
}

const JsonValue* JsonMembers::find(const char* name) {
    const JsonValue* found = object_.member(name);
    if (found == nullptr) note(core::sentence("the member \"{name}\" is missing", {{"name", name}}));
    return found;
}

const JsonValue& JsonMembers::inside(const char* name) {
    const JsonValue* found = find(name);
    return found == nullptr ? object_ : *found;
}

int JsonMembers::whole_number(const char* name, int least, int most) {
    const JsonValue* found = find(name);
    if (found == nullptr) return least;
    const double* number = found->number();
    if (number != nullptr && *number >= least && *number <= most && std::trunc(*number) == *number)
        return static_cast<int>(*number);
    note(core::sentence("\"{name}\" is {found}, but it must be a whole number from {least} to {most}",
                        {{"name", name},
                         {"found", number == nullptr ? "no number" : core::shortest_text(*number)},
                         {"least", least},
                         {"most", most}}));
    return least;
}

std::vector<double> JsonMembers::numbers(const char* name) {
    const JsonValue* found = find(name);
    if (found == nullptr) return {};
    const JsonList* list = found->list();
    if (list != nullptr && list->row_length == 0 && list->items.empty() && !list->first_odd) return list->numbers;
    note(core::sentence("\"{name}\" must be a list of numbers", {{"name", name}}));
    return {};
}

std::vector<double> JsonMembers::optional_numbers(const char* name) {
    const JsonValue* found = object_.member(name);
    return found == nullptr || found->is_null() ? std::vector<double>() : numbers(name);
}

JsonPoints JsonMembers::points(const char* name) {
    const JsonValue* found = find(name);
    if (found == nullptr) return {};
    const JsonList* list = found->list();
    const bool is_good = list != nullptr && !list->first_odd && (list->row_length == 2 || list->row_length == 3);
    if (!is_good) {
        note(core::sentence("\"{name}\" must be a list of points, each a list of two or three numbers",
                            {{"name", name}}));
        return {};
    }
    JsonPoints points;
    const std::vector<double>& numbers = list->numbers;
    for (std::size_t i = 0; i < numbers.size(); i += list->row_length) {
        points.points.emplace_back(numbers[i], numbers[i + 1]);
        if (list->row_length == 3 && numbers[i + 2] != 0.0) points.has_heights = true;
    }
    return points;
}

bool JsonMembers::flag(const char* name) {
    const JsonValue* found = object_.member(name);
    if (found == nullptr) return false;
    if (found->flag() == nullptr) note(core::sentence("\"{name}\" must be true or false", {{"name", name}}));
    return found->flag() != nullptr && *found->flag();
}

std::string JsonMembers::name() const {
    const JsonValue* found = object_.member("name");
    return found != nullptr && found->text() != nullptr ? *found->text() : std::string();
}

}  // namespace batten::exchange
