#include "app/editor/recovery/document_pieces.h"

#include <algorithm>
#include <concepts>
#include <cstring>
#include <span>

#include "app/editor/recovery/byte_code.h"
#include "core/make/fit_points.h"

namespace batten::editor {

template <class T, class Type>
concept Is = std::same_as<std::remove_const_t<T>, Type>;

// The structured bindings name every member: a structure that gets another one does not compile until it is named here.

template <class Code>
void members(Code& code, Is<core::Point> auto& point) {
    code(point.x, point.y);
}

template <class Code>
void members(Code& code, Is<core::Vector> auto& vector) {
    code(vector.x, vector.y);
}

template <class Code>
void members(Code& code, Is<core::DocumentColor> auto& color) {
    auto& [red, green, blue] = color;
    code(red, green, blue);
}

template <class Code>
void members(Code& code, Is<core::Symmetry> auto& symmetry) {
    auto& [group, place, turns, center, angle, unknown_members] = symmetry;
    code(group, place, turns, center, angle, unknown_members);
}

template <class Code>
void members(Code& code, Is<core::KnotMark> auto& knot) {
    auto& [u, mark, unknown_members] = knot;
    code(u, mark, unknown_members);
}

template <class Code>
void members(Code& code, Is<core::EndMark> auto& entry) {
    auto& [end, joint, mark, unknown_members] = entry;
    code(end, joint, mark, unknown_members);
}

template <class Code>
void members(Code& code, Is<core::JointMarks> auto& joints) {
    auto& [knots, ends] = joints;
    code(knots, ends);
}

template <class Code>
void members(Code& code, Is<core::FitPoint> auto& point) {
    auto& [place, joint, handle] = point;
    code(place, joint, handle);
}

template <class Code>
void members(Code& code, Is<core::FitPoints> auto& fit) {
    auto& [points, parameters, kind, parametrization, closed] = fit;
    code(points, parameters, kind, parametrization, closed);
}

template <class Code>
void members(Code& code, Is<core::Picture> auto& picture) {
    auto& [path, width, height, position, scale, rotation, opacity, visible, locked, unknown_members] = picture;
    code(path, width, height, position, scale, rotation, opacity, visible, locked, unknown_members);
}

template <class Code>
void members(Code& code, Is<core::Guide> auto& guide) {
    auto& [point, angle, unknown_members] = guide;
    code(point, angle, unknown_members);
}

template <class Code>
void members(Code& code, Is<core::DocumentUnits> auto& units) {
    auto& [unit, scale, unknown_members] = units;
    code(unit, scale, unknown_members);
}

template <class Code>
void members(Code& code, Is<core::DocumentView> auto& view) {
    auto& [parameter, overlays, notation, unknown_members] = view;
    code(parameter, overlays, notation, unknown_members);
}

// All but the curve.
template <class Code>
void members(Code& code, Is<core::DocumentCurve> auto& entry) {
    auto& [name, curve, color, visible, locked, tears, pinned, symmetry, joints, unknown_members, point_hues, fit,
           unknown_fit_members, group] = entry;
    bool may_tear = tears == core::Tears::allow;
    code(name, color, visible, locked, may_tear, pinned, symmetry, joints, unknown_members, point_hues, fit,
         unknown_fit_members, group);
    if constexpr (std::same_as<Code, ByteReader>) tears = may_tear ? core::Tears::allow : core::Tears::refuse;
}

// All but the curves, and but what is only told once.
template <class Code>
void members(Code& code, Is<core::Document> auto& document) {
    auto& [title, description, curves, active, pictures, guides, units, view, unknown_members, lost_fits] = document;
    code(title, description, active, pictures, guides, units, view, unknown_members);
}

namespace {

// What is told of a curve beside its arrays.
struct CurveFacts {
    int degree = 0;
    bool periodic = false;
    core::KnotKind kind = core::KnotKind::custom;
};

template <class Value>
Piece written_piece(const Value& value) {
    ByteWriter writer;
    writer(value);
    return piece_of(writer.take());
}

Piece entry_piece(const core::DocumentCurve& entry) {
    ByteWriter writer;
    writer(entry, entry.curve->degree(), entry.curve->is_periodic(), entry.curve->knots().kind());
    return piece_of(writer.take());
}

template <class T>
Piece array_piece(const core::DocumentCurve& entry, std::span<const T> values) {
    return {entry.curve, {reinterpret_cast<const char*>(values.data()), values.size_bytes()}};
}

CurvePieces pieces_of_curve(const core::DocumentCurve& entry) {
    const core::Curve& curve = *entry.curve;
    return {entry_piece(entry), array_piece(entry, curve.knots().stored()), array_piece(entry, curve.control_points()),
            array_piece(entry, curve.weights())};
}

template <class T>
std::vector<T> array_of(const Piece& piece) {
    std::vector<T> values(piece.bytes.size() / sizeof(T));
    if (!values.empty()) std::memcpy(values.data(), piece.bytes.data(), values.size() * sizeof(T));
    return values;
}

std::shared_ptr<const core::Curve> curve_of(const CurvePieces& pieces, const CurveFacts& facts) {
    auto curve = core::Curve::make({.degree = facts.degree,
                                    .knots = array_of<double>(pieces[1]),
                                    .points = array_of<core::Point>(pieces[2]),
                                    .weights = array_of<double>(pieces[3]),
                                    .periodic = facts.periodic,
                                    .kind = facts.kind,
                                    .tears = core::Tears::allow});
    return curve ? std::make_shared<const core::Curve>(*std::move(curve)) : nullptr;
}

// Whether what is told of the curve can be so.
bool is_sound(const core::DocumentCurve& entry) {
    const std::size_t count = entry.curve->control_points().size();
    const auto is_marked_knot = [&](const core::KnotMark& mark) { return core::is_inner_knot(*entry.curve, mark.u); };
    return std::ranges::all_of(entry.pinned, [&](std::size_t i) { return i < count; }) &&
           std::ranges::is_sorted(entry.pinned) && std::ranges::all_of(entry.joints.knots, is_marked_knot) &&
           (entry.point_hues == nullptr || entry.point_hues->size() == count) &&
           (entry.fit == nullptr || core::check_fit_points(*entry.fit));
}

bool take_curve(core::Document& document, const CurvePieces& pieces) {
    core::DocumentCurve& entry = document.curves.emplace_back();
    CurveFacts facts;
    ByteReader reader(pieces[0].bytes);
    reader(entry, facts.degree, facts.periodic, facts.kind);
    if (!reader.is_good() || !reader.is_at_end()) return false;
    entry.curve = curve_of(pieces, facts);
    return entry.curve != nullptr && is_sound(entry);
}

}  // namespace

Piece piece_of(std::string bytes) {
    const auto owner = std::make_shared<const std::string>(std::move(bytes));
    return {owner, *owner};
}

DocumentPieces pieces_of(const core::Document& document) {
    DocumentPieces pieces{{written_piece(document)}};
    pieces.reserve(document.curves.size() + 1);
    for (const core::DocumentCurve& entry : document.curves) pieces.push_back(pieces_of_curve(entry));
    return pieces;
}

Outcome<core::Document> document_of(const DocumentPieces& pieces) {
    const auto damaged = [] { return tl::unexpected(Refusal("the journal is damaged")); };
    if (pieces.empty()) return damaged();
    core::Document document;
    ByteReader reader(pieces.front()[0].bytes);
    reader(document);
    if (!reader.is_good() || !reader.is_at_end()) return damaged();
    for (std::size_t i = 1; i < pieces.size(); ++i)
        if (!take_curve(document, pieces[i])) return damaged();
    if (document.active >= std::max<std::size_t>(1, document.curves.size())) return damaged();
    return document;
}

}  // namespace batten::editor
