// A calibration certificate: what ISO/IEC 17025 7.8.2 and 7.8.4 ask for, results in result lines, conformity,
// signature, end. One to three pages; what else there is stands in the report.
#include <algorithm>
#include <cmath>

#include "core/base/version.h"
#include "core/project/certificate_logo.h"
#include "core/report/certificate_defaults.h"
#include "core/report/certificate_parts.h"
#include "core/report/report.h"
#include "core/result/representation.h"

namespace covaria {
namespace {

using namespace report_parts;
namespace words = certificate_words;

constexpr std::size_t most_certified = 60;  // results, where no analyses were chosen

std::size_t measurand_count(const EvaluatedAnalysis& evaluated) {
    const auto& outputs = evaluated.result->outputs;
    return static_cast<std::size_t>(std::count_if(outputs.begin(), outputs.end(), is_measurand));
}

/// Those whose results fit, in their order; if none does, the first.
std::vector<EvaluatedAnalysis> those_that_fit(const std::vector<EvaluatedAnalysis>& analyses) {
    std::vector<EvaluatedAnalysis> fitting;
    std::size_t count = 0;
    for (const EvaluatedAnalysis& one : analyses) {
        if (count + measurand_count(one) > most_certified) continue;
        count += measurand_count(one);
        fitting.push_back(one);
    }
    if (fitting.empty() && !analyses.empty()) fitting.push_back(analyses.front());
    return fitting;
}

/// Lines of an address in one.
std::string in_one_line(const std::string& text) {
    std::string out;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string line = text.substr(begin, end - begin);
        if (!is_blank(line)) out += (out.empty() ? "" : ", ") + line;
        begin = end + 1;
    }
    return out;
}

/// What was typed; the gap where it is required and not there; empty where it need not be.
std::string stated(const Certificate& certificate, std::string Certificate::*member,
                   const DocumentLanguage& in) {
    if (is_missing(certificate_field(member), certificate)) return in.say(words::not_stated);
    const std::string text = in_one_line(certificate.*member);
    const std::size_t slash = text.find('/');
    if (certificate_field(member).kind != CertificateText::dates || slash == std::string::npos) return text;
    return in.say(words::dates, {text.substr(0, slash), text.substr(slash + 1)});
}

void add_facts(Blocks& blocks, const Certificate& certificate,
               const std::vector<std::string Certificate::*>& members, const DocumentLanguage& in) {
    FactsBlock facts;
    facts.literal = true;
    for (const auto member : members) {
        std::string text = stated(certificate, member, in);
        if (text.empty()) text = said_in_place_of(member, in);
        if (!text.empty())
            facts.facts.emplace_back(in.say_declared(certificate_field(member).title), std::move(text));
    }
    if (!facts.facts.empty()) blocks.push_back(std::move(facts));
}

void add_administration(Blocks& blocks, const Certificate& certificate, const DocumentLanguage& in) {
    using C = Certificate;
    if (is_blank(certificate.number)) add_facts(blocks, certificate, {&C::number}, in);
    add_facts(blocks, certificate,
              {&C::laboratory, &C::laboratory_address, &C::accreditation, &C::place, &C::customer,
               &C::customer_address},
              in);
    blocks.push_back(HeadingBlock{2, in.say(words::item)});
    add_facts(blocks, certificate,
              {&C::item, &C::manufacturer, &C::type, &C::serial_number, &C::identification, &C::condition,
               &C::received, &C::calibrated, &C::issued},
              in);
    blocks.push_back(HeadingBlock{2, in.say(words::calibration)});
    add_facts(blocks, certificate,
              {&C::method, &C::deviations, &C::environment, &C::traceability, &C::adjustment}, in);
}

/// Whether the PDF carries a digital certificate, which then states the results of all analyses.
bool has_digital(const ReportSource& source) {
    if (missing_in_digital(source.made.project().certificate).has_errors()) return false;
    for (const EvaluatedAnalysis& one : source.analyses)
        for (const OutputResult& output : one.result->outputs)
            if (is_measurand(output) &&
                !(std::isfinite(output.estimate) && std::isfinite(output.expanded_uncertainty) &&
                  std::isfinite(output.coverage_factor)))
                return false;
    return true;
}

/// Analyses whose results the certificate does not have, and how many those are.
void add_left_out(Blocks& blocks, const ReportSource& source, const std::vector<EvaluatedAnalysis>& shown,
                  const DocumentLanguage& in) {
    std::size_t all = 0, here = 0, digital = 0;
    std::string names;
    for (const EvaluatedAnalysis& one : source.analyses) {
        all += measurand_count(one);
        const bool is_here = std::any_of(shown.begin(), shown.end(), [&](const EvaluatedAnalysis& other) {
            return other.analysis->id == one.analysis->id;
        });
        if (is_here) {
            here += measurand_count(one);
            continue;
        }
        names += (names.empty() ? "" : ", ") + one.analysis->name + " (" +
                 std::to_string(measurand_count(one)) + ")";
        if (represents_measurand(*one.result)) digital += measurand_count(one);
    }
    if (here < all) {
        std::string text =
            in.say(words::left_out, {std::to_string(here), std::to_string(all), std::move(names)});
        if (digital > 0 && has_digital(source))
            text += " " + in.say(digital == 1 ? words::further_result : words::further_results,
                                 {std::to_string(digital)});
        blocks.push_back(ParagraphBlock{std::move(text), true});
    }
    for (const FailedAnalysis& failed : source.failed)
        if (failed.study.empty())
            blocks.push_back(ParagraphBlock{
                in.say(words::not_evaluated, {failed.name.empty() ? failed.id : failed.name}), true});
}

void add_results_of(Blocks& blocks, const ReportSource& source, const std::vector<EvaluatedAnalysis>& shown,
                    const DocumentLanguage& in) {
    blocks.push_back(HeadingBlock{2, in.say(words::results)});
    for (const EvaluatedAnalysis& one : shown) {
        if (shown.size() > 1) blocks.push_back(HeadingBlock{3, one.analysis->name});
        add_certified_results(blocks, one, in);
    }
    add_left_out(blocks, source, shown, in);
    add_uncertainty_statement(blocks, shown, in);
}

void add_closing(Blocks& blocks, const ReportSource& source, const std::vector<EvaluatedAnalysis>& shown,
                 const DocumentLanguage& in) {
    const Certificate& certificate = source.made.project().certificate;
    add_facts(blocks, certificate, {&Certificate::remarks}, in);
    std::string ids;
    for (const EvaluatedAnalysis& one : shown) ids += (ids.empty() ? "" : ", ") + one.analysis->name;
    blocks.push_back(ParagraphBlock{in.say(ids.empty() ? words::evaluated_with : words::evaluated_analyses,
                                           {version(), project_fingerprint(source), ids}),
                                    true});
    const bool numbered = !is_blank(certificate.number);
    blocks.push_back(SignatureBlock{
        in.say(words::closing), in.say(words::date_of_issue, {stated(certificate, &Certificate::issued, in)}),
        stated(certificate, &Certificate::authorised_by, in), stated(certificate, &Certificate::function, in),
        in.say(numbered ? words::end_of : words::end, {certificate.number})});
}

}  // namespace

