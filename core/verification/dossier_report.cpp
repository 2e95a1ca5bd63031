// The dossier as a document, and for programs.
#include <algorithm>
#include <set>

#include "core/base/version.h"
#include "core/kinds/registries.h"
#include "core/report/table_builder.h"
#include "core/result_files/json_values.h"
#include "core/text/numbers.h"
#include "core/verification/dossier.h"

namespace covaria {
namespace {

using Blocks = std::vector<ReportBlock>;

void add_heading(Blocks& blocks, int level, const std::string& text, const std::string& anchor = {},
                 bool begins_page = false) {
    blocks.push_back(HeadingBlock{level, text, anchor, begins_page});
}

struct Sum {
    std::size_t figures = 0, passed = 0, negative = 0;
};

Sum sum_of(const std::vector<CheckedCase>& cases) {
    Sum sum;
    for (const CheckedCase& one : cases)
        for (const CheckedFigure& figure : one.figures) {
            ++sum.figures;
            sum.passed += figure.passed() ? 1 : 0;
            sum.negative += figure.check.naive ? 1 : 0;
        }
    return sum;
}

std::string of_all(std::size_t part, std::size_t all) {
    return std::to_string(part) + " of " + std::to_string(all);
}

void add_summary(Blocks& blocks, const std::vector<CheckedCase>& cases, const ProgramFacts& facts) {
    const Sum sum = sum_of(cases);
    blocks.push_back(FactsBlock{facts, true});
    blocks.push_back(ParagraphBlock{of_all(sum.passed, sum.figures) + " figures of " +
                                    std::to_string(cases.size()) + " cases are as they should be. Beside " +
                                    std::to_string(sum.negative) +
                                    " of them stands what a naive evaluation gives, which is not ours."});
    for (const CheckedCase& one : cases)
        if (!one.not_evaluated.empty())
            blocks.push_back(ParagraphBlock{"Not evaluated: " + one.of.title + ": " + one.not_evaluated});
    add_heading(blocks, 2, "How a figure passes");
    blocks.push_back(ListBlock{
        {"printed digits: it lies within half of the last digit that the source prints, or the table says "
         "why "
         "the source differs;",
         "10κε: it differs from its reference by at most ten times its condition number κ times ε = 2⁻⁵². "
         "κ "
         "is the largest change of the figure in eight evaluations with all typed numbers changed by a "
         "relative "
         "10⁻⁸ with random signs, over that change; of figures in closed form the number stated;",
         "4 standard errors: it is a result of trials and lies within four combined standard errors of its "
         "reference;",
         "digits of the reference: it lies within what the digits of a reference value leave open that was "
         "computed in double precision or stated with few digits;",
         "where a naive figure stands beside it: it differs from that by more than what is allowed."}});
    add_heading(blocks, 2, "How to repeat it");
    blocks.push_back(CodeBlock{"covaria verify --dossier dossier.pdf"});
    blocks.push_back(ParagraphBlock{
        "evaluates the projects that are installed with the program and holds every figure against these "
        "lists again. Reference values at 50 digits are made by the scripts in tests/reference/cases, which "
        "share no code with the program."});
}

void add_matrix(Blocks& blocks, const std::vector<ClauseEvidence>& evidence) {
    add_heading(blocks, 1, "Conformity with the GUM, clause by clause", "dossier-clauses", true);
    report_parts::TableBuilder table("clauses", "Clauses of JCGM 100, 101, 102 and 106");
    for (const char* head : {"Clause", "Asks for", "Cases", "Figures", "Naive", "Result"}) table.text(head);
    for (const ClauseEvidence& one : evidence) {
        std::string cases = one.cases.empty() ? "none" : one.cases.front();
        if (one.cases.size() > 1) cases += " and " + std::to_string(one.cases.size() - 1) + " more";
        table.row({one.of.clause, one.of.asks, cases, std::to_string(one.figures),
                   one.negative ? std::to_string(one.negative) : std::string(),
                   std::string(one.figures == 0            ? "no figure"
                               : one.passed == one.figures ? "conforms"
                                                           : "FAILS")});
    }
    table.note("Naive: figures beside which stands what an evaluation gives that overlooks the clause.");
    blocks.push_back(table.take());
}

/// "Points: base points (name, x, y, z); moving points".
std::vector<std::string> inputs_of(const SetupSchema& schema) {
    std::vector<std::string> items;
    std::string section;
    for (const FieldSpec& field : schema.fields()) {
        if (items.empty() || field.section != section)
            items.push_back((section = field.section) + (section.empty() ? "" : ": "));
        else
            items.back() += "; ";
        items.back() += field.title;
        std::string columns;
        for (const ColumnSpec& column : field.columns)
            columns += (columns.empty() ? "" : ", ") + column.title;
        if (!columns.empty()) items.back() += " (" + columns + ")";
    }
    return items;
}

std::string evidence_words(const ModelEvidence& evidence) {
    if (evidence.figures == 0)
        return "No figure of this model is verified here; its tests are those of the source tree.";
    std::string words = of_all(evidence.passed, evidence.figures) + " figures of " +
                        std::to_string(evidence.cases) + " cases are as they should be.";
    if (!evidence.largest_of.empty())
        words += " The largest difference of one by the law of propagation from its reference is " +
                 format_short(evidence.largest, 2) + " of what is allowed: " + evidence.largest_of + ".";
    return words;
}

Result<void> add_model(Blocks& blocks, const ModelDescriptor& model, const std::vector<CheckedCase>& cases) {
    const auto scope = model_scope(model.id);
    if (!scope) return fail(scope.error());
    add_heading(blocks, 2, model.title, "dossier-" + model.id, true);
    blocks.push_back(ParagraphBlock{scope->task});
    add_heading(blocks, 3, "Sources of error that are covered");
    blocks.push_back(ListBlock{scope->covered});
    add_heading(blocks, 3, "Not covered");
    blocks.push_back(ListBlock{scope->not_covered});
    add_heading(blocks, 3, "Inputs");
    blocks.push_back(ListBlock{inputs_of(model.schema)});
    if (!model.references.empty()) {
        add_heading(blocks, 3, "Sources of its equations");
        ListBlock list;
        for (const Reference& reference : model.references) list.items.push_back(reference.text);
        blocks.push_back(std::move(list));
    }
    add_heading(blocks, 3, "Evidence");
    blocks.push_back(ParagraphBlock{evidence_words(evidence_of(model.id, cases))});
    return {};
}

}  // namespace

Result<ReportDocument> dossier_document(const std::vector<CheckedCase>& cases, const ProgramFacts& facts) {
    const auto clauses = evaluation_clauses();
    if (!clauses) return fail(clauses.error());
    ReportDocument document;
    document.title = document.running_head = std::string("Dossier of Covaria ") + version();
    document.over = "Evidence for evaluations of measurement uncertainty";
    Blocks& blocks = document.blocks;
    add_summary(blocks, cases, facts);
    blocks.push_back(ContentsBlock{2});
    add_matrix(blocks, evidence_of(*clauses, cases));
    add_heading(blocks, 1, "Scope of the models", "dossier-scope");
    blocks.push_back(ParagraphBlock{
        "A declaration of what each model takes account of, as ISO/TS 15530-4 asks for of software that "
        "evaluates task-specific uncertainty: the task, the sources of error that are covered and how, those "
        "that are not, the inputs, and the evidence."});
    for (const ModelDescriptor& model : model_registry())
        if (auto added = add_model(blocks, model, cases); !added) return fail(added.error());
    add_heading(blocks, 1, "Cases", "dossier-cases", true);
    for (const CheckedCase& one : cases) blocks.push_back(verification_table(one));
    return document;
}

Result<std::string> dossier_json(const std::vector<CheckedCase>& cases, const ProgramFacts& facts) {
    const auto clauses = evaluation_clauses();
    if (!clauses) return fail(clauses.error());
    OrderedJson json = OrderedJson::parse(verification_json(cases));
    json["format"] = "covaria-dossier";
    OrderedJson program = OrderedJson::object(), matrix = OrderedJson::array(), models = OrderedJson::array();
    for (const auto& [key, value] : facts) program[key] = value;
    for (const ClauseEvidence& one : evidence_of(*clauses, cases))
        matrix.push_back({{"clause", one.of.clause},
                          {"asks", one.of.asks},
                          {"cases", one.cases},
                          {"figures", one.figures},
                          {"passed", one.passed},
                          {"negative", one.negative}});
    for (const ModelDescriptor& model : model_registry()) {
        const auto scope = model_scope(model.id);
        if (!scope) return fail(scope.error());
        const ModelEvidence evidence = evidence_of(model.id, cases);
        models.push_back({{"model", model.id},
                          {"task", scope->task},
                          {"covered", scope->covered},
                          {"notCovered", scope->not_covered},
                          {"cases", evidence.cases},
                          {"figures", evidence.figures},
                          {"passed", evidence.passed},
                          {"largestDifference", json_number(evidence.largest)},
                          {"largestDifferenceOf", evidence.largest_of}});
    }
    json["program"] = std::move(program);
    json["clauses"] = std::move(matrix);
    json["models"] = std::move(models);
    return json.dump(1) + "\n";
}

}  // namespace covaria
