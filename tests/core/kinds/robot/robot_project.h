// projects/er10l-c10.covaria with changes, for tests. Millimetres.
#pragma once

#include <cmath>
#include <stdexcept>

#include "tests/core/kinds/robot/shipped_project.h"

namespace covaria::robot_test {

using Row = std::vector<double>;

struct Robot : ShippedProject {
    Robot() : ShippedProject("er10l-c10.covaria") {}

    covaria::Setup& asset_setup(const std::string& id) {
        for (AssetEntry& entry : project.assets)
            if (entry.id == id) return entry.setup;
        throw std::out_of_range(id);
    }
    /// A table of an asset, every column there.
    SetupTable& asset_table(const std::string& id, const std::string& key) {
        return std::get<SetupTable>(asset_setup(id).values.at(key));
    }
    std::shared_ptr<const Asset> asset(const std::string& id) {
        problems = {};
        assets = made_assets(project, problems);
        const AssetLibrary::Entry* entry = assets.find(id);
        if (!entry) throw std::runtime_error(words());
        return entry->asset;
    }

    std::shared_ptr<const PreparedAnalysis> prepare(const std::string& id) override {
        problems = {};
        assets = made_assets(project, problems);
        return made_analysis(project, id, problems);
    }

    AssetLibrary assets;
};

inline Row each(const UncertaintyResult& r, double (*value)(const OutputResult&)) {
    Row row;
    for (const OutputResult& y : r.outputs) row.push_back(1e3 * value(y));
    return row;
}
inline Row estimates(const UncertaintyResult& r) {
    return each(r, [](const OutputResult& y) { return y.estimate; });
}
inline Row estimates_first_order(const UncertaintyResult& r) {
    return each(r, [](const OutputResult& y) { return y.first_order.estimate; });
}
inline Row u(const UncertaintyResult& r) {
    return each(r, [](const OutputResult& y) { return y.standard_uncertainty; });
}
/// XX, YY, ZZ, XY, XZ, YZ in mm².
inline Row covariance(const UncertaintyResult& r) {
    const Eigen::MatrixXd C = 1e6 * r.covariance.whole();
    return {C(0, 0), C(1, 1), C(2, 2), C(0, 1), C(0, 2), C(1, 2)};
}
inline const BudgetRow* budget_row(const UncertaintyResult& r, std::size_t output,
                                   const std::string& quantity) {
    for (const BudgetRow& row : r.budget.rows[output])
        if (r.budget.components[row.component].quantities == std::vector<std::string>{quantity}) return &row;
    return nullptr;
}
/// u of x, y, z in the zero pose, had the parameters that an analysis finds nothing in common.
inline Row u_without_correlation(Robot& robot, const std::string& identification) {
    const UncertaintyResult found = robot.run(identification, 0), zero = robot.run("zero-pose", 0);
    Row u(3);
    for (const OutputResult& parameter : found.outputs)
        for (std::size_t i = 0; i < 3; ++i)
            if (const BudgetRow* row = budget_row(zero, i, parameter.quantity.symbol))
                u[i] = std::hypot(u[i], 1e3 * row->sensitivity * parameter.standard_uncertainty);
    return u;
}

}  // namespace covaria::robot_test
