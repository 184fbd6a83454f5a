/// One entity of a DXF file: the numbers of those groups that draw it.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "exchange/dxf/dxf_groups.h"

namespace batten::exchange {

class DxfEntity {
  public:
    /// Begins with the group of code 0 that names it.
    explicit DxfEntity(const DxfGroup& group = {}) : name_(group.value), line_(group.line) {}

    void take(const DxfGroup& group);

    std::string_view name() const { return name_; }
    std::size_t line() const { return line_; }
    std::string_view layer() const { return layer_; }

    std::string_view line_type() const { return line_type_; }

    /// What a table calls it.
    std::string_view title() const { return title_; }

    /// All numbers of the codes 10, 11, 20, 21, 40 and 41 in their order, of other codes that are kept the last one.
    std::span<const double> numbers(int code) const;
    double number(int code, double where_missing) const;
    bool has_bit(int code, unsigned bit) const;

    /// The pairs of numbers of two codes, as many as both have.
    std::vector<core::Point> points(int x_code, int y_code) const;

    /// The vector of the numbers of two codes; none where one is missing, or both are 0.
    std::optional<core::Vector> vector(int x_code, int y_code) const;

    /// One for each vertex.
    std::vector<double> bulges() const;

    /// Whether some leg of a polyline has a width.
    bool has_widths() const;

    bool is_off_plane() const { return is_off_plane_; }  ///< some z or elevation is not 0

    /// Of the first number that is none, but for those of tangents and of the look; empty: there is none.
    const std::string& defect() const { return defect_; }

    /// Likewise of the numbers of tangents alone, 12, 13, 22 and 23.
    const std::string& defect_of_tangents() const { return defect_of_tangents_; }

    /// Of a POLYLINE, whose vertices are entities of their own: begins with none, and adds one.
    void forget_vertices();
    void add_vertex(const DxfEntity& vertex);

  private:
    static constexpr std::array kept_codes{10, 11, 12, 13, 20, 21, 22, 23, 30, 31, 38,  39,  40,  41,  42,
                                           43, 50, 51, 60, 62, 67, 70, 71, 72, 73, 210, 220, 230, 370, 420};

    static std::optional<std::size_t> slot_of(int code);
    void keep(int code, double value);

    std::string_view name_;
    std::size_t line_ = 0;
    std::string_view layer_{};
    std::string_view line_type_{};
    std::string_view title_{};
    std::array<std::vector<double>, kept_codes.size()> numbers_{};
    std::vector<double> bulges_{};
    bool is_off_plane_ = false;
    bool has_wide_vertex_ = false;
    bool has_ended_ = false;  // what follows belongs to an object inside it
    std::string defect_{};
    std::string defect_of_tangents_{};
};

}  // namespace batten::exchange
