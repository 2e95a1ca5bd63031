// Compiler from statements to a program: order, names, dimensions.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/base/in_quotes.h"
#include "core/equation/derivative.h"
#include "core/equation/emitter.h"

namespace covaria::equation {

namespace {

constexpr std::size_t most_dimension_problems = 20;

/// Statements so that each comes after those it refers to; a circle is reported.
class StatementOrder {
public:
    StatementOrder(const ParsedText& parsed, TextProblems& problems) : parsed_(parsed), problems_(problems) {
        for (std::size_t s = 0; s < parsed.statements.size(); ++s)
            for (const Definition& d : parsed.statements[s].defined) owner_[d.name] = s;
        state_.assign(parsed.statements.size(), State::unseen);
    }

    std::vector<std::size_t> run() {
        for (std::size_t s = 0; s < parsed_.statements.size(); ++s)
            if (state_[s] == State::unseen) visit(s);
        return std::move(order_);
    }

private:
    enum class State { unseen, open, done };
    struct Open {
        std::size_t statement;
        std::size_t next_node;
    };

    void enter(std::size_t s) {
        state_[s] = State::open;
        open_.push_back({s, parsed_.statements[s].first_node});
    }

    // The walk has a stack of its own: chains of definitions may be long.
    void visit(std::size_t s) {
        enter(s);
        while (!open_.empty()) {
            Open& top = open_.back();
            const Statement& statement = parsed_.statements[top.statement];
            if (top.next_node == statement.last_node) {
                state_[top.statement] = State::done;
                order_.push_back(top.statement);
                open_.pop_back();
                continue;
            }
            const std::size_t at = top.next_node++;
            follow(parsed_.nodes[at], top.statement, at >= statement.first_of_equations);
        }
    }

    void follow(const Node& node, std::size_t user, bool in_equations) {
        if (node.operation != Operation::symbol) return;
        const auto owner = owner_.find(node.text);
        if (owner == owner_.end() || state_[owner->second] == State::done) return;
        if (owner->second == user && parsed_.statements[user].is_system() && in_equations) return;
        if (state_[owner->second] == State::unseen) return enter(owner->second);
        problems_.push_back(
            {node.place,
             tell<"'%1' is defined by itself here, directly or through other definitions; an equation that "
                  "is to be solved is written 'solve %1 = 1: ... = ...', with a starting value">(node.text)});
    }

    const ParsedText& parsed_;
    TextProblems& problems_;
    std::map<std::string, std::size_t, std::less<>> owner_;
    std::vector<State> state_;
    std::vector<Open> open_;
    std::vector<std::size_t> order_;
};

/// Nodes inside the second and third argument of an 'if': they need no value where they are not taken.
std::vector<bool> nodes_in_branches(const ParsedText& parsed) {
    std::vector<bool> in_branch(parsed.nodes.size(), false);
    for (std::size_t i = parsed.nodes.size(); i-- > 0;) {  // operands stand before what uses them
        const Node& n = parsed.nodes[i];
        const bool is_if = n.operation == Operation::select;
        for (const int operand : {n.a, n.b, n.c})
            if (operand >= 0 && (in_branch[i] || (is_if && operand != n.a)))
                in_branch[static_cast<std::size_t>(operand)] = true;
    }
    return in_branch;
}

Message text_of(const Node& node) {
    if (node.operation == Operation::symbol) return "'" + node.text + "'";
    if (node.operation == Operation::constant && !(node.unit == Unit{}))
        return node.text + " " + node.unit.text();
    if (node.operation == Operation::constant) return node.text;
    return tell<"the expression in columns %1-%2">(
        node.place.column, node.place.column + std::max<std::size_t>(node.place.length, 1) - 1);
}

/// Kind of a value that has been reported already: no further complaint follows from it.
Kind any_kind() {
    Kind any;
    any.any = true;
    return any;
}

Message unknown_symbol(const std::string& name) {
    return tell<
        "'%1' is neither defined nor one of the quantities: give it a row in the table of quantities">(name);
}

/// Objection to differences of temperatures that are wanted in degC.
Message difference_objection(const WantedOutput& wanted, const Kind& kind) {
    if (!wanted.unit || !wanted.unit->has_offset() || !kind.is_difference()) return {};
    return tell<"%1 is a difference of temperatures: its unit is K, not %2">(in_quotes(wanted.name),
                                                                             wanted.unit->text());
}

TemperatureKind temperature_of(const Kind& kind) {
    return kind.is_celsius()      ? TemperatureKind::reading
           : kind.is_difference() ? TemperatureKind::difference
                                  : TemperatureKind::by_unit;
}

/// For each node, the temperature in degC that is a factor of its value.
class ReadingsOfNodes {
public:
    explicit ReadingsOfNodes(const ParsedText& parsed)
        : parsed_(parsed), reading_(parsed.nodes.size(), nothing) {}

