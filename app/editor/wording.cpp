#include "app/editor/wording.h"

#include "app/editor/formula.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

std::string deviation_sentence(const std::string& done, const Distances& distances) {
    const std::string deviation = bound_text(*distances.deviation);
    if (distances.is_rounding)
        return core::sentence("{done}: the curve is unchanged but for rounding, at most {deviation}",
                              {{"done", done}, {"deviation", deviation}});
    if (distances.of_shapes)
        return core::sentence(
            "{done}: deviates by at most {deviation} at equal parameters, in shape by at most {shape}",
            {{"done", done}, {"deviation", deviation}, {"shape", bound_text(*distances.of_shapes)}});
    return core::sentence("{done}: deviates by at most {deviation}", {{"done", done}, {"deviation", deviation}});
}

}  // namespace

std::string done_sentence(const std::string& done, ShapeEffect effect, const Distances& distances) {
    const auto& [deviation, of_shapes, error, is_rounding] = distances;
    const bool is_unchanged = deviation ? *deviation == 0.0 : effect == ShapeEffect::keeps && !error;
    if (is_unchanged) return core::sentence("{done}: the curve is unchanged", {{"done", done}});
    if (deviation) return deviation_sentence(done, distances);
    if (!error) return done;
    if (effect == ShapeEffect::keeps)
        return core::sentence("{done}: the shape is kept up to rounding of far control points, error at most {error}",
                              {{"done", done}, {"error", bound_text(*error)}});
    return core::sentence("{done}: error at most {error}", {{"done", done}, {"error", bound_text(*error)}});
}

std::string nothing_changed_sentence() {
    return "Nothing had to be changed";
}

}  // namespace batten::editor
