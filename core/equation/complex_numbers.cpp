#include "core/equation/complex_numbers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/base/in_quotes.h"

namespace covaria::equation {

namespace {

using O = Operation;

constexpr double greatest_product = 16.0;  ///< whole powers up to it are products

/// The nodes that are complex, found by walking until nothing changes: definitions stand in any order.
class ComplexNodes {
public:
    explicit ComplexNodes(const ParsedText& parsed) : parsed_(parsed), is_complex_(parsed.nodes.size()) {
        for (bool changed = true; changed;) {
            changed = false;
            for (const Statement& s : parsed.statements)
                for (const Definition& d : walked(s))
                    if (d.root >= 0 && (*this)[d.root]) changed = names_.insert(d.name).second || changed;
        }
    }

    bool operator[](int node) const { return node >= 0 && is_complex_[static_cast<std::size_t>(node)]; }
    const std::set<std::string>& names() const { return names_; }

private:
    const std::vector<Definition>& walked(const Statement& s) {
        for (std::size_t i = s.first_node; i < s.last_node; ++i) is_complex_[i] = found(parsed_.nodes[i]);
        return s.defined;
    }

    bool found(const Node& node) const {
        switch (node.operation) {
            case O::complex_number:
            case O::polar_number:
                return true;
            case O::real_part:
            case O::imaginary_part:
            case O::argument:
            case O::absolute:
                return false;
            case O::symbol:
                return names_.contains(node.text);
            case O::select:
                return (*this)[node.b] || (*this)[node.c];
            default:
                return !is_condition(node.operation) && ((*this)[node.a] || (*this)[node.b]);
        }
    }

    const ParsedText& parsed_;
    std::vector<bool> is_complex_;
    std::set<std::string> names_;
};

bool has_complex_functions(const ParsedText& parsed) {
    return std::any_of(parsed.nodes.begin(), parsed.nodes.end(), [](const Node& node) {
        return node.operation >= O::complex_number && node.operation <= O::argument;
    });
}

/// Nodes of the real and the imaginary part; no imaginary part: a real number.
struct Pair {
    int re = -1, im = -1;
    bool is_complex() const { return im >= 0; }
};

/// Writes the nodes of one text in real numbers.
class Lowering {
public:
    Lowering(const ParsedText& parsed, TextProblems& problems)
        : parsed_(parsed), problems_(problems), complex_(parsed), pairs_(parsed.nodes.size()) {}

    ParsedText run() {
        check_names();
        for (const Statement& s : parsed_.statements) statement(s);
        return std::move(made_);
    }

private:
    void refuse(const Place& place, Message message) { problems_.push_back({place, std::move(message)}); }

    /// The parts of a complex definition have names that nothing else may have.
    void check_names() {
        std::set<std::string> taken;
        for (const SymbolUse& use : free_symbols(parsed_)) taken.insert(use.name);
        for (const Statement& s : parsed_.statements)
            for (const Definition& d : s.defined) taken.insert(d.name);
        for (const Statement& s : parsed_.statements)
            for (const Definition& d : s.defined)
                for (const std::string& part : {real_part_of(d.name), imaginary_part_of(d.name)})
                    if (complex_.names().contains(d.name) && taken.contains(part))
                        refuse(d.place,
                               tell<"'%1' is complex, so that '%2' is a part of it: to use a part "
                                    "write re(%1) or im(%1), else choose another name">(d.name, part));
    }

    void statement(const Statement& s) {
        Statement made;
        made.first_node = made_.nodes.size();
        for (std::size_t i = s.first_node; i < s.first_of_equations; ++i) lower(i);
        if (!s.is_system())
            for (std::size_t i = s.first_of_equations; i < s.last_node; ++i) lower(i);
        for (const Definition& d : s.defined) define(made, d);
        made.first_of_equations = s.is_system() ? made_.nodes.size() : made.first_node;
        if (s.is_system()) system(s, made);
        made.last_node = made_.nodes.size();
        made_.statements.push_back(std::move(made));
    }

    void define(Statement& made, const Definition& d) {
        const Pair value = pair(d.root);
        if (!complex_.names().contains(d.name)) {
            made.defined.push_back({d.name, d.place, value.re});
            return;
        }
        made.defined.push_back({real_part_of(d.name), d.place, value.re});
        made.defined.push_back({imaginary_part_of(d.name), d.place, imaginary(value, d.place)});
    }

    void system(const Statement& s, Statement& made) {
        for (std::size_t i = s.first_of_equations; i < s.last_node; ++i) lower(i);
        for (const Residual& r : s.equations) {
            const Pair left = pair(r.left), right = pair(r.right);
            made.equations.push_back({left.re, right.re, r.place});
            if (left.is_complex() || right.is_complex())
                made.equations.push_back({imaginary(left, r.place), imaginary(right, r.place), r.place});
        }
        if (made.equations.size() != made.defined.size())
            refuse(s.defined.front().place,
                   tell<"a complex unknown counts twice, and so does a complex equation: there are %1 real "
                        "unknowns and %2 real equations">(made.defined.size(), made.equations.size()));
    }

