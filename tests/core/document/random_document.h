/// Random documents with everything that files have.
#pragma once

#include "core/document/document.h"
#include "tests/core/random_curves.h"

namespace batten::core {

/// A document of up to four curves, some of whose members no version knows.
Document random_document(RandomCurves& random);

/// The same with fits, joints, symmetries, groups, pins, pictures, guides and units, as the program makes them: its
/// text can be read.
Document random_rich_document(RandomCurves& random);

}  // namespace batten::core