    /// Behind its operands; `kind_of` says of what kind a node is.
    template <class KindOf>
    void note(std::size_t node, const Kind& kind, const KindOf& kind_of) {
        const bool is_multiple = kind.has_celsius() && !kind.is_celsius();
        if (kind.readings == 0.0 && !is_multiple) return;
        const Node& of = parsed_.nodes[node];
        const bool is_sum = of.operation == Operation::add || of.operation == Operation::subtract;
        for (const int operand : {of.a, of.b, of.c}) {
            if (operand < 0 || reading_[node] >= 0) continue;
            const int below = reading_[static_cast<std::size_t>(operand)];
            reading_[node] = below >= 0 || is_sum || !kind_of(operand).is_celsius() ? below : operand;
        }
        if (of.operation != Operation::symbol) return;
        if (const auto defined = defined_.find(of.text); defined != defined_.end())
            reading_[node] = defined->second;
    }
    void define(const std::string& name, int root) {
        defined_[name] = reading_[static_cast<std::size_t>(root)];
    }

    /// The node itself where no other is known.
    const Node& of(int node) const {
        const int reading = reading_[static_cast<std::size_t>(node)];
        return parsed_.nodes[static_cast<std::size_t>(reading >= 0 ? reading : node)];
    }

private:
    static constexpr int nothing = -1;
    const ParsedText& parsed_;
    std::vector<int> reading_;
    std::map<std::string, int, std::less<>> defined_;
};

/// Text of an operand in an equation: "t", "20 [degC]"; "t" stands for longer expressions.
std::string written(const Node& node) {
    if (node.operation == Operation::symbol) return node.text;
    return node.operation == Operation::constant ? node.text + " [" + node.unit.text() + "]" : "t";
}

class Compiler {
public:
    Compiler(const ParsedText& parsed, std::span<const KnownSymbol> symbols, TextProblems& problems)
        : parsed_(parsed),
          symbols_(symbols),
          problems_(problems),
          emitter_(compiled_.program),
          readings_(parsed) {
        for (std::size_t i = 0; i < symbols.size(); ++i) quantity_[symbols[i].name] = i;
    }

    Compiled run(std::span<const WantedOutput> outputs) {
        const std::vector<std::size_t> order = StatementOrder(parsed_, problems_).run();
        if (!problems_.empty()) return {};
        registers_.assign(parsed_.nodes.size(), -1);
        in_branch_ = nodes_in_branches(parsed_);
        for (const std::size_t s : order) {
            if (parsed_.statements[s].is_system())
                system(parsed_.statements[s]);
            else
                definition(parsed_.statements[s]);
        }
        emitter_.finish();
        if (problems_.empty())
            for (const WantedOutput& output : outputs) add_output(output);
        return std::move(compiled_);
    }

private:
    void refuse(const Place& place, Message message) {
        if (problems_.size() < most_dimension_problems) problems_.push_back({place, std::move(message)});
    }
    int& at(int node) { return registers_[static_cast<std::size_t>(node)]; }

    /// Reports each temperature once, with all its places: they are mended together.
    void refuse_reading(int index) {
        const Operand used = operand(index);
        if (const Message sum = sum_objection(used); !sum.empty())
            return refuse(parsed_.nodes[static_cast<std::size_t>(index)].place, sum);
        const Node& reading = readings_.of(index);
        const bool is_multiple = used.kind.has_celsius() && !used.kind.is_celsius();
        const std::string text = written(reading);
        const auto [known, is_new] = refused_readings_.try_emplace(text, problems_.size());
        if (is_new)
            refuse(reading.place, is_multiple ? multiple_objection(used.text, scale_of(reading))
                                              : factor_objection(text_of(reading), text, scale_of(reading)));
        if (known->second >= problems_.size()) return;
        problems_[known->second].reading = text;
        problems_[known->second].readings.push_back(reading.place);
    }

