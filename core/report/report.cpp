// Builds the report of a project: its sections in order, then the numbers of headings, tables and figures.
#include "core/report/report.h"

#include <array>

#include "core/base/file_names.h"
#include "core/project/project_file.h"
#include "core/report/report_parts.h"

namespace covaria {
namespace {

using namespace report_parts;

/// Puts "2.1", "Table 3." and "Figure 2." before headings and captions, in order of appearance.
struct Numbering {
    std::array<int, 2> heading{};
    int tables = 0, figures = 0;

    void operator()(HeadingBlock& block) {
        if (block.level == 1)
            heading = {heading[0] + 1, 0};
        else if (block.level == 2)
            ++heading[1];
        if (block.level > 2) return;
        const std::string number = std::to_string(heading[0]);
        block.text =
            (block.level == 1 ? number : number + "." + std::to_string(heading[1])) + "\u2002" + block.text;
    }
    void operator()(TableBlock& block) {
        block.table.title = "Table " + std::to_string(++tables) + ". " + block.table.title;
    }
    void operator()(PlotBlock& block) { block.caption = figure() + block.caption; }
    void operator()(SceneBlock& block) { block.caption = figure() + block.caption; }
    template <class Other>
    void operator()(Other&) {}

    std::string figure() { return "Figure " + std::to_string(++figures) + ". "; }
};

/// Figures are files: every id is there once, whatever the names of groups become.
struct FigureNaming {
    FileNames charts = {}, pictures = {};

    void operator()(PlotBlock& block) { block.plot.id = charts.unique(block.plot.id, ""); }
    void operator()(SceneBlock& block) { block.id = pictures.unique(block.id, ""); }
    template <class Other>
    void operator()(Other&) {}
};

void add_analysis(Blocks& blocks, const ReportSource& source, const EvaluatedAnalysis& evaluated,
                  std::set<std::string>& shown_assets) {
    blocks.push_back(HeadingBlock{1, evaluated.analysis->name});
    add_setup(blocks, source, evaluated);
    add_links(blocks, evaluated);
    add_inputs(blocks, evaluated);
    add_assets(blocks, source, evaluated, shown_assets);
    add_budgets(blocks, evaluated);
    add_results(blocks, source, evaluated);
    add_sobol(blocks, evaluated);
    add_contributors(blocks, evaluated);
    add_model_evaluation(blocks, evaluated);
    add_comparison(blocks, evaluated);
    add_regions(blocks, evaluated);
    add_distributions(blocks, evaluated);
    add_scene(blocks, evaluated);
    add_correlation(blocks, evaluated);
    add_studies(blocks, evaluated);
}

}  // namespace

ReportDocument build_report(const Project& project, const AssetLibrary& assets,
                            const std::vector<EvaluatedAnalysis>& analyses,
                            const std::vector<FailedAnalysis>& failed) {
    const ReportSource source{project, assets, analyses, failed};
    ReportDocument document;
    document.title = project.title.empty() ? "Uncertainty report" : project.title;
    document.running_head = document.title;
    add_title(document.blocks, source);
    add_models(document.blocks, source);
    std::set<std::string> shown_assets;
    for (const EvaluatedAnalysis& evaluated : analyses)
        add_analysis(document.blocks, source, evaluated, shown_assets);
    add_notes(document.blocks, source);
    add_provenance(document.blocks, source);
    Numbering numbering;
    for (ReportBlock& block : document.blocks) std::visit(numbering, block);
    FigureNaming naming;
    for (ReportBlock& block : document.blocks) std::visit(naming, block);
    return document;
}

}  // namespace covaria
