// Recursive descent over the tokens, with a limit to its depth.
#include "core/equation/parser.h"

#include <algorithm>
#include <optional>
#include <set>

#include "core/equation/token.h"

namespace covaria::equation {

namespace {

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

std::string shown(const Token& token) {
    switch (token.kind) {
        case TokenKind::end_of_statement:
        case TokenKind::end_of_text:
            return "the end of the equation";
        case TokenKind::unit:
            return "'[" + token.text + "]'";
        default:
            return "'" + token.text + "'";
    }
}

class Parser {
public:
    Parser(std::vector<Token> tokens, TextProblems& problems)
        : tokens_(std::move(tokens)), problems_(problems) {}

    ParsedText run() {
        while (now().kind != TokenKind::end_of_text && problems_.size() < most_grammar_problems) {
            failed_ = false;
            depth_ = 0;
            if (now().kind == TokenKind::end_of_statement) {
                ++at_;
                continue;
            }
            statement();
            if (failed_) skip_statement();
        }
        return std::move(parsed_);
    }

private:
    const Token& now() const { return tokens_[at_]; }
    const Token& following() const { return tokens_[std::min(at_ + 1, tokens_.size() - 1)]; }

    int refuse(const Place& place, const std::string& message) {
        if (!failed_) problems_.push_back({place, message});
        failed_ = true;
        return nothing;
    }

    void skip_statement() {
        while (now().kind != TokenKind::end_of_statement && now().kind != TokenKind::end_of_text) ++at_;
    }

    int add(Node node) {
        parsed_.nodes.push_back(std::move(node));
        return static_cast<int>(parsed_.nodes.size()) - 1;
    }
    Node& node(int index) { return parsed_.nodes[static_cast<std::size_t>(index)]; }

    int binary(Operation operation, int a, int b, const Place& sign) {
        if (failed_) return nothing;
        return add({operation, a, b, -1, 0.0, {}, {}, joined(node(a).place, node(b).place), sign});
    }

    void statement() {
        Statement made;
        made.first_node = made.first_of_equations = parsed_.nodes.size();
        if (is_word(now(), "solve"))
            system(made);
        else
            definition(made);
        if (!failed_ && now().kind != TokenKind::end_of_statement) refuse_rest();
        made.last_node = parsed_.nodes.size();
        if (!failed_) parsed_.statements.push_back(std::move(made));
    }

    void refuse_rest() {
        const bool operand =
            now().kind == TokenKind::name || now().kind == TokenKind::number || is_sign(now(), "(");
        if (is_sign(now(), ")"))
            refuse(now().place, "this parenthesis closes nothing");
        else if (is_sign(now(), "="))
            refuse(now().place,
                   "an equation defines one name: write 'y = ...'; to compare, write '=='; an equation that "
                   "is to "
                   "be solved starts with 'solve'");
        else if (operand)
            refuse(now().place, "an operator is missing before " + shown(now()));
        else if (now().kind == TokenKind::unit)
            refuse(now().place, "a unit in brackets belongs behind a number: 20 [degC]");
        else
            refuse(now().place, shown(now()) + " is not expected here");
    }

    void definition(Statement& made) {
        if (now().kind != TokenKind::name || !is_sign(following(), "=")) {
            refuse(now().place, "an equation starts with the name that it defines: y = ...");
            return;
        }
        define(made);
    }

    /// name = expression
    void define(Statement& made) {
        if (now().kind != TokenKind::name || !is_sign(following(), "=")) {
            refuse(now().place, "a name with its starting value is expected here: y = 1");
            return;
        }
        Definition defined{now().text, now().place, nothing};
        check_name(defined);
        at_ += 2;
        defined.root = expression();
        made.defined.push_back(std::move(defined));
    }

    void check_name(const Definition& defined) {
        if (is_reserved(defined.name))
            refuse(defined.place,
                   "'" + defined.name + "' is " +
                       (find_function(defined.name) ? "a function" : "a word of the language") +
                       ": choose another name");
        else if (!names_.insert(defined.name).second)
            refuse(defined.place, "'" + defined.name + "' is defined twice");
    }

