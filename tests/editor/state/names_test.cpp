// Every enumeration that people, files or commands name has one table, complete and in order.

#include "core/base/names.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "app/editor/command_spec.h"
#include "app/editor/commands/curve_ends.h"
#include "app/editor/commands/file_commands.h"
#include "app/editor/commands/help_commands.h"
#include "app/editor/commands/knot_question_commands.h"
#include "app/editor/commands/transform_commands.h"
#include "app/editor/commands/trim_commands.h"
#include "app/editor/commands/unit_commands.h"
#include "app/editor/pointer/cursor.h"
#include "app/editor/state/state.h"
#include "app/editor/state/theme.h"
#include "app/editor/state/view.h"
#include "core/curve/curve_end.h"
#include "core/curve/knot_vector.h"
#include "core/edit/knot_edit.h"
#include "core/make/conics.h"
#include "core/make/parametrization.h"
#include "core/measure/closing.h"
#include "core/measure/conic_form.h"
#include "core/measure/intersect_line.h"
#include "core/refine/join.h"

namespace batten::editor {
namespace {

// An enumeration by its last value.
template <auto last_value>
struct Last {
    using Enum = decltype(last_value);
    static constexpr Enum value = last_value;
};

template <class T>
class Names : public ::testing::Test {};

using Enumerations =
    ::testing::Types<Last<core::KnotKind::custom>, Last<core::Side::right>, Last<core::CurveEnd::end>,
                     Last<core::KnotMove::snap>, Last<core::Parametrization::centripetal>,
                     Last<core::CirclePolygon::triangle>, Last<core::JoinContinuity::g3>, Last<core::Closing::periodic>,
                     Last<core::ConicType::hyperbola>, Last<core::ContactKind::ending>, Last<ShapeEffect::changes>,
                     Last<CommandGroup::gesture>, Last<Dialog::at_work>, Last<Overlay::quiz>, Last<Tool::transform>,
                     Last<BrushKind::fair>, Last<core::JointMark::curvature>, Last<core::LengthUnit::px>,
                     Last<UnitChoice::px>, Last<AxisUse::array_polar>, Last<SnapKind::angles>, Last<ShapeKind::conic>,
                     Last<ThemeName::light>, Last<CurveEnds::both>, Last<JointOperation::offset>, Last<SplitScope::all>,
                     Last<core::Onward::straight>, Last<core::GeometricContinuity::g3>, Last<Escapable::presentation>,
                     Last<UnsavedAnswer::cancel>, Last<Cursor::text>, Last<MapTarget::all>, Last<ShearAxis::y>,
                     Last<KnotQuestion::continuity>, Last<ShownMapKind::project>>;
TYPED_TEST_SUITE(Names, Enumerations);

TYPED_TEST(Names, of_an_enumeration_are_complete_and_differ) {
    using Enum = typename TypeParam::Enum;
    const auto& table = core::Names<Enum>::table;
    ASSERT_EQ(table.size(), static_cast<std::size_t>(TypeParam::value) + 1);
    std::set<std::string> names;
    for (std::size_t i = 0; i < table.size(); ++i) {
        const auto value = static_cast<Enum>(i);
        EXPECT_EQ(table[i].value, value);
        EXPECT_TRUE(names.insert(core::name_of(value)).second) << core::name_of(value);
        EXPECT_EQ(core::value_named<Enum>(core::name_of(value)), value);
    }
    EXPECT_EQ(core::value_named<Enum>("no such name"), std::nullopt);
}

}  // namespace
}  // namespace batten::editor
