// Recursive descent over the tokens, with a limit to its depth.
#include "core/equation/parser.h"

#include <algorithm>
#include <optional>
#include <set>

#include "core/base/in_quotes.h"
#include "core/equation/token.h"

namespace covaria::equation {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int deepest = 100;
constexpr std::size_t most_grammar_problems = 20;

/// No node: a mistake has been noted and the statement is given up.
constexpr int nothing = -1;

bool is_sign(const Token& token, std::string_view text) {
    return token.kind == TokenKind::sign && token.text == text;
}
bool is_word(const Token& token, std::string_view text) {
    return token.kind == TokenKind::name && token.text == text;
}

Message shown(const Token& token) {
    switch (token.kind) {
        case TokenKind::end_of_statement:
        case TokenKind::end_of_text:
            return tell<"the end of the equation">();
        case TokenKind::unit:
            return "'[" + token.text + "]'";
        default:
            return "'" + token.text + "'";
    }
}

/// Position of the parser in the tokens, and whether the statement there is given up.
class TokenCursor {
public:
    TokenCursor(std::vector<Token> tokens, TextProblems& problems)
        : tokens_(std::move(tokens)), problems_(problems) {}

    const Token& now() const { return tokens_[at_]; }
    const Token& following() const { return tokens_[std::min(at_ + 1, tokens_.size() - 1)]; }
    const Token& next() { return tokens_[at_++]; }
    std::size_t problems() const { return problems_.size(); }
    bool failed() const { return failed_; }

    bool taken(std::string_view sign) {
        if (!is_sign(now(), sign)) return false;
        ++at_;
        return true;
    }
    bool taken_word(std::string_view word) {
        if (!is_word(now(), word)) return false;
        ++at_;
        return true;
    }

    /// Only the first mistake of a statement is noted.
    int refuse(const Place& place, const Message& message) {
        if (!failed_) problems_.push_back({place, message});
        failed_ = true;
        return nothing;
    }

    void begin_statement() { failed_ = false; }
    void skip_statement() {
        while (now().kind != TokenKind::end_of_statement && now().kind != TokenKind::end_of_text) ++at_;
    }

private:
    std::vector<Token> tokens_;
    TextProblems& problems_;
    std::size_t at_ = 0;
    bool failed_ = false;
};

std::optional<Operation> comparison_of(const Token& token) {
    static constexpr std::pair<std::string_view, Operation> signs[] = {
        {"<", Operation::less},    {"<=", Operation::less_or_equal},
        {">", Operation::greater}, {">=", Operation::greater_or_equal},
        {"==", Operation::equal},  {"!=", Operation::not_equal}};
    for (const auto& [text, operation] : signs)
        if (is_sign(token, text)) return operation;
    return std::nullopt;
}

Message no_function(const std::string& name) {
    std::string known;
    for (const std::string& f : function_names()) known += (known.empty() ? "" : ", ") + f;
    return tell<"%1 is not a function; to multiply, write '*'. Functions are: %2">(in_quotes(name), known);
}

Message wrong_count(const FunctionInfo& f, std::size_t count) {
    const std::string name = in_quotes(std::string(f.name));
    return f.fewest == f.most
               ? tell<"%1 needs %2 arguments; here it has %3">(name, f.fewest, count)
               : tell<"%1 needs %2 to %3 arguments; here it has %4">(name, f.fewest, f.most, count);
}

/// Parser of an expression, whose nodes are put behind those there. Returns its root, or `nothing`.
class ExpressionParser {
public:
    ExpressionParser(TokenCursor& in, std::vector<Node>& nodes) : in_(in), nodes_(nodes) {}

    int expression() {
        int left = conjunction();
        while (!in_.failed() && is_word(in_.now(), "or")) {
            const Place sign = in_.next().place;
            left = binary(Operation::logical_or, left, conjunction(), sign);
        }
        return left;
    }

    int sum() {
        int left = product();
        while (!in_.failed() && (is_sign(in_.now(), "+") || is_sign(in_.now(), "-"))) {
            const Token& sign = in_.next();
            left =
                binary(sign.text == "+" ? Operation::add : Operation::subtract, left, product(), sign.place);
        }
        return left;
    }

private:
    int add(Node node) {
        nodes_.push_back(std::move(node));
        return static_cast<int>(nodes_.size()) - 1;
    }
    Node& node(int index) { return nodes_[static_cast<std::size_t>(index)]; }

