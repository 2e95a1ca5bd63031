// Writes every text that core declares and the window translates (ui/theme/core_text.h), each as
// QT_TRANSLATE_NOOP("core", "..."), for lupdate. They are taken from the registries: a new field, choice,
// model or column of a table is in the catalogues without anybody listing it.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "core/kinds/registries.h"
#include "core/made/analysis_templates.h"
#include "core/made/examples.h"
#include "core/made/library.h"
#include "core/made/load_project.h"
#include "core/manual/help_words.h"
#include "core/math/rotation_convention.h"
#include "core/project/asset_certificate_fields.h"
#include "core/project/certificate.h"
#include "core/project/design_fields.h"
#include "core/project/option_fields.h"
#include "core/project/report_contents.h"
#include "core/project/requirement_fields.h"
#include "core/project/review.h"
#include "core/propagation/engine.h"
#include "core/quantity/distribution.h"
#include "core/quantity/statement_text.h"
#include "core/readers/budget_columns.h"
#include "core/readers/point_columns.h"
#include "core/readers/readers.h"
#include "core/report/certificate_words.h"
#include "core/setup/field_words.h"
#include "core/text/symbol.h"
#include "core/views/comparison_columns.h"
#include "core/views/design_results.h"
#include "core/views/plot_words.h"
#include "core/views/result_columns.h"
#include "core/writers/writers.h"

