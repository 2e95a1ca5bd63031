#include "core/project/design_check.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/in_quotes.h"
#include "core/base/own_folder.h"
#include "core/base/temperature.h"
#include "core/project/analysis_fields.h"
#include "core/project/csv_table.h"
#include "core/project/design_fields.h"
#include "core/project/entry_graph.h"
#include "core/project/entry_names.h"
#include "core/project/kind_lookup.h"
#include "core/project/project_id.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

/// The place of the table of a choice; its key is empty after an error.
struct TablePlace {
    const SetupSchema* schema = nullptr;
    const Setup* setup = nullptr;
    DesignTable found = {};
};

TablePlace place_of_table(const Project& project, const AnalysisEntry& analysis, const DesignChoice& choice,
                          Problems& problems) {
    TablePlace place{schema_of(analysis), &analysis.setup, {}};
    if (!choice.asset.empty()) {
        const AssetEntry* asset = project.find_asset(choice.asset);
        if (!asset) {
            problems.error(choice_fields().place(&DesignChoice::asset),
                           tell<"there is no asset %1%2">(in_quotes(choice.asset),
                                                          did_you_mean_entry(choice.asset, project.assets)));
            return place;
        }
        place.schema = schema_of(*asset);
        place.setup = &asset->setup;
        place.found.asset = static_cast<std::size_t>(asset - project.assets.data());
    }
    const std::string head = "/setup/", tail = "/rows";
    const std::string& text = choice.table;
    if (text.size() > head.size() + tail.size() && text.starts_with(head) && text.ends_with(tail))
        place.found.key = text.substr(head.size(), text.size() - head.size() - tail.size());
    else
        problems.error(
            choice_fields().place(&DesignChoice::table),
            tell<"a table to choose from is written as \"/setup/KEY/rows\"; it is %1">(in_quotes(text)));
    return place;
}

/// Adds the candidates of the CSV file, in the units of the table, behind its rows.
void add_candidates(const Project& project, const FieldSpec& field, const std::string& file,
                    DesignTable& table, Problems& problems) {
    if (is_led_out_of(project.directory, file))
        return problems.error(choice_fields().place(&DesignChoice::candidates),
                              tell<"the file of candidates '%1' is a link that leads out of the project's "
                                   "folder: put the file itself there">(file));
    CsvTable csv = table_from_csv_file(project.directory / file, field);
    for (const Problem& problem : csv.problems.items()) {
        Problem placed = problem;
        placed.path = choice_fields().place(&DesignChoice::candidates);
        problems.add(placed);
    }
    if (csv.problems.has_errors()) return;
    for (auto& row : csv.table.rows) {
        for (std::size_t c = 0; c < row.size() && c < csv.table.units.size(); ++c)
            if (double* number = std::get_if<double>(&row[c]); number && c < table.rows.units.size())
                *number = table.rows.units[c].from_si(csv.table.units[c].to_si(*number));
        table.rows.rows.push_back(std::move(row));
    }
}

template <class M>
std::string at(M Design::*member) {
    return design_fields().place(member);
}
template <class M>
std::string at(std::vector<M> Design::*member, std::size_t item) {
    return design_fields().place(member, item);
}
/// The path of a member of the choice, within the design.
template <class M>
std::string at(M DesignChoice::*member) {
    return at(&Design::choose) + choice_fields().place(member);
}

class DesignCheck {
public:
    DesignCheck(const Project& project, const AnalysisEntry& analysis, const InputSet* inputs,
                const std::vector<OutputQuantity>* outputs, Problems& problems)
        : project_(project), analysis_(analysis), inputs_(inputs), outputs_(outputs), problems_(problems) {}

    void check(const Design& design, const std::string& path) {
        path_ = path;
        if (!is_project_id(design.id))
            error(at(&Design::id), tell<"its id must be made of letters, digits, '-' and '_'">());
        if (design.variables.empty() && !design.choose && design.reductions.empty())
            error("", tell<"a design needs 'variables', a table to 'choose' from, or 'reductions'">());
        if (!design.reductions.empty() && (design.choose || !design.variables.empty()))
            error(at(&Design::reductions),
                  tell<"the cheapest reductions are a design of their own, without variables and rows">());
        if (design.reductions.size() > most_design_variables)
            error(at(&Design::reductions), tell<"a design has at most %1 reductions">(most_design_variables));
        for (std::size_t i = 0; i < design.reductions.size(); ++i) check_reduction(design, i);
        if (design.variables.size() > most_design_variables)
            error(at(&Design::variables), tell<"a design has at most %1 variables">(most_design_variables));
        for (std::size_t i = 0; i < design.variables.size(); ++i) check_variable(design, i);
        if (design.choose) check_choice(*design.choose);
        if (design.objective == DesignObjective::cost && design.reductions.empty() &&
            (!design.choose || design.choose->prices.empty() || !design.variables.empty()))
            error(at(&Design::objective), tell<"the cost is that of rows with 'prices': it needs a table to "
                                               "choose from, and no variables">());
        for (std::size_t i = 0; i < design.outputs.size(); ++i)
            check_study_output(outputs_, design.outputs[i], path_ + at(&Design::outputs, i), problems_);
        check_space(design);
        check_search(design);
    }

private:
    void error(const std::string& below, const Message& message) { problems_.error(path_ + below, message); }

