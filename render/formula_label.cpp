#include "render/formula_label.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "render/first_sign.h"
#include "render/tex_signs.h"

namespace batten::render {

namespace {

constexpr std::size_t most_depth = 40;  // of groups within groups, which are read one in another

/// What a sign is to those beside it.
enum class Role { ordinary, fraction, binary, relation, named, comma, opening, closing, space };

template <std::size_t Count>
bool is_among(const std::array<std::string_view, Count>& names, std::string_view name) {
    return std::ranges::find(names, name) != names.end();
}

constexpr std::array<std::string_view, 29> relations{"=", "<", ">", "≤", "≥", "≠", "≈", "≡", "≅", "∼",
                                                     "∝", "≪", "≫", "∈", "∉", "∋", "⊂", "⊃", "⊆", "⊇",
                                                     "→", "←", "↔", "↦", "⇒", "⇐", "⇔", "∥", "⊥"};
constexpr std::array<std::string_view, 14> binaries{"+", "−", "×", "÷", "±", "∓", "·",
                                                    "∪", "∩", "∧", "∨", "∘", "⊗", "⊕"};
constexpr std::array<std::string_view, 3> large_signs{"∑", "∏", "∫"};
constexpr std::array<std::string_view, 3> openings{"(", "[", "⟨"};
constexpr std::array<std::string_view, 3> closings{")", "]", "⟩"};
constexpr std::array<std::string_view, 3> commas{",", ";", ":"};

constexpr std::array<std::string_view, 24> functions{"sin",  "cos",  "tan", "cot", "arcsin", "arccos", "arctan", "sinh",
                                                     "cosh", "tanh", "exp", "log", "ln",     "lg",     "max",    "min",
                                                     "sup",  "inf",  "lim", "det", "dim",    "deg",    "ker",    "arg"};
constexpr std::array<std::string_view, 4> fractions{"frac", "tfrac", "dfrac", "cfrac"};
/// Fonts, which a title has one of.
constexpr std::array<std::string_view, 9> fonts{"mathrm", "mathbf",     "mathit",  "mathsf", "mathtt",
                                                "bm",     "boldsymbol", "mathcal", "mathscr"};
constexpr std::array<std::string_view, 6> texts{"text", "textrm", "textbf", "textit", "mbox", "mathnormal"};
constexpr std::array<std::string_view, 17> left_out{"left",   "right",    "big",          "Big",       "bigg",  "Bigg",
                                                    "bigl",   "bigr",     "Bigl",         "Bigr",      "biggl", "biggr",
                                                    "limits", "nolimits", "displaystyle", "textstyle", "!"};

struct Space {
    std::string_view command;
    std::string_view text;
};
constexpr std::array spaces{
    Space{",", "\u2009"}, Space{":", "\u2009"},    Space{">", "\u2009"},       Space{";", " "},
    Space{" ", " "},      Space{"quad", "\u2003"}, Space{"enspace", "\u2002"}, Space{"qquad", "\u2003\u2003"}};

Role role_of(std::string_view sign) {
    if (is_among(relations, sign)) return Role::relation;
    if (is_among(binaries, sign)) return Role::binary;
    if (is_among(large_signs, sign)) return Role::named;
    if (is_among(openings, sign)) return Role::opening;
    if (is_among(closings, sign)) return Role::closing;
    return is_among(commas, sign) ? Role::comma : Role::ordinary;
}

bool is_digit(char sign) {
    return '0' <= sign && sign <= '9';
}

/// Takes as many bytes off `rest` and returns them.
std::string_view take(std::string_view& rest, std::size_t size) {
    const std::string_view taken = rest.substr(0, size);
    rest.remove_prefix(taken.size());
    return taken;
}

void skip_blanks(std::string_view& rest) {
    while (rest.starts_with(' ')) rest.remove_prefix(1);
}

/// "\alpha" or "\," without the backslash; `rest` begins with one.
std::string_view take_command(std::string_view& rest) {
    rest.remove_prefix(1);
    std::size_t size = 0;
    while (size < rest.size() && is_letter(rest[size])) ++size;
    return take(rest, size > 0 ? size : first_sign(rest).size());
}

/// How many bytes a group has that begins with `open`, with its ends.
std::size_t group_size(std::string_view text, char open, char close) {
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\\') {
            ++i;
            continue;
        }
        depth += text[i] == open ? 1 : text[i] == close ? -1 : 0;
        if (depth == 0) return i + 1;
    }
    return text.size();
}

