#include "exchange/font_reader.h"

#include <freetype/freetype.h>
#include <freetype/ftoutln.h>
#include <freetype/tttables.h>
#include <ft2build.h>

#include <algorithm>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/sentence.h"
#include "core/base/utf8.h"
#include "exchange/outline.h"
#include "exchange/refusal.h"

namespace batten::exchange {

namespace {

using core::Point;

struct Character {
    FT_ULong code = 0;
    std::string text;
};

// The character at the front of `text`; none where its bytes are no UTF-8.
std::optional<Character> front_character(std::string_view text) {
    const auto code = core::utf8_code(text);
    if (!code) return std::nullopt;
    return Character{*code, std::string(text.substr(0, core::utf8_length(text)))};
}

struct FaceCloser {
    void operator()(FT_Face face) const { FT_Done_Face(face); }
};
struct LibraryCloser {
    void operator()(FT_Library library) const { FT_Done_FreeType(library); }
};

// A font in memory.
struct OpenFont {
    std::unique_ptr<std::remove_pointer_t<FT_Library>, LibraryCloser> library;
    std::unique_ptr<std::remove_pointer_t<FT_Face>, FaceCloser> face;
};

core::FileResult<OpenFont> open_font(std::string_view bytes) {
    FT_Library library = nullptr;
    if (FT_Init_FreeType(&library) != 0) return refused_file("the library that reads fonts cannot be started");
    OpenFont font;
    font.library.reset(library);
    FT_Face face = nullptr;
    const auto* const data = reinterpret_cast<const FT_Byte*>(bytes.data());
    if (bytes.empty() || FT_New_Memory_Face(library, data, static_cast<FT_Long>(bytes.size()), 0, &face) != 0)
        return refused_file("this is no font, or a damaged one; TrueType, OpenType and Type 1 are read");
    font.face.reset(face);
    if (!FT_IS_SCALABLE(face) || face->units_per_EM == 0)
        return refused_file("this font has pictures of pixels only; one with outlines is needed");
    if (FT_Select_Charmap(face, FT_ENCODING_UNICODE) != 0)
        return refused_file("the letters of this font have no numbers of Unicode, by which they could be found");
    return font;
}

// Takes the steps of FT_Outline_Decompose, whose coordinates are twice those of the font: points between two off the
// outline are in their middle, which then is a whole number.
class ContourTaker {
  public:
    ContourTaker(Point origin, double scale) : origin_(origin), scale_(scale) {}

    bool take(FT_Outline& outline) {
        const FT_Outline_Funcs steps{
            .move_to = &move, .line_to = &line, .conic_to = &conic, .cubic_to = &cubic, .shift = 1, .delta = 0};
        return FT_Outline_Decompose(&outline, &steps, this) == 0;
    }

    std::vector<Outline>& contours() { return contours_; }

  private:
    static ContourTaker& taker(void* user) { return *static_cast<ContourTaker*>(user); }
    Point at(const FT_Vector* v) const {
        const auto scaled = [this](FT_Pos value) { return static_cast<double>(value) / 2.0 * scale_; };
        return origin_ + core::Vector(scaled(v->x), scaled(v->y));
    }
    Outline& last() { return contours_.back(); }

    static int move(const FT_Vector* to, void* user) {
        taker(user).contours_.emplace_back(taker(user).at(to));
        return 0;
    }
    static int line(const FT_Vector* to, void* user) {
        taker(user).last().line_to(taker(user).at(to));
        return 0;
    }
    static int conic(const FT_Vector* corner, const FT_Vector* to, void* user) {
        taker(user).last().quadratic_to(taker(user).at(corner), taker(user).at(to));
        return 0;
    }
    static int cubic(const FT_Vector* first, const FT_Vector* second, const FT_Vector* to, void* user) {
        const ContourTaker& self = taker(user);
        taker(user).last().cubic_to(self.at(first), self.at(second), self.at(to));
        return 0;
    }

    Point origin_;
    double scale_;
    std::vector<Outline> contours_;
};

// Writes letters one after another.
class Typesetter {
  public:
    Typesetter(FT_Face face, const Lettering& lettering, std::size_t most_points)
        : face_(face),
          most_points_(most_points),
          start_(lettering.position),
          scale_(lettering.size ? *lettering.size / face->units_per_EM : 1.0),
          names_(core::Document()) {}

    void add(const Character& character) {
        if (is_full_) return;
        ++count_;
        if (character.code == '\r') return;
        if (character.code == '\n') return begin_line();
        const FT_UInt glyph = FT_Get_Char_Index(face_, character.code);
        if (glyph == 0) return miss(character.text);
        if (before_ != 0) {
            FT_Vector kerning{};
            if (FT_Get_Kerning(face_, before_, glyph, FT_KERNING_UNSCALED, &kerning) == 0) x_ += kerning.x;
            has_pairs_ = true;
        }
        before_ = glyph;
        if (FT_Load_Glyph(face_, glyph, FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING) != 0) {
            damaged_.push_back(character.text);
            return;
        }
        if (face_->glyph->format == FT_GLYPH_FORMAT_OUTLINE) add_outline(character.text);
        x_ += face_->glyph->metrics.horiAdvance;
    }

