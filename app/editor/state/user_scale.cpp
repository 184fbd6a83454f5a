#include "app/editor/state/user_scale.h"

namespace batten::editor {

void set_user_scale(View& view, double scale) {
    const double display_scale = view.interface_scale / view.user_scale;
    view.user_scale = user_scales.clamp(scale);
    view.interface_scale = display_scale * view.user_scale;
}

}  // namespace batten::editor
