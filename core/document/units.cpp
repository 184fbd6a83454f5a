#include "core/document/units.h"

namespace batten::core {

namespace {

// In 480ths of a millimeter, of which all units are whole numbers, so that their ratios are rounded once.
double whole_size(LengthUnit unit) {
    switch (unit) {
        case LengthUnit::mm:
            return 480.0;
        case LengthUnit::inch:
            return 12192.0;
        case LengthUnit::px:
            return 127.0;
    }
    return 480.0;
}

}  // namespace

double converted(double length, LengthUnit from, LengthUnit to) {
    return length * whole_size(from) / whole_size(to);
}

}  // namespace batten::core