    /// Unit of a temperature as it is written; degC for a computed one.
    Unit scale_of(const Node& reading) const {
        if (reading.operation == Operation::constant && reading.unit.has_offset()) return reading.unit;
        const auto known = quantity_.find(reading.text);
        const bool is_quantity = reading.operation == Operation::symbol && known != quantity_.end();
        const Unit unit = is_quantity ? symbols_[known->second].unit : Unit();
        return unit.has_offset() ? unit : Unit::of("degC");
    }

    void nodes(std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            registers_[i] = node(parsed_.nodes[i]);
            readings_.note(i, emitter_.kind(registers_[i]),
                           [&](int operand) { return emitter_.kind(at(operand)); });
        }
    }

    void definition(const Statement& s) {
        nodes(s.first_node, s.last_node);
        for (const Definition& d : s.defined) {  // the parts of a complex number are two
            if (emitter_.kind(at(d.root)).condition)
                refuse(d.place, tell<"'%1' would be a condition: a definition must give a number">(d.name));
            defined_[d.name] = at(d.root);
            readings_.define(d.name, d.root);
        }
    }

    void system(const Statement& s) {
        NewtonSystem made;
        nodes(s.first_node, s.first_of_equations);
        for (const Definition& d : s.defined) {
            Kind kind = emitter_.kind(at(d.root));
            kind.any = false;
            made.starts.push_back(at(d.root));
            made.unknowns.push_back(emitter_.unknown(kind));
            defined_[d.name] = made.unknowns.back();
        }
        emitter_.begin_system();
        const std::size_t first = compiled_.program.instructions.size();
        nodes(s.first_of_equations, s.last_node);
        for (const Residual& r : s.equations) made.residuals.push_back(residual(r));
        const auto& all = compiled_.program.instructions;
        const std::vector<Instruction> own(all.begin() + static_cast<std::ptrdiff_t>(first), all.end());
        made.jacobian = emit_jacobian(emitter_, own, made.residuals, made.unknowns);
        check_jacobian(s, made);
        emitter_.end_system(std::move(made));
    }

    int residual(const Residual& r) {
        emitter_.set_place(r.place);
        const Operand left = operand(r.left), right = operand(r.right);
        const KindOfResult result = kind_of(Operation::subtract, left, right, {});
        if (const auto misused = misused_reading(Operation::equal, left, right, {}))
            refuse_reading(*misused == 0 ? r.left : r.right);
        else if (!result.objection.empty())
            refuse(r.place, tell<"%1 is %2, %3 is %4: they cannot be equal">(
                                left.text, kind_words(left.kind), right.text, kind_words(right.kind)));
        else if (const Message objection = zeros_objection(left, right); !objection.empty())
            refuse(r.place, objection);
        return emitter_.operation(Operation::subtract, at(r.left), at(r.right), -1, result.kind);
    }

    void check_jacobian(const Statement& s, const NewtonSystem& made) {
        const std::size_t n = made.size();
        for (std::size_t k = 0; k < n; ++k) {
            bool occurs = false;
            for (std::size_t r = 0; r < n; ++r) occurs = occurs || made.jacobian[r * n + k] >= 0;
            if (!occurs)
                refuse(s.defined[k].place,
                       tell<"the equations do not depend on the unknown '%1'">(s.defined[k].name));
        }
        for (std::size_t r = 0; r < n; ++r) {
            bool depends = false;
            for (std::size_t k = 0; k < n; ++k) depends = depends || made.jacobian[r * n + k] >= 0;
            if (!depends)
                refuse(s.equations[r].place, tell<"this equation does not depend on any unknown">());
        }
    }

    Operand operand(int index) {
        if (index < 0) return {};
        const Node& node = parsed_.nodes[static_cast<std::size_t>(index)];
        return {emitter_.kind(at(index)), emitter_.value(at(index)), text_of(node)};
    }

