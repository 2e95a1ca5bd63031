#include "core/readers/stated_budget.h"

#include <cctype>

#include "core/equation/operations.h"
#include "core/equation/parser.h"
#include "core/readers/entry_texts.h"
#include "core/text/symbol.h"

namespace covaria {

namespace {

constexpr const char* budget_kind = "measurement-equation";
constexpr std::size_t longest_symbol = 24;

SetupCell optional_figure(const std::optional<double>& figure) {
    return figure ? SetupCell(*figure) : SetupCell();
}
SetupCell optional_text(const std::string& text) {
    return text.empty() ? SetupCell() : SetupCell(text);
}

void add_component(TableRows& rows, const std::string& symbol, const std::string& name, SetupCell value,
                   const NotedComponent& c) {
    rows.add({{"symbol", symbol},
              {"name", optional_text(name)},
              {"value", std::move(value)},
              {"unit", c.unit.text()},
              {"statement", optional_text(c.statement)},
              {"a", optional_figure(c.a)},
              {"b", optional_figure(c.b)},
              {"nu", optional_figure(c.degrees_of_freedom)},
              {"source", optional_text(c.source)}});
}

/// Adds a quantity. One with a single component in its own unit is one row; others have a row for each
/// component.
void add_quantity(TableRows& rows, TableRows& observations, const NotedQuantity& q) {
    for (std::size_t i = 0; i < q.observations.size(); ++i)
        observations.add(
            {{"quantity", q.symbol},
             {"number", q.observed_together ? SetupCell(static_cast<double>(i + 1)) : SetupCell()},
             {"value", q.observations[i]}});
    if (q.observations.empty() && q.components.size() == 1 && q.components.front().unit == q.unit)
        return add_component(rows, q.symbol, q.name, q.value, q.components.front());
    if (q.observations.empty())
        add_component(rows, q.symbol, q.name, q.value, {.unit = q.unit});
    else
        add_component(rows, q.symbol, q.name, SetupCell(), {.statement = "observations", .unit = q.unit});
    for (const NotedComponent& c : q.components) add_component(rows, q.symbol, c.name, SetupCell(), c);
}

bool is_symbol_text(const std::string& text) {
    if (text.empty() || text.size() > longest_symbol) return false;
    for (const char c : text)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_') return false;
    return std::isalpha(static_cast<unsigned char>(text.front())) && text.back() != '_' &&
           !equation::is_reserved(text);
}

}  // namespace

AnalysisEntry analysis_of(const StatedBudget& budget) {
    TableRows rows(table_of(budget_kind, "quantities")), outputs(table_of(budget_kind, "outputs")),
        observations(table_of(budget_kind, "observations"));
    for (const NotedQuantity& q : budget.quantities) add_quantity(rows, observations, q);
    for (const NotedResult& r : budget.results)
        outputs.add({{"symbol", r.symbol},
                     {"name", optional_text(r.name)},
                     {"unit", r.unit ? SetupCell(r.unit->text()) : SetupCell()}});
    AnalysisEntry analysis{.id = budget.id, .model = budget_kind, .name = budget.name, .notes = budget.notes};
    analysis.setup.values["equations"] = budget.equations;
    analysis.setup.values["quantities"] = rows.table();
    if (!budget.results.empty()) analysis.setup.values["outputs"] = outputs.table();
    if (!observations.table().rows.empty()) analysis.setup.values["observations"] = observations.table();
    for (const StatedCorrelation& c : budget.correlations)
        if (c.coefficient != 0.0)
            analysis.correlations.push_back(
                {budget.quantities[c.first].symbol, budget.quantities[c.second].symbol, c.coefficient});
    return analysis;
}

std::string SymbolNames::take(const std::string& text) {
    std::string symbol = plain_symbol(plain_name(text));
    // The symbol of "δl" is delta_l: "deltal" would be a word.
    if (const auto greek = greek_letter_at(plain_name(text));
        greek && greek->name.size() < symbol.size() &&
        std::isalpha(static_cast<unsigned char>(symbol[greek->name.size()])))
        symbol.insert(greek->name.size(), 1, '_');
    if (!is_symbol_text(symbol)) symbol = "x_" + std::to_string(taken_.size() + 1);
    const std::string wanted = symbol;
    for (int n = 2; !taken_.insert(symbol).second; ++n) symbol = wanted + "_" + std::to_string(n);
    return symbol;
}

Message equation_complaint(const std::string& equations) {
    equation::TextProblems problems;
    equation::parse(equations, problems);
    if (problems.empty()) return {};
    return equation::place_words(problems.front().place) + problems.front().message;
}

}  // namespace covaria
