// Reads the set-up of "measurement equation": parses, checks and compiles.
#include "core/kinds/equation/setup.h"

#include <algorithm>
#include <set>

#include "core/equation/complex_numbers.h"
#include "core/setup/message_text.h"
#include "core/text/symbol.h"

namespace covaria::equation_model {

namespace {

/// Names that equations define and no other equation uses.
std::vector<equation::Definition> last_definitions(const equation::ParsedText& parsed) {
    std::set<std::string> used;
    std::vector<equation::Definition> found;
    for (const equation::Statement& s : parsed.statements)
        for (std::size_t i = s.first_node; i < s.last_node; ++i) {
            const equation::Node& node = parsed.nodes[i];
            const bool own = std::any_of(s.defined.begin(), s.defined.end(),
                                         [&](const equation::Definition& d) { return d.name == node.text; });
            if (node.operation == equation::Operation::symbol && !own) used.insert(node.text);
        }
    for (const equation::Statement& s : parsed.statements)
        for (const equation::Definition& d : s.defined)
            if (!used.contains(d.name)) found.push_back(d);
    return found;
}

class SetupBuilder {
public:
    SetupBuilder(const StatedEquations& stated, Problems& problems) : stated_(stated), problems_(problems) {}

    std::optional<EquationSetup> build() {
        EquationSetup setup;
        equation::TextProblems found;
        setup.parsed = equation::parse(stated_.text, found);
        if (found.empty() && setup.parsed.statements.empty())
            found.push_back({{}, tell<"there is no equation: write one, y = x_1 + x_2">()});
        StatedQuantities stated = read_quantities(stated_, problems_);
        const equation::ParsedText real = equation::in_real_numbers(setup.parsed, found);
        check_names(setup.parsed, stated);
        const auto wanted = wanted_outputs(real, setup.outputs);
        if (found.empty() && !problems_.has_errors()) {
            equation::Compiled compiled = equation::compile(real, stated.symbols, wanted, found);
            setup.program = std::move(compiled.program);
            for (std::size_t j = 0; j < compiled.outputs.size(); ++j) {
                setup.outputs[j].unit = compiled.outputs[j].unit;
                setup.outputs[j].periodic = compiled.outputs[j].on_circle;
                setup.outputs[j].temperature = compiled.outputs[j].temperature;
            }
        }
        report(found, stated_, problems_);
        setup.inputs = std::move(stated.inputs);
        setup.observed = std::move(stated.observed);
        if (problems_.has_errors()) return std::nullopt;
        return setup;
    }

private:
    void check_names(const equation::ParsedText& parsed, const StatedQuantities& stated) {
        std::set<std::string> used;
        for (const equation::SymbolUse& use : equation::free_symbols(parsed)) used.insert(use.name);
        for (std::size_t i = 0; i < stated.symbols.size(); ++i) {
            const std::string& name = stated.symbols[i].name;
            const std::string path = equation_fields().place(&StatedEquations::components, stated.rows[i],
                                                             &StatedComponent::symbol);
            if (parsed.find(name))
                problems_.error(path,
                                tell<"'%1' is defined by an equation: it cannot be a quantity too">(name));
            else if (!used.contains(name) && !parsed.statements.empty())
                problems_.warning(path, tell<"no equation uses '%1'">(name));
        }
    }

    std::vector<equation::WantedOutput> wanted_outputs(const equation::ParsedText& parsed,
                                                       std::vector<OutputQuantity>& outputs) {
        std::vector<equation::WantedOutput> wanted;
        for (std::size_t row = 0; row < stated_.outputs.size(); ++row) add_row(parsed, row, wanted, outputs);
        if (!stated_.outputs.empty()) return wanted;
        for (const equation::Definition& d : last_definitions(parsed)) {
            wanted.push_back({d.name, std::nullopt});
            outputs.push_back({.symbol = d.name, .name = d.name});
        }
        return wanted;
    }