    void check_variable(const Design& design, std::size_t i) {
        const DesignVariable& variable = design.variables[i];
        const std::string below = at(&Design::variables, i);
        check_study_axis(project_, analysis_, inputs_, variable.number, path_ + below, problems_);
        if (!(variable.tolerance >= 0.0) || !std::isfinite(variable.tolerance))
            error(below + variable_fields().place(&DesignVariable::tolerance),
                  tell<"a tolerance must not be negative">());
        const auto target = find_study_target(project_, analysis_, inputs_, variable.number);
        if (target && target->whole)
            error(below + reduced_number_fields().place(&StudyAxis::target),
                  tell<"'%1' takes whole numbers: a study shows what each of them gives">(
                      target->title.message()));
        for (std::size_t j = 0; j < i; ++j)
            if (design.variables[j].number.asset == variable.number.asset &&
                design.variables[j].number.target == variable.number.target)
                error(below + reduced_number_fields().place(&StudyAxis::target),
                      tell<"%1 is chosen by two variables">(in_quotes(variable.number.target)));
    }

    void check_reduction(const Design& design, std::size_t i) {
        const DesignReduction& reduction = design.reductions[i];
        const std::string below = at(&Design::reductions, i);
        const auto target = find_study_target(project_, analysis_, inputs_, reduction.number);
        if (!target) error(below + target.error().path, target.error().message);
        if (target && !part_objection(target->scale).empty())
            error(below + reduced_number_fields().place(&StudyAxis::target), part_objection(target->scale));
        if (!(reduction.number.from > 0.0) || !(reduction.number.from < 1.0))
            error(below + reduced_number_fields().place(&StudyAxis::from),
                  tell<"the smallest factor is between 0 and 1">());
        if (!(reduction.price >= 0.0) || !std::isfinite(reduction.price))
            error(below + reduction_fields().place(&DesignReduction::price),
                  tell<"a price must not be negative">());
        for (std::size_t j = 0; j < i; ++j)
            if (design.reductions[j].number.asset == reduction.number.asset &&
                design.reductions[j].number.target == reduction.number.target)
                error(below + reduced_number_fields().place(&StudyAxis::target),
                      tell<"%1 is reduced twice">(in_quotes(reduction.number.target)));
    }

    void check_choice(const DesignChoice& choice) {
        Problems found;
        const auto table = find_design_table(project_, analysis_, choice, found);
        problems_.take(found, path_ + at(&Design::choose));
        if (!table) return;
        const std::size_t rows = table->rows.rows.size();
        if (choice.keep < std::max<std::size_t>(1, table->least) || choice.keep > rows)
            error(at(&DesignChoice::keep),
                  tell<"of %1 rows, %2 to %3 can be kept; it is %4">(
                      rows, std::max<std::size_t>(1, table->least), rows, choice.keep));
        std::set<std::size_t> seen;
        for (std::size_t i = 0; i < choice.fixed.size(); ++i) {
            const std::string below = at(&DesignChoice::fixed) + "/" + std::to_string(i);
            if (choice.fixed[i] >= rows)
                error(below, tell<"there are %1 rows, counted from 0">(rows));
            else if (!seen.insert(choice.fixed[i]).second)
                error(below, tell<"row %1 is fixed twice">(choice.fixed[i]));
        }
        if (choice.fixed.size() > choice.keep)
            error(at(&DesignChoice::fixed), tell<"more rows are fixed than kept">());
        if (choice.prices.size() > 1 && choice.prices.size() != rows)
            error(at(&DesignChoice::prices),
                  tell<"there is one price for all rows, or one for each of the %1; there are %2">(
                      rows, choice.prices.size()));
        for (std::size_t i = 0; i < choice.prices.size(); ++i)
            if (!(choice.prices[i] >= 0.0) || !std::isfinite(choice.prices[i]))
                error(at(&DesignChoice::prices) + "/" + std::to_string(i),
                      tell<"a price must not be negative">());
    }

    void check_box(const DesignBox& box, const std::string& below) {
        const Message objection = unit_objection(tell<"a box">(), {0.0, box.unit}, Unit::of("mm"));
        if (!objection.empty()) return error(below + box_fields().place(&DesignBox::unit), objection);
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (!std::isfinite(box.from[axis]) || !(box.from[axis] < box.to[axis]))
                return error(below + box_fields().place(&DesignBox::to),
                             tell<"every coordinate of 'to' must be greater than that of 'from'">());
    }