    int binary(Operation operation, int a, int b, const Place& sign) {
        if (in_.failed()) return nothing;
        return add({operation, a, b, -1, 0.0, {}, {}, joined(node(a).place, node(b).place), sign});
    }

    int leaf(Operation operation, double value, const Token& token) {
        return add({operation, -1, -1, -1, value, {}, token.text, token.place, token.place});
    }

    int conjunction() {
        int left = negation();
        while (!in_.failed() && is_word(in_.now(), "and")) {
            const Place sign = in_.next().place;
            left = binary(Operation::logical_and, left, negation(), sign);
        }
        return left;
    }

    int negation() {
        if (!is_word(in_.now(), "not")) return comparison();
        return unary(Operation::logical_not, &ExpressionParser::negation);
    }

    int comparison() {
        const int left = sum();
        const auto operation = comparison_of(in_.now());
        if (in_.failed() || !operation) return left;
        const Place sign = in_.next().place;
        return binary(*operation, left, sum(), sign);
    }

    int product() {
        int left = signed_factor();
        while (!in_.failed() && (is_sign(in_.now(), "*") || is_sign(in_.now(), "/"))) {
            const Token& sign = in_.next();
            left = binary(sign.text == "*" ? Operation::multiply : Operation::divide, left, signed_factor(),
                          sign.place);
        }
        return left;
    }

    /// -a^2 is -(a^2).
    int signed_factor() {
        if (is_sign(in_.now(), "+")) {
            in_.next();
            if (is_sign(in_.now(), "+")) return in_.refuse(in_.now().place, tell<"'+' stands here twice">());
            return signed_factor();
        }
        if (!is_sign(in_.now(), "-")) return power();
        return unary(Operation::negate, &ExpressionParser::signed_factor);
    }

    int unary(Operation operation, int (ExpressionParser::*operand)()) {
        const Place sign = in_.now().place;
        if (!descend()) return nothing;
        in_.next();
        const int a = (this->*operand)();
        --depth_;
        if (in_.failed()) return nothing;
        return add({operation, a, -1, -1, 0.0, {}, {}, joined(sign, node(a).place), sign});
    }

    int power() {
        const int base = primary();
        if (in_.failed() || !is_sign(in_.now(), "^")) return base;
        const Place sign = in_.now().place;
        if (!descend()) return nothing;
        in_.next();
        const int exponent = signed_factor();
        --depth_;
        return binary(Operation::power, base, exponent, sign);
    }

    bool descend() {
        if (++depth_ <= deepest) return true;
        in_.refuse(
            in_.now().place,
            tell<"the expression is nested more than %1 levels deep: split it into definitions">(deepest));
        return false;
    }

    int primary() {
        if (in_.failed()) return nothing;
        const Token& token = in_.now();
        if (token.kind == TokenKind::number) return number();
        if (token.kind == TokenKind::name) return name();
        if (is_sign(token, "(")) return parenthesis();
        if (token.kind == TokenKind::unit)
            return in_.refuse(token.place, tell<"a unit in brackets belongs behind a number: 20 [degC]">());
        return in_.refuse(token.place,
                          tell<"a number, a name or a parenthesis is expected here, not %1">(shown(token)));
    }

    int parenthesis() {
        const Place open = in_.now().place;
        if (!descend()) return nothing;
        in_.next();
        const int inside = expression();
        --depth_;
        if (in_.failed()) return nothing;
        if (!is_sign(in_.now(), ")")) return in_.refuse(open, tell<"this parenthesis is not closed">());
        node(inside).place = joined(open, in_.now().place);
        in_.next();
        return inside;
    }

    int number() {
        const Token& token = in_.next();
        Node made{Operation::constant, -1, -1, -1, token.number, {}, token.text, token.place, token.place};
        if (in_.now().kind == TokenKind::unit) {
            const Token& bracket = in_.next();
            const Result<Unit> unit = Unit::parse(bracket.text);
            if (!unit) return in_.refuse(bracket.place, unit.error().message);
            made.unit = *unit;
            made.value = unit->to_si(token.number);
            made.place = joined(token.place, bracket.place);
        }
        return add(std::move(made));
    }

