#include "core/readers/stated_quantities.h"

#include <cmath>

#include "core/readers/entry_texts.h"

namespace covaria {

namespace {

constexpr const char* equation_kind = "measurement-equation";

SetupCell cell_of(const std::optional<double>& figure) {
    return figure ? SetupCell(*figure) : SetupCell();
}
SetupCell cell_of(const std::string& text) {
    return text.empty() ? SetupCell() : SetupCell(text);
}

}  // namespace

AnalysisEntry analysis_of(const std::string& id, const std::string& name, const std::string& notes,
                          const std::vector<StatedQuantity>& quantities,
                          const std::vector<StatedCorrelation>& correlations) {
    TableRows rows(table_of(equation_kind, "quantities")), outputs(table_of(equation_kind, "outputs"));
    std::string equations;
    for (const StatedQuantity& q : quantities) {
        const std::string result = "y_" + q.symbol;
        equations += (equations.empty() ? "" : "\n") + result + " = " + q.symbol;
        rows.add({{"symbol", q.symbol},
                  {"name", cell_of(q.name)},
                  {"value", q.value},
                  {"unit", q.unit.text()},
                  {"statement", cell_of(q.statement)},
                  {"a", cell_of(q.a)},
                  {"b", cell_of(q.b)},
                  {"nu", cell_of(q.degrees_of_freedom)},
                  {"source", cell_of(q.source)}});
        outputs.add({{"symbol", result},
                     {"name", cell_of(q.name)},
                     {"unit", q.unit.text()},
                     {"group", cell_of(q.group)}});
    }
    AnalysisEntry analysis{.id = id, .model = equation_kind, .name = name, .notes = notes};
    analysis.setup.values["equations"] = equations;
    analysis.setup.values["quantities"] = rows.table();
    analysis.setup.values["outputs"] = outputs.table();
    for (const StatedCorrelation& c : correlations)
        if (c.coefficient != 0.0)
            analysis.correlations.push_back(
                {quantities[c.first].symbol, quantities[c.second].symbol, c.coefficient});
    return analysis;
}

}  // namespace covaria
