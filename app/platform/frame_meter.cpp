#include "app/platform/frame_meter.h"

#include <ctime>
#include <utility>

namespace batten::platform {

double processor_ms() {
    constexpr double ms_per_second = 1e3;
    return static_cast<double>(std::clock()) * (ms_per_second / CLOCKS_PER_SEC);
}

void FrameMeter::enter(FramePart part) {
    const double now_ms = clock_();
    cost_.part_ms.at(static_cast<std::size_t>(part_)) += now_ms - mark_ms_;
    mark_ms_ = now_ms;
    part_ = part;
}

FrameCost FrameMeter::take() {
    enter(FramePart::input);
    return std::exchange(cost_, {});
}

}  // namespace batten::platform