    int name() {
        const Token& token = in_.next();
        if (is_sign(in_.now(), "(")) return call(token);
        if (token.text == "pi") return leaf(Operation::constant, pi, token);
        if (find_function(token.text) && is_reserved(token.text))
            return in_.refuse(token.place,
                              tell<"'%1' is a function: its argument follows in parentheses">(token.text));
        if (is_reserved(token.text))
            return in_.refuse(token.place, tell<"the word '%1' is not expected here">(token.text));
        return leaf(Operation::symbol, 0.0, token);
    }

    int call(const Token& name) {
        const FunctionInfo* function = find_function(name.text);
        if (!function) return in_.refuse(name.place, no_function(name.text));
        std::vector<int> arguments;
        if (!descend()) return nothing;
        const Place open = in_.now().place;
        do {
            in_.next();
            arguments.push_back(expression());
        } while (!in_.failed() && is_sign(in_.now(), ","));
        --depth_;
        if (in_.failed()) return nothing;
        if (!is_sign(in_.now(), ")"))
            return in_.now().kind == TokenKind::end_of_statement
                       ? in_.refuse(open, tell<"this parenthesis is not closed">())
                       : in_.refuse(
                             in_.now().place,
                             tell<"an operator, a comma or ')' is expected here, not %1">(shown(in_.now())));
        const Place close = in_.next().place;
        return applied(*function, arguments, name.place, joined(name.place, close));
    }

    int applied(const FunctionInfo& f, const std::vector<int>& arguments, const Place& name,
                const Place& whole) {
        if (arguments.size() < f.fewest || arguments.size() > f.most)
            return in_.refuse(name, wrong_count(f, arguments.size()));
        if (f.operation == Operation::select)
            return add({f.operation, arguments[0], arguments[1], arguments[2], 0.0, {}, {}, whole, name});
        int result = arguments[0];
        if (arguments.size() == 1) return add({f.operation, result, -1, -1, 0.0, {}, {}, whole, name});
        for (std::size_t i = 1; i < arguments.size(); ++i)
            result = add({f.operation, result, arguments[i], -1, 0.0, {}, {}, whole, name});
        return result;
    }

    TokenCursor& in_;
    std::vector<Node>& nodes_;
    int depth_ = 0;
};

/// Statements: definitions, and systems of equations to be solved.
class Parser {
public:
    Parser(std::vector<Token> tokens, TextProblems& problems) : in_(std::move(tokens), problems) {}

    ParsedText run() {
        while (in_.now().kind != TokenKind::end_of_text && in_.problems() < most_grammar_problems) {
            in_.begin_statement();
            if (in_.now().kind == TokenKind::end_of_statement) {
                in_.next();
                continue;
            }
            statement();
            if (in_.failed()) in_.skip_statement();
        }
        return std::move(parsed_);
    }

private:
    void statement() {
        Statement made;
        made.first_node = made.first_of_equations = parsed_.nodes.size();
        if (is_word(in_.now(), "solve"))
            system(made);
        else
            definition(made);
        if (!in_.failed() && in_.now().kind != TokenKind::end_of_statement) refuse_rest();
        made.last_node = parsed_.nodes.size();
        if (!in_.failed()) parsed_.statements.push_back(std::move(made));
    }

    void refuse_rest() {
        const bool operand = in_.now().kind == TokenKind::name || in_.now().kind == TokenKind::number ||
                             is_sign(in_.now(), "(");
        if (is_sign(in_.now(), ")"))
            in_.refuse(in_.now().place, tell<"this parenthesis closes nothing">());
        else if (is_sign(in_.now(), "="))
            in_.refuse(in_.now().place,
                       tell<"an equation defines one name: write 'y = ...'; to compare, write '=='; an "
                            "equation that is to be solved starts with 'solve'">());
        else if (operand)
            in_.refuse(in_.now().place, tell<"an operator is missing before %1">(shown(in_.now())));
        else if (in_.now().kind == TokenKind::unit)
            in_.refuse(in_.now().place, tell<"a unit in brackets belongs behind a number: 20 [degC]">());
        else
            in_.refuse(in_.now().place, tell<"%1 is not expected here">(shown(in_.now())));
    }

