#include "tests/core/kinds/force/force_project.h"

#include <cmath>
#include <stdexcept>

#include "core/base/resource_path.h"
#include "core/kinds/registries.h"
#include "tests/core/made.h"

namespace covaria {

ForceProject::ForceProject() {
    LoadedProject loaded = load_project(data_directory() / "projects/force-moment-sensor.covaria");
    project = std::move(loaded.project);
    problems = std::move(loaded.problems);
    if (problems.has_errors()) throw std::runtime_error(words());
}

covaria::Setup& ForceProject::asset(const std::string& id) {
    for (AssetEntry& entry : project.assets)
        if (entry.id == id) return entry.setup;
    throw std::out_of_range(id);
}

AnalysisEntry& ForceProject::analysis(const std::string& id) {
    for (AnalysisEntry& entry : project.analyses)
        if (entry.id == id) return entry;
    throw std::out_of_range(id);
}

SetupTable& ForceProject::table(const std::string& asset_id, const std::string& key) {
    return std::get<SetupTable>(asset(asset_id).values.at(key));
}

std::size_t ForceProject::column(const std::string& key) const {
    const FieldSpec& field = *find_asset_kind("force-sensor")->schema.find("readings");
    return SetupSchema::column(field, key);
}

void ForceProject::change_readings(const Place& place,
                                   const std::function<bool(std::vector<SetupCell>&)>& change) {
    SetupTable& readings = table("sensor", "readings");
    const auto text = [&](const std::vector<SetupCell>& row, const char* key) {
        return std::get<std::string>(row[column(key)]);
    };
    const auto number = [&](const std::vector<SetupCell>& row, const char* key) {
        return static_cast<int>(std::get<double>(row[column(key)]));
    };
    std::vector<std::vector<SetupCell>> kept;
    for (std::vector<SetupCell>& row : readings.rows) {
        const bool here = (place.axis.empty() || text(row, "loaded_axis") == place.axis) &&
                          (place.series.empty() || text(row, "series") == place.series) &&
                          (place.phase.empty() || text(row, "phase") == place.phase) &&
                          (place.run == 0 || number(row, "run") == place.run) &&
                          (place.step < 0 || number(row, "step") == place.step);
        if (!here || change(row)) kept.push_back(std::move(row));
    }
    readings.rows = std::move(kept);
}

std::shared_ptr<const PreparedAnalysis> ForceProject::prepare(const std::string& analysis_id) {
    problems = {};
    return made_analysis(project, analysis_id, problems);
}

UncertaintyResult ForceProject::first_order(const std::string& analysis_id) {
    analysis(analysis_id).options.method = Method::first_order;
    const auto prepared = prepare(analysis_id);
    if (!prepared) throw std::runtime_error(words());
    return *run_analysis(*prepared, {});
}

UncertaintyResult ForceProject::monte_carlo(const std::string& analysis_id, std::uint64_t trials) {
    EvaluationOptions& options = analysis(analysis_id).options;
    options.method = Method::monte_carlo;
    options.trials = trials;
    const auto prepared = prepare(analysis_id);
    if (!prepared) throw std::runtime_error(words());
    return *run_analysis(*prepared, {});
}

std::vector<Table> ForceProject::asset_tables(const std::string& id) {
    problems = {};
    const AssetLibrary assets = made_assets(project, problems);
    const AssetLibrary::Entry* entry = assets.find(id);
    if (!entry || !entry->asset) throw std::runtime_error(words());
    return entry->asset->evaluation();
}

std::vector<Table> ForceProject::model_tables(const std::string& analysis_id) {
    const auto prepared = prepare(analysis_id);
    if (!prepared) throw std::runtime_error(words());
    return prepared->model->evaluation();
}

std::string ForceProject::words() const {
    std::string text;
    for (const Problem& problem : problems.items())
        text += problem.path + ": " + problem.message.english() + "\n";
    return text;
}

bool ForceProject::refuses(const std::string& analysis_id, const std::string& expected) {
    return !prepare(analysis_id) && problems.has_errors() && words().find(expected) != std::string::npos;
}

bool ForceProject::warns(const std::string& analysis_id, const std::string& expected) {
    return prepare(analysis_id) && !problems.has_errors() && words().find(expected) != std::string::npos;
}

const Table& table_with(const std::vector<Table>& tables, const std::string& id) {
    for (const Table& table : tables)
        if (table.id == id) return table;
    throw std::out_of_range(id);
}

std::vector<double> numbers(const Table& table, std::size_t column) {
    std::vector<double> values;
    for (std::size_t row = 0; row < table.rows; ++row) {
        const auto number = exact_quantity(table.columns.at(column).cell(row));
        values.push_back(number ? number->value : std::nan(""));
    }
    return values;
}

}  // namespace covaria