    Pair pair(int node) const { return node < 0 ? Pair{} : pairs_[static_cast<std::size_t>(node)]; }

    int add(Node node) {
        made_.nodes.push_back(std::move(node));
        return static_cast<int>(made_.nodes.size()) - 1;
    }
    int constant(double value, const Place& place) {
        Node node{O::constant};
        node.value = value;
        node.text = value == 0.0 ? "0" : "2";
        node.place = node.sign = place;
        return add(std::move(node));
    }
    /// The plain 0 has every dimension.
    int imaginary(const Pair& value, const Place& place) {
        return value.is_complex() ? value.im : constant(0.0, place);
    }

    /// Adds an operation at the place of the node that is being lowered.
    int op(Operation operation, int a, int b = -1, int c = -1) {
        Node node{operation, a, b, c};
        node.place = now_->place;
        node.sign = now_->sign;
        return add(std::move(node));
    }
    int sum(int a, int b) { return op(O::add, a, b); }
    int difference(int a, int b) { return op(O::subtract, a, b); }
    int product(int a, int b) { return op(O::multiply, a, b); }
    int quotient(int a, int b) { return op(O::divide, a, b); }
    int modulus(const Pair& z) { return op(O::hypotenuse, z.re, z.im); }
    int argument(const Pair& z) { return op(O::arc_tangent_2, z.im, z.re); }

    Pair polar(int modulus, int argument) {
        return {product(modulus, op(O::cosine, argument)), product(modulus, op(O::sine, argument))};
    }

    Pair product(const Pair& z, const Pair& w) {
        if (!z.is_complex() && !w.is_complex()) return {product(z.re, w.re)};
        if (!w.is_complex()) return {product(z.re, w.re), product(z.im, w.re)};
        if (!z.is_complex()) return {product(z.re, w.re), product(z.re, w.im)};
        return {difference(product(z.re, w.re), product(z.im, w.im)),
                sum(product(z.re, w.im), product(z.im, w.re))};
    }

    Pair quotient(const Pair& z, const Pair& w) {
        if (!w.is_complex()) return {quotient(z.re, w.re), z.is_complex() ? quotient(z.im, w.re) : -1};
        const int squared = sum(product(w.re, w.re), product(w.im, w.im));
        const Pair conjugate{w.re, op(O::negate, w.im)};
        const Pair numerator = product(z, conjugate);
        return {quotient(numerator.re, squared), quotient(numerator.im, squared)};
    }

    Pair exponential(const Pair& z) {
        const int size = op(O::exponential, z.re);
        return z.is_complex() ? polar(size, z.im) : Pair{size};
    }

    Pair logarithm(const Pair& z) { return {op(O::logarithm, modulus(z)), argument(z)}; }

    /// A real base is its logarithm's; it must be greater than zero then.
    Pair logarithm_of_base(const Pair& z) {
        return z.is_complex() ? logarithm(z) : Pair{op(O::logarithm, z.re)};
    }

    Pair power(const Node& node) {
        const Pair base = pair(node.a), exponent = pair(node.b);
        if (!exponent.is_complex()) {
            const Node& n = made_.nodes[static_cast<std::size_t>(exponent.re)];
            const bool is_constant = n.operation == O::constant && n.unit == Unit{};
            if (is_constant && n.value == std::round(n.value) && n.value >= 1.0 &&
                n.value <= greatest_product)
                return whole_power(base, static_cast<int>(n.value));
            return polar(op(O::power, modulus(base), exponent.re), product(exponent.re, argument(base)));
        }
        return exponential(product(exponent, logarithm_of_base(base)));
    }

    Pair whole_power(const Pair& base, int n) {
        Pair power = base;
        for (int i = 1; i < n; ++i) power = product(power, base);
        return power;
    }

    Pair square_root(const Pair& z) {
        return polar(op(O::square_root, modulus(z)), quotient(argument(z), constant(2.0, now_->place)));
    }

    /// sin(a + ib) = sin a cosh b + i cos a sinh b and so on.
    Pair sine(const Pair& z) {
        return {product(op(O::sine, z.re), op(O::hyperbolic_cosine, z.im)),
                product(op(O::cosine, z.re), op(O::hyperbolic_sine, z.im))};
    }
    Pair cosine(const Pair& z) {
        return {product(op(O::cosine, z.re), op(O::hyperbolic_cosine, z.im)),
                op(O::negate, product(op(O::sine, z.re), op(O::hyperbolic_sine, z.im)))};
    }
    Pair hyperbolic_sine(const Pair& z) {
        return {product(op(O::hyperbolic_sine, z.re), op(O::cosine, z.im)),
                product(op(O::hyperbolic_cosine, z.re), op(O::sine, z.im))};
    }
    Pair hyperbolic_cosine(const Pair& z) {
        return {product(op(O::hyperbolic_cosine, z.re), op(O::cosine, z.im)),
                product(op(O::hyperbolic_sine, z.re), op(O::sine, z.im))};
    }

