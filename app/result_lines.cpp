#include "app/result_lines.h"

#include "core/project/stated_requirements.h"
#include "core/result/result_line.h"
#include "core/result_files/csv_text.h"
#include "core/text/numbers.h"

namespace covaria {
namespace {

/// "yes", "no"; empty where nothing is required.
std::string met_word(const std::vector<RequirementResult>& verdicts, std::size_t output) {
    const auto met = are_met(verdicts, output);
    return !met ? "" : *met ? "yes" : "no";
}

std::string line_of(const OutputResult& output, const UncertaintyResult& result) {
    const Unit& unit = output.quantity.unit;
    const CoverageInterval interval = coverage_interval_of(output, result);
    std::string line = csv_text(output.quantity.group) + "," + csv_text(output.quantity.symbol) + "," +
                       csv_text(unit.text());
    for (const double value :
         {unit.from_si(output.estimate), unit.interval_from_si(output.standard_uncertainty),
          unit.interval_from_si(output.expanded_uncertainty), output.coverage_factor,
          result.coverage_probability, unit.from_si(interval.low), unit.from_si(interval.high)})
        line += "," + format_exact(value);
    return line;
}

std::string empty_line(const NamedRun& run, const std::string& analysis, const std::string& problem) {
    return csv_text(run.name) + "," + csv_text(analysis) + ",,,,,,,,,,,," + csv_text(run.folder) + "," +
           csv_text(problem) + "\r\n";
}

}  // namespace

std::string result_lines_head() {
    return "name,analysis,group,symbol,unit,estimate,u,U,k,p,low,high,met,folder,problem\r\n";
}

std::string result_lines(const NamedRun& run, const Project& project, const Evaluation& evaluation) {
    std::string lines;
    for (const EvaluatedAnalysis& one : evaluation.analyses) {
        const auto verdicts = judge(*one.result, *project.find_analysis(one.analysis->id));
        for (std::size_t i = 0; i < one.result->outputs.size(); ++i) {
            const OutputResult& output = one.result->outputs[i];
            if (output.quantity.role != OutputRole::measurand) continue;
            lines += csv_text(run.name) + "," + csv_text(one.analysis->id) + "," +
                     line_of(output, *one.result) + "," + met_word(verdicts, i) + "," + csv_text(run.folder) +
                     ",\r\n";
        }
    }
    for (const FailedAnalysis& failed : evaluation.failed)
        if (failed.study.empty()) lines += empty_line(run, failed.id, failed.cause.english());
    return lines;
}

std::string line_without_results(const NamedRun& run, const std::string& problem) {
    return empty_line(run, "", problem);
}

}  // namespace covaria
