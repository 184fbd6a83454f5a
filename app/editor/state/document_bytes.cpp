#include "app/editor/state/document_bytes.h"

#include <span>
#include <unordered_set>

#include "core/make/fit_points.h"

namespace batten::editor {

namespace {

// Counts each array once, by where it is.
class ArrayCount {
  public:
    void add(const core::DocumentCurve& item) {
        add(item.curve->knots().values());
        add(item.curve->control_points());
        add(item.curve->weights());
        if (item.fit != nullptr) {
            add(std::span<const core::FitPoint>(item.fit->points));
            add(std::span<const double>(item.fit->parameters));
        }
        if (item.point_hues != nullptr) add(std::span<const std::uint8_t>(*item.point_hues));
    }
    std::size_t bytes() const { return bytes_; }

  private:
    template <class T>
    void add(std::span<const T> array) {
        if (seen_.insert(array.data()).second) bytes_ += array.size_bytes();
    }

    std::unordered_set<const void*> seen_;
    std::size_t bytes_ = 0;
};

}  // namespace

std::size_t bytes_beside(const core::Document& document, const core::Document* other) {
    ArrayCount count;
    if (other != nullptr)
        for (const core::DocumentCurve& item : other->curves) count.add(item);
    const std::size_t of_other = count.bytes();
    std::size_t entries = 0;
    for (const core::DocumentCurve& item : document.curves) {
        count.add(item);
        entries += sizeof(core::DocumentCurve) + item.name.size() + item.group.size() + item.unknown_members.size() +
                   item.unknown_fit_members.size() + item.pinned.size() * sizeof(std::size_t) +
                   item.joints.knots.size() * sizeof(core::KnotMark) + item.joints.ends.size() * sizeof(core::EndMark);
    }
    for (const core::Picture& picture : document.pictures)
        entries += sizeof(core::Picture) + picture.path.native().size() + picture.unknown_members.size();
    if (document.units) entries += document.units->unknown_members.size();
    return count.bytes() - of_other + entries + document.guides.size() * sizeof(core::Guide);
}

}  // namespace batten::editor