    void check_space(const Design& design) {
        if (design.least_distance) {
            const Message objection =
                unit_objection(tell<"the least distance">(), *design.least_distance, Unit::of("mm"));
            if (!objection.empty())
                error(at(&Design::least_distance), objection);
            else if (!(design.least_distance->value > 0.0))
                error(at(&Design::least_distance), tell<"the least distance must be greater than zero">());
        }
        for (std::size_t i = 0; i < design.keep_out.size(); ++i)
            check_box(design.keep_out[i], at(&Design::keep_out, i));
        for (std::size_t i = 0; i < design.hidden_by.size(); ++i)
            check_box(design.hidden_by[i], at(&Design::hidden_by, i));
    }

    void check_search(const Design& design) {
        if (design.starts < 1 || design.starts > most_design_starts)
            error(at(&Design::starts), tell<"there are 1 to %1 starts">(most_design_starts));
        if (design.most_evaluations < 1)
            error(at(&Design::most_evaluations), tell<"at least one evaluation is needed">());
        if (design.trials == 1) error(at(&Design::trials), tell<"Monte Carlo needs at least two trials">());
    }

    const Project& project_;
    const AnalysisEntry& analysis_;
    const InputSet* inputs_;
    const std::vector<OutputQuantity>* outputs_;
    Problems& problems_;
    std::string path_;
};

}  // namespace

double DesignChoice::price_of(const std::vector<std::size_t>& rows) const {
    if (prices.empty()) return 0.0;
    double sum = 0.0;
    for (const std::size_t row : rows) sum += prices.size() == 1 ? prices.front() : prices[row];
    return sum;
}

std::optional<DesignTable> find_design_table(const Project& project, const AnalysisEntry& analysis,
                                             const DesignChoice& choice, Problems& problems) {
    Problems own;
    TablePlace place = place_of_table(project, analysis, choice, own);
    DesignTable& table = place.found;
    const FieldSpec* field = place.schema && !table.key.empty() ? place.schema->find(table.key) : nullptr;
    if (!own.has_errors() && (!field || field->kind != FieldKind::table))
        own.error(
            choice_fields().place(&DesignChoice::table),
            tell<"the set-up has no table %1%2">(
                in_quotes(table.key), (place.schema ? did_you_mean(table.key, place.schema->keys()) : "")));
    if (!own.has_errors()) {
        table.title = field->title;
        table.least = field->min_rows;
        if (const auto* rows = std::get_if<SetupTable>(&value_of(*field, *place.setup))) table.rows = *rows;
        table.rows.csv_file.clear();
        table.rows.csv_columns.clear();
        table.present = table.rows.rows.size();
        if (table.rows.units.empty())
            for (const ColumnSpec& column : field->columns) table.rows.units.push_back(column.unit);
        if (!choice.candidates.empty()) add_candidates(project, *field, choice.candidates, table, own);
    }
    problems.take(own, "");
    if (own.has_errors()) return {};
    return std::move(table);
}

std::vector<DesignTableOffer> tables_to_choose_from(const Project& project, const AnalysisEntry& analysis) {
    std::vector<DesignTableOffer> offers;
    const auto add = [&](const SetupSchema* schema, const Setup& setup, const AssetEntry* asset) {
        if (!schema) return;
        for (const FieldSpec& field : schema->fields()) {
            if (field.kind != FieldKind::table || !is_shown(*schema, field, setup)) continue;
            const auto* table = std::get_if<SetupTable>(&value_of(field, setup));
            const std::size_t rows = table ? table->rows.size() : 0;
            if (rows < 2) continue;
            const Text prefix = asset ? (asset->name.empty() ? asset->id : asset->name) + ": " : "";
            offers.push_back({{.asset = asset ? asset->id : "",
                               .table = "/setup/" + field.key + "/rows",
                               .keep = std::max<std::size_t>({1, field.min_rows, rows / 2})},
                              prefix + field.title});
        }
    };
    add(schema_of(analysis), analysis.setup, nullptr);
    for (const std::string& id : assets_used_by(project, analysis)) {
        const AssetEntry& asset = *project.find_asset(id);
        add(schema_of(asset), asset.setup, &asset);
    }
    return offers;
}

void check_designs(const Project& project, const AnalysisEntry& analysis, const InputSet* inputs,
                   const std::vector<OutputQuantity>* outputs, Problems& problems) {
    std::set<std::string> ids;
    DesignCheck check(project, analysis, inputs, outputs, problems);
    for (std::size_t i = 0; i < analysis.designs.size(); ++i) {
        const std::string path = analysis_fields().place(&AnalysisEntry::designs, i);
        if (!ids.insert(analysis.designs[i].id).second)
            problems.error(path + at(&Design::id), tell<"another design has the same id">());
        check.check(analysis.designs[i], path);
    }
}

}  // namespace covaria