ReportDocument build_certificate(const MadeProject& made, const std::vector<EvaluatedAnalysis>& analyses,
                                 const std::vector<FailedAnalysis>& failed, CertifiedResults which,
                                 const DocumentLanguage& in) {
    const ReportSource source{made, analyses, failed};
    const Certificate& certificate = made.project().certificate;
    const std::vector<EvaluatedAnalysis> shown =
        which == CertifiedResults::all ? analyses : those_that_fit(analyses);
    ReportDocument document;
    document.title =
        is_blank(certificate.number) ? in.say(words::untitled) : in.say(words::title, {certificate.number});
    document.language = in.code();
    document.page_words = in.say(words::page);
    document.running_head = document.title;
    document.over = in_one_line(certificate.laboratory);
    document.head_on_every_page = true;
    if (auto logo = certificate_logo(made.project())) document.logo = *std::move(logo);
    add_administration(document.blocks, certificate, in);
    add_results_of(document.blocks, source, shown, in);
    add_certified_conformity(document.blocks, source, shown, in);
    add_closing(document.blocks, source, shown, in);
    return document;
}

std::string said_in_place_of(std::string Certificate::*text, const DocumentLanguage& in) {
    return text == &Certificate::place ? in.say(words::in_the_laboratory) : std::string();
}

}  // namespace covaria
