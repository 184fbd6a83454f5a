/// The polynomials of a curve, each about the middle of its piece: the form that is quickest to evaluate.
#pragma once

#include <vector>

#include "core/evaluate/detail/span_block.h"

namespace batten::core {

/// The numbers of one piece. With t = scale (u - middle), from -1 to 1, a polynomial curve is
/// C(u) = c_0 + c_1 t + ... + c_p t^p, a rational one C(u) = c_0 + (c_1 t + ... + c_p t^p) / (1 + w_1 t + ... + w_p
/// t^p). The scale is a power of two, so that t is exact; zero where such a sum would lose digits.
struct TaylorPiece {
    const double* numbers =
        nullptr;        ///< middle, scale, c_0.x, c_0.y, c_1.x, c_1.y, ...; where rational, w_k behind c_k
    std::size_t p = 0;  ///< degree
    bool is_rational = false;

    double middle() const { return numbers[0]; }
    double scale() const { return numbers[1]; }
    bool is_sharp() const { return scale() != 0.0; }
    /// The t of u.
    double at(double u) const { return scale() * (u - middle()); }
    /// c_0.
    const double* point() const { return numbers + 2; }
    /// c_1, and w_1 where rational, and so on.
    const double* terms() const { return numbers + 4; }
};

struct TaylorPieces {
    std::size_t p = 0;  ///< degree
    bool is_rational = false;
    std::vector<double> joints{};  ///< ascending; piece i lies between joints[i] and joints[i + 1]
    std::vector<double> numbers{};

    std::size_t stride() const { return 4 + (is_rational ? 3 : 2) * p; }
    TaylorPiece operator[](std::size_t i) const { return {numbers.data() + i * stride(), p, is_rational}; }
};

/// Part of a span, or all of it.
struct SpanPart {
    std::size_t span;
    Interval interval;
};

/// Makes the pieces of a curve, which must outlive it: one for each span, or several, as a span is halved, a few times,
/// until the terms are no larger than the control points allow, so that their sum loses no digits. Cost O(p^3) for each
/// piece, several of them at once by vector instructions. Source: Taylor's theorem, with the derivatives by de Boor's
/// algorithm.
class TaylorExpander {
  public:
    explicit TaylorExpander(const Curve& curve);

    const TaylorPieces& pieces() const { return pieces_; }

    /// Begins anew with span `first`, which is not empty.
    void begin_at(std::size_t first);

    /// Adds the pieces of the next spans, block_size of them, or fewer at the end of the domain.
    void add_spans();

    /// The pieces of all spans.
    TaylorPieces all_pieces();

  private:
    void add_parts(int halvings);
    void expand_parts(std::span<const SpanPart> parts);
    bool are_following(std::span<const SpanPart> parts) const;
    void add_piece(std::size_t lane, double upper);
    void put_in_order(std::size_t first);

    const Curve& curve_;
    TaylorPieces pieces_;
    std::size_t next_ = 0;  // the span that is looked at next
    std::vector<SpanPart> parts_{};
    SpanBlock block_;
    std::array<LaneRow, most_taylor_numbers> numbers_;
};

}  // namespace batten::core
