#include "render/tex_signs.h"

#include <algorithm>
#include <array>
#include <string>

namespace batten::render {

namespace {

/// A sign and what LaTeX calls it.
struct NamedSign {
    std::string_view sign;
    std::string_view name;
};

// Blackboard letters would need a package: bold ones mean the same.
constexpr std::array math_signs{NamedSign{"−", "-"},
                                NamedSign{"·", "\\cdot "},
                                NamedSign{"×", "\\times "},
                                NamedSign{"÷", "\\div "},
                                NamedSign{"±", "\\pm "},
                                NamedSign{"∓", "\\mp "},
                                NamedSign{"≤", "\\le "},
                                NamedSign{"≥", "\\ge "},
                                NamedSign{"≠", "\\ne "},
                                NamedSign{"≈", "\\approx "},
                                NamedSign{"≡", "\\equiv "},
                                NamedSign{"≅", "\\cong "},
                                NamedSign{"∼", "\\sim "},
                                NamedSign{"∝", "\\propto "},
                                NamedSign{"≪", "\\ll "},
                                NamedSign{"≫", "\\gg "},
                                NamedSign{"∞", "\\infty "},
                                NamedSign{"…", "\\dots "},
                                NamedSign{"⋯", "\\cdots "},
                                NamedSign{"′", "'"},
                                NamedSign{"″", "''"},
                                NamedSign{"‴", "'''"},
                                NamedSign{"∑", "\\sum "},
                                NamedSign{"∏", "\\prod "},
                                NamedSign{"∫", "\\int "},
                                NamedSign{"√", "\\sqrt{}"},
                                NamedSign{"∂", "\\partial "},
                                NamedSign{"∇", "\\nabla "},
                                NamedSign{"∈", "\\in "},
                                NamedSign{"∉", "\\notin "},
                                NamedSign{"∋", "\\ni "},
                                NamedSign{"⊂", "\\subset "},
                                NamedSign{"⊃", "\\supset "},
                                NamedSign{"⊆", "\\subseteq "},
                                NamedSign{"⊇", "\\supseteq "},
                                NamedSign{"∪", "\\cup "},
                                NamedSign{"∩", "\\cap "},
                                NamedSign{"∅", "\\emptyset "},
                                NamedSign{"∀", "\\forall "},
                                NamedSign{"∃", "\\exists "},
                                NamedSign{"¬", "\\neg "},
                                NamedSign{"∧", "\\wedge "},
                                NamedSign{"∨", "\\vee "},
                                NamedSign{"→", "\\to "},
                                NamedSign{"←", "\\leftarrow "},
                                NamedSign{"↔", "\\leftrightarrow "},
                                NamedSign{"↑", "\\uparrow "},
                                NamedSign{"↓", "\\downarrow "},
                                NamedSign{"↦", "\\mapsto "},
                                NamedSign{"⇒", "\\Rightarrow "},
                                NamedSign{"⇐", "\\Leftarrow "},
                                NamedSign{"⇔", "\\Leftrightarrow "},
                                NamedSign{"∘", "\\circ "},
                                NamedSign{"⊗", "\\otimes "},
                                NamedSign{"⊕", "\\oplus "},
                                NamedSign{"⟨", "\\langle "},
                                NamedSign{"⟩", "\\rangle "},
                                NamedSign{"‖", "\\|"},
                                NamedSign{"∥", "\\parallel "},
                                NamedSign{"⊥", "\\perp "},
                                NamedSign{"∠", "\\angle "},
                                NamedSign{"△", "\\triangle "},
                                NamedSign{"▶", "\\triangleright "},
                                NamedSign{"●", "\\bullet "},
                                NamedSign{"•", "\\bullet "},
                                NamedSign{"°", "^\\circ "},
                                NamedSign{"ℓ", "\\ell "},
                                NamedSign{"ℜ", "\\Re "},
                                NamedSign{"ℑ", "\\Im "},
                                NamedSign{"ℝ", "\\mathbf{R}"},
                                NamedSign{"ℂ", "\\mathbf{C}"},
                                NamedSign{"ℕ", "\\mathbf{N}"},
                                NamedSign{"ℤ", "\\mathbf{Z}"},
                                NamedSign{"ℚ", "\\mathbf{Q}"},
                                NamedSign{"ℙ", "\\mathbf{P}"},
                                NamedSign{"⁰", "^0"},
                                NamedSign{"¹", "^1"},
                                NamedSign{"²", "^2"},
                                NamedSign{"³", "^3"},
                                NamedSign{"⁴", "^4"},
                                NamedSign{"⁵", "^5"},
                                NamedSign{"⁶", "^6"},
                                NamedSign{"⁷", "^7"},
                                NamedSign{"⁸", "^8"},
                                NamedSign{"⁹", "^9"},
                                NamedSign{"⁺", "^+"},
                                NamedSign{"⁻", "^-"},
                                NamedSign{"ⁿ", "^n"},
                                NamedSign{"ⁱ", "^i"},
                                NamedSign{"₀", "_0"},
                                NamedSign{"₁", "_1"},
                                NamedSign{"₂", "_2"},
                                NamedSign{"₃", "_3"},
                                NamedSign{"₄", "_4"},
                                NamedSign{"₅", "_5"},
                                NamedSign{"₆", "_6"},
                                NamedSign{"₇", "_7"},
                                NamedSign{"₈", "_8"},
                                NamedSign{"₉", "_9"},
                                NamedSign{"₊", "_+"},
                                NamedSign{"₋", "_-"},
                                NamedSign{"ᵢ", "_i"},
                                NamedSign{"ⱼ", "_j"},
                                NamedSign{"ₖ", "_k"},
                                NamedSign{"ₙ", "_n"},
                                NamedSign{"α", "\\alpha "},
                                NamedSign{"β", "\\beta "},
                                NamedSign{"γ", "\\gamma "},
                                NamedSign{"δ", "\\delta "},
                                NamedSign{"ε", "\\epsilon "},
                                NamedSign{"ζ", "\\zeta "},
                                NamedSign{"η", "\\eta "},
                                NamedSign{"θ", "\\theta "},
                                NamedSign{"ι", "\\iota "},
                                NamedSign{"κ", "\\kappa "},
                                NamedSign{"λ", "\\lambda "},
                                NamedSign{"μ", "\\mu "},
                                NamedSign{"ν", "\\nu "},
                                NamedSign{"ξ", "\\xi "},
                                NamedSign{"π", "\\pi "},
                                NamedSign{"ρ", "\\rho "},
                                NamedSign{"σ", "\\sigma "},
                                NamedSign{"τ", "\\tau "},
                                NamedSign{"υ", "\\upsilon "},
                                NamedSign{"φ", "\\phi "},
                                NamedSign{"χ", "\\chi "},
                                NamedSign{"ψ", "\\psi "},
                                NamedSign{"ω", "\\omega "},
                                NamedSign{"ϕ", "\\phi "},
                                NamedSign{"ϑ", "\\vartheta "},
                                NamedSign{"ς", "\\varsigma "},
                                NamedSign{"µ", "\\mu "},
                                NamedSign{"Γ", "\\Gamma "},
                                NamedSign{"Δ", "\\Delta "},
                                NamedSign{"Θ", "\\Theta "},
                                NamedSign{"Λ", "\\Lambda "},
                                NamedSign{"Ξ", "\\Xi "},
                                NamedSign{"Π", "\\Pi "},
                                NamedSign{"Σ", "\\Sigma "},
                                NamedSign{"Υ", "\\Upsilon "},
                                NamedSign{"Φ", "\\Phi "},
                                NamedSign{"Ψ", "\\Psi "},
                                NamedSign{"Ω", "\\Omega "},
                                NamedSign{"Α", "\\mathrm{A}"},
                                NamedSign{"Β", "\\mathrm{B}"},
                                NamedSign{"Ε", "\\mathrm{E}"},
                                NamedSign{"Ζ", "\\mathrm{Z}"},
                                NamedSign{"Η", "\\mathrm{H}"},
                                NamedSign{"Ι", "\\mathrm{I}"},
                                NamedSign{"Κ", "\\mathrm{K}"},
                                NamedSign{"Μ", "\\mathrm{M}"},
                                NamedSign{"Ν", "\\mathrm{N}"},
                                NamedSign{"Ο", "\\mathrm{O}"},
                                NamedSign{"Ρ", "\\mathrm{P}"},
                                NamedSign{"Τ", "\\mathrm{T}"},
                                NamedSign{"Χ", "\\mathrm{X}"},
                                NamedSign{"ο", "\\mathrm{o}"}};

constexpr std::array fraction_signs{
    NamedSign{"½", "\\frac{1}{2}"}, NamedSign{"⅓", "\\frac{1}{3}"}, NamedSign{"⅔", "\\frac{2}{3}"},
    NamedSign{"¼", "\\frac{1}{4}"}, NamedSign{"¾", "\\frac{3}{4}"}, NamedSign{"⅕", "\\frac{1}{5}"},
    NamedSign{"⅖", "\\frac{2}{5}"}, NamedSign{"⅗", "\\frac{3}{5}"}, NamedSign{"⅘", "\\frac{4}{5}"},
    NamedSign{"⅙", "\\frac{1}{6}"}, NamedSign{"⅚", "\\frac{5}{6}"}, NamedSign{"⅐", "\\frac{1}{7}"},
    NamedSign{"⅛", "\\frac{1}{8}"}, NamedSign{"⅜", "\\frac{3}{8}"}, NamedSign{"⅝", "\\frac{5}{8}"},
    NamedSign{"⅞", "\\frac{7}{8}"}, NamedSign{"⅑", "\\frac{1}{9}"}, NamedSign{"⅒", "\\frac{1}{10}"}};

constexpr std::array ascii_signs{NamedSign{"<", "<"},   NamedSign{">", ">"}, NamedSign{"|", "|"}, NamedSign{"+", "+"},
                                 NamedSign{"=", "="},   NamedSign{"*", "*"}, NamedSign{"/", "/"}, NamedSign{"(", "("},
                                 NamedSign{")", ")"},   NamedSign{"[", "["}, NamedSign{"]", "]"}, NamedSign{"{", "\\{"},
                                 NamedSign{"}", "\\}"}, NamedSign{"-", "-"}};

// Of "\$" and its like LaTeX since 2020 knows only bitmaps where no more fonts are installed than it needs.
constexpr std::array text_signs{NamedSign{"&", "\\&"},
                                NamedSign{"%", "\\%"},
                                NamedSign{"$", "\\symbol{36}"},
                                NamedSign{"#", "\\#"},
                                NamedSign{"_", "\\_"},
                                NamedSign{"~", "\\textasciitilde{}"},
                                NamedSign{"\"", "''"},
                                NamedSign{"“", "``"},
                                NamedSign{"”", "''"},
                                NamedSign{"„", ",,"},
                                NamedSign{"‘", "`"},
                                NamedSign{"’", "'"},
                                NamedSign{"«", "$\\ll$"},
                                NamedSign{"»", "$\\gg$"},
                                NamedSign{"–", "--"},
                                NamedSign{"—", "---"},
                                NamedSign{"\u2011", "-"},
                                NamedSign{"^", "\\textasciicircum{}"},
                                NamedSign{"\\", "\\textbackslash{}"},
                                NamedSign{"§", "\\S{}"},
                                NamedSign{"¶", "\\P{}"},
                                NamedSign{"†", "\\dag{}"},
                                NamedSign{"‡", "\\ddag{}"},
                                NamedSign{"©", "\\copyright{}"},
                                NamedSign{"£", "\\pounds{}"},
                                NamedSign{"\u00a0", "~"},
                                NamedSign{"\u2009", "\\,"},
                                NamedSign{"\u202f", "\\,"}};

/// Other names of the same signs.
constexpr std::array other_names{NamedSign{"≤", "\\leq"},        NamedSign{"≥", "\\geq"},
                                 NamedSign{"≠", "\\neq"},        NamedSign{"…", "\\ldots"},
                                 NamedSign{"…", "\\dotsc"},      NamedSign{"⋯", "\\dotsb"},
                                 NamedSign{"→", "\\rightarrow"}, NamedSign{"→", "\\longrightarrow"},
                                 NamedSign{"←", "\\gets"},       NamedSign{"↦", "\\longmapsto"},
                                 NamedSign{"⇒", "\\implies"},    NamedSign{"⇔", "\\iff"},
                                 NamedSign{"∧", "\\land"},       NamedSign{"∨", "\\lor"},
                                 NamedSign{"¬", "\\lnot"},       NamedSign{"ε", "\\varepsilon"},
                                 NamedSign{"φ", "\\varphi"},     NamedSign{"ϱ", "\\varrho"},
                                 NamedSign{"∅", "\\varnothing"}, NamedSign{"′", "\\prime"},
                                 NamedSign{"•", "\\bullet"},     NamedSign{"*", "\\ast"},
                                 NamedSign{":", "\\colon"},      NamedSign{"|", "\\mid"},
                                 NamedSign{"|", "\\vert"},       NamedSign{"|", "\\lvert"},
                                 NamedSign{"|", "\\rvert"},      NamedSign{"‖", "\\Vert"},
                                 NamedSign{"‖", "\\lVert"},      NamedSign{"‖", "\\rVert"}};

template <class Signs>
std::optional<std::string_view> sign_in(const Signs& signs, std::string_view name) {
    const auto* found = std::ranges::find_if(
        signs, [&](const NamedSign& sign) { return sign.name == name || sign.name == std::string(name) + ' '; });
    return found == signs.end() ? std::nullopt : std::optional(found->sign);
}

template <class Signs>
std::optional<std::string_view> name_in(const Signs& signs, std::string_view sign) {
    const auto* found = std::ranges::find(signs, sign, &NamedSign::sign);
    return found == signs.end() ? std::nullopt : std::optional(found->name);
}

}  // namespace

std::optional<std::string_view> math_sign(std::string_view sign) {
    if (const auto name = name_in(math_signs, sign)) return name;
    if (const auto name = name_in(fraction_signs, sign)) return name;
    return name_in(ascii_signs, sign);
}

std::optional<std::string_view> text_sign(std::string_view sign) {
    return name_in(text_signs, sign);
}

std::optional<std::string_view> sign_of_command(std::string_view command) {
    const std::string name = std::string(1, '\\').append(command);
    if (const auto sign = sign_in(other_names, name)) return sign;
    if (const auto sign = sign_in(math_signs, name)) return sign;
    if (const auto sign = sign_in(ascii_signs, name)) return sign;
    return sign_in(text_signs, name);
}

std::optional<std::string_view> blackboard_sign(char letter) {
    return sign_in(math_signs, std::string("\\mathbf{").append(1, letter).append(1, '}'));
}

std::optional<std::string_view> script_sign(char kind, std::string_view sign) {
    return sign_in(math_signs, std::string(1, kind).append(sign == "−" ? "-" : sign));
}

std::optional<std::string_view> fraction_sign(std::string_view upper, std::string_view lower) {
    return sign_in(fraction_signs,
                   std::string("\\frac{").append(upper).append(1, '}').append(1, '{').append(lower).append(1, '}'));
}

}  // namespace batten::render
