// Formulas as Unicode text and as MathML.
#include "core/text/formula.h"

#include <string_view>

namespace covaria {

namespace {

using K = Formula::Kind;

/// A single thing, which needs no parentheses in a quotient written on one line.
bool is_simple(const Formula& f) {
    if (f.kind == K::row)
        return f.parts.size() == 1
                   ? is_simple(f.parts.front())
                   : f.parts.size() == 2 && f.parts[0].kind == K::word && f.parts[1].kind == K::fence;
    return f.kind != K::fraction && !(f.kind == K::number && f.text.find("\u00a0") != std::string::npos);
}

std::string in_line(const Formula& f) {
    return is_simple(f) ? to_unicode(f) : "(" + to_unicode(f) + ")";
}

std::string raised(const Formula& exponent) {
    return unicode_superscripts(to_unicode(exponent)).value_or("^" + in_line(exponent));
}

std::string sign_text(const std::string& sign) {
    if (sign == "·") return "·";
    return sign == "," || sign == ";" ? sign + " " : " " + sign + " ";
}

std::string row_text(const Formula& f) {
    std::string text;
    for (std::size_t i = 0; i < f.parts.size(); ++i) {
        const Formula& part = f.parts[i];
        const bool leading = i == 0 || f.parts[i - 1].kind == K::sign;
        if (part.kind == K::sign)
            text += part.text == "−" && leading ? part.text : sign_text(part.text);
        else
            text += to_unicode(part);
    }
    return text;
}

std::string element(const char* tag, const std::string& inside) {
    return "<" + std::string(tag) + ">" + inside + "</" + tag + ">";
}

/// MathML of a script: a single letter is italic by itself there, and several are upright.
std::string script_element(const std::string& script) {
    std::vector<std::string> elements;
    for (const ScriptPart& part : script_parts(script)) {
        const std::string_view letters = part.letters;
        const bool is_capital = letters.size() == 1 && letters[0] >= 'A' && letters[0] <= 'Z';
        if (is_capital)
            elements.push_back("<mi mathvariant=\"normal\">" + part.letters + "</mi>");
        else if (!part.italic)
            elements.push_back(element("mi", escape_html(letters)));
        else
            for (std::size_t at = 0; at < letters.size(); at += character_length(letters.substr(at)))
                elements.push_back(
                    element("mi", escape_html(letters.substr(at, character_length(letters.substr(at))))));
    }
    if (elements.size() == 1) return elements.front();
    std::string row;
    for (const std::string& each : elements) row += each;
    return element("mrow", row);
}

/// The base with its scripts.
std::string symbol_element(const Symbol& symbol) {
    const std::string base = element("mi", escape_html(symbol.base));
    const std::string below = script_element(symbol.subscript), above = script_element(symbol.superscript);
    if (symbol.subscript.empty()) return symbol.superscript.empty() ? base : element("msup", base + above);
    return symbol.superscript.empty() ? element("msub", base + below)
                                      : element("msubsup", base + below + above);
}

std::string parts_of(const Formula& f);

std::string mathml(const Formula& f) {
    switch (f.kind) {
        case K::symbol:
            return symbol_element(f.symbol);
        case K::number:
            return element("mn", escape_html(f.text));
        case K::word:
            return element(f.text.find(' ') == std::string::npos ? "mi" : "mtext", escape_html(f.text));
        case K::sign:
            return element("mo", escape_html(f.text));
        case K::row:
            return element("mrow", parts_of(f));
        case K::fraction:
            return element("mfrac", parts_of(f));
        case K::power:
            return element("msup", parts_of(f));
        case K::root:
            if (f.text.empty()) return element("msqrt", parts_of(f));
            return element("mroot", parts_of(f) + element("mn", f.text));
        case K::fence:
            return element("mrow",
                           element("mo", f.text) + parts_of(f) + element("mo", f.text == "(" ? ")" : "|"));
    }
    return {};
}

std::string parts_of(const Formula& f) {
    std::string text;
    for (const Formula& part : f.parts) text += mathml(part);
    return text;
}

}  // namespace

Formula with_numbers(Formula formula, const NumberLocale& numbers) {
    if (formula.kind == K::number) formula.text = grouped_digits(formula.text, numbers);
    if (formula.kind == K::sign && formula.text == "," && numbers.decimal == ",") formula.text = ";";
    for (Formula& part : formula.parts) part = with_numbers(std::move(part), numbers);
    return formula;
}

std::string to_unicode(const Formula& f) {
    switch (f.kind) {
        case K::symbol:
            return to_unicode(to_text(f.symbol));
        case K::row:
            return row_text(f);
        case K::fraction:
            return in_line(f.parts[0]) + "/" + in_line(f.parts[1]);
        case K::power:
            return to_unicode(f.parts[0]) + raised(f.parts[1]);
        case K::root:
            return (f.text.empty() ? "√" : "∛") + std::string("(") + to_unicode(f.parts[0]) + ")";
        case K::fence:
            return f.text + to_unicode(f.parts[0]) + (f.text == "(" ? ")" : "|");
        default:
            return f.text;
    }
}

std::string to_mathml(const Formula& formula) {
    return "<math xmlns=\"http://www.w3.org/1998/Math/MathML\" display=\"block\">" + mathml(formula) +
           "</math>";
}

}  // namespace covaria