/// What stands in a group, which is taken with its ends.
std::string_view take_group(std::string_view& rest, char open, char close) {
    const std::string_view group = take(rest, group_size(rest, open, close));
    return group.size() < 2 ? std::string_view() : group.substr(1, group.size() - 2);
}

/// A group, a command or a sign.
std::string_view take_argument(std::string_view& rest) {
    skip_blanks(rest);
    if (rest.starts_with('{')) return take_group(rest, '{', '}');
    if (!rest.starts_with('\\')) return take(rest, first_sign(rest).size());
    std::string_view behind = rest;
    take_command(behind);
    return take(rest, rest.size() - behind.size());
}

/// Whether one pair of parentheses holds all of it.
bool is_in_parentheses(std::string_view text) {
    return text.starts_with('(') && group_size(text, '(', ')') == text.size();
}

/// What a formula, or a part of one, is on a line.
struct Line {
    std::string text;
    std::size_t atoms = 0;  ///< letters, numbers and signs, with their scripts
    bool is_sum = false;    ///< of what adds, compares or divides
};

std::string in_parentheses(std::string text) {
    if (is_in_parentheses(text)) return text;
    return text.insert(0, 1, '(').append(1, ')');
}

/// As one atom.
std::string whole(const Line& line) {
    return line.atoms > 1 || line.is_sum ? in_parentheses(line.text) : line.text;
}

/// Sets one group after another, each by a setter of its own.
class FormulaSetter {
  public:
    FormulaSetter(FormulaLabel& label, std::size_t depth, bool is_script)
        : label_(label), depth_(depth), is_script_(is_script) {}

    Line line_of(std::string_view formula) {
        if (depth_ > most_depth) return {std::string(formula), formula.size()};
        for (skip_blanks(formula); !formula.empty(); skip_blanks(formula)) set_first(formula);
        return std::move(line_);
    }

  private:
    /// What a fraction, a root, a font or a script is of.
    std::string_view argument(std::string_view& rest) {
        skip_blanks(rest);
        label_.is_whole = label_.is_whole && !rest.empty();
        return take_argument(rest);
    }

    void set_first(std::string_view& rest) {
        if (rest.starts_with('\\')) return set_command(take_command(rest), rest);
        if (rest.starts_with('{')) return add(inner(take_argument(rest)));
        const std::string_view sign = take(rest, first_sign(rest).size());
        if (sign == "_" || sign == "^") return set_script(sign.front(), argument(rest));
        if (sign == "-") return add("−", Role::binary);
        if (sign == "'") return attach("′");
        const bool goes_on = is_digit(sign.front()) && !line_.text.empty() && last_ == Role::ordinary &&
                             (is_digit(line_.text.back()) || line_.text.back() == '.');
        if (goes_on || sign == ".") return attach(sign);
        add(sign, role_of(sign));
    }

    Line inner(std::string_view formula) { return FormulaSetter(label_, depth_ + 1, is_script_).line_of(formula); }

    void set_command(std::string_view name, std::string_view& rest) {
        if (const auto* space = std::ranges::find(spaces, name, &Space::command); space != spaces.end())
            return add(space->text, Role::space);
        if (is_among(left_out, name)) return skip_size(rest);
        if (is_among(fractions, name)) return set_fraction(rest);
        if (name == "sqrt") return set_root(rest);
        if (name == "mathbb") return set_blackboard(argument(rest));
        if (is_among(fonts, name)) return add(inner(argument(rest)));
        if (is_among(texts, name)) return add(argument(rest), Role::ordinary);
        if (name == "operatorname") return add(inner(argument(rest)).text, Role::named);
        if (is_among(functions, name)) return add(name, Role::named);
        if (const auto sign = sign_of_command(name)) return add(*sign, role_of(*sign));
        set_unknown(name, rest);
    }

    /// "\left." stands for no sign.
    static void skip_size(std::string_view& rest) {
        if (rest.starts_with('.')) rest.remove_prefix(1);
    }