    int node(const Node& node) {
        if (node.operation == Operation::constant) return constant(node);
        if (node.operation == Operation::symbol) return symbol(node);
        const Operand a = operand(node.a), b = operand(node.b), c = operand(node.c);
        KindOfResult result = kind_of(node.operation, a, b, c);
        const auto misused = misused_reading(node.operation, a, b, c);
        if (misused)
            refuse_reading(std::array{node.a, node.b, node.c}[*misused]);
        else if (!result.objection.empty())
            refuse(node.sign, result.objection);
        if (misused || !result.objection.empty())
            result.kind = is_condition(node.operation) ? Kind::of_condition() : any_kind();
        emitter_.set_place(node.place);
        const auto reg = [&](int i) { return i < 0 ? -1 : at(i); };
        const int made =
            node.operation == Operation::power
                ? emitter_.power(at(node.a), at(node.b), result.kind)
                : emitter_.operation(node.operation, reg(node.a), reg(node.b), reg(node.c), result.kind);
        const auto value = emitter_.value(made);
        const bool may_be_left_out = in_branch_[static_cast<std::size_t>(&node - parsed_.nodes.data())];
        if (value && !std::isfinite(*value) && !may_be_left_out)
            refuse(node.sign,
                   tell<"this constant has no value (division by zero, or root of a negative number)">());
        return made;
    }

    int constant(const Node& node) {
        Kind kind = Kind::of(node.unit);
        kind.any = node.value == 0.0 && node.unit == Unit{};
        return emitter_.constant(node.value, kind);
    }

    int symbol(const Node& node) {
        if (const auto defined = defined_.find(node.text); defined != defined_.end()) return defined->second;
        if (const auto known = quantity_.find(node.text); known != quantity_.end())
            return emitter_.input(known->second, Kind::of(symbols_[known->second].unit));
        if (unknown_.insert(node.text).second) refuse(node.place, unknown_symbol(node.text));
        return emitter_.unknown(any_kind());
    }

    void add_output(const WantedOutput& wanted) {
        const auto defined = defined_.find(wanted.name);
        if (defined == defined_.end()) return refuse({}, tell<"no equation defines '%1'">(wanted.name));
        const Kind& kind = emitter_.kind(defined->second);
        const Definition& definition = *parsed_.find(wanted.name);
        const Place place = definition.place;
        const std::string coherent = coherent_unit(kind);
        if (wanted.unit && !kind.same_dimension(Kind::of(*wanted.unit)))
            refuse(place, tell<"'%1' is to be given in %2, but is %3">(wanted.name, wanted.unit->text(),
                                                                       kind_words(kind)));
        if (kind.readings != 0.0 || (kind.has_celsius() && !kind.is_celsius()))
            refuse_reading(definition.root);
        else if (const Message meaning = difference_objection(wanted, kind); !meaning.empty())
            refuse(place, meaning);
        if (!wanted.unit && coherent.empty())
            refuse(place, tell<"'%1' is %2, which has no unit of its own">(wanted.name, kind_words(kind)));
        compiled_.program.outputs.push_back(defined->second);
        const Unit unit = wanted.unit ? *wanted.unit : unit_of_inputs(kind, coherent);
        compiled_.outputs.push_back({unit, temperature_of(kind), kind.on_circle && is_circle_unit(unit)});
    }

    /// Temperatures keep the coherent unit: one in degC may be a difference.
    Unit unit_of_inputs(const Kind& kind, const std::string& coherent) const {
        const Unit otherwise = Unit::parse(coherent).value_or(Unit{});
        if (kind.is_number() || otherwise.dimension() == Unit::of("K").dimension()) return otherwise;
        const auto same = std::find_if(symbols_.begin(), symbols_.end(), [&](const KnownSymbol& known) {
            return known.unit.dimension() == otherwise.dimension();
        });
        return same == symbols_.end() ? otherwise : same->unit;
    }

    const ParsedText& parsed_;
    std::span<const KnownSymbol> symbols_;
    TextProblems& problems_;
    Compiled compiled_;
    Emitter emitter_;
    std::map<std::string, std::size_t, std::less<>> quantity_;
    std::map<std::string, int, std::less<>> defined_;
    std::set<std::string> unknown_;
    ReadingsOfNodes readings_;
    std::map<std::string, std::size_t> refused_readings_;  ///< index of the problem by its text
    std::vector<int> registers_;                           ///< register of each node
    std::vector<bool> in_branch_;                          ///< whether each node is in a branch
};

}  // namespace

Compiled compile(const ParsedText& parsed, std::span<const KnownSymbol> symbols,
                 std::span<const WantedOutput> outputs, TextProblems& problems) {
    return Compiler(parsed, symbols, problems).run(outputs);
}

}  // namespace covaria::equation
