// The snapshot of a design.
#include <algorithm>

#include "core/design/design.h"
#include "core/project/links.h"
#include "core/project/project_file.h"
#include "core/project/stated_requirements.h"
#include "core/study/varied_part.h"

namespace covaria {

namespace {

/// Problems of one design of an analysis, paths relative to it.
Problems problems_of(const MadeProject& made, const PreparedAnalysis& analysis, const Design& design) {
    AnalysisEntry only = *made.project().find_analysis(analysis.id);
    only.designs = {design};
    Problems found, own;
    check_designs(made.project(), only, &analysis.inputs, &analysis.model->outputs(), found);
    const std::string first = "/designs/0";
    for (std::size_t i = 0; i < design.variables.size(); ++i)
        refuse_idle_asset(made, analysis.id, design.variables[i].number.asset,
                          first + "/variables/" + std::to_string(i) + "/asset", found);
    for (std::size_t i = 0; i < design.reductions.size(); ++i)
        refuse_idle_asset(made, analysis.id, design.reductions[i].number.asset,
                          first + "/reductions/" + std::to_string(i) + "/asset", found);
    if (design.choose)
        refuse_idle_asset(made, analysis.id, design.choose->asset, first + "/choose/asset", found);
    for (Problem problem : found.items()) {
        problem.path = problem.path.substr(first.size());
        own.add(problem);
    }
    return own;
}

/// The smallest of its target uncertainties, where an output has some.
std::vector<std::optional<double>> targets_of(const AnalysisEntry& entry,
                                              const std::vector<OutputQuantity>& outputs) {
    Problems ignored;  // problems of the analysis, which was made
    std::vector<std::optional<double>> targets(outputs.size());
    for (const OutputRequirement& requirement : read_requirements(entry, outputs, ignored)) {
        if (!requirement.target_uncertainty) continue;
        auto& target = targets[requirement.output];
        target = std::min(target.value_or(*requirement.target_uncertainty), *requirement.target_uncertainty);
    }
    return targets;
}

std::vector<DesignedOutput> designed_outputs(const AnalysisEntry& entry, const PreparedAnalysis& analysis,
                                             const Design& design) {
    const std::vector<OutputQuantity>& outputs = analysis.model->outputs();
    const auto targets = targets_of(entry, outputs);
    const auto wanted = [&](std::size_t j) {
        if (design.outputs.empty()) return true;
        return std::find(design.outputs.begin(), design.outputs.end(),
                         StudyOutput{outputs[j].group, outputs[j].symbol}) != design.outputs.end();
    };
    std::vector<DesignedOutput> with_target, chosen;
    for (std::size_t j = 0; j < outputs.size(); ++j) {
        if (!wanted(j)) continue;
        DesignedOutput output{{outputs[j].group, outputs[j].symbol}, outputs[j], targets[j]};
        take_style(output.quantity, analysis.style);
        if (targets[j]) with_target.push_back(output);
        if (!design.outputs.empty() || outputs[j].role == OutputRole::measurand) chosen.push_back(output);
    }
    return with_target.empty() ? chosen : with_target;
}

/// The project whose table has all candidates, so that what they refer to is part of it.
Project with_candidates(Project project, const AnalysisEntry& entry, const DesignTable& table) {
    Setup& setup = table.asset == StudyTarget::analysis
                       ? project
                             .analyses[static_cast<std::size_t>(project.find_analysis(entry.id) -
                                                                project.analyses.data())]
                             .setup
                       : project.assets[table.asset].setup;
    setup.values[table.key] = table.rows;
    return project;
}

/// Index of the asset in the part.
std::size_t asset_in(const Project& part, const std::string& id) {
    const AssetEntry* asset = id.empty() ? nullptr : part.find_asset(id);
    return asset ? static_cast<std::size_t>(asset - part.assets.data()) : StudyTarget::analysis;
}

/// Indices of the assets that the part's analysis uses when its table has these rows.
std::vector<std::size_t> assets_used(Project part, const DesignTable& table,
                                     std::vector<std::vector<SetupCell>> rows) {
    Setup& setup =
        table.asset == StudyTarget::analysis ? part.analyses.front().setup : part.assets[table.asset].setup;
    std::get<SetupTable>(setup.values.at(table.key)).rows = std::move(rows);
    std::vector<std::size_t> used;
    for (const std::string& id : assets_used_by(part, part.analyses.front()))
        used.push_back(asset_in(part, id));
    std::sort(used.begin(), used.end());
    return used;
}

// A candidate is made without the assets of the rows that it leaves out, which may be hundreds.
void find_assets_of_rows(const Project& part, PreparedDesign& prepared) {
    const DesignTable& table = *prepared.table;
    prepared.assets_without_rows = assets_used(part, table, {});
    const auto& base = prepared.assets_without_rows;
    for (const auto& row : table.rows.rows) {
        std::vector<std::size_t> further;
        for (const std::size_t asset : assets_used(part, table, {row}))
            if (!std::binary_search(base.begin(), base.end(), asset)) further.push_back(asset);
        prepared.assets_of_rows.push_back(std::move(further));
    }
}

/// Part of the project that the design needs; empty after an error.
std::optional<Project> part_for(const Project& project, const AnalysisEntry& entry,
                                PreparedDesign& prepared) {
    if (!prepared.design.choose) return analysis_part(project, entry);
    Problems found;
    prepared.table = find_design_table(project, entry, *prepared.design.choose, found);
    if (!prepared.table) return {};
    const Project extended = with_candidates(project, entry, *prepared.table);
    Project part = analysis_part(extended, *extended.find_analysis(entry.id));
    prepared.table->asset = asset_in(part, prepared.design.choose->asset);
    return part;
}

}  // namespace

Project design_part(const Project& project, const AnalysisEntry& entry, const Design& design) {
    std::optional<DesignTable> table;
    Problems ignored;  // the list of problems has them
    if (design.choose && !design.choose->candidates.empty())
        table = find_design_table(project, entry, *design.choose, ignored);
    const Project extended = table ? with_candidates(project, entry, *table) : project;
    Project part = analysis_part(extended, *extended.find_analysis(entry.id));
    part.analyses.front().designs = {design};
    return part;
}

bool same_search(Project a, Project b) {
    for (Project* part : {&a, &b})
        for (Design& design : part->analyses.front().designs) design.name.clear();
    const AnalysisEntry &of_a = a.analyses.front(), &of_b = b.analyses.front();
    return of_a.designs == of_b.designs && of_a.requirements == of_b.requirements &&
           same_numbers(std::move(a), std::move(b));
}

std::shared_ptr<const PreparedDesign> prepare_design(const MadeProject::Pointer& made,
                                                     const std::string& analysis_id,
                                                     const std::string& design_id, Problems& problems) {
    problems.take(made->problems_of_analysis(analysis_id), "");
    const auto analysis = made->analysis(analysis_id);
    if (!analysis) return nullptr;
    const Project& project = made->project();
    const AnalysisEntry& entry = *project.find_analysis(analysis_id);
    const std::string path = "/analyses/" + std::to_string(&entry - project.analyses.data()) + "/designs";
    const auto design = std::find_if(entry.designs.begin(), entry.designs.end(),
                                     [&](const Design& candidate) { return candidate.id == design_id; });
    if (design == entry.designs.end()) {
        problems.error(path, tell<"the analysis has no design '%1'">(design_id));
        return nullptr;
    }
    const Problems found = problems_of(*made, *analysis, *design);
    problems.take(found, path + "/" + std::to_string(design - entry.designs.begin()));
    if (found.has_errors()) return nullptr;
    auto prepared = std::make_shared<PreparedDesign>();
    prepared->design = *design;
    prepared->numbers.analysis = analysis;
    prepared->fingerprint = analysis->fingerprint();
    prepared->outputs = designed_outputs(entry, *analysis, *design);
    for (const DesignVariable& variable : design->variables)
        prepared->numbers.axes.push_back(variable.number);
    for (const DesignReduction& reduction : design->reductions)
        prepared->numbers.axes.push_back(reduction.number);
    auto part = part_for(project, entry, *prepared);
    if (!part || !find_targets(analysis->inputs, prepared->numbers.axes, *part, prepared->numbers.targets))
        return nullptr;
    for (std::size_t i = 0; i < prepared->numbers.axes.size(); ++i)
        prepared->present.push_back(present_value(prepared->numbers.axes[i], prepared->numbers.targets[i]));
    if (prepared->table) find_assets_of_rows(*part, *prepared);
    prepared->numbers.made = MadeProject::make(without_choices(*std::move(part)), made);
    return prepared;
}

}  // namespace covaria
