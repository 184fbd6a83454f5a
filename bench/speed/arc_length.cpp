// The length of a curve, right to 1e-9 of itself, and the parameter in the middle of it.
#include "core/measure/arc_length.h"

#include <GCPnts_AbscissaPoint.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <memory>

#include "curve_numbers.h"
#include "inputs.h"
#include "works.h"

namespace batten::bench {

namespace {

constexpr double tolerance = 1e-9;

void add_length_of(Contests& contests, std::size_t n) {
    const core::Curve curve = spiral(n);
    const double length = core::arc_length(curve).value;
    Contest whole("arc_length/n:" + std::to_string(n), 1.0, tolerance);
    whole.enter("Batten", [curve] { return core::arc_length(curve).value; });
    whole.enter("SISL", [sisl = std::make_shared<SislCurve>(sisl_curve(curve))] {
        double value = 0.0;
        int status = 0;
        s1240(sisl->get(), tolerance, &value, &status);
        return value;
    });
    whole.enter("OpenCASCADE", [occt = occt_curve(curve), length] {
        return GCPnts_AbscissaPoint::Length(Geom2dAdaptor_Curve(occt), tolerance * length);
    });
    contests.push_back(std::move(whole));

    Contest inverse("length_inverse/n:" + std::to_string(n), 1.0, 1e-7);
    inverse.enter("Batten", [curve, length] { return core::ArcLengthTable(curve).parameter_at(0.5 * length); });
    inverse.enter("Batten_prepared", [table = std::make_shared<core::ArcLengthTable>(curve), length] {
        return table->parameter_at(0.5 * length);
    });
    inverse.enter("OpenCASCADE", [occt = occt_curve(curve), length] {
        return GCPnts_AbscissaPoint(Geom2dAdaptor_Curve(occt), 0.5 * length, 0.0, tolerance).Parameter();
    });
    contests.push_back(std::move(inverse));
}

}  // namespace

void add_arc_length(Contests& contests) {
    for (const std::size_t n : {10UL, 100UL, 1000UL}) add_length_of(contests, n);
}

}  // namespace batten::bench