    core::FileResult<Imported> result() && {
        if (imported_.document.curves.empty() && imported_.report.left_out.empty() && missing_.empty())
            return refused_file("the text has no letter that is drawn");
        tell(missing_,
             {"the font has no '{character}', which is left out",
              "the font does not have {count} of the characters, the first one '{character}'; they are left out"});
        tell(damaged_,
             {"the outline of '{character}' is damaged and left out",
              "the outlines of {count} characters are damaged and left out, the first one that of '{character}'"});
        if (is_full_)
            imported_.report.left_out.push_back(core::sentence(
                "only the first {count} characters are drawn, since the outlines of one more would make more than "
                "{most} points",
                {{"count", count_ - 1}, {"most", most_points_}}));
        if (imported_.document.curves.empty()) return refused_file(imported_.report.left_out.front());
        if (has_pairs_ && !FT_HAS_KERNING(face_) && has_table(FT_MAKE_TAG('G', 'P', 'O', 'S')))
            imported_.report.left_out.emplace_back(
                "pairs of letters keep their plain distance: this font has their kerning only in its table GPOS, which "
                "is not read");
        return std::move(imported_);
    }

  private:
    void begin_line() {
        x_ = 0;
        ++line_;
        before_ = 0;
    }

    void miss(const std::string& character) {
        missing_.push_back(character);
        before_ = 0;
    }

    void add_outline(const std::string& name) {
        points_ += static_cast<std::size_t>(face_->glyph->outline.n_points);
        is_full_ = points_ > most_points_;
        if (is_full_) return;
        const core::Vector offset{static_cast<double>(x_), -static_cast<double>(line_ * face_->height)};
        ContourTaker taker(start_ + scale_ * offset, scale_);
        if (!taker.take(face_->glyph->outline)) {
            damaged_.push_back(name);
            return;
        }
        const std::size_t first = imported_.document.curves.size();
        for (Outline& contour : taker.contours()) add_contour(contour, name);
        auto& curves = imported_.document.curves;
        if (curves.size() < first + 2) return;
        for (std::size_t i = first; i < curves.size(); ++i) curves[i].group = curves[first].name;
    }

    void add_contour(Outline& contour, const std::string& name) {
        contour.close();
        if (contour.is_empty()) return;
        auto curve = contour.curve();
        if (!curve) {
            damaged_.push_back(name);
            return;
        }
        core::DocumentCurve entry;
        entry.name = names_.take(name);
        entry.curve = std::make_shared<const core::Curve>(*std::move(curve));
        imported_.document.curves.push_back(std::move(entry));
    }

    void tell(const std::vector<std::string>& characters, const core::PluralPattern& pattern) {
        if (characters.empty()) return;
        imported_.report.left_out.push_back(core::filled_as_needed(
            pattern.for_count(characters.size()), {{"count", characters.size()}, {"character", characters.front()}}));
    }

    bool has_table(FT_ULong tag) {
        FT_ULong length = 0;
        return FT_Load_Sfnt_Table(face_, tag, 0, nullptr, &length) == 0 && length > 0;
    }

    FT_Face face_;
    std::size_t most_points_;
    Point start_;
    double scale_;
    std::size_t count_ = 0;
    std::size_t points_ = 0;
    bool is_full_ = false;
    core::FreeNames names_;
    FT_Pos x_ = 0;
    FT_Pos line_ = 0;
    FT_UInt before_ = 0;
    bool has_pairs_ = false;
    std::vector<std::string> missing_;
    std::vector<std::string> damaged_;
    Imported imported_;
};

core::FileResult<std::vector<Character>> characters_of(std::string_view text) {
    std::vector<Character> characters;
    const std::size_t size = text.size();
    while (!text.empty()) {
        const auto character = front_character(text);
        if (!character)
            return refused_file(
                core::sentence("byte {place} of the text is no UTF-8", {{"place", size - text.size() + 1}}));
        if (characters.size() == most_letters)
            return refused_file(core::sentence("the text has more than {most} characters, the most that are set",
                                               {{"most", most_letters}}));
        text.remove_prefix(character->text.size());
        characters.push_back(*character);
    }
    return characters;
}

}  // namespace

core::FileResult<Imported> read_glyphs(std::string_view font, const Lettering& lettering, std::size_t most_points) {
    const auto characters = characters_of(lettering.text);
    if (!characters) return tl::unexpected(characters.error());
    const auto open = open_font(font);
    if (!open) return tl::unexpected(open.error());
    Typesetter typesetter(open->face.get(), lettering, most_points);
    for (const Character& character : *characters) typesetter.add(character);
    return std::move(typesetter).result();
}

}  // namespace batten::exchange
