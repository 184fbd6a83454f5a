#include "exchange/cad/cad_files.h"

#include <algorithm>
#include <span>

#include "exchange/cad/cad_curves.h"
#include "exchange/cad/iges_check.h"
#include "exchange/cad/occt_process.h"
#include "exchange/cad/step_check.h"
#include "exchange/refusal.h"

namespace batten::exchange {

namespace {

constexpr core::PluralPattern not_held{
    "'{place}' was left out: read from such a file, its numbers make no curve",
    "{count} curves were left out: read from such a file, their numbers make no curves; the first one is '{place}'"};
constexpr core::PluralPattern read_otherwise{
    "'{place}' is read from the file otherwise than it was written: OpenCASCADE takes ends nearer than 1e-7, and "
    "weights that differ in the last digit, for equal",
    "{count} curves are read from the file otherwise than they were written, the first one '{place}': OpenCASCADE "
    "takes "
    "ends nearer than 1e-7, and weights that differ in the last digit, for equal"};

struct CadFormat {
    const char* name;
    Reader read;
};

core::Document cad_document(core::LengthUnit unit, std::span<const CadCurve> curves) {
    core::Document document;
    document.units = core::DocumentUnits{.unit = unit};
    for (const CadCurve& curve : curves) {
        core::DocumentCurve& entry = document.curves.emplace_back();
        entry.name = curve.name;
        entry.curve = std::make_shared<const core::Curve>(curve.curve);
    }
    return document;
}

// What is written, and what is read from it again.
struct WrittenAndRead {
    Exported written{};
    std::vector<core::DocumentCurve> copies{};  // none where one of the curves does not come back
};

core::FileResult<WrittenAndRead> written_and_read(const CadFormat& format, core::LengthUnit unit,
                                                  std::span<const CadCurve> curves) {
    return write_through_occt(format.name, cad_document(unit, curves)).map([&](Exported written) {
        auto copy = format.read(written.text);
        WrittenAndRead result{std::move(written)};
        if (copy && copy->document.curves.size() == curves.size()) result.copies = std::move(copy->document.curves);
        return result;
    });
}

// Parts the curves until those are found that do not come back; after so many tries, what is left is given up.
class LostCurves {
  public:
    LostCurves(const CadFormat& format, CadCurves& curves) : format_(format), curves_(curves) {}

    void leave_out() {
        std::vector<CadCurve> all = std::move(curves_.curves);
        curves_.curves.clear();
        sort_halves(all);
    }

  private:
    void sort(std::span<CadCurve> part) {
        if (tries_ > 0 && --tries_ > 0 && comes_back(part))
            curves_.curves.insert(curves_.curves.end(), part.begin(), part.end());
        else if (part.size() == 1 || tries_ == 0)
            for (const CadCurve& curve : part) curves_.notes.add(not_held, [&] { return curve.name; });
        else
            sort_halves(part);
    }

    void sort_halves(std::span<CadCurve> part) {
        const std::size_t half = part.size() / 2;
        if (half > 0) sort(part.first(half));
        sort(part.subspan(half));
    }

    bool comes_back(std::span<const CadCurve> part) const {
        const auto result = written_and_read(format_, curves_.unit, part);
        return result && !result->copies.empty();
    }

    const CadFormat& format_;
    CadCurves& curves_;
    int tries_ = 200;
};

Exported with_report(CadCurves& curves, WrittenAndRead result) {
    double largest_error = 0.0;
    for (std::size_t i = 0; i < curves.curves.size(); ++i) {
        const CadCurve& curve = curves.curves[i];
        const double change = copy_error(curves, curve, *result.copies[i].curve);
        if (change > 0.0) curves.notes.add(read_otherwise, [&] { return curve.name; });
        largest_error = std::max(largest_error, curve.error + change);
    }
    Exported exported = std::move(result.written);
    std::vector<std::string> told = curves.notes.sentences();
    told.insert(told.end(), exported.report.left_out.begin(), exported.report.left_out.end());
    exported.report = {largest_error, std::move(told)};
    return exported;
}

core::FileResult<Exported> write_cad(const CadFormat& format, const core::Document& document) {
    auto curves = cad_curves(document);
    if (!curves) return tl::unexpected(curves.error());
    auto result = written_and_read(format, curves->unit, curves->curves);
    if (result && result->copies.empty()) {
        LostCurves(format, *curves).leave_out();
        if (curves->curves.empty()) return refused_file(curves->notes.sentences().back());
        result = written_and_read(format, curves->unit, curves->curves);
    }
    if (!result) return tl::unexpected(result.error());
    if (result->copies.empty()) return refused_file("the file that was made does not give its curves back");
    return with_report(*curves, *std::move(result));
}

}  // namespace

core::FileResult<Imported> read_iges(std::string_view text) {
    if (auto defect = iges_defect(text)) return tl::unexpected(*std::move(defect));
    return read_through_occt("iges", text);
}

core::FileResult<Imported> read_step(std::string_view text) {
    if (auto defect = step_defect(text)) return tl::unexpected(*std::move(defect));
    return read_through_occt("step", text);
}

core::FileResult<Exported> write_iges(const core::Document& document, const WriteOptions& /*options*/) {
    return write_cad({"iges", read_iges}, document);
}

core::FileResult<Exported> write_step(const core::Document& document, const WriteOptions& /*options*/) {
    return write_cad({"step", read_step}, document);
}

}  // namespace batten::exchange