    void system(Statement& made) {
        const Place place = now().place;
        ++at_;
        do define(made);
        while (!failed_ && taken(","));
        made.first_of_equations = parsed_.nodes.size();
        if (!failed_ && !taken(":"))
            refuse(now().place,
                   "a colon is expected before the equations to be solved: solve y = 1: y^2 = x");
        if (failed_) return;
        do residual(made);
        while (!failed_ && taken_word("and"));
        if (!failed_ && made.equations.size() != made.defined.size())
            refuse(place, std::to_string(made.defined.size()) +
                              " unknowns need as many equations; there are " +
                              std::to_string(made.equations.size()));
        if (!failed_ && made.defined.size() > 6) refuse(place, "at most six unknowns can be solved together");
    }

    void residual(Statement& made) {
        Residual equation;
        equation.left = sum();
        equation.place = now().place;
        if (!failed_ && !taken("=") && !taken("=="))
            refuse(now().place, "an equals sign is expected in an equation to be solved");
        if (failed_) return;
        equation.right = sum();
        made.equations.push_back(equation);
    }

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

    int expression() { return disjunction(); }

    int disjunction() {
        int left = conjunction();
        while (!failed_ && is_word(now(), "or")) {
            const Place sign = tokens_[at_++].place;
            left = binary(Operation::logical_or, left, conjunction(), sign);
        }
        return left;
    }

    int conjunction() {
        int left = negation();
        while (!failed_ && is_word(now(), "and")) {
            const Place sign = tokens_[at_++].place;
            left = binary(Operation::logical_and, left, negation(), sign);
        }
        return left;
    }

    int negation() {
        if (!is_word(now(), "not")) return comparison();
        const Place sign = now().place;
        if (!descend()) return nothing;
        ++at_;
        const int a = negation();
        --depth_;
        if (failed_) return nothing;
        return add({Operation::logical_not, a, -1, -1, 0.0, {}, {}, joined(sign, node(a).place), sign});
    }

    std::optional<Operation> comparison_sign() const {
        using O = Operation;
        static constexpr std::pair<std::string_view, O> signs[] = {
            {"<", O::less},   {"<=", O::less_or_equal}, {">", O::greater}, {">=", O::greater_or_equal},
            {"==", O::equal}, {"!=", O::not_equal}};
        for (const auto& [text, operation] : signs)
            if (is_sign(now(), text)) return operation;
        return std::nullopt;
    }

    int comparison() {
        const int left = sum();
        const auto operation = comparison_sign();
        if (failed_ || !operation) return left;
        const Place sign = tokens_[at_++].place;
        return binary(*operation, left, sum(), sign);
    }

    int sum() {
        int left = product();
        while (!failed_ && (is_sign(now(), "+") || is_sign(now(), "-"))) {
            const Token& sign = tokens_[at_++];
            left =
                binary(sign.text == "+" ? Operation::add : Operation::subtract, left, product(), sign.place);
        }
        return left;
    }

    int product() {
        int left = signed_factor();
        while (!failed_ && (is_sign(now(), "*") || is_sign(now(), "/"))) {
            const Token& sign = tokens_[at_++];
            left = binary(sign.text == "*" ? Operation::multiply : Operation::divide, left, signed_factor(),
                          sign.place);
        }
        return left;
    }

    /// -a^2 is -(a^2).
    int signed_factor() {
        if (is_sign(now(), "+")) {
            ++at_;
            if (is_sign(now(), "+")) return refuse(now().place, "'+' stands here twice");
            return signed_factor();
        }
        if (!is_sign(now(), "-")) return power();
        const Place sign = now().place;
        if (!descend()) return nothing;
        ++at_;
        const int a = signed_factor();
        --depth_;
        if (failed_) return nothing;
        return add({Operation::negate, a, -1, -1, 0.0, {}, {}, joined(sign, node(a).place), sign});
    }

    int power() {
        const int base = primary();
        if (failed_ || !is_sign(now(), "^")) return base;
        const Place sign = now().place;
        if (!descend()) return nothing;
        ++at_;
        const int exponent = signed_factor();
        --depth_;
        return binary(Operation::power, base, exponent, sign);
    }

    bool descend() {
        if (++depth_ <= deepest) return true;
        refuse(now().place, "the expression is nested more than " + std::to_string(deepest) +
                                " levels deep: split it into definitions");
        return false;
    }

