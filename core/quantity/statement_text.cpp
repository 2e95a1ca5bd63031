// Words, figures and units, one after the other.
#include "core/quantity/statement_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/base/temperature.h"
#include "core/quantity/statement.h"
#include "core/text/digit_groups.h"
#include "core/text/numbers.h"

namespace covaria {

namespace {

/// Notation of a kind: the first word is the one that is written.
struct Notation {
    std::string_view kind;
    std::vector<std::string_view> words;
    std::string_view before_a = {};  ///< written between the word and the first figure
    std::string_view second = {};    ///< name of the second figure
    int figures = 1;                 ///< largest number of figures
    int needed = 1;
    bool has_unit = true;         ///< the first
    std::string_view first = {};  ///< name of the first figure, where it tells the kind from another one
};

const std::vector<Notation>& notations() {
    static const std::vector<Notation> all{
        {"standard", {"u", "standard", "std"}, "= "},
        {"standard-deviation", {"s"}, "= ", "n", 2, 1},
        {"certificate-k", {"U", "certificate", "cert"}, "= ", "k", 2, 2},
        {"certificate-p", {"U", "certificate", "cert"}, "= ", "p", 2, 2},
        {"rectangular", {"rectangular", "rect", "uniform", "±"}, "± "},
        {"triangular", {"triangular", "tri"}, "± "},
        {"arcsine", {"arcsine", "arc", "u-shaped"}, "± "},
        {"trapezoidal", {"trapezoidal", "trap"}, "± ", "ratio", 2, 2},
        {"curvilinear-trapezoid", {"curvilinear", "ctrap"}, "± ", "inexactness", 2, 2},
        {"limits", {"limits", "between"}, "", "to", 2, 2},
        {"resolution", {"resolution", "res", "digit"}},
        {"mpe", {"MPE"}, "± ", "+", 2, 1},
        {"exponential", {"exponential", "exp"}, "", "", 0, 0},
        {"counts", {"counts"}, "", "", 1, 1, false},
        {"weibull", {"Weibull"}, "scale ", "shape", 2, 2, true, "scale"},
        {"weibull-deviation", {"Weibull"}},
        {"laplace-scale", {"Laplace"}, "scale ", "", 1, 1, true, "scale"},
        {"laplace", {"Laplace"}},
        {"poisson", {"Poisson"}, "", "", 1, 0, false},
        {"binomial", {"binomial"}, "n = ", "p", 2, 1, false, "n"},
        {"sample", {"sample", "empirical"}, "", "weights", 0, 0},
        {"histogram", {"histogram", "hist"}, "", "weights", 0, 0},
        {"observations", {"observations", "obs"}, "", "", 0, 0},
        {"pooled", {"pooled"}, "", "", 1, 0, false},
        {"constant", {"constant", "const", "exact"}, "", "", 0, 0}};
    return all;
}

/// Letters, abbreviations (u, U, k, p, MPE) and names of people are the same in every language.
bool is_translated(std::string_view word) {
    return word.size() > 1 && word != "MPE" && word != "Laplace" && word != "Weibull" && word != "Poisson";
}

tl::unexpected<Error> not_read(Message message) {
    return fail(ErrorCode::bad_input, std::move(message));
}

std::string lower(std::string_view text) {
    std::string out(text);
    std::transform(out.begin(), out.end(), out.begin(),
                   [](unsigned char c) { return static_cast<char>(c < 128 ? std::tolower(c) : c); });
    return out;
}

/// u and U, k and K are different things; longer words are not.
bool same_word(std::string_view a, std::string_view b) {
    return a.size() == 1 || b.size() == 1 ? a == b : lower(a) == lower(b);
}

struct Token {
    std::string text;
    std::optional<double> number = {};
};

/// "75nm, k=2" -> 75, nm, k, 2. With `groups`, digits may stand in groups of three: "0.000 25 mA".
class Tokens {
public:
    Tokens(std::string_view text, bool decimal_comma, bool groups) : comma_(decimal_comma), groups_(groups) {
        for (at_ = 0; at_ < text.size();) step(text);
    }
    const Token* next() { return given_ < all_.size() ? &all_[given_++] : nullptr; }
    const Token* peek() const { return given_ < all_.size() ? &all_[given_] : nullptr; }

private:
    static bool is_digit(char c) { return c >= '0' && c <= '9'; }
    bool is_point(char c) const { return c == '.' || (comma_ && c == ','); }