    void set_unknown(std::string_view name, std::string_view& rest) {
        std::string text = "\\";
        label_.unknown.push_back(text += name);
        while (rest.starts_with('{')) text.append(1, '{').append(inner(take_argument(rest)).text).append(1, '}');
        add(text, Role::fraction);
    }

    void set_fraction(std::string_view& rest) {
        const Line upper = inner(argument(rest));
        const Line lower = inner(argument(rest));
        if (const auto sign = fraction_sign(upper.text, lower.text)) return add(*sign, Role::ordinary);
        std::string text = upper.is_sum ? in_parentheses(upper.text) : upper.text;
        text.append(1, '/').append(whole(lower));
        add(text, Role::fraction);
    }

    void set_root(std::string_view& rest) {
        skip_blanks(rest);
        const std::string_view index = rest.starts_with('[') ? take_group(rest, '[', ']') : std::string_view();
        const Line root = inner(argument(rest));
        add("", Role::ordinary);
        if (!index.empty()) set_script('^', index);
        attach("√");
        attach(whole(root));
        last_ = Role::fraction;  // ends where what follows is apart
        has_power_ = false;
    }

    void set_blackboard(std::string_view letters) {
        for (; !letters.empty(); letters.remove_prefix(1))
            add(blackboard_sign(letters.front()).value_or(letters.substr(0, 1)), Role::ordinary);
    }

    /// Labels have scripts of one level: of those within them only what there are small signs for.
    void set_script(char kind, std::string_view formula) {
        const Line script = FormulaSetter(label_, depth_ + 1, true).line_of(formula);
        bool& has_script = kind == '^' ? has_power_ : has_index_;
        label_.is_whole = label_.is_whole && !has_script;
        has_script = true;
        if (script.text.empty()) return;
        if (kind == '^' && script.text == "∘") return attach("°");
        if (!is_script_) return attach(std::string(1, kind).append(1, '{').append(script.text).append(1, '}'));
        std::string small;
        for (std::string_view rest = script.text; !rest.empty();) {
            const auto sign = script_sign(kind, take(rest, first_sign(rest).size()));
            if (!sign) return set_unknown_script(kind, script.text);
            small += *sign;
        }
        attach(small);
    }

    void set_unknown_script(char kind, const std::string& script) {
        const std::string typed = std::string(1, kind) + script;
        label_.unknown.push_back(typed);
        attach(typed);
    }

    /// To what stands last.
    void attach(std::string_view text) {
        if (line_.atoms == 0) add("", Role::ordinary);
        line_.text += text;
    }

    void add(const Line& line) {
        if (line.atoms == 0) return;
        add(line.text, Role::ordinary);
        line_.atoms += line.atoms - 1;
        line_.is_sum = line_.is_sum || line.is_sum;
    }

    void add(std::string_view text, Role role) {
        const bool follows_operand =
            line_.atoms > 0 && (last_ == Role::ordinary || last_ == Role::fraction || last_ == Role::closing);
        if (role == Role::binary && !follows_operand) role = Role::ordinary;  // a sign before a number
        if (!is_script_ && line_.atoms > 0 && is_apart(role)) line_.text += ' ';
        line_.text += text;
        line_.is_sum =
            line_.is_sum || role == Role::binary || role == Role::relation || role == Role::fraction || text == "/";
        ++line_.atoms;
        last_ = role;
        has_index_ = has_power_ = false;
    }

    /// Whether what has this role has a blank before it.
    bool is_apart(Role role) const {
        if (last_ == Role::space || role == Role::space || role == Role::comma || role == Role::closing) return false;
        if (last_ == Role::opening) return false;
        if (last_ == Role::named) return role != Role::opening;
        const auto is_wide = [](Role r) { return r == Role::binary || r == Role::relation || r == Role::fraction; };
        return is_wide(role) || is_wide(last_) || role == Role::named || last_ == Role::comma;
    }

    FormulaLabel& label_;
    std::size_t depth_;
    bool is_script_;
    Line line_;
    Role last_ = Role::ordinary;
    bool has_index_ = false;  ///< what stands last
    bool has_power_ = false;
};

}  // namespace

FormulaLabel formula_label(std::string_view formula) {
    FormulaLabel label;
    label.text = FormulaSetter(label, 0, false).line_of(formula).text;
    return label;
}

}  // namespace batten::render
