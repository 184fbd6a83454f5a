#include "app/editor/wording.h"

#include "app/editor/formula.h"
#include "core/base/sentence.h"

namespace batten::editor {

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

}  // namespace batten::editor
