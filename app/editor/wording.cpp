#include "app/editor/wording.h"

#include <array>

#include "app/editor/formula.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

struct Verb {
    const char* present;
    const char* past;
};

constexpr std::array irregular_verbs{Verb{"Add", "Added"},  Verb{"Cut", "Cut"},     Verb{"Draw", "Drew"},
                                     Verb{"Fit", "Fitted"}, Verb{"Hide", "Hid"},    Verb{"Set", "Set"},
                                     Verb{"Keep", "Kept"},  Verb{"Show", "Showed"}, Verb{"Split", "Split"},
                                     Verb{"Type", "Typed"}, Verb{"Make", "Made"}};

std::string past_of_verb(const std::string& verb) {
    for (const Verb& irregular : irregular_verbs)
        if (verb == irregular.present) return irregular.past;
    return verb + (!verb.empty() && verb.back() == 'e' ? "d" : "ed");
}

}  // namespace

std::string past_of(const std::string& label) {
    const std::size_t end = std::min(label.find(' '), label.size());
    return past_of_verb(label.substr(0, end)) + label.substr(end);
}

std::string edit_sentence(const std::string& label, ShapeEffect effect, std::optional<double> deviation) {
    const std::string done = past_of(label);
    const bool is_unchanged = effect == ShapeEffect::keeps || (effect == ShapeEffect::changes && deviation == 0.0);
    if (is_unchanged) return done + ": the curve is unchanged";
    if (effect == ShapeEffect::changes && deviation) return done + ": deviates by at most " + number_text(*deviation);
    return done;
}

std::string done_sentence(const std::string& done, ShapeEffect effect, std::optional<double> deviation,
                          std::optional<double> error) {
    const bool is_unchanged = deviation ? *deviation == 0.0 : effect == ShapeEffect::keeps && !error;
    if (is_unchanged) return core::sentence("{done}: the curve is unchanged", {{"done", done}});
    if (deviation)
        return core::sentence("{done}: deviates by at most {deviation}",
                              {{"done", done}, {"deviation", number_text(*deviation)}});
    if (error) return core::sentence("{done}: error at most {error}", {{"done", done}, {"error", number_text(*error)}});
    return done;
}

std::string with_error(const std::string& sentence, double error) {
    return sentence + ": error at most " + number_text(error);
}

}  // namespace batten::editor
