#include "core/report/amendment.h"

#include <algorithm>
#include <cmath>

#include "core/base/dates.h"
#include "core/base/in_quotes.h"
#include "core/project/stated_requirements.h"
#include "core/report/certificate_parts.h"
#include "core/result/representation.h"
#include "core/views/result_statement.h"

namespace covaria {

namespace {

using C = Certificate;
namespace words = certificate_words;

/// The texts whose change an amended certificate states: those that are its own by their nature are not.
const std::vector<const CertificateField*>& amended_texts() {
    static const std::vector<const CertificateField*> fields = [] {
        std::vector<const CertificateField*> all;
        for (const CertificateField& field : certificate_fields()) {
            const bool is_own = field.member == &C::number || field.member == &C::issued ||
                                std::string(field.group) == "replaces";
            if (!is_own && field.member != &C::language && field.member != &C::logo) all.push_back(&field);
        }
        return all;
    }();
    return fields;
}

std::string key_of_text(const CertificateField& field) {
    return pointer_of(field).substr(std::string("/certificate/").size());
}

ReplacedDecision decision_on(const std::vector<RequirementResult>& verdicts, std::size_t output) {
    ReplacedDecision decision = ReplacedDecision::none;
    for (const RequirementResult& verdict : verdicts) {
        if (verdict.output != output || !verdict.not_judged.empty()) continue;
        if (!verdict.lower_limit && !verdict.upper_limit) continue;
        const bool accepted = verdict.decision == RequirementResult::Decision::accept;
        if (!accepted || decision == ReplacedDecision::fail)
            decision = ReplacedDecision::fail;
        else
            decision = ReplacedDecision::pass;
    }
    return decision;
}

/// The results that a certificate states of an analysis.
std::vector<ReplacedResult> stated_results(const EvaluatedAnalysis& evaluated, const Project& project,
                                           const std::string& id) {
    std::vector<ReplacedResult> results;
    const UncertaintyResult& result = *evaluated.result;
    if (!represents_measurand(result)) return results;
    const auto verdicts = judge(result, project, evaluated.analysis->id);
    for (std::size_t i = 0; i < result.outputs.size(); ++i) {
        const OutputResult& output = result.outputs[i];
        const Unit& unit = output.quantity.unit;
        const bool stated = std::isfinite(output.estimate) && std::isfinite(output.expanded_uncertainty);
        if (!result_words::is_measurand(output) || !stated) continue;
        results.push_back({id, output.quantity.group, output.quantity.symbol, unit.from_si(output.estimate),
                           unit.interval_from_si(output.expanded_uncertainty), unit,
                           decision_on(verdicts, i)});
    }
    return results;
}

std::string statement(const ReplacedResult& result, const DocumentLanguage& in) {
    const Unit& unit = result.unit;
    std::string text = value_statement(unit.to_si(result.estimate),
                                       unit.interval_to_si(result.expanded_uncertainty), unit, 2, true, in);
    if (result.decision == ReplacedDecision::none) return text;
    return text + "; " + in.say(result.decision == ReplacedDecision::pass ? words::passes : words::fails);
}

/// The same result in the unit of another, so that both are read alike.
ReplacedResult in_unit_of(ReplacedResult result, const Unit& unit) {
    if (result.unit.dimension() != unit.dimension()) return result;
    result.estimate = unit.from_si(result.unit.to_si(result.estimate));
    result.expanded_uncertainty =
        unit.interval_from_si(result.unit.interval_to_si(result.expanded_uncertainty));
    result.unit = unit;
    return result;
}

bool is_same_result(const ReplacedResult& a, const ReplacedResult& b) {
    return a.analysis == b.analysis && a.group == b.group && a.symbol == b.symbol;
}

/// A result before and now, in words; empty where it is not stated.
struct ChangedResult {
    ReplacedResult of;
    std::string before = {}, now = {};
};

std::vector<ChangedResult> changed_results(const std::vector<ReplacedResult>& before,
                                           const std::vector<ReplacedResult>& now,
                                           const DocumentLanguage& in) {
    const auto find = [](const std::vector<ReplacedResult>& all, const ReplacedResult& wanted) {
        return std::find_if(all.begin(), all.end(),
                            [&](const ReplacedResult& one) { return is_same_result(one, wanted); });
    };
    std::vector<ChangedResult> changes;
    for (const ReplacedResult& result : now) {
        const auto old = find(before, result);
        const std::string was =
            old == before.end() ? std::string() : statement(in_unit_of(*old, result.unit), in);
        if (const std::string is = statement(result, in); is != was) changes.push_back({result, was, is});
    }
    for (const ReplacedResult& result : before)
        if (find(now, result) == now.end()) changes.push_back({result, statement(result, in), ""});
    return changes;
}

/// The name of a group as the results of now have it; one that is gone as it was called.
std::string group_words(const std::string& group, const std::vector<EvaluatedAnalysis>& shown,
                        const DocumentLanguage& in) {
    for (const EvaluatedAnalysis& evaluated : shown)
        for (const OutputResult& output : evaluated.result->outputs)
            if (group == std::string(output.quantity.group)) return in.say(said_name(output.quantity.group));
    return group;
}

const std::string& or_dash(const std::string& text) {
    static const std::string dash = "\u2014";
    return text.empty() ? dash : text;
}

void add_changed_results(report_parts::Blocks& blocks, const ReportSource& source,
                         const std::vector<EvaluatedAnalysis>& shown, const DocumentLanguage& in) {
    const Project& project = source.made.project();
    const Amendment now = statements_of({source.made, shown, source.failed, in});
    const auto changed = changed_results(project.amendment.results, now.results, in);
    if (changed.empty()) return blocks.push_back(ParagraphBlock{in.say(words::no_changed_result)});
    const auto where = [&](const ReplacedResult& result) {
        const std::string group = group_words(result.group, shown, in);
        if (shown.size() < 2) return group;
        const AnalysisEntry* analysis = project.find_analysis(result.analysis);
        const std::string name = analysis ? analysis->name : result.analysis;
        return group.empty() ? name : in.say(words::results_of, {name, group});
    };
    const bool placed =
        std::ranges::any_of(changed, [&](const ChangedResult& one) { return !where(one.of).empty(); });
    report_parts::TableBuilder table("amended-results", "", in);
    if (placed) table.text(in.say(words::group));
    table.text(in.say(words::quantity), true);
    table.text(in.say(words::replaced));
    table.text(in.say(words::amended));
    for (const ChangedResult& one : changed) {
        std::vector<Cell> row;
        if (placed) row.emplace_back(where(one.of));
        row.emplace_back(one.of.symbol);
        row.emplace_back(or_dash(one.before));
        row.emplace_back(or_dash(one.now));
        table.row(std::move(row));
    }
    blocks.push_back(table.take());
}

void add_changed_texts(report_parts::Blocks& blocks, const Project& project, const DocumentLanguage& in) {
    report_parts::TableBuilder table("amended-texts", "", in);
    table.text(in.say(words::statement));
    table.text(in.say(words::replaced));
    table.text(in.say(words::amended));
    bool any = false;
    for (const CertificateField* field : amended_texts()) {
        const auto old =
            std::ranges::find(project.amendment.texts, key_of_text(*field), &ReplacedText::field);
        const std::string was =
            report_parts::in_one_line(old == project.amendment.texts.end() ? std::string() : old->text);
        const std::string is = report_parts::in_one_line(project.certificate.*field->member);
        if (was == is) continue;
        any = true;
        table.row({in.say_declared(field->title), or_dash(was), or_dash(is)});
    }
    if (any) blocks.push_back(table.take());
}

}  // namespace

Amendment statements_of(const ReportSource& source, const std::map<std::string, std::string>& present) {
    Amendment amendment;
    const Project& project = source.made.project();
    for (const CertificateField* field : amended_texts())
        if (const std::string& text = project.certificate.*field->member; !is_blank(text))
            amendment.texts.push_back({key_of_text(*field), text});
    for (const EvaluatedAnalysis& evaluated : source.analyses) {
        const std::string& own = evaluated.analysis->id;
        const auto id = present.find(own);
        const auto results = stated_results(evaluated, project, id == present.end() ? own : id->second);
        amendment.results.insert(amendment.results.end(), results.begin(), results.end());
    }
    return amendment;
}

Result<Project> amended(Project project, const Project& replaced, Amendment statements,
                        const AmendmentRequest& request) {
    if (is_blank(replaced.certificate.number))
        return fail(
            ErrorCode::bad_input,
            tell<"the certificate that is to be replaced has no number: there is none to refer to">());
    if (replaced.certificate.number == request.number)
        return fail(ErrorCode::bad_input,
                    tell<"an amended certificate has a number of its own; %1 is that of the one that it "
                         "replaces">(in_quotes(request.number)));
    if (!date_of(request.issued))
        return fail(ErrorCode::bad_input,
                    tell<"the date of issue must be of the form 2026-04-17; it is '%1'">(request.issued));
    project.certificate.number = request.number;
    project.certificate.issued = request.issued;
    project.certificate.replaces = replaced.certificate.number;
    project.certificate.replaced_issued = replaced.certificate.issued;
    project.certificate.reasons = request.reasons;
    project.amendment = std::move(statements);
    return project;
}

void report_parts::add_changes(Blocks& blocks, const ReportSource& source,
                               const std::vector<EvaluatedAnalysis>& shown, const DocumentLanguage& in) {
    const Project& project = source.made.project();
    if (is_blank(project.certificate.replaces) || project.amendment.empty()) return;
    blocks.push_back(HeadingBlock{2, in.say(words::changes, {project.certificate.replaces})});
    add_changed_results(blocks, source, shown, in);
    add_changed_texts(blocks, project, in);
}

}  // namespace covaria