    void definition(Statement& made) {
        if (in_.now().kind != TokenKind::name || !is_sign(in_.following(), "=")) {
            in_.refuse(in_.now().place, tell<"an equation starts with the name that it defines: y = ...">());
            return;
        }
        define(made);
    }

    /// name = expression
    void define(Statement& made) {
        if (in_.now().kind != TokenKind::name || !is_sign(in_.following(), "=")) {
            in_.refuse(in_.now().place, tell<"a name with its starting value is expected here: y = 1">());
            return;
        }
        Definition defined{in_.now().text, in_.now().place, nothing};
        check_name(defined);
        in_.next();
        in_.next();
        defined.root = ExpressionParser(in_, parsed_.nodes).expression();
        made.defined.push_back(std::move(defined));
    }

    void check_name(const Definition& defined) {
        if (is_reserved(defined.name))
            in_.refuse(defined.place,
                       tell<"'%1' is %2: choose another name">(
                           defined.name, (find_function(defined.name) ? tell<"a function">()
                                                                      : tell<"a word of the language">())));
        else if (!names_.insert(defined.name).second)
            in_.refuse(defined.place, tell<"'%1' is defined twice">(defined.name));
    }

    void system(Statement& made) {
        const Place place = in_.now().place;
        in_.next();
        do define(made);
        while (!in_.failed() && in_.taken(","));
        made.first_of_equations = parsed_.nodes.size();
        if (!in_.failed() && !in_.taken(":"))
            in_.refuse(in_.now().place,
                       tell<"a colon is expected before the equations to be solved: solve y = 1: y^2 = x">());
        if (in_.failed()) return;
        do residual(made);
        while (!in_.failed() && in_.taken_word("and"));
        if (!in_.failed() && made.equations.size() != made.defined.size())
            in_.refuse(place, tell<"%1 unknowns need as many equations; there are %2">(
                                  made.defined.size(), made.equations.size()));
        if (!in_.failed() && made.defined.size() > most_unknowns)
            in_.refuse(place, tell<"%1 unknowns are too many to be solved together: the time for each trial "
                                   "grows with the cube of their number, so the limit is %2; solve what does "
                                   "not depend on the rest in systems of its own">(made.defined.size(),
                                                                                   most_unknowns));
    }

    void residual(Statement& made) {
        Residual equation;
        equation.left = ExpressionParser(in_, parsed_.nodes).sum();
        equation.place = in_.now().place;
        if (!in_.failed() && !in_.taken("=") && !in_.taken("=="))
            in_.refuse(in_.now().place, tell<"an equals sign is expected in an equation to be solved">());
        if (in_.failed()) return;
        equation.right = ExpressionParser(in_, parsed_.nodes).sum();
        made.equations.push_back(equation);
    }

    TokenCursor in_;
    ParsedText parsed_;
    std::set<std::string> names_;
};

}  // namespace

const Definition* ParsedText::find(std::string_view name) const {
    for (const Statement& statement : statements)
        for (const Definition& definition : statement.defined)
            if (definition.name == name) return &definition;
    return nullptr;
}

ParsedText parse(std::string_view text, TextProblems& problems) {
    std::vector<Token> tokens = tokens_of(text, problems);
    if (!problems.empty()) return {};
    return Parser(std::move(tokens), problems).run();
}

std::vector<SymbolUse> free_symbols(const ParsedText& parsed) {
    std::set<std::string> known;
    for (const Statement& statement : parsed.statements)
        for (const Definition& definition : statement.defined) known.insert(definition.name);
    std::vector<SymbolUse> found;
    for (const Statement& statement : parsed.statements)
        for (std::size_t i = statement.first_node; i < statement.last_node; ++i) {
            const Node& node = parsed.nodes[i];
            if (node.operation == Operation::symbol && known.insert(node.text).second)
                found.push_back({node.text, node.place});
        }
    return found;
}

}  // namespace covaria::equation
