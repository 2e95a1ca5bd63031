// A calibration certificate: what ISO/IEC 17025 7.8.2 and 7.8.4 ask for, results in result lines, conformity,
// signature, end. One to three pages; what else there is stands in the report.
#include <algorithm>
#include <cmath>

#include "core/base/version.h"
#include "core/project/certificate_logo.h"
#include "core/report/certificate_parts.h"
#include "core/report/report.h"
#include "core/result/representation.h"

namespace covaria {
namespace {

using namespace report_parts;

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
std::string stated(const Certificate& certificate, std::string Certificate::*member) {
    if (is_missing(certificate_field(member), certificate)) return not_stated;
    const std::string words = in_one_line(certificate.*member);
    const std::size_t slash = words.find('/');
    if (certificate_field(member).kind != CertificateText::dates || slash == std::string::npos) return words;
    return words.substr(0, slash) + " to " + words.substr(slash + 1);
}

void add_facts(Blocks& blocks, const Certificate& certificate,
               const std::vector<std::string Certificate::*>& members) {
    FactsBlock facts;
    facts.literal = true;
    for (const auto member : members) {
        std::string words = stated(certificate, member);
        if (words.empty() && member == &Certificate::place) words = "in the laboratory";
        if (!words.empty()) facts.facts.emplace_back(certificate_field(member).title, std::move(words));
    }
    if (!facts.facts.empty()) blocks.push_back(std::move(facts));
}

void add_administration(Blocks& blocks, const Certificate& certificate) {
    using C = Certificate;
    add_facts(blocks, certificate,
              {&C::laboratory, &C::laboratory_address, &C::accreditation, &C::place, &C::customer,
               &C::customer_address});
    blocks.push_back(HeadingBlock{2, "Item"});
    add_facts(blocks, certificate,
              {&C::item, &C::manufacturer, &C::type, &C::serial_number, &C::identification, &C::condition,
               &C::received, &C::calibrated, &C::issued});
    blocks.push_back(HeadingBlock{2, "Calibration"});
    add_facts(blocks, certificate,
              {&C::method, &C::deviations, &C::environment, &C::traceability, &C::adjustment});
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
void add_left_out(Blocks& blocks, const ReportSource& source, const std::vector<EvaluatedAnalysis>& shown) {
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
        std::string words = "This certificate states " + std::to_string(here) + " of " + std::to_string(all) +
                            " results. Not stated: " + names + ".";
        if (digital > 0 && has_digital(source))
            words += " " + std::to_string(digital) +
                     (digital == 1 ? " further result is" : " further results are") +
                     " in the digital certificate that is attached to the PDF (certificate.xml).";
        blocks.push_back(ParagraphBlock{words, true});
    }
    for (const FailedAnalysis& failed : source.failed)
        if (failed.study.empty())
            blocks.push_back(ParagraphBlock{
                "Not evaluated: " + (failed.name.empty() ? failed.id : failed.name) + ".", true});
}

void add_results_of(Blocks& blocks, const ReportSource& source, const std::vector<EvaluatedAnalysis>& shown) {
    blocks.push_back(HeadingBlock{2, "Results"});
    for (const EvaluatedAnalysis& one : shown) {
        if (shown.size() > 1) blocks.push_back(HeadingBlock{3, one.analysis->name});
        add_certified_results(blocks, one);
    }
    add_left_out(blocks, source, shown);
    add_uncertainty_statement(blocks, shown);
}

void add_closing(Blocks& blocks, const ReportSource& source, const std::vector<EvaluatedAnalysis>& shown) {
    const Certificate& certificate = source.made.project().certificate;
    add_facts(blocks, certificate, {&Certificate::remarks});
    std::string ids;
    for (const EvaluatedAnalysis& one : shown) ids += (ids.empty() ? "" : ", ") + one.analysis->id;
    blocks.push_back(ParagraphBlock{"Evaluated with Covaria " + std::string(version()) +
                                        ", project fingerprint " + project_fingerprint(source) +
                                        (ids.empty() ? "" : ", " + std::string("analyses: ") + ids) + ".",
                                    true});
    const std::string number = is_blank(certificate.number) ? "" : " " + certificate.number;
    const auto issued = stated(certificate, &Certificate::issued);
    blocks.push_back(SignatureBlock{
        "The results relate only to the item described above, in the state in which it was calibrated. This "
        "certificate may be reproduced in full only, unless the laboratory permits otherwise.",
        std::string("Date of issue: ") + issued, stated(certificate, &Certificate::authorised_by),
        stated(certificate, &Certificate::function), "End of certificate" + number});
}

}  // namespace

ReportDocument build_certificate(const MadeProject& made, const std::vector<EvaluatedAnalysis>& analyses,
                                 const std::vector<FailedAnalysis>& failed, CertifiedResults which) {
    const ReportSource source{made, analyses, failed};
    const Certificate& certificate = made.project().certificate;
    const std::vector<EvaluatedAnalysis> shown =
        which == CertifiedResults::all ? analyses : those_that_fit(analyses);
    ReportDocument document;
    document.title = "Calibration certificate " +
                     (is_blank(certificate.number) ? std::string(not_stated) : certificate.number);
    document.running_head = document.title;
    document.over = stated(certificate, &Certificate::laboratory);
    document.head_on_every_page = true;
    if (auto logo = certificate_logo(made.project())) document.logo = *std::move(logo);
    add_administration(document.blocks, certificate);
    add_results_of(document.blocks, source, shown);
    add_certified_conformity(document.blocks, source, shown);
    add_closing(document.blocks, source, shown);
    return document;
}

}  // namespace covaria