    void step(std::string_view text) {
        const std::string_view rest = text.substr(at_);
        for (const std::string_view sign : {"±", "+/-", "+-"})
            if (rest.starts_with(sign)) return take("±", sign.size());
        if (rest.starts_with("\u2212")) return take("-", std::string_view("\u2212").size());
        const bool unit_of_figure = rest.starts_with("1/") && !all_.empty() && all_.back().number;
        if (unit_of_figure) return take_word(rest);
        if (is_digit(rest[0]) || (rest.size() > 1 && is_point(rest[0]) && is_digit(rest[1])))
            return number(rest);
        if (std::string_view(" \t=;,:").find(rest[0]) != std::string_view::npos) {
            ++at_;
            return;
        }
        if (rest[0] == '+' || rest[0] == '-') return take(rest.substr(0, 1), 1);
        take_word(rest);
    }

    void take_word(std::string_view rest) {
        std::size_t length = 1;
        while (length < rest.size() &&
               std::string_view(" \t=;,:").find(rest[length]) == std::string_view::npos)
            ++length;
        take(rest.substr(0, length), length);
    }

    void take(std::string_view word, std::size_t length) {
        all_.push_back({std::string(word)});
        at_ += length;
    }

    void number(std::string_view rest) {
        bool point = false;
        std::size_t length = groups_ ? length_in_groups(rest) : 0;
        if (!comma_ && rest.substr(0, length).find(',') != std::string_view::npos) length = 0;
        const bool is_plain = length == 0;
        while (is_plain && length < rest.size() &&
               (is_digit(rest[length]) || (is_point(rest[length]) && !point))) {
            point = point || is_point(rest[length]);
            ++length;
        }
        if (length < rest.size() && (rest[length] == 'e' || rest[length] == 'E')) {
            std::size_t end = length + 1;
            if (end < rest.size() && (rest[end] == '+' || rest[end] == '-')) ++end;
            if (end < rest.size() && is_digit(rest[end])) {
                while (end < rest.size() && is_digit(rest[end])) ++end;
                length = end;
            }
        }
        std::string digits = without_group_spaces(rest.substr(0, length));
        std::replace(digits.begin(), digits.end(), ',', '.');
        double value = 0.0;
        const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        const bool minus = !all_.empty() && all_.back().text == "-";
        const bool good =
            status == std::errc() && end == digits.data() + digits.size() && std::isfinite(value);
        if (minus) all_.pop_back();
        at_ += length;
        all_.push_back({std::string(rest.substr(0, length)),
                        good ? std::optional(minus ? -value : value) : std::nullopt});
    }

    bool comma_, groups_;
    std::size_t at_ = 0, given_ = 0;
    std::vector<Token> all_;
};

/// The first word may be shortened to three letters; the others stand between spaces or at the end.
std::string in_english(std::string_view text, const WordOf& word) {
    const std::string typed = lower(text.substr(std::min(text.find_first_not_of(' '), text.size())));
    const std::string first = typed.substr(0, typed.find_first_of(" \t0123456789.,+-=\xc2"));
    std::string english(text), found;
    std::size_t length = 0;
    for (const std::string& known : statement_words()) {
        const std::string other = lower(word(known));
        if (typed.starts_with(other) && other.size() > length) {
            length = other.size();
            found = known;
        }
        if (length == 0 && first.size() >= 3 && other.starts_with(first)) {
            length = first.size();
            found = known;
        }
        const std::string between = " " + other + " ";
        if (const std::size_t at = lower(english + " ").find(between); at != std::string::npos)
            english.replace(at, between.size(), " " + known + " ");
    }
    if (found.empty()) return english;
    const std::size_t begin = english.find_first_not_of(' ');
    return english.replace(begin, length, found + " ");
}

/// A figure and the words behind it: its unit, if it has one.
struct Figure {
    double value = 0.0;
    std::optional<Unit> unit = {};
};

class StatementReader {
public:
    StatementReader(std::string_view text, const Unit& unit, bool decimal_comma, bool groups)
        : tokens_(text, decimal_comma, groups), unit_(unit) {}

