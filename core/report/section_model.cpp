// Measurement models: summary and equations with the standards that they are of. Papers are on the page of
// the model (help, `covaria describe`).
#include <algorithm>

#include "core/report/report_parts.h"

namespace covaria::report_parts {
namespace {

bool of_standard(const std::string& source) {
    return source.starts_with("JCGM") || source.starts_with("ISO");
}

void add_model(Blocks& blocks, const ModelDescriptor& model) {
    blocks.push_back(HeadingBlock{2, model.title});
    if (!model.summary.empty()) blocks.push_back(ParagraphBlock{model.summary});
    for (const ModelEquation& equation : model.equations)
        blocks.push_back(EquationBlock{equation.text, of_standard(equation.source) ? equation.source : "",
                                       equation.formula});
}

}  // namespace

void add_models(Blocks& blocks, const ReportSource& source) {
    blocks.push_back(HeadingBlock{1, "Measurement model"});
    std::vector<const ModelDescriptor*> done;
    for (const EvaluatedAnalysis& evaluated : source.analyses) {
        const ModelDescriptor* model = evaluated.analysis->descriptor;
        if (std::find(done.begin(), done.end(), model) != done.end()) continue;
        add_model(blocks, *model);
        done.push_back(model);
    }
}

void add_model_evaluation(Blocks& blocks, const EvaluatedAnalysis& evaluated) {
    if (!evaluated.analysis->model) return;
    std::vector<DataTable> tables = evaluated.analysis->model->evaluation();
    std::vector<PlotSpecification> plots = evaluated.analysis->model->figures();
    if (tables.empty() && plots.empty()) return;
    blocks.push_back(HeadingBlock{2, "Evaluation of the set-up"});
    for (DataTable& table : tables) blocks.push_back(TableBlock{std::move(table), {}});
    for (PlotSpecification& plot : plots) {
        std::string caption = to_unicode(plot.title) + ".";
        blocks.push_back(figure(std::move(plot), evaluated, std::move(caption)));
    }
}

}  // namespace covaria::report_parts