    void add_row(const equation::ParsedText& parsed, std::size_t row,
                 std::vector<equation::WantedOutput>& wanted, std::vector<OutputQuantity>& outputs) {
        const StatedOutput& stated = stated_.outputs[row];
        const std::string path =
            equation_fields().place(&StatedEquations::outputs, row, &StatedOutput::symbol);
        const std::string symbol = plain_symbol(stated.symbol);
        if (!parsed.find(symbol) && !parsed.statements.empty()) {
            std::vector<std::string> names;
            for (const equation::Statement& s : parsed.statements)
                for (const equation::Definition& d : s.defined) names.push_back(d.name);
            if (parsed.find(equation::real_part_of(symbol)))
                problems_.error(path, tell<"'%1' is complex: list its parts %2 and %3, or define abs(%1) and "
                                           "arg(%1) and list these">(symbol, equation::real_part_of(symbol),
                                                                     equation::imaginary_part_of(symbol)));
            else
                problems_.error(path,
                                tell<"no equation defines '%1'%2">(symbol, did_you_mean(symbol, names)));
        }
        if (std::any_of(wanted.begin(), wanted.end(), [&](const auto& w) { return w.name == symbol; }))
            problems_.error(path, tell<"'%1' is listed twice">(symbol));
        equation::WantedOutput output{symbol, std::nullopt};
        if (!stated.unit.empty()) {
            const Result<Unit> unit = Unit::parse(stated.unit);
            if (unit)
                output.unit = *unit;
            else
                problems_.error(equation_fields().place(&StatedEquations::outputs, row, &StatedOutput::unit),
                                unit.error().message);
        }
        wanted.push_back(output);
        outputs.push_back({.symbol = symbol,
                           .name = stated.name.empty() ? symbol : stated.name,
                           .group = stated.group,
                           .role = stated.role});
    }

    const StatedEquations& stated_;
    Problems& problems_;
};

SetupTable empty_table(const FieldSpec& field) {
    SetupTable table;
    for (const ColumnSpec& column : field.columns) table.units.push_back(column.unit);
    return table;
}

bool has_symbol(const SetupTable& table, const std::string& symbol) {
    return std::any_of(table.rows.begin(), table.rows.end(), [&](const std::vector<SetupCell>& row) {
        const std::string* text = row.empty() ? nullptr : std::get_if<std::string>(&row.front());
        return text && plain_symbol(*text) == symbol;
    });
}

}  // namespace

std::string path_of(const equation::Place& place) {
    const std::size_t end = place.column + std::max<std::size_t>(place.length, 1) - 1;
    return equation_fields().place(&StatedEquations::text) + "/" + std::to_string(place.line - 1) + "/" +
           std::to_string(place.column) + "-" + std::to_string(end);
}

void report(const equation::TextProblems& found, Problems& problems) {
    for (const equation::TextProblem& problem : found)
        problems.error(path_of(problem.place), place_words(problem.place) + problem.message);
}

std::optional<EquationSetup> read_equation_setup(const SetupReader& reader, const AssetLibrary& assets,
                                                 Problems& problems) {
    const StatedEquations stated = equation_fields().read(reader, assets, problems);
    return SetupBuilder(stated, problems).build();
}

Setup with_rows_for_names(const Setup& setup) {
    const auto& fields = equation_fields();
    const SetupSchema schema = fields.schema();
    equation::TextProblems ignored;
    const auto* text =
        std::get_if<std::string>(&value_of(*schema.find(fields.key(&StatedEquations::text)), setup));
    const equation::ParsedText parsed = equation::parse(text ? *text : "", ignored);
    Setup completed = setup;
    const auto add_row = [&](const std::string& key, const std::string& symbol) {
        const FieldSpec& field = *schema.find(key);
        const auto* given = std::get_if<SetupTable>(&completed.values[key]);
        SetupTable table = given ? *given : empty_table(field);
        if (has_symbol(table, symbol)) return;
        std::vector<SetupCell> row(field.columns.size());
        row.front() = symbol;
        table.rows.push_back(std::move(row));
        completed.values[key] = std::move(table);
    };
    for (const equation::SymbolUse& use : equation::free_symbols(parsed))
        add_row(fields.key(&StatedEquations::components), use.name);
    for (const equation::Definition& d : last_definitions(equation::in_real_numbers(parsed, ignored)))
        add_row(fields.key(&StatedEquations::outputs), d.name);
    std::erase_if(completed.values,
                  [](const auto& entry) { return std::holds_alternative<std::monostate>(entry.second); });
    return completed;
}

}  // namespace covaria::equation_model