    Result<TypedStatement> run() {
        if (!tokens_.peek()) return TypedStatement{};
        if (!tokens_.peek()->number) word_ = tokens_.next()->text;
        if (auto read = figures(); !read) return fail(read.error());
        return statement();
    }

private:
    Result<void> figures() {
        while (const Token* token = tokens_.next()) {
            if (token->text == "±") continue;
            if (token->number) {
                auto found = figure(*token->number);
                if (!found) return fail(found.error());
                (weighted_ ? weights_ : figures_).push_back(*found);
            } else if ((word_.empty() || word_ == "±") && is_notation_word(token->text)) {
                word_ = token->text;
            } else if (auto read = named(token->text); !read) {
                return read;
            }
        }
        return {};
    }

    Result<Figure> figure(double value) {
        Figure figure{value};
        const Token* behind = tokens_.peek();
        if (!behind || behind->number || is_name(behind->text) || is_notation_word(behind->text))
            return figure;
        const auto unit = Unit::parse(behind->text);
        if (!unit) return fail(unit.error());
        tokens_.next();
        figure.unit = *unit;
        return figure;
    }

    static bool is_name(std::string_view word) {
        static constexpr std::array<std::string_view, 15> names{
            "k",   "p",     "n",           "nu", "ν",     "nu_eff", "to",     "..",
            "and", "ratio", "inexactness", "+",  "scale", "shape",  "weights"};
        return word == "±" || std::find(names.begin(), names.end(), word) != names.end();
    }

    /// Whether a word may follow the figures, where a letter is a unit: "0.01 % rectangular", but "3 s".
    static bool is_notation_word(std::string_view text) {
        if (text.size() < 3) return false;
        const auto& all = notations();
        return std::any_of(all.begin(), all.end(), [&](const Notation& notation) {
            return std::any_of(notation.words.begin(), notation.words.end(),
                               [&](std::string_view word) { return same_word(word, text); });
        });
    }

    Result<void> named(const std::string& name) {
        if (!is_name(name)) return not_read(tell<"'%1' is not understood here">(name));
        if (name == "weights" && !weighted_) {
            weighted_ = true;
            return {};
        }
        const Token* token = tokens_.next();
        if (!token || !token->number) return not_read(tell<"a number is missing after '%1'">(name));
        auto found = figure(*token->number);
        if (!found) return fail(found.error());
        if (name == "nu" || name == "ν" || name == "nu_eff") {
            degrees_of_freedom_ = found->value;
            return {};
        }
        const bool is_first = figures_.empty() && (name == "n" || name == "scale");
        if (is_first)
            first_ = name;
        else if (name == "k" || name == "p" || name == "n" || name == "ratio" || name == "inexactness" ||
                 name == "shape")
            second_ = name;
        if (name == "to" || name == "..") joined_ = true;
        figures_.push_back(*found);
        return {};
    }

