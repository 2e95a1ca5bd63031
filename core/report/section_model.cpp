// Measurement models: summary and equations with the standards that these come from. Papers are on the page
// of the model (help, `covaria describe`).
#include <algorithm>

#include "core/report/report_parts.h"
#include "core/views/seen_table.h"

namespace covaria::report_parts {
namespace {

bool of_standard(const std::string& source) {
    return source.starts_with("JCGM") || source.starts_with("ISO");
}

void add_model(Blocks& blocks, const ModelDescriptor& model, const DocumentLanguage& in) {
    blocks.push_back(HeadingBlock{2, in.say_declared(model.title)});
    if (!model.summary.empty()) blocks.push_back(ParagraphBlock{in.say_declared(model.summary)});
    for (const ModelEquation& equation : model.equations)
        blocks.push_back(EquationBlock{in.say(equation.text),
                                       of_standard(equation.source.english()) ? in.say(equation.source) : "",
                                       with_numbers(equation.formula, in.numbers())});
}

}  // namespace

void add_models(Blocks& blocks, const ReportSource& source) {
    blocks.push_back(HeadingBlock{1, source.in.say(tell<"Measurement model">())});
    std::vector<const ModelDescriptor*> done;
    for (const EvaluatedAnalysis& evaluated : source.analyses) {
        const ModelDescriptor* model = evaluated.analysis->descriptor;
        if (std::find(done.begin(), done.end(), model) != done.end()) continue;
        add_model(blocks, *model, source.in);
        done.push_back(model);
    }
}

void add_model_evaluation(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in) {
    if (!evaluated.analysis->model) return;
    const std::vector<Table> tables = evaluated.analysis->model->evaluation();
    std::vector<PlotSpecification> plots = evaluated.analysis->model->figures();
    const auto redundant = evaluated.analysis->model->redundant_readings();
    if (tables.empty() && plots.empty() && !redundant) return;
    blocks.push_back(HeadingBlock{2, in.say(tell<"Evaluation of the set-up">())});
    for (const Table& table : tables) blocks.push_back(evaluation_block(table, in));
    if (redundant) {
        Table seen = seen_table(*redundant, evidence::seen_of(*redundant), in);
        for (Message& note : seen.notes) note = Message(in.say(note));
        blocks.push_back(TableBlock{std::move(seen), {{}, 2, in}});
    }
    for (PlotSpecification& plot : plots)
        blocks.push_back(titled_figure(in.say_plot(std::move(plot)), evaluated));
}

}  // namespace covaria::report_parts
