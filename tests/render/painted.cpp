#include "tests/render/painted.h"

#include <stdexcept>

namespace batten::test {
namespace {

struct Shared {
    OffscreenContext context;
    render::GlPainter painter = [] {
        auto made = render::GlPainter::make();
        if (!made) throw std::runtime_error(made.error());
        return std::move(*made);
    }();
};

/// One context for all suites: between two, the display would be left by its only client, and a virtual one then starts
/// anew.
class SharedContext : public testing::Environment {
  public:
    void SetUp() override { shared_ = std::make_unique<Shared>(); }
    void TearDown() override { shared_.reset(); }
    [[nodiscard]] render::GlPainter& painter() const { return shared_->painter; }

  private:
    std::unique_ptr<Shared> shared_;
};

SharedContext* const shared_context = [] {
    auto context = std::make_unique<SharedContext>();
    testing::AddGlobalTestEnvironment(context.get());
    return context.release();  // the test program deletes it
}();

}  // namespace

render::GlPainter& Painted::painter() {
    return shared_context->painter();
}

Image Painted::paint(const std::vector<render::DrawCommand>& commands, glm::ivec2 size_px, float scale) {
    const OffscreenTarget target(size_px);
    painter().paint({commands}, target.viewport(), black, scale);
    return target.read();
}

render::Polyline line(std::vector<render::Pixel> points, float width_px, render::Color color) {
    render::Polyline result;
    result.points = std::move(points);
    result.width_px = width_px;
    result.color = color;
    return result;
}

}  // namespace batten::test