    Result<TypedStatement> statement() {
        const Notation* notation = find();
        const bool is_list = notation && (notation->kind == "observations" || notation->second == "weights");
        if (is_list && (!figures_.empty() || weighted_)) return observed(*notation);
        if (!notation)
            return not_read(
                tell<"'%1' is no way to state an uncertainty. For example: 75 nm; U = 0.3 um, k = 2; "
                     "rectangular 0.5; resolution 0.01; constant">(word_));
        const int count = static_cast<int>(figures_.size());
        if (count > notation->figures)
            return not_read(notation->figures == 1
                                ? tell<"%1 has %2 figure">(notation->kind, notation->figures)
                                : tell<"%1 has %2 figures">(notation->kind, notation->figures));
        if (count < notation->needed)
            return not_read(
                notation->second == "k" || notation->second == "p"
                    ? tell<"a figure is missing: an expanded uncertainty needs k = ... or p = ... %">()
                    : tell<"a figure is missing: it is noted as %1">(example(*notation)));
        for (const auto& [given, known] : {std::pair(first_, notation->first), {second_, notation->second}})
            if (!given.empty() && given != known)
                return not_read(tell<"'%1' is no part of it: it is noted as %2">(given, example(*notation)));
        if (weighted_)
            return not_read(tell<"'%1' is no part of it: it is noted as %2">("weights", example(*notation)));
        TypedStatement made{std::string(notation->kind), {}, {}, degrees_of_freedom_};
        if (count == 0) return made;
        const Result<Unit> stated = stated_unit(*notation);
        if (!stated) return fail(stated.error());
        if (!(*stated == row_unit(*notation))) made.unit = stated->text();
        made.a = figures_[0].value;
        if (count == 1) return made;
        auto b = second(*notation, *stated);
        if (!b) return fail(b.error());
        made.b = *b;
        return made;
    }

    /// A unit behind the last one is that of all before it that have none.
    Result<TypedStatement> observed(const Notation& notation) const {
        TypedStatement made{std::string(notation.kind), {}, {}, degrees_of_freedom_};
        if (weighted_ && notation.second != "weights")
            return not_read(tell<"observations have no weights: for values with weights write sample 1; 2; 3 "
                                 "weights 2; 5; 2">());
        for (const Figure& weight : weights_) {
            if (weight.unit && weight.unit->text() != "%") return not_read(tell<"weights have no unit">());
            made.weights.push_back(weight.value);
        }
        const std::size_t cells = notation.kind == "histogram" ? 1 : 0;  // one edge more
        if (weighted_ && made.weights.size() + cells != figures_.size())
            return not_read(cells == 1 ? tell<"a histogram has one edge more than weights: histogram 0; 1; 2 "
                                              "weights 5; 8">()
                                       : tell<"there must be as many weights as values">());
        if (!weighted_ && cells == 1)
            return not_read(tell<"the weights of the cells are missing: histogram 0; 1; 2 weights 5; 8">());
        for (const Figure& figure : figures_) {
            const Unit& unit = figure.unit            ? *figure.unit
                               : figures_.back().unit ? *figures_.back().unit
                                                      : unit_;
            if (unit.dimension() != unit_.dimension()) return not_read(other_dimension(unit));
            if (const Message objection = reading_objection(unit, unit_); !objection.empty())
                return not_read(objection);
            made.observations.push_back(unit == unit_ ? figure.value
                                                      : clean(unit_.from_si(unit.to_si(figure.value))));
        }
        return made;
    }

    /// Finds the notation by its word, and that of U by what is said of it.
    const Notation* find() const {
        if (word_.empty())  // "75 nm, k = 2" is what a certificate says
            return of_kind(figures_.size() > 2 && second_.empty() && !joined_ ? "observations"
                           : joined_                                          ? "limits"
                           : second_ == "k"                                   ? "certificate-k"
                           : second_ == "p"                                   ? "certificate-p"
                           : second_ == "n"                                   ? "standard-deviation"
                                                                              : "standard");
        for (const Notation& notation : notations()) {
            const bool named = std::any_of(notation.words.begin(), notation.words.end(),
                                           [&](std::string_view word) { return same_word(word, word_); }) ||
                               lower(word_) == notation.kind;
            if (!named) continue;
            const bool percent = figures_.size() > 1 && figures_[1].unit && figures_[1].unit->text() == "%";
            if (notation.kind == "certificate-k" && (second_ == "p" || (second_.empty() && percent)))
                continue;
            // Kinds with one word are told apart by the name of the first figure.
            if (notation.first == "scale" && first_ != notation.first && second_ != "shape") continue;
            return &notation;
        }
        return nullptr;
    }
    static const Notation* of_kind(std::string_view kind) {
        const auto& all = notations();
        return &*std::find_if(all.begin(), all.end(), [&](const Notation& n) { return n.kind == kind; });
    }

