// Set-ups of calibration curves for tests.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <stdexcept>

#include "core/kinds/registries.h"
#include "core/model/asset.h"
#include "core/propagation/engine.h"

namespace covaria::curve_setups {

struct Points {
    std::vector<double> x, u_x, y, u_y;
};

inline covaria::Setup setup_of(const Points& points, const std::string& uncertainty, int degree = 1) {
    covaria::Setup setup;
    SetupTable table;
    table.units.assign(4, Unit{});
    for (std::size_t i = 0; i < points.x.size(); ++i)
        table.rows.push_back({points.x[i], points.u_x.empty() ? SetupCell{} : SetupCell(points.u_x[i]),
                              points.y[i], points.u_y.empty() ? SetupCell{} : SetupCell(points.u_y[i])});
    setup.values["points"] = table;
    setup.values["uncertainty"] = uncertainty;
    setup.values["degree"] = Quantity{double(degree), Unit{}};
    return setup;
}

inline std::unique_ptr<MeasurementModel> model_of(const covaria::Setup& setup, Problems& problems) {
    const ModelDescriptor& d = *find_model("calibration-curve");
    check_setup(d.schema, setup, problems);
    if (problems.has_errors()) return nullptr;
    return d.create(SetupReader(d.schema, setup), AssetLibrary{}, problems);
}

inline void set_number(covaria::Setup& setup, const std::string& key, double value) {
    setup.values[key] = Quantity{value, Unit{}};
}

inline void use_at(covaria::Setup& setup, const std::vector<double>& places) {
    SetupTable table;
    table.units.assign(2, Unit{});
    for (const double x : places) table.rows.push_back({x, SetupCell{}});
    setup.values["predictions"] = table;
}

struct Observed {
    double y = 0.0;
    std::optional<double> u_y = {}, readings = {}, near = {};
};

inline void use_inversely(covaria::Setup& setup, const std::vector<Observed>& observed) {
    SetupTable table;
    table.units.assign(5, Unit{});
    const auto cell = [](const std::optional<double>& v) { return v ? SetupCell(*v) : SetupCell{}; };
    for (const Observed& o : observed)
        table.rows.push_back({o.y, cell(o.u_y), cell(o.readings), cell(o.near), SetupCell{}});
    setup.values["inverse"] = table;
}

inline const OutputResult& output(const UncertaintyResult& result, const std::string& symbol) {
    for (const OutputResult& o : result.outputs)
        if (o.quantity.symbol == symbol) return o;
    throw std::runtime_error("no output " + symbol);
}

inline UncertaintyResult first_order(const covaria::Setup& setup) {
    Problems problems;
    const auto model = model_of(setup, problems);
    for (const Problem& p : problems.items())
        if (p.severity == Severity::error) ADD_FAILURE() << p.path << " " << p.message.english();
    return evaluate_first_order(*model, model->inputs(), {}).value();
}

inline Points five() {
    return {{-2, -1, 0, 1, 2}, {}, {0.1, 0.9, 2.2, 2.9, 4.1}, {}};
}

}  // namespace covaria::curve_setups
