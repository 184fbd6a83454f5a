/// Finds where pieces of curves meet, by subdivision finished by Newton's iteration.
#pragma once

#include <span>
#include <vector>

#include "core/evaluate/detail/piece_motion.h"
#include "core/measure/detail/contact_piece.h"

namespace batten::core {

/// A place on a sequence of pieces: the number of a piece, and where on it.
struct PiecePlace {
    std::size_t span = 0;
    double share = 0.0;  ///< in [0, 1]
};

/// What two pieces have in common: a point, or an interval on which they coincide.
struct FoundContact {
    PiecePlace first_begin;
    PiecePlace first_end;     ///< equal to first_begin for a point
    PiecePlace second_begin;  ///< belongs to first_begin
    PiecePlace second_end;    ///< belongs to first_end
    bool is_tangent = false;
};

/// The pieces of one curve, all seen from the same origin; pieces that are single points are left out.
struct ContactPieces {
    std::vector<PieceMotion> motions;
    std::vector<ContactPiece> pieces;  ///< `span` is the index in `motions`
};

ContactPieces contact_pieces(const Curve& curve, Point origin);

/// Collects the contacts of pairs of pieces. Pairs whose boxes are apart have none; pairs that are transversal to each
/// other have at most one, which Newton's iteration finds; others are halved, until they are smaller than 2^-22 of the
/// size of the smaller curve. What is left then is gathered into clusters of neighbors, each one tangential contact.
/// Pieces that coincide on an interval are recognized before. Source: Sederberg and Meyers 1988 for the directions.
class ContactSearch {
  public:
    /// Points nearer than `tolerance` are one; `size` is that of the smaller curve. For a curve with itself both are
    /// the same object.
    ContactSearch(const ContactPieces& first, const ContactPieces& second, double size, double tolerance);

    /// Seeks the contacts of two pieces that have no end in common.
    void add_pair(const ContactPiece& a, const ContactPiece& b);

    /// Seeks those of two pieces of one curve, the second of which begins where the first ends, besides that point.
    void add_neighbors(const ContactPiece& a, const ContactPiece& b);

    /// Seeks those of a piece of one curve with itself.
    void add_alone(const ContactPiece& a);

    /// All contacts, once each per pair of pieces; ends of pieces may come several times. Call once.
    std::vector<FoundContact> finish();

    /// Whether no pair of pieces was left undecided because it took too many halvings.
    bool is_complete() const { return is_complete_; }

  private:
    struct Unresolved {
        ContactPiece a;
        ContactPiece b;
    };

    void search(const ContactPiece& a, const ContactPiece& b);
    void search_joint(const ContactPiece& a, const ContactPiece& b, int depth);
    void search_alone(const ContactPiece& a, int depth);
    bool take_overlap(const ContactPiece& a, const ContactPiece& b);
    bool take_crossing(const ContactPiece& a, const ContactPiece& b);
    void take_cluster(std::span<const Unresolved> cluster);
    bool is_same_curve() const { return &first_ == &second_; }
    bool is_at_joint(const Unresolved& pair) const;
    bool is_small(const ContactPiece& a, const ContactPiece& b) const;
    bool affords(double evaluations, const ContactPiece& a, const ContactPiece& b);

    const ContactPieces& first_;
    const ContactPieces& second_;
    double size_;
    double tolerance_;
    std::size_t visits_ = 0;  // of parts of the present pair of pieces
    double work_left_;        // for all pairs
    bool is_complete_ = true;
    std::vector<Unresolved> unresolved_;
    std::vector<FoundContact> found_;
};

}  // namespace batten::core