    /// Limits are values on the row's scale, the others are intervals.
    Unit row_unit(const Notation& notation) const {
        return notation.kind == "limits" ? unit_ : unit_.interval();
    }

    /// Unit of the first figure; for limits, noted as "1 to 2 mm", also that of the second.
    Result<Unit> stated_unit(const Notation& notation) const {
        const bool limits = notation.kind == "limits";
        const std::optional<Unit> typed = limits && !figures_[0].unit ? figures_[1].unit : figures_[0].unit;
        if (!typed) return row_unit(notation);
        if (!notation.has_unit) return not_read(tell<"it has no unit">());
        const Unit unit = limits ? *typed : typed->interval();
        const bool part_of_value = is_part_of_estimate(unit, unit_) && !limits;
        if (unit.dimension() != unit_.dimension() && !part_of_value) return not_read(other_dimension(unit));
        if (const Message objection = reading_objection(unit, unit_); limits && !objection.empty())
            return not_read(objection);
        return unit;
    }

    Result<double> second(const Notation& notation, const Unit& stated) const {
        const Figure& b = figures_[1];
        if (notation.kind == "limits" || notation.second == "inexactness") {
            if (!b.unit) return b.value;
            const bool limits = notation.kind == "limits";
            const Unit unit = limits ? *b.unit : b.unit->interval();
            if (unit == stated) return b.value;
            if (unit.dimension() != stated.dimension()) return not_read(other_dimension(unit));
            return clean(limits ? stated.from_si(unit.to_si(b.value))
                                : stated.interval_from_si(unit.interval_to_si(b.value)));
        }
        const bool per_cent = notation.second == "p" || notation.second == "+";
        if (b.unit && !(per_cent && b.unit->text() == "%"))
            return not_read(per_cent ? tell<"the second figure has no unit but %">()
                                     : tell<"the second figure has no unit">());
        if (notation.second == "+" && !b.unit)
            return not_read(tell<"the further part is one in %: write MPE 3 + 0.1 %">());
        if (notation.second == "n" && second_.empty())
            return not_read(tell<"a figure is missing: it is noted as %1">(example(notation)));
        if (notation.kind == "binomial" && !b.unit) {
            if (second_.empty() || !(b.value >= 0.0 && b.value <= 1.0))
                return not_read(tell<"write the probability as p = 0.02 or p = 2 %">());
            return clean(100.0 * b.value);
        }
        // An expanded uncertainty with two bare figures says neither k nor p.
        if ((notation.second == "k") && second_.empty())
            return not_read(tell<"say which it is: k = ... or p = ... %">());
        return b.value;
    }

    Message other_dimension(const Unit& unit) const {
        return tell<"%1 is no unit for a quantity in %2">(unit.display(), unit_.display());
    }
    /// Without the last digit's noise of a conversion.
    static double clean(double value) {
        std::array<char, 32> text{};
        const auto end =
            std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, 14)
                .ptr;
        double out = value;
        std::from_chars(text.data(), end, out);
        return out;
    }
    static std::string example(const Notation& notation) {
        const auto number = [](double value) { return std::to_string(static_cast<int>(value)); };
        TypedStatement shown{std::string(notation.kind), {}, {}, {}};
        if (notation.figures > 0) shown.a = 1.0;
        if (notation.figures > 1) shown.b = notation.second == "p" ? 95.0 : 2.0;
        return statement_text(shown, Unit(), number);
    }

    Tokens tokens_;
    const Unit& unit_;
    std::string word_, first_, second_;
    bool joined_ = false;    ///< "1 to 2"
    bool weighted_ = false;  ///< the figures that follow are weights
    std::vector<Figure> figures_, weights_;
    std::optional<double> degrees_of_freedom_;
};

}  // namespace