    int primary() {
        if (failed_) return nothing;
        const Token& token = now();
        if (token.kind == TokenKind::number) return number();
        if (token.kind == TokenKind::name) return name();
        if (is_sign(token, "(")) return parenthesis();
        if (token.kind == TokenKind::unit)
            return refuse(token.place, "a unit in brackets belongs behind a number: 20 [degC]");
        return refuse(token.place, "a number, a name or a parenthesis is expected here, not " + shown(token));
    }

    int parenthesis() {
        const Place open = now().place;
        if (!descend()) return nothing;
        ++at_;
        const int inside = expression();
        --depth_;
        if (failed_) return nothing;
        if (!is_sign(now(), ")")) return refuse(open, "this parenthesis is not closed");
        node(inside).place = joined(open, now().place);
        ++at_;
        return inside;
    }

    int number() {
        const Token& token = tokens_[at_++];
        Node made{Operation::constant, -1, -1, -1, token.number, {}, token.text, token.place, token.place};
        if (now().kind == TokenKind::unit) {
            const Token& bracket = tokens_[at_++];
            const Result<Unit> unit = Unit::parse(bracket.text);
            if (!unit) return refuse(bracket.place, unit.error().message);
            made.unit = *unit;
            made.value = unit->to_si(token.number);
            made.place = joined(token.place, bracket.place);
        }
        return add(std::move(made));
    }

    int name() {
        const Token& token = tokens_[at_++];
        if (is_sign(now(), "(")) return call(token);
        if (token.text == "pi")
            return add({Operation::constant,
                        -1,
                        -1,
                        -1,
                        3.14159265358979323846,
                        {},
                        "pi",
                        token.place,
                        token.place});
        if (find_function(token.text))
            return refuse(token.place,
                          "'" + token.text + "' is a function: its argument follows in parentheses");
        if (is_reserved(token.text))
            return refuse(token.place, "the word '" + token.text + "' is not expected here");
        return add({Operation::symbol, -1, -1, -1, 0.0, {}, token.text, token.place, token.place});
    }

    int call(const Token& name) {
        const FunctionInfo* function = find_function(name.text);
        if (!function) return refuse_call(name);
        std::vector<int> arguments;
        if (!descend()) return nothing;
        const Place open = now().place;
        do {
            ++at_;
            arguments.push_back(expression());
        } while (!failed_ && is_sign(now(), ","));
        --depth_;
        if (failed_) return nothing;
        if (!is_sign(now(), ")"))
            return now().kind == TokenKind::end_of_statement
                       ? refuse(open, "this parenthesis is not closed")
                       : refuse(now().place,
                                "an operator, a comma or ')' is expected here, not " + shown(now()));
        const Place close = tokens_[at_++].place;
        return applied(*function, arguments, name.place, joined(name.place, close));
    }

    int refuse_call(const Token& name) {
        std::string known;
        for (const std::string& f : function_names()) known += (known.empty() ? "" : ", ") + f;
        return refuse(name.place, "'" + name.text +
                                      "' is not a function; to multiply, write '*'. Functions are: " + known);
    }

    int applied(const FunctionInfo& f, const std::vector<int>& arguments, const Place& name,
                const Place& whole) {
        if (arguments.size() < f.fewest || arguments.size() > f.most) {
            const std::string wanted = f.fewest == f.most
                                           ? std::to_string(f.fewest)
                                           : std::to_string(f.fewest) + " to " + std::to_string(f.most);
            return refuse(name, "'" + std::string(f.name) + "' needs " + wanted + " arguments; here it has " +
                                    std::to_string(arguments.size()));
        }
        if (f.operation == Operation::select)
            return add({f.operation, arguments[0], arguments[1], arguments[2], 0.0, {}, {}, whole, name});
        int result = arguments[0];
        if (arguments.size() == 1) return add({f.operation, result, -1, -1, 0.0, {}, {}, whole, name});
        for (std::size_t i = 1; i < arguments.size(); ++i)
            result = add({f.operation, result, arguments[i], -1, 0.0, {}, {}, whole, name});
        return result;
    }

    std::vector<Token> tokens_;
    TextProblems& problems_;
    ParsedText parsed_;
    std::set<std::string> names_;
    std::size_t at_ = 0;
    int depth_ = 0;
    bool failed_ = false;
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
