#include "app/editor/commands/curve_end_named.h"

namespace batten::editor {

Outcome<core::CurveEnd> curve_end_named(const std::string& name) {
    if (name == "start") return core::CurveEnd::start;
    if (name == "end") return core::CurveEnd::end;
    return tl::unexpected("end is '" + name + "'; it must be start or end");
}

std::optional<Argument> curve_end(const EditorState&) {
    return "end";
}

std::optional<Argument> both_ends(const EditorState&) {
    return "both";
}

Outcome<core::Curve> change_ends(const core::Curve& curve, const std::string& ends,
                                 core::Result<core::Curve> (*change)(const core::Curve&, core::CurveEnd)) {
    if (ends != "start" && ends != "end" && ends != "both")
        return tl::unexpected("end is '" + ends + "'; it must be start, end or both");
    core::Result<core::Curve> result = curve;
    if (ends != "end") result = change(*result, core::CurveEnd::start);
    if (ends != "start" && result) result = change(*result, core::CurveEnd::end);
    return result.map_error(core::describe);
}

}  // namespace batten::editor