Result<TypedStatement> read_statement(std::string_view text, const Unit& unit, bool decimal_comma,
                                      const WordOf& word) {
    const std::string english = word ? in_english(text, word) : std::string(text);
    const auto read_with = [&](bool groups) {
        return StatementReader(english, unit, decimal_comma, groups).run();
    };
    // Blanks can only part groups between semicolons. Else figures in groups are what makes no sense as
    // several, if a word or a unit says what they are: "100 101" alone may be two readings.
    if (english.find(';') != std::string::npos)
        if (auto read = read_with(true)) return read;
    auto read = read_with(false);
    const bool has_words =
        std::ranges::any_of(english, [](unsigned char c) { return c >= 128 || std::isalpha(c) || c == '%'; });
    if (read || !has_words) return read;
    auto grouped = read_with(true);
    return grouped ? grouped : read;
}

std::vector<std::string> statement_words() {
    std::vector<std::string> words;
    for (const Notation& notation : notations())
        for (const std::string_view word : {notation.words.front(), notation.first, notation.second})
            if (is_translated(word)) words.emplace_back(word);
    return words;
}

std::string statement_text(const TypedStatement& statement, const Unit& row_unit,
                           const std::function<std::string(double)>& number, const WordOf& word) {
    const Unit unit = statement.unit.empty() ? row_unit : Unit::parse(statement.unit).value_or(row_unit);
    const auto say = [&](std::string_view english) {
        return word && is_translated(english) ? word(std::string(english)) : std::string(english);
    };
    for (const Notation& notation : notations()) {
        if (notation.kind != statement.kind) continue;
        const auto in_unit = [&](double figure, const Unit& of) {
            const std::string behind = unit_after_number(of);
            const bool has_space = behind.starts_with("\u00a0");  // one that can be typed
            return number(figure) + (has_space ? " " + of.display() : behind);
        };
        std::string text = say(notation.words.front());
        for (std::size_t i = 0; i < statement.observations.size(); ++i)
            text += (i == 0 ? " " : "; ") + number(statement.observations[i]);
        for (std::size_t i = 0; i < statement.weights.size(); ++i)
            text += (i == 0 ? " " + say("weights") + " " : "; ") + number(statement.weights[i]);
        const bool limits = notation.kind == "limits";
        if (statement.a) {
            text += ' ';
            text += notation.first.size() > 1 ? say(notation.first) + " " : std::string(notation.before_a);
            text +=
                notation.has_unit && !limits ? in_unit(*statement.a, unit.interval()) : number(*statement.a);
        }
        if (!statement.b) return text;
        if (limits) return text + " " + say("to") + " " + in_unit(*statement.b, unit);
        if (notation.second == "+") return text + " + " + number(*statement.b) + " %";
        text += ", " + say(notation.second) + " ";
        if (notation.second == "k" || notation.second == "n") return text + "= " + number(*statement.b);
        if (notation.second == "p") return text + "= " + number(*statement.b) + " %";
        return text + (notation.second == "inexactness" ? in_unit(*statement.b, unit.interval())
                                                        : number(*statement.b));
    }
    return statement.kind;
}

std::string statement_examples() {
    return "75 nm: standard uncertainty\n"
           "2 ppm: standard uncertainty, a part of the value; absolute where the quantity is a ratio itself\n"
           "U = 0.3 um, k = 2 (or p = 95 %): certificate\n"
           "s = 13 nm, n = 5: standard deviation known before, mean of n observations (Type A)\n"
           "rectangular 0.5 (or rect, ±): limits about the value; likewise triangular, arcsine\n"
           "limits 19.5 to 20.5: they give the value\n"
           "10.1; 10.3; 10.2: observations\n"
           "resolution 0.01, MPE 3 + 0.1 %, counts 12, constant\n"
           "Laplace 0.3, Weibull 0.3 (standard deviations), Weibull scale 2, shape 1.5\n"
           "Poisson 12, binomial n = 50, p = 2 %: they give the value\n"
           "sample 1; 2; 3 weights 2; 5; 2 (drawn as they are), histogram 0; 1; 2 weights 5; 8 (edges)\n"
           "nu 18 behind any of them: degrees of freedom";
}

}  // namespace covaria
