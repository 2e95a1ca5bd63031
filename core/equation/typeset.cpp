// Formulas made from nodes.
#include "core/equation/typeset.h"

#include <algorithm>
#include <array>

#include "core/text/numbers.h"

namespace covaria::equation {

namespace {

using O = Operation;
using K = Formula::Kind;

constexpr std::size_t most_nodes = 400;  // of one statement; deeper trees are no formula that people read

/// Strength with which the outermost operation binds.
enum Binding { loose, comparing, adding, multiplying, signing, raising, tight };

struct Built {
    Formula formula;
    Binding binding = tight;
};

Formula symbol(std::string_view name) {
    return Formula::of_symbol(parse_symbol(name));
}

Formula fence(Formula inside, std::string text = "(") {
    Formula f = Formula::leaf(K::fence, std::move(text));
    f.parts.push_back(std::move(inside));
    return f;
}

Formula two(K kind, Formula first, Formula second) {
    Formula f = Formula::leaf(kind, {});
    f.parts.push_back(std::move(first));
    f.parts.push_back(std::move(second));
    return f;
}

/// The formula, in parentheses where it binds less than `needed`.
Formula bound(Built built, Binding needed) {
    if (built.binding >= needed) return std::move(built.formula);
    return fence(std::move(built.formula));
}

/// A sum of sums is one row.
void append(std::vector<Formula>& parts, Formula f) {
    if (f.kind != K::row) return parts.push_back(std::move(f));
    for (Formula& part : f.parts) parts.push_back(std::move(part));
}

Built joined(Built a, const char* sign, Built b, Binding binding) {
    std::vector<Formula> parts;
    append(parts, bound(std::move(a), binding));
    parts.push_back(Formula::leaf(K::sign, sign));
    append(parts, bound(std::move(b), static_cast<Binding>(binding + 1)));
    return {Formula::row(std::move(parts)), binding};
}

Built call(std::string name, std::vector<Built> arguments) {
    std::vector<Formula> inside;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (i > 0) inside.push_back(Formula::leaf(K::sign, ","));
        append(inside, std::move(arguments[i].formula));
    }
    std::vector<Formula> parts;
    parts.push_back(Formula::leaf(K::word, std::move(name)));
    parts.push_back(fence(Formula::row(std::move(inside))));
    return {Formula::row(std::move(parts)), tight};
}

std::string name_of(Operation operation) {
    for (const FunctionInfo& f : functions())
        if (f.operation == operation) return std::string(f.operation == O::logarithm ? "ln" : f.name);
    return {};
}

const char* sign_of(Operation operation) {
    switch (operation) {
        case O::less:
            return "<";
        case O::less_or_equal:
            return "≤";
        case O::greater:
            return ">";
        case O::greater_or_equal:
            return "≥";
        case O::equal:
            return "=";
        case O::not_equal:
            return "≠";
        case O::logical_and:
            return "and";
        default:
            return "or";
    }
}

class StatementBuilder {
public:
    StatementBuilder(const ParsedText& parsed, const Statement& statement)
        : parsed_(parsed), statement_(statement), built_(statement.last_node - statement.first_node) {
        for (std::size_t i = statement.first_node; i < statement.last_node; ++i)
            built_[i - statement.first_node] = build(parsed.nodes[i]);
    }

    Formula definition() {
        const Definition& d = statement_.defined.front();
        std::vector<Formula> parts{symbol(d.name), Formula::leaf(K::sign, "=")};
        append(parts, taken(d.root).formula);
        return Formula::row(std::move(parts));
    }

    Formula system() {
        std::vector<Formula> parts;
        for (const Residual& r : statement_.equations) {
            if (!parts.empty()) parts.push_back(Formula::leaf(K::sign, ";"));
            append(parts, taken(r.left).formula);
            parts.push_back(Formula::leaf(K::sign, "="));
            append(parts, taken(r.right).formula);
        }
        parts.push_back(Formula::leaf(K::word, " solved for "));
        for (std::size_t k = 0; k < statement_.defined.size(); ++k) {
            if (k > 0) parts.push_back(Formula::leaf(K::sign, ","));
            parts.push_back(symbol(statement_.defined[k].name));
        }
        return Formula::row(std::move(parts));
    }

private:
    Built taken(int node) {
        return std::move(built_[static_cast<std::size_t>(node) - statement_.first_node]);
    }

    Built build(const Node& node) {
        switch (node.operation) {
            case O::constant:
                return number(node);
            case O::symbol:
                return {symbol(node.text), tight};
            case O::add:
                return joined(taken(node.a), "+", taken(node.b), adding);
            case O::subtract:
                return joined(taken(node.a), "−", taken(node.b), adding);
            case O::multiply:
                return joined(taken(node.a), "·", taken(node.b), multiplying);
            case O::divide:
                return {two(K::fraction, taken(node.a).formula, taken(node.b).formula), raising};
            case O::negate:
                return negative(node);
            case O::power:
                return {two(K::power, bound(taken(node.a), tight), taken(node.b).formula), raising};
            default:
                return is_condition(node.operation) ? condition(node) : function(node);
        }
    }

    static Built number(const Node& node) {
        if (node.text == "pi") return {symbol("pi"), tight};
        const bool has_unit = !(node.unit == Unit{});
        return {Formula::leaf(K::number, node.text + unit_after_number(node.unit)),
                has_unit ? multiplying : tight};
    }

    Built negative(const Node& node) {
        std::vector<Formula> parts{Formula::leaf(K::sign, "−")};
        append(parts, bound(taken(node.a), multiplying));
        return {Formula::row(std::move(parts)), signing > multiplying ? adding : signing};
    }

    Built condition(const Node& node) {
        if (is_comparison(node.operation))
            return joined(taken(node.a), sign_of(node.operation), taken(node.b), comparing);
        std::vector<Formula> parts;
        if (node.operation != O::logical_not) append(parts, taken(node.a).formula);
        parts.push_back(Formula::leaf(K::word, node.operation == O::logical_not
                                                   ? "not "
                                                   : " " + std::string(sign_of(node.operation)) + " "));
        append(parts, bound(taken(node.operation == O::logical_not ? node.a : node.b), comparing));
        return {Formula::row(std::move(parts)), loose};
    }

    Built function(const Node& node) {
        if (node.operation == O::square_root || node.operation == O::cube_root) {
            Formula root = Formula::leaf(K::root, node.operation == O::cube_root ? "3" : "");
            root.parts.push_back(taken(node.a).formula);
            return {std::move(root), tight};
        }
        if (node.operation == O::absolute) return {fence(taken(node.a).formula, "|"), tight};
        std::vector<Built> arguments;
        for (const int operand : {node.a, node.b, node.c})
            if (operand >= 0) arguments.push_back(taken(operand));
        return call(name_of(node.operation), std::move(arguments));
    }

    const ParsedText& parsed_;
    const Statement& statement_;
    std::vector<Built> built_;
};

}  // namespace

std::vector<Formula> formulas(const ParsedText& parsed) {
    std::vector<Formula> all;
    for (const Statement& s : parsed.statements) {
        if (s.last_node - s.first_node > most_nodes) {
            all.push_back(Formula::leaf(K::word, s.defined.front().name + " = … (see the set-up)"));
            continue;
        }
        StatementBuilder builder(parsed, s);
        all.push_back(s.is_system() ? builder.system() : builder.definition());
    }
    return all;
}

}  // namespace covaria::equation
