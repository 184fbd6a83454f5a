/// Measures what frames cost: the processor time of the whole process, by the parts of a frame.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <numeric>

#include "core/base/names.h"

namespace batten::platform {

/// What a frame does, in order.
enum class FramePart {
    input,     ///< events, hover and what begins a frame
    commands,  ///< what was asked for
    panels,    ///< laid out
    scene,     ///< the pictures of canvas and dock, made as data
    upload,    ///< their triangles, made and handed to OpenGL
    draw       ///< pictures and panels painted and shown
};
inline constexpr std::size_t frame_part_count = 6;

struct FrameCost {
    std::array<double, frame_part_count> part_ms{};  ///< by FramePart
    std::size_t vertices = 0;                        ///< of both pictures and of the panels

    double total_ms() const { return std::accumulate(part_ms.begin(), part_ms.end(), 0.0); }
};

/// The processor time that all threads of the process have used, in milliseconds; exact to a microsecond.
double processor_ms();

/// All the time goes to one part or another, so that a frame costs what lies between the end of the one before and its
/// own.
class FrameMeter {
  public:
    using Clock = std::function<double()>;  ///< milliseconds

    explicit FrameMeter(Clock clock = processor_ms) : clock_(std::move(clock)), mark_ms_(clock_()) {}

    /// What is used from now on belongs to `part`; at first, and after take(), to input.
    void enter(FramePart part);

    void add_vertices(std::size_t count) { cost_.vertices += count; }

    /// Ends a frame and returns what it cost.
    FrameCost take();

  private:
    Clock clock_;
    double mark_ms_;
    FramePart part_ = FramePart::input;
    FrameCost cost_;
};

}  // namespace batten::platform

namespace batten::core {

template <>
struct Names<platform::FramePart> {
    using enum platform::FramePart;
    static constexpr std::array table{Named{input, "input", "input"},    Named{commands, "commands", "commands"},
                                      Named{panels, "panels", "panels"}, Named{scene, "scene", "scene"},
                                      Named{upload, "upload", "upload"}, Named{draw, "draw", "draw"}};
};

}  // namespace batten::core
