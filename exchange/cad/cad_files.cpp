#include "exchange/cad/cad_files.h"

#include <algorithm>
#include <charconv>
#include <functional>
#include <span>

#include "exchange/cad/cad_curves.h"
#include "exchange/cad/iges_check.h"
#include "exchange/cad/occt_process.h"
#include "exchange/cad/step_check.h"
#include "exchange/cad/step_text.h"
#include "exchange/refusal.h"

namespace batten::exchange {

namespace {

constexpr core::PluralPattern not_held{
    "'{place}' was left out, since it does not come back from such a file",
    "{count} curves were left out, since they do not come back from such a file; the first one is '{place}'"};
constexpr core::PluralPattern not_readable{
    "'{place}' was left out, since the file with it cannot be read: {reason}",
    "{count} curves were left out, since files with them cannot be read: {reason}; the first one is '{place}'"};
constexpr core::PluralPattern not_tried{
    "'{place}' was left out, since too many others do not come back from such a file",
    "{count} curves were left out, since too many others do not come back from such a file; the first one is "
    "'{place}'"};
constexpr core::PluralPattern read_otherwise{
    "'{place}' is read from the file otherwise than it was written, by at most the error that is told",
    "{count} curves are read from the file otherwise than they were written, the first one '{place}', by at most the "
    "error that is told"};

struct CadFormat {
    const char* name;
    Reader read;
    CadWeights weights;
    std::vector<std::size_t> (*damaged_curves)(std::string_view text);  // of those that a file was written of, if known
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
    std::vector<core::DocumentCurve> copies{};  // none where the file cannot be read
    std::string refusal{};                      // why it cannot
};

core::FileResult<WrittenAndRead> written_and_read(const CadFormat& format, const core::Document& document) {
    return write_through_occt(format.name, document).map([&](Exported written) {
        auto copy = format.read(written.text);
        WrittenAndRead result{std::move(written)};
        if (copy)
            result.copies = std::move(copy->document.curves);
        else
            result.refusal = copy.error().what;
        return result;
    });
}

// Finds the curves that do not come back. Those that are only missing show at once, and so do those whose numbers the
// text has no numbers for. Others for whose sake nothing can be read are found by halves, a few tries for each of them;
// after so many tries, what is left is given up.
class LostCurves {
  public:
    LostCurves(const CadFormat& format, CadCurves& curves) : format_(format), curves_(curves) {}

    void leave_out() {
        const std::vector<CadCurve> all = std::move(curves_.curves);
        curves_.curves.clear();
        sort(all);
    }

  private:
    // What came of a file of some curves.
    struct Try {
        std::vector<bool> is_there;
        std::vector<std::size_t> damaged{};  // those at fault where the file cannot be read, if they are known
        std::string refusal{};
    };

    void sort(std::span<const CadCurve> part) {
        if (tries_ == 0) return leave_out(part, not_tried, {});
        --tries_;
        const Try tried = try_file(part);
        const bool is_nothing_there = std::ranges::none_of(tried.is_there, std::identity());
        if (part.size() > 1 && is_nothing_there)
            return tried.damaged.empty() ? sort_halves(part) : sort_others(part, tried);
        for (std::size_t i = 0; i < part.size(); ++i)
            if (tried.is_there[i])
                curves_.curves.push_back(part[i]);
            else
                leave_out_alone(part[i], tried);
    }

    void sort_halves(std::span<const CadCurve> part) {
        const std::size_t half = part.size() / 2;
        sort(part.first(half));
        sort(part.subspan(half));
    }

    void sort_others(std::span<const CadCurve> part, const Try& tried) {
        std::vector<CadCurve> others;
        for (std::size_t i = 0; i < part.size(); ++i)
            if (std::ranges::binary_search(tried.damaged, i))
                leave_out_alone(part[i], tried);
            else
                others.push_back(part[i]);
        if (!others.empty()) sort(others);
    }

    void leave_out_alone(const CadCurve& curve, const Try& tried) {
        leave_out({&curve, 1}, tried.refusal.empty() ? not_held : not_readable, tried.refusal);
    }

    void leave_out(std::span<const CadCurve> part, const core::PluralPattern& why, std::string_view reason) {
        for (const CadCurve& curve : part)
            curves_.notes.add(
                why, [&] { return curve.name; }, {}, reason);
    }

    // In the file they are named by their numbers.
    Try try_file(std::span<const CadCurve> part) const {
        Try tried{std::vector<bool>(part.size(), false)};
        core::Document document = cad_document(curves_.unit, part);
        for (std::size_t i = 0; i < part.size(); ++i) document.curves[i].name = std::to_string(i);
        const auto result = written_and_read(format_, document);
        if (!result) {
            tried.refusal = result.error().what;
            return tried;
        }
        for (const core::DocumentCurve& copy : result->copies) {
            std::size_t i = part.size();
            std::from_chars(copy.name.data(), copy.name.data() + copy.name.size(), i);
            if (i < part.size()) tried.is_there[i] = true;
        }
        if (result->copies.empty()) tried.damaged = format_.damaged_curves(result->written.text);
        tried.refusal = result->refusal;
        return tried;
    }

    const CadFormat& format_;
    CadCurves& curves_;
    int tries_ = 100;
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
    auto curves = cad_curves(document, format.weights);
    if (!curves) return tl::unexpected(curves.error());
    const auto written = [&] { return written_and_read(format, cad_document(curves->unit, curves->curves)); };
    auto result = written();
    if (result && result->copies.size() != curves->curves.size()) {
        LostCurves(format, *curves).leave_out();
        if (curves->curves.empty()) return refused_file(curves->notes.sentences().back());
        result = written();
    }
    if (!result) return tl::unexpected(result.error());
    if (result->copies.size() != curves->curves.size())
        return refused_file("the file that was made does not give its curves back");
    return with_report(*curves, *std::move(result));
}

}  // namespace

core::FileResult<Imported> read_iges(std::string_view text) {
    if (auto defect = iges_defect(text)) return tl::unexpected(*std::move(defect));
    return read_through_occt("iges", text);
}

core::FileResult<Imported> read_step(std::string_view text) {
    if (auto defect = step_defect(text)) return tl::unexpected(*std::move(defect));
    return read_through_occt("step", step_text_for_occt(text));
}

core::FileResult<Exported> write_iges(const core::Document& document, const WriteOptions& /*options*/) {
    return write_cad({"iges", read_iges, CadWeights::larger, damaged_iges_entities}, document);
}

core::FileResult<Exported> write_step(const core::Document& document, const WriteOptions& /*options*/) {
    return write_cad({"step", read_step, CadWeights::kept, [](std::string_view) { return std::vector<std::size_t>(); }},
                     document);
}

}  // namespace batten::exchange
