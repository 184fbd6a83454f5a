/// The forms of views that a document keeps in its file: the member "forms" of its "view".
#pragma once

#include <string>

#include "app/editor/fields/field.h"
#include "app/editor/state/view.h"

namespace batten::editor {

/// What views are set to, apart from which are shown.
struct ViewForms {
    ShapeView shape;
    ShownMap map;
    Orbit orbit;
    bool blossom_values = false;
};

ViewForms forms_of(const View& view);
void take_forms(View& view, const ViewForms& forms);

/// The forms among `members`, a JSON object or nothing, that core::DocumentView does not know; those that are missing
/// are as they begin. Refused, with the place in the file, where one is not of its type or out of its range.
Outcome<ViewForms> read_forms(const std::string& members);

/// `members` with these forms: only those that are not as they begin, and what a later version put beside them.
std::string with_forms(const std::string& members, const ViewForms& forms);

}  // namespace batten::editor
