#include "exchange/dxf/dxf_writer.h"

#include <gtest/gtest.h>

#include <set>

#include "core/make/conics.h"
#include "exchange/dxf/dxf_groups.h"
#include "exchange/dxf/dxf_reader.h"
#include "tests/exchange/carried_curves.h"

namespace batten::exchange {

namespace {

using core::Curve;

// The values of a code in the order of the file, of groups from the entity SPLINE on.
std::vector<std::string> values(const core::Document& document, int code, std::string_view from = "SPLINE") {
    const auto written = write_dxf(document, {});
    EXPECT_TRUE(written);
    std::vector<std::string> values;
    DxfGroups groups(written->text);
    bool has_begun = from.empty();
    while (const auto group = groups.next()) {
        has_begun = has_begun || group->value == from;
        if (has_begun && group->code == code) values.emplace_back(group->value);
    }
    return values;
}

Curve parabola() {
    return Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0.1}, {0.5, 0}, {1, 1}}}).value();
}

}  // namespace

TEST(DxfWriter, WritesSplinesWithoutWeightsWhereTheyAreOne) {
    const core::Document document = document_of(parabola());
    EXPECT_EQ(values(document, 41), std::vector<std::string>());
    EXPECT_EQ(values(document, 40), (std::vector<std::string>{"0", "0", "0", "1", "1", "1"}));
    EXPECT_EQ(values(document, 10), (std::vector<std::string>{"0", "0.5", "1"}));
    EXPECT_EQ(values(document, 20), (std::vector<std::string>{"0.1", "0", "1"}));
    EXPECT_EQ(values(document, 70).front(), "8");
    EXPECT_EQ(values(document, 72).front(), "6");
    EXPECT_EQ(values(document, 73).front(), "3");
}

TEST(DxfWriter, SaysWhetherCurvesAreClosedAndRational) {
    // Planar, rational, and ends that meet; and a truly periodic one, of 4 points and 3 that repeat.
    EXPECT_EQ(values(document_of(core::circle({0, 0}, 1).value()), 70).front(), "13");
    const Curve periodic =
        Curve::make(
            {.degree = 3, .knots = {0, 1, 2, 3, 4}, .points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, .periodic = true})
            .value();
    const core::Document document = document_of(periodic);
    EXPECT_EQ(values(document, 70).front(), "11");
    EXPECT_EQ(values(document, 10), (std::vector<std::string>{"0", "1", "1", "0", "0", "1", "1"}));
    EXPECT_EQ(values(document, 40),
              (std::vector<std::string>{"-3", "-2", "-1", "0", "1", "2", "3", "4", "5", "6", "7"}));
}

TEST(DxfWriter, PutsEachCurveOnALayerOfItsNameInItsColor) {
    core::Document document = document_of({{"Wave", parabola()}, {"wave", parabola()}, {"a/b=ä", parabola()}});
    document.curves[0].color = core::DocumentColor{0x12, 0x34, 0x56};
    EXPECT_EQ(values(document, 8), (std::vector<std::string>{"Wave", "wave", "a_b_ä"}));
    EXPECT_EQ(values(document, 420), std::vector<std::string>{"1193046"});
    // Names of layers know no capitals.
    const std::vector<std::string> names = values(document, 2, "LAYER");
    EXPECT_EQ(std::vector(names.begin(), names.begin() + 4), (std::vector<std::string>{"LAYER", "0", "Wave", "a_b_ä"}));
}

TEST(DxfWriter, LocksLayersOfWhichAllCurvesAreLocked) {
    core::Document document =
        document_of({{"fixed", parabola()}, {"Wave", parabola()}, {"wave", parabola()}, {"free", parabola()}});
    document.curves[0].locked = true;
    document.curves[2].locked = true;
    const auto written = write_dxf(document, {});
    ASSERT_TRUE(written);
    EXPECT_EQ(written->report.left_out,
              std::vector<std::string>{"the lock of 'wave' was left out, since a curve on its layer is not locked"});
    const auto copy = read_dxf(written->text);
    ASSERT_TRUE(copy);
    std::vector<bool> locks;
    for (const core::DocumentCurve& entry : copy->document.curves) locks.push_back(entry.locked);
    EXPECT_EQ(locks, (std::vector<bool>{true, false, false, false}));
    // The layer 0, on which is nothing, then the others.
    const std::vector<std::string> flags = values(document, 70, "AcDbLayerTableRecord");
    EXPECT_EQ(std::vector(flags.begin(), flags.begin() + 4), (std::vector<std::string>{"0", "4", "0", "0"}));
}

TEST(DxfWriter, GivesEveryObjectAHandleOfItsOwn) {
    const core::Document document = document_of(carried_curves(0));
    std::vector<std::string> handles = values(document, 5, "TABLES");
    const std::set<std::string> different(handles.begin(), handles.end());
    EXPECT_EQ(different.size(), handles.size());
    EXPECT_FALSE(different.contains(values(document, 5, "$HANDSEED").front()));
}

TEST(DxfWriter, WritesUnitsThatDxfHas) {
    core::Document document = document_of(parabola());
    const auto unit = [&] { return values(document, 70, "$INSUNITS").front(); };
    EXPECT_EQ(unit(), "0");
    document.units = core::DocumentUnits{core::LengthUnit::mm};
    EXPECT_EQ(unit(), "4");
    document.units = core::DocumentUnits{core::LengthUnit::inch};
    EXPECT_EQ(unit(), "1");
    document.units = core::DocumentUnits{core::LengthUnit::mm, 0.1};
    EXPECT_EQ(unit(), "5");
    EXPECT_EQ(read_dxf(write_dxf(document, {})->text)->document.units, document.units);
    // Feet, meters, kilometers, microns, decimeters.
    for (const auto& [code, units] :
         std::vector<std::pair<std::string, core::DocumentUnits>>{{"2", {core::LengthUnit::inch, 1.0 / 12.0}},
                                                                  {"6", {core::LengthUnit::mm, 0.001}},
                                                                  {"7", {core::LengthUnit::mm, 1e-6}},
                                                                  {"13", {core::LengthUnit::mm, 1000.0}},
                                                                  {"14", {core::LengthUnit::mm, 0.01}}}) {
        document.units = units;
        EXPECT_EQ(unit(), code);
        EXPECT_EQ(read_dxf(write_dxf(document, {})->text)->document.units, units);
    }
    document.units = core::DocumentUnits{core::LengthUnit::px};
    EXPECT_EQ(unit(), "0");
    EXPECT_EQ(write_dxf(document, {})->report.left_out,
              std::vector<std::string>{"the unit of length was left out, since DXF has none of that size; the numbers "
                                       "stay as they are"});
}

}  // namespace batten::exchange