    void lower(std::size_t i) {
        now_ = &parsed_.nodes[i];
        pairs_[i] = lowered(*now_);
    }

    Pair lowered(const Node& node) {
        const Pair a = pair(node.a), b = pair(node.b);
        if (node.operation == O::symbol && complex_.names().contains(node.text)) return parts(node);
        if (node.operation >= O::complex_number && node.operation <= O::argument)
            return of_complex_function(node, a, b);
        const bool any = a.is_complex() || b.is_complex() || pair(node.c).is_complex();
        if (any) return of_complex(node, a, b);
        Node same = node;
        same.a = a.re;
        same.b = b.re;
        same.c = pair(node.c).re;
        return {add(std::move(same))};
    }

    Pair parts(const Node& node) {
        Node re = node, im = node;
        re.text = real_part_of(node.text);
        im.text = imaginary_part_of(node.text);
        const int first = add(std::move(re));
        return {first, add(std::move(im))};
    }

    Pair of_complex_function(const Node& node, const Pair& a, const Pair& b) {
        const Message name = node.operation == O::polar_number ? tell<"modulus and argument">()
                                                               : tell<"real and imaginary part">();
        switch (node.operation) {
            case O::complex_number:
            case O::polar_number:
                if (a.is_complex() || b.is_complex())
                    refuse(node.sign,
                           tell<"%1 of a complex number are real; one of them is complex here">(name));
                return node.operation == O::polar_number ? polar(a.re, b.re) : Pair{a.re, b.re};
            case O::real_part:
                return {a.re};
            case O::imaginary_part:
                return {imaginary(a, node.place)};
            case O::conjugate:
                return a.is_complex() ? Pair{a.re, op(O::negate, a.im)} : a;
            default:  // the argument of a negative number is pi
                return {op(O::arc_tangent_2, imaginary(a, node.place), a.re)};
        }
    }

    Pair of_complex(const Node& node, const Pair& a, const Pair& b) {
        const auto part = [&](Operation operation) {
            return Pair{op(operation, a.re, b.re),
                        op(operation, imaginary(a, node.place), imaginary(b, node.place))};
        };
        switch (node.operation) {
            case O::add:
            case O::subtract:
                return part(node.operation);
            case O::negate:
                return {op(O::negate, a.re), op(O::negate, a.im)};
            case O::multiply:
                return product(a, b);
            case O::divide:
                return quotient(a, b);
            case O::power:
                return power(node);
            case O::select:
                return chosen(node);
            case O::absolute:
                return {modulus(a)};
            default:
                return of_function(node, a);
        }
    }

    Pair chosen(const Node& node) {
        const Pair condition = pair(node.a), yes = pair(node.b), no = pair(node.c);
        return {op(O::select, condition.re, yes.re, no.re),
                op(O::select, condition.re, imaginary(yes, node.place), imaginary(no, node.place))};
    }

    Pair of_function(const Node& node, const Pair& z) {
        switch (node.operation) {
            case O::square_root:
                return square_root(z);
            case O::exponential:
                return exponential(z);
            case O::logarithm:
                return logarithm(z);
            case O::sine:
                return sine(z);
            case O::cosine:
                return cosine(z);
            case O::tangent:
                return quotient(sine(z), cosine(z));
            case O::hyperbolic_sine:
                return hyperbolic_sine(z);
            case O::hyperbolic_cosine:
                return hyperbolic_cosine(z);
            case O::hyperbolic_tangent:
                return quotient(hyperbolic_sine(z), hyperbolic_cosine(z));
            default:
                refuse(
                    node.sign,
                    is_condition(node.operation)
                        ? tell<"complex numbers have no order and are no condition: compare re, im, abs or "
                               "arg of them">()
                        : tell<"this function is one of real numbers; for a complex one there are + - * / ^, "
                               "exp, log, sqrt, sin, cos, tan, sinh, cosh, tanh, conj, abs, arg, re and "
                               "im">());
                return {constant(0.0, node.place)};
        }
    }

    const ParsedText& parsed_;
    TextProblems& problems_;
    ComplexNodes complex_;
    std::vector<Pair> pairs_;
    ParsedText made_;
    const Node* now_ = nullptr;
};

}  // namespace

std::string real_part_of(const std::string& name) {
    return name + "_re";
}

std::string imaginary_part_of(const std::string& name) {
    return name + "_im";
}

std::vector<std::string> complex_definitions(const ParsedText& parsed) {
    if (!has_complex_functions(parsed)) return {};
    const ComplexNodes nodes(parsed);
    return {nodes.names().begin(), nodes.names().end()};
}

ParsedText in_real_numbers(const ParsedText& parsed, TextProblems& problems) {
    if (!problems.empty() || !has_complex_functions(parsed)) return parsed;
    return Lowering(parsed, problems).run();
}

}  // namespace covaria::equation
