// All Bézier pieces.
#include "core/evaluate/bezier_pieces.h"

#include <Geom2dConvert_BSplineCurveToBezierCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <memory>

#include "curve_numbers.h"
#include "inputs.h"
#include "works.h"

namespace batten::bench {

namespace {

// The joints twice, as pieces have them.
struct PiecePoints {
    Numbers operator()(const core::BezierPieces& pieces) const {
        Numbers numbers;
        for (std::size_t k = 0; k < pieces.size(); ++k)
            for (const core::Point& point : pieces.points(k)) numbers.insert(numbers.end(), {point.x, point.y});
        return numbers;
    }
    Numbers operator()(const SislCurve& curve) const { return ControlPoints()(curve); }
    Numbers operator()(const std::vector<Handle(Geom2d_BezierCurve)>& pieces) const {
        Numbers numbers;
        for (const auto& piece : pieces)
            for (const gp_Pnt2d& pole : piece->Poles()) numbers.insert(numbers.end(), {pole.X(), pole.Y()});
        return numbers;
    }
};

void add_pieces_of(Contests& contests, std::size_t n) {
    const core::Curve curve = spiral(n);
    Contest contest("bezier_pieces/n:" + std::to_string(n), 1.0, 1e-13);
    contest.enter(
        "Batten", [curve] { return core::bezier_pieces(curve); }, PiecePoints());
    contest.enter(
        "SISL",
        [sisl = std::make_shared<SislCurve>(sisl_curve(curve))] {
            SISLCurve* result = nullptr;
            int status = 0;
            s1730(sisl->get(), &result, &status);
            return SislCurve(result);
        },
        PiecePoints());
    contest.enter(
        "OpenCASCADE",
        [occt = occt_curve(curve)] {
            Geom2dConvert_BSplineCurveToBezierCurve conversion(occt);
            std::vector<Handle(Geom2d_BezierCurve)> pieces;
            for (int k = 1; k <= conversion.NbArcs(); ++k) pieces.push_back(conversion.Arc(k));
            return pieces;
        },
        PiecePoints());
    contests.push_back(std::move(contest));
}

}  // namespace

void add_bezier_pieces(Contests& contests) {
    for (const std::size_t n : {10UL, 100UL, 1000UL, 10'000UL, 100'000UL}) add_pieces_of(contests, n);
}

}  // namespace batten::bench
