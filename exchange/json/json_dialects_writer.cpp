#include "exchange/json/json_dialects_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "exchange/json/homogeneous.h"
#include "exchange/refusal.h"
#include "exchange/written_curves.h"

namespace batten::exchange {

namespace {

using core::CurveDefinition;
using core::DocumentCurve;

constexpr core::PluralPattern too_large{
    "'{place}' was left out: a control point times its weight is too large a number",
    "{count} curves were left out, since control points times their weights are too large numbers, the first one "
    "'{place}'"};
constexpr core::PluralPattern listed_curves{
    "the curves were written as a list; tinyspline itself reads one curve from a file",
    "{count} curves were written as a list; tinyspline itself reads one curve from a file"};

std::string quoted(const std::string& text) {
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

// "[0,0.5,1]".
template <class Items, class Append>
std::string list_text(const Items& items, Append append) {
    std::string text = "[";
    for (const auto& item : items) {
        if (text.size() > 1) text.push_back(',');
        append(text, item);
    }
    text.push_back(']');
    return text;
}

std::string numbers_text(const std::vector<double>& numbers) {
    return list_text(numbers, core::append_json_text);
}

std::string points_text(const std::vector<core::Point>& points) {
    return list_text(points, [](std::string& text, core::Point point) {
        text.push_back('[');
        core::append_json_text(text, point.x);
        text.push_back(',');
        core::append_json_text(text, point.y);
        text.push_back(']');
    });
}

// The members of one curve, each in a line of its own.
class Members {
  public:
    void add(const char* name, const std::string& value) {
        text_ += fmt::format("{}\n    \"{}\": {}", text_.empty() ? "" : ",", name, value);
    }
    void add(const char* name, std::size_t value) { add(name, std::to_string(value)); }
    void add_weights(const std::vector<double>& weights) {
        if (!weights.empty()) add("weights", numbers_text(weights));
    }
    std::string object() const { return fmt::format("{{{}\n  }}", text_); }

  private:
    std::string text_;
};

// The texts of all curves.
struct Written {
    std::vector<std::string> curves{};
    double largest_error = 0.0;
    double error = 0.0;  // of the curve that is written
    Notes notes{};

    std::string list() const { return fmt::format("[{}]", fmt::join(curves, ", ")); }
    Exported exported(std::string text) const { return {std::move(text), {largest_error, notes.sentences()}}; }
};

// The text of one curve; none where it cannot be written, of which `written` then has a note.
using WriteCurve = std::string (*)(const DocumentCurve& entry, Written& written);

std::string nurbs_python_curve(const DocumentCurve& entry, Written& /*written*/) {
    const CurveDefinition curve = full_definition(*entry.curve);
    const std::string weights =
        curve.weights.empty() ? "" : fmt::format(", \"weights\": {}", numbers_text(curve.weights));
    Members members;
    members.add("type", "\"spline\"");
    members.add("rational", curve.weights.empty() ? "false" : "true");
    members.add("dimension", "2");
    members.add("name", quoted(entry.name));
    members.add("degree", static_cast<std::size_t>(curve.degree));
    members.add("knotvector", numbers_text(curve.knots));
    members.add("control_points", fmt::format("{{\"points\": {}{}}}", points_text(curve.points), weights));
    members.add("delta", "0.01");
    return members.object();
}

std::string tinyspline_curve(const DocumentCurve& entry, Written& written) {
    const CurveDefinition curve = full_definition(*entry.curve);
    const std::vector<double> weights = weights_near_one(curve.weights);
    const bool is_homogeneous = !weights.empty();
    double error = 0.0;
    std::vector<double> numbers;
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
        const core::Point point = curve.points[i];
        const double w = is_homogeneous ? weights[i] : 1.0;
        numbers.insert(numbers.end(), {point.x * w, point.y * w});
        if (!is_homogeneous) continue;
        error = std::max(error,
                         std::hypot(quotient_error(point.x, w, point.x * w), quotient_error(point.y, w, point.y * w)));
        numbers.push_back(w);
    }
    if (!std::isfinite(error)) {
        written.notes.add(too_large, [&] { return entry.name; });
        return {};
    }
    written.error += error;
    Members members;
    members.add("name", quoted(entry.name));
    members.add("degree", static_cast<std::size_t>(curve.degree));
    members.add("dimension", is_homogeneous ? "3" : "2");
    if (is_homogeneous) members.add("homogeneous", "true");
    members.add("control_points", numbers_text(numbers));
    members.add("knots", numbers_text(curve.knots));
    return members.object();
}

std::string rhino_curve(const DocumentCurve& entry, Written& /*written*/) {
    CurveDefinition curve = full_definition(*entry.curve);
    curve.knots.pop_back();
    curve.knots.erase(curve.knots.begin());
    Members members;
    members.add("name", quoted(entry.name));
    members.add("degree", static_cast<std::size_t>(curve.degree));
    members.add("points", points_text(curve.points));
    members.add_weights(curve.weights);
    members.add("knots", numbers_text(curve.knots));
    return members.object();
}

// The period that begins with the last of the equal knots at its seam.
CurveDefinition begun_after_seam(const core::Curve& curve) {
    CurveDefinition definition = curve.definition();
    if (!definition.periodic) return full_definition(curve);
    std::vector<double>& knots = definition.knots;
    const auto first_above = std::ranges::upper_bound(knots, knots.front());
    const std::ptrdiff_t moved = first_above - knots.begin() - 1;
    knots.erase(knots.begin(), knots.begin() + moved);
    knots.insert(knots.end(), static_cast<std::size_t>(moved), knots.back());
    definition.weights.assign(curve.weights().begin(), curve.weights().end());
    std::rotate(definition.points.begin(), definition.points.begin() + moved, definition.points.end());
    std::rotate(definition.weights.begin(), definition.weights.begin() + moved, definition.weights.end());
    return definition;
}

std::string opencascade_curve(const DocumentCurve& entry, Written& /*written*/) {
    const CurveDefinition curve = begun_after_seam(*entry.curve);
    std::vector<double> knots;
    std::vector<double> multiplicities;
    for (const double u : curve.knots) {
        if (knots.empty() || knots.back() != u) {
            knots.push_back(u);
            multiplicities.push_back(0.0);
        }
        multiplicities.back() += 1.0;
    }
    if (curve.periodic) multiplicities.front() = multiplicities.back();
    Members members;
    members.add("name", quoted(entry.name));
    members.add("degree", static_cast<std::size_t>(curve.degree));
    members.add("periodic", curve.periodic ? "true" : "false");
    members.add("poles", points_text(curve.points));
    members.add_weights(curve.weights);
    members.add("knots", numbers_text(knots));
    members.add("multiplicities", numbers_text(multiplicities));
    return members.object();
}

core::FileResult<Written> written(const core::Document& document, WriteCurve write, bool has_periods = false) {
    const auto entries = visible_curves(document);
    if (!entries) return tl::unexpected(entries.error());
    Written result;
    note_losses(result.notes, document, {.periodic = has_periods});
    for (const DocumentCurve* entry : *entries) {
        result.error = has_periods ? 0.0 : unrolling_error(*entry->curve);
        std::string text = write(*entry, result);
        if (text.empty()) continue;
        result.curves.push_back(std::move(text));
        result.largest_error = std::max(result.largest_error, result.error);
    }
    if (result.curves.empty()) return refused_file(result.notes.sentences().back());
    return result;
}

core::FileResult<Exported> write_list(const core::Document& document, WriteCurve write, const char* style,
                                      bool has_periods) {
    return written(document, write, has_periods).map([&](const Written& curves) {
        return curves.exported(fmt::format("{{\n  \"style\": \"{}\",\n  \"curves\": {}\n}}\n", style, curves.list()));
    });
}

}  // namespace

core::FileResult<Exported> write_nurbs_python(const core::Document& document, const WriteOptions& /*options*/) {
    return written(document, nurbs_python_curve).map([](const Written& curves) {
        return curves.exported(
            fmt::format("{{\"shape\": {{\n  \"type\": \"curve\",\n  \"count\": {},\n  \"data\": {}\n}}}}\n",
                        curves.curves.size(), curves.list()));
    });
}

core::FileResult<Exported> write_tinyspline(const core::Document& document, const WriteOptions& /*options*/) {
    return written(document, tinyspline_curve).map([](Written curves) {
        const bool is_list = curves.curves.size() > 1;
        for (std::size_t i = 0; is_list && i < curves.curves.size(); ++i)
            curves.notes.add(listed_curves, [] { return std::string(); });
        return curves.exported(fmt::format("{}\n", is_list ? curves.list() : curves.curves.front()));
    });
}

core::FileResult<Exported> write_rhino(const core::Document& document, const WriteOptions& /*options*/) {
    return write_list(document, rhino_curve, "rhino", false);
}

core::FileResult<Exported> write_opencascade(const core::Document& document, const WriteOptions& /*options*/) {
    return write_list(document, opencascade_curve, "opencascade", true);
}

}  // namespace batten::exchange