namespace covaria {
namespace {

std::string as_literal(std::string_view text) {
    std::string literal = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') literal += '\\';
        literal += c == '\n' ? std::string("\\n") : std::string(1, c);
    }
    return literal + '"';
}

/// A list on standard output with each text once, below a remark on what it is.
class TextList {
public:
    void say(std::string_view what, std::string_view text) {
        if (!looks_like_symbol(text)) say_word(what, text);
    }
    /// Adds a text that is no symbol, although it looks like one: "beta".
    void say_word(std::string_view what, std::string_view text) {
        if (text.empty() || !said_.insert(std::string(text)).second) return;
        std::printf("//: %.*s\nQT_TRANSLATE_NOOP(\"core\", %s)\n", int(what.size()), what.data(),
                    as_literal(text).c_str());
    }
    void say_choices(const std::string& of, const std::vector<Choice>& choices) {
        for (const Choice& choice : choices) say("Choice of " + of, choice.title);
    }

private:
    std::set<std::string> said_;
};

void say_schema(TextList& list, const std::string& owner, const SetupSchema& schema) {
    for (const FieldSpec& field : schema.fields()) {
        const std::string of = owner + ", " + field.title;
        list.say("Heading of fields of " + owner, field.section);
        list.say("Field of " + owner, field.title);
        list.say("Help on " + of, field.help);
        list.say_choices(of, field.choices);
        for (const ColumnSpec& column : field.columns) {
            list.say("Head of a column of " + of, column.title);
            list.say("Help on a column of " + of, column.help);
            list.say_choices(of + ", " + column.title, column.choices);
        }
    }
}

void say_kinds(TextList& list) {
    for (const ModelDescriptor& model : model_registry()) {
        list.say("Measurement model", model.title);
        list.say("What a measurement model is for", model.summary);
        for (const std::string& note : model.notes) list.say("Note on " + model.title, note);
        say_schema(list, model.title, model.schema);
    }
    for (const AssetDescriptor& asset : asset_registry()) {
        list.say("Kind of asset", asset.title);
        list.say("What an asset is", asset.summary);
        for (const std::string& note : asset.notes) list.say("Note on " + asset.title, note);
        say_schema(list, asset.title, asset.schema);
    }
    for (const AnalysisTemplate& known : analysis_templates()) {
        list.say("Template of an analysis", known.title);
        list.say("What the template answers", known.question);
    }
}

void say_examples(TextList& list) {
    for (const char* folder : {"", "gum"})
        for (const Example& example : shipped_examples(folder)) {
            list.say("Example that is shipped", example.title);
            list.say("What the example is about", example.summary);
        }
}

void say_parts_of_project(TextList& list) {
    for (const OptionField& field : option_fields()) {
        list.say("Option of an evaluation", field.title);
        list.say(std::string("Help on ") + field.title, field.help);
        list.say_choices(field.title, field.choices);
    }
    for (const RequirementField& field : requirement_fields()) {
        list.say("Figure of a requirement", field.title);
        list.say(std::string("Help on ") + field.title, field.help);
    }
    for (const GuardRuleChoice& known : guard_rules())
        list.say("How a guard band is chosen", known.choice.title);
    for (const CertificateSection& section : certificate_sections()) {
        list.say("Heading of fields of a certificate", section.title);
        for (const CertificateField& field : section.fields) {
            list.say("Field of a certificate", field.title);
            list.say(std::string("Help on ") + field.title, field.help);
        }
    }
    for (const AssetCertificateText& text : asset_certificate_texts()) {
        list.say("Field of a certificate that figures come from", text.title);
        list.say(std::string("Help on ") + text.title, text.help);
    }
    for (const ReviewStepField& step : review_steps()) {
        list.say("Step of the review of a project", step.title);
        list.say(std::string("Help on ") + step.title, step.help);
    }
    for (const FiguresFromWord& word : figures_from_words())
        list.say_word("What figures come from", word.title);
    for (const CertificateSite& site : certificate_sites())
        list.say("Whose place a calibration was performed at", site.words);
    for (const DesignObjective objective :
         {DesignObjective::largest, DesignObjective::mean, DesignObjective::root_mean_square})
        for (const bool targets : {true, false})
            list.say("What a design makes smallest", objective_words(objective, targets));
    for (const char* phrase : Phrase::all()) list.say_word("Words of a certificate or a chart", phrase);
    for (const FieldKind kind : {FieldKind::number, FieldKind::integer, FieldKind::choice, FieldKind::text,
                                 FieldKind::flag, FieldKind::pose, FieldKind::table, FieldKind::reference})
        list.say_word("What a field takes", kind_words(kind));
    for (const RotationConventionInfo& convention : rotation_conventions())
        for (const RotationCoordinate& coordinate : convention.coordinates)
            list.say_word("Coordinate of a rotation", coordinate.name);
    for (const char* words : Message::all_words()) list.say_word("Words of messages and reports", words);
    for (const ReportChapterField& chapter : report_chapters())
        list.say("Chapter of a report", chapter.title);
    for (const DistributionKindInfo& kind : distribution_kinds()) {
        list.say_word("Distribution", kind.title);
        for (const DistributionParameterInfo& parameter : kind.parameters)
            list.say_word("Parameter of a distribution", parameter.title);
    }
    list.say("Examples of statements in the cell of a budget; the notations stay", statement_examples());
    for (const std::string& word : statement_words())
        list.say_word("Word of a statement, as it is typed: one word", word);
    for (const LibraryItem& item : load_library().items)
        if (!item.own) list.say("Collection of the library", item.collection);
    for (const Reader& reader : reader_registry()) list.say("Format of a file that is read", reader.title);
    for (const BudgetColumnWord& word : budget_column_words())
        list.say_word("What a column of a budget is read as", word.title);
    for (const auto& [word, title] : point_column_titles())
        if (title != word) list.say_word("What a column of points is read as", title);
    for (const Writer& writer : writer_registry()) list.say("Format of a file that is written", writer.title);
}

/// Adds the words of a text; symbols stay out.
void say_plain(TextList& list, std::string_view what, const Text& text) {
    if (text.is_plain()) return list.say(what, text.letters());
    if (const TextPattern pattern = pattern_of(text); pattern.has_words()) list.say(what, pattern.words);
}

/// `without`: columns whose texts are phrases, and in the list of those; `phrased`: only the head is one.
void say_table(TextList& list, const Table& table, const std::set<std::string>& without = {},
               const std::set<std::string>& phrased = {}) {
    for (const Column& column : table.columns) {
        if (without.contains(column.key)) continue;
        if (!phrased.contains(column.key)) say_plain(list, "Head of a column of results", column.title);
        if (!column.is_symbol) list.say_word("Head of a column of results in a report", column.head);
        list.say("Help on a column of results", column.help.english());
        for (const std::string& word : column.undeclared) list.say("Cell of a table of results", word);
    }
}

void say_tables_of(TextList& list, const std::shared_ptr<const UncertaintyResult>& result) {
    const std::vector<std::string> contributors = contributor_keys(*result);
    say_table(list, results_table(*result, {0}, {}), {contributors.begin(), contributors.end()},
              {"shortest low", "shortest high", "stated low", "stated high"});
    say_table(list, budget_table(*result, budget_places(*result, 0)));
    say_table(list, inputs_table(result->inputs, all_shares(result->inputs)));
    say_table(list, input_correlations_table(result->inputs, {}));
    say_table(list, regions_table(*result));
    const ResultComparison comparison = compare_results(result, result);
    say_table(list, compared_results_table(comparison));
    say_table(list, compared_budget_table(comparison, compared_places(comparison, 0)));
}

/// The heads of tables are those of a result, whatever it is of; help says how U was found.
bool say_tables(TextList& list) {
    const LoadedProject loaded = load_project(COVARIA_SOURCE_DIR "/projects/gum/h1-end-gauge.covaria");
    if (!loaded.made || loaded.project.analyses.empty()) return false;
    const auto prepared = loaded.made->analysis(loaded.project.analyses.front().id);
    if (!prepared) return false;
    for (const Method method : {Method::first_order, Method::monte_carlo})
        for (const auto& k : {std::optional<double>(), std::optional(2.0)}) {
            EvaluationOptions options = prepared->options;
            options.method = method;
            options.trials = 1000;
            options.coverage_factor = k;
            Result<UncertaintyResult> evaluated = evaluate(*prepared->propagated, options);
            if (!evaluated) return false;
            say_tables_of(list, std::make_shared<const UncertaintyResult>(std::move(*evaluated)));
        }
    for (const std::string& word : {Answer{}.yes, Answer{}.no}) list.say("Cell of a table of results", word);
    return true;
}

void say_tables_for_reading(TextList& list, const std::vector<Table>& tables) {
    for (const Table& table : tables) {
        list.say("Title of a table", table.title);
        for (const Column& column : table.columns)
            for (const std::string& head : {column.key, column.head})
                if (!column.is_symbol && !column.hidden && !head.empty()) list.say("Head of a column", head);
    }
}

void say_figures(TextList& list, const std::vector<PlotSpecification>& figures) {
    for (const PlotSpecification& figure : figures) {
        for (const Text& text : {figure.title, figure.x.title, figure.y.title})
            say_plain(list, "In a chart", text);
        for (const PlotSeries& series : figure.series) say_plain(list, "In a chart", series.name);
        for (const PlotMark& mark : figure.marks) say_plain(list, "In a chart", mark.label);
    }
}

void say_groupings(TextList& list, const std::vector<GroupTag>& tags) {
    for (const GroupTag& tag : tags) list.say_word("By what a report groups components", tag.grouping);
}

/// A design with something in every table.
DesignResult filled_design() {
    DesignResult design;
    design.cost = 1.0;
    design.goals.resize(1);
    design.values.resize(1);
    design.rows.resize(1);
    design.gains.resize(1);
    design.sources.resize(1);
    design.curve.resize(1);
    design.front.resize(1);
    design.path.resize(1);
    design.reasons.resize(1);
    return design;
}

/// Files of all examples, in the same order on every machine.
std::set<std::filesystem::path> example_files() {
    const std::filesystem::path projects = COVARIA_SOURCE_DIR "/projects";
    std::set<std::filesystem::path> files;
    for (const auto& file : std::filesystem::recursive_directory_iterator(projects))
        if (file.path().extension() == ".covaria") files.insert(file.path());
    return files;
}

/// Adds the texts that models and assets of the examples show of their set-ups.
void say_evaluations(TextList& list) {
    for (const std::filesystem::path& file : example_files()) {
        const LoadedProject loaded = load_project(file);
        if (!loaded.made) continue;
        for (const auto& [id, entry] : loaded.made->assets().entries()) {
            say_tables_for_reading(list, entry.asset->evaluation());
            say_figures(list, entry.asset->figures());
        }
        for (const AnalysisEntry& analysis : loaded.project.analyses) {
            const auto prepared = loaded.made->analysis(analysis.id);
            if (!prepared) continue;
            for (const InputQuantity& quantity : prepared->inputs.quantities)
                say_groupings(list, quantity.tags);
            for (const UncertaintyComponent& component : prepared->inputs.components)
                say_groupings(list, component.tags);
            say_tables_for_reading(list, prepared->model->evaluation());
            say_figures(list, prepared->model->figures());
        }
    }
}

}  // namespace
}  // namespace covaria

int main() {
    using namespace covaria;
    TextList list;
    say_kinds(list);
    say_examples(list);
    say_parts_of_project(list);
    say_evaluations(list);
    say_tables_for_reading(list, design_tables(filled_design()));
    if (say_tables(list)) return 0;
    std::fputs("the example projects/gum/h1-end-gauge.covaria has no result\n", stderr);
    return 1;
}
