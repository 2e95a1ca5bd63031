// projects/force-moment-sensor.covaria with changes: for the tests of Kim's force/moment sensor.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/made/load_project.h"
#include "core/project/project.h"

namespace covaria {

class ForceProject {
public:
    ForceProject();

    covaria::Setup& asset(const std::string& id);
    AnalysisEntry& analysis(const std::string& id);
    SetupTable& table(const std::string& asset_id, const std::string& key);
    /// Rows of the readings of "sensor" with these cells.
    struct Place {
        std::string axis, series, phase;
        int run = 0, step = -1;  ///< -1: all steps
    };
    /// Changes or, when `change` returns false, removes the rows at a place.
    void change_readings(const Place& place, const std::function<bool(std::vector<SetupCell>&)>& change);
    void remove_readings(const Place& place) {
        change_readings(place, [](auto&) { return false; });
    }
    std::size_t column(const std::string& key) const;  ///< column of the readings

    std::shared_ptr<const PreparedAnalysis> prepare(const std::string& analysis_id);
    UncertaintyResult first_order(const std::string& analysis_id);
    UncertaintyResult monte_carlo(const std::string& analysis_id, std::uint64_t trials);
    std::vector<Table> asset_tables(const std::string& id);
    std::vector<Table> model_tables(const std::string& analysis_id);

    std::string words() const;
    bool refuses(const std::string& analysis_id, const std::string& expected);
    bool warns(const std::string& analysis_id, const std::string& expected);

    Project project;
    Problems problems;
};

const Table& table_with(const std::vector<Table>& tables, const std::string& id);
/// Numbers of a column, in the unit of the table's head or of the cell; NaN for other cells.
std::vector<double> numbers(const Table& table, std::size_t column);

}  // namespace covaria
