// Set-ups of "geometry from points" for tests, in mm.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <string>

#include "core/kinds/registries.h"
#include "core/propagation/engine.h"
#include "core/text/cell.h"
#include "tests/core/kinds/geometry/nist_points.h"
#include "tests/core/table_rows.h"

namespace covaria::geometry_test {

struct NamedPoints {
    std::string name, form;
    Points points;
    bool reversed = false;
};

/// Columns of points as the schema has them: feature, name, x y z, u_x u_y u_z, r_xy r_xz r_yz.
inline covaria::Setup setup_of(const std::vector<NamedPoints>& features, double u_mm = 0.005) {
    covaria::Setup setup;
    SetupTable forms, points;
    const Unit mm = Unit::of("mm"), one;
    forms.units.assign(3, one);
    points.units = {one, one, mm, mm, mm, mm, mm, mm, one, one, one};
    for (const NamedPoints& feature : features) {
        forms.rows.push_back({feature.name, feature.form, feature.reversed});
        for (std::size_t i = 0; i < feature.points.size(); ++i) {
            const Eigen::Vector3d& p = feature.points[i];
            points.rows.push_back(
                {feature.name, std::to_string(i + 1), p.x(), p.y(), p.z(), {}, {}, {}, {}, {}, {}});
        }
    }
    setup.values["features"] = forms;
    setup.values["points"] = points;
    setup.values["u_point"] = Quantity{u_mm, mm};
    return setup;
}

inline std::unique_ptr<MeasurementModel> model_of(const covaria::Setup& setup, Problems& problems) {
    const ModelDescriptor& d = *find_model("geometry-from-points");
    check_setup(d.schema, setup, problems);
    if (problems.has_errors()) return nullptr;
    return d.create(SetupReader(d.schema, setup), AssetLibrary{}, problems);
}

inline std::unique_ptr<MeasurementModel> made(const covaria::Setup& setup) {
    Problems problems;
    auto model = model_of(setup, problems);
    for (const Problem& p : problems.items())
        if (!model) ADD_FAILURE() << p.path << " " << p.message.english();
    if (!model) throw std::runtime_error("no model");
    return model;
}

inline std::string first_error(const covaria::Setup& setup) {
    Problems problems;
    model_of(setup, problems);
    for (const Problem& p : problems.items())
        if (p.severity == Severity::error) return p.path + ": " + p.message.english();
    return {};
}

inline std::vector<double> estimates(const MeasurementModel& model) {
    std::vector<double> x;
    for (std::size_t i = 0; i < model.inputs().quantities.size(); ++i)
        x.push_back(estimate_of(model.inputs(), i));
    return x;
}

/// Results by group and symbol, SI.
using Results = std::map<std::string, double>;
inline Results results_of(const MeasurementModel& model) {
    std::vector<double> y(model.outputs().size());
    const std::vector<double> x = estimates(model);
    EXPECT_TRUE(model.evaluate(x, y));
    Results results;
    for (std::size_t j = 0; j < y.size(); ++j)
        results[model.outputs()[j].group + "." + model.outputs()[j].symbol] = y[j];
    return results;
}
inline Eigen::Vector3d place_in(const Results& results, const std::string& group) {
    return 1e3 *
           Eigen::Vector3d(results.at(group + ".x"), results.at(group + ".y"), results.at(group + ".z"));
}
inline Eigen::Vector3d direction_in(const Results& results, const std::string& group) {
    return {results.at(group + ".n_x"), results.at(group + ".n_y"), results.at(group + ".n_z")};
}

inline std::vector<double> column(const MeasurementModel& model, const std::string& id,
                                  const std::string& word) {
    std::vector<double> found;
    for (const Table& table : model.evaluation())
        for (const auto& row : test::rows_of(table))
            if (table.id == id && english_of(row[1]).find(word) != std::string::npos)
                found.push_back(std::holds_alternative<Quantity>(row[2]) ? std::get<Quantity>(row[2]).value
                                                                         : test::si_of(row[2]));
    return found;
}

}  // namespace covaria::geometry_test
