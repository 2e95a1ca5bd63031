// Formulas as Unicode text and as MathML.
#include <algorithm>
#include <array>
#include <string_view>

#include "core/base/symbol.h"
#include "core/equation/typeset.h"

namespace covaria::equation {

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
    static constexpr std::array<std::string_view, 10> digits{"⁰", "¹", "²", "³", "⁴",
                                                             "⁵", "⁶", "⁷", "⁸", "⁹"};
    const std::string text = to_unicode(exponent);
    std::string above;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] >= '0' && text[i] <= '9')
            above += digits[static_cast<std::size_t>(text[i] - '0')];
        else if (text.substr(i, 3) == "−")
            above += "⁻", i += 2;
        else
            return "^" + in_line(exponent);
    }
    return above;
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

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else
            out += c;
    }
    return out;
}

std::string element(const char* tag, const std::string& inside) {
    return "<" + std::string(tag) + ">" + inside + "</" + tag + ">";
}

/// "alpha_s" with its subscript.
std::string symbol_element(const std::string& name) {
    const std::size_t at = std::min(name.find('_', 1), name.size());
    const std::string base = element("mi", escaped(symbol_to_unicode(name.substr(0, at))));
    if (at >= name.size() - 1) return base;
    std::string below = name.substr(at + 1);
    std::replace(below.begin(), below.end(), '_', ',');
    return element("msub", base + element("mi", escaped(symbol_to_unicode(below))));
}

std::string parts_of(const Formula& f);

std::string mathml(const Formula& f) {
    switch (f.kind) {
        case K::symbol:
            return symbol_element(f.text);
        case K::number:
            return element("mn", escaped(f.text));
        case K::word:
            return element(f.text.find(' ') == std::string::npos ? "mi" : "mtext", escaped(f.text));
        case K::sign:
            return element("mo", escaped(f.text));
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

std::string to_unicode(const Formula& f) {
    switch (f.kind) {
        case K::symbol:
            return symbol_to_unicode(f.text);
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

}  // namespace covaria::equation
