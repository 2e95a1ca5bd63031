// Set-ups of test sheets made in a test, and what their models say.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <string>

#include "core/kinds/registries.h"
#include "core/model/asset.h"
#include "core/propagation/engine.h"
#include "tests/core/table_rows.h"

namespace covaria::sheets_test {

inline std::unique_ptr<MeasurementModel> made(const char* id, const covaria::Setup& setup,
                                              Problems& problems) {
    const ModelDescriptor& d = *find_model(id);
    check_setup(d.schema, setup, problems);
    if (problems.has_errors()) return nullptr;
    return d.create(SetupReader(d.schema, setup), AssetLibrary{}, problems);
}

inline std::unique_ptr<MeasurementModel> made(const char* id, const covaria::Setup& setup) {
    Problems problems;
    auto model = made(id, setup, problems);
    for (const Problem& p : problems.items())
        if (p.severity == Severity::error) ADD_FAILURE() << p.path << " " << p.message.english();
    if (!model) throw std::runtime_error("no model");
    return model;
}

inline Table table_of(const std::vector<Table>& tables, const std::string& id) {
    for (const Table& table : tables)
        if (table.id == id) return table;
    throw std::runtime_error("no table " + id);
}

inline FirstOrderOutput first_order(const MeasurementModel& model, const std::string& symbol) {
    const auto result = evaluate_first_order(model, model.inputs(), {});
    if (!result) throw std::runtime_error(result.error().message.english());
    for (std::size_t j = 0; j < model.outputs().size(); ++j)
        if (model.outputs()[j].symbol == symbol) return result->outputs[j].first_order;
    throw std::runtime_error("no output " + symbol);
}

/// The number of a cell; of a quantity, in its unit.
inline double value(const Cell& cell) {
    return std::holds_alternative<Quantity>(cell) ? std::get<Quantity>(cell).value
                                                  : std::get<Measured>(cell).si;
}

}  // namespace covaria::sheets_test
