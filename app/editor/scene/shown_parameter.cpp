#include "app/editor/scene/shown_parameter.h"

#include "app/editor/words/number_column.h"

namespace batten::editor {

std::string shown_parameter(const View& view, const core::Curve& curve, double u) {
    std::string decimals = parameter_text(curve, u);
    return view.parts.window ? decimals : unrounded_text(view.notation, u, std::move(decimals));
}

}  // namespace batten::editor
