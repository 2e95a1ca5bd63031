// A calibration certificate: the contents that ISO/IEC 17025 7.8.2 and 7.8.4 ask for, results in result
// lines, conformity, signature, end. It has one to three pages; everything else stands in the report.
#include <algorithm>
#include <cmath>

#include "core/base/version.h"
#include "core/made/certificate_gaps.h"
#include "core/project/certificate_logo.h"
#include "core/project/release.h"
#include "core/report/certificate_defaults.h"
#include "core/report/certificate_parts.h"
#include "core/report/date_words.h"
#include "core/report/report.h"
#include "core/report/stated_uncertainty.h"
#include "core/result/representation.h"
#include "core/views/result_words.h"

namespace covaria {
namespace {

using namespace report_parts;
namespace words = certificate_words;

constexpr std::size_t most_certified = 60;  // results where no analyses were chosen

std::size_t measurand_count(const EvaluatedAnalysis& evaluated) {
    const auto& outputs = evaluated.result->outputs;
    return static_cast<std::size_t>(std::count_if(outputs.begin(), outputs.end(), is_measurand));
}

/// The analyses whose results fit, in their order; if none does, the first.
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

/// The place as it is stated: the site where one was chosen, and the place.
std::string stated_place(const Certificate& certificate, const DocumentLanguage& in) {
    const std::string place = in_one_line(certificate.place);
    const std::string site = is_blank(certificate.site) ? "" : in.say_declared(site_of(certificate).words);
    if (site.empty() || place.empty()) return site + place;
    return in.say(words::results_of, {site, place});
}

/// The text of a field as it was typed; the gap where it is required and not there; empty where it need not
/// be.
std::string stated(const Certificate& certificate, std::string Certificate::*member,
                   const DocumentLanguage& in, Conformity conformity = Conformity::not_stated) {
    const CertificateField& field = certificate_field(member);
    if (is_missing(field, certificate, conformity)) return in.say(words::not_stated);
    if (member == &Certificate::place) return stated_place(certificate, in);
    const std::string text = in_one_line(certificate.*member);
    const bool dated = field.kind == CertificateText::date || field.kind == CertificateText::dates;
    return dated ? date_words(text, in) : text;
}

void add_facts(Blocks& blocks, const Certificate& certificate,
               const std::vector<std::string Certificate::*>& members, const DocumentLanguage& in,
               Conformity conformity = Conformity::not_stated) {
    FactsBlock facts;
    facts.literal = true;
    for (const auto member : members) {
        std::string text = stated(certificate, member, in, conformity);
        if (text.empty()) text = said_in_place_of(member, in);
        if (!text.empty())
            facts.facts.emplace_back(in.say_declared(certificate_field(member).title), std::move(text));
    }
    if (!facts.facts.empty()) blocks.push_back(std::move(facts));
}

/// Adds the administrative data. The specification stands with the statement of conformity; without one, with
/// the method.
void add_administration(Blocks& blocks, const Certificate& certificate, bool conformity_follows,
                        const DocumentLanguage& in) {
    using C = Certificate;
    if (is_blank(certificate.number)) add_facts(blocks, certificate, {&C::number}, in);
    if (!is_blank(certificate.replaces))
        add_facts(blocks, certificate, {&C::replaces, &C::replaced_issued, &C::reasons}, in);
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
    std::vector<std::string C::*> members{&C::method, &C::deviations, &C::environment, &C::traceability,
                                          &C::adjustment};
    if (!conformity_follows) members.push_back(&C::specification);
    add_facts(blocks, certificate, members, in);
}

/// The statement of conformity: tables, and above them the specification that they refer to; nothing without
/// tolerances.
Blocks conformity_of(const ReportSource& source, const std::vector<EvaluatedAnalysis>& shown,
                     const DocumentLanguage& in) {
    Blocks tables, blocks;
    add_certified_conformity(tables, source, shown, in);
    if (tables.empty()) return tables;
    blocks.push_back(HeadingBlock{2, in.say(words::conformity)});
    add_facts(blocks, source.made.project().certificate, {&Certificate::specification}, in,
              Conformity::stated);
    blocks.insert(blocks.end(), tables.begin(), tables.end());
    return blocks;
}

/// Whether the PDF carries a digital certificate, which then states the results of all analyses.
bool has_digital(const ReportSource& source) {
    if (missing_in_digital(source.made.project().certificate,
                           stated_conformity(source.made.project(), ids_of(source.analyses)))
            .has_errors())
        return false;
    for (const EvaluatedAnalysis& one : source.analyses)
        for (const OutputResult& output : one.result->outputs)
            if (is_measurand(output) &&
                !(std::isfinite(output.estimate) && std::isfinite(output.expanded_uncertainty) &&
                  std::isfinite(output.coverage_factor)))
                return false;
    return true;
}

bool is_among(const EvaluatedAnalysis& one, const std::vector<EvaluatedAnalysis>& shown) {
    return std::ranges::any_of(
        shown, [&](const EvaluatedAnalysis& other) { return other.analysis->id == one.analysis->id; });
}

/// Adds the names of the analyses whose results the certificate does not have, and the number of these
/// results.
void add_left_out(Blocks& blocks, const ReportSource& source, const std::vector<EvaluatedAnalysis>& shown,
                  const DocumentLanguage& in) {
    std::size_t all = 0, here = 0, digital = 0;
    std::string names;
    for (const EvaluatedAnalysis& one : source.analyses) {
        all += measurand_count(one);
        if (is_among(one, shown)) {
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
}

bool are_all_raised(const MadeProject& made, const EvaluatedAnalysis& one) {
    const auto findings = capability_findings(made, *one.result);
    const auto raised = std::ranges::count(findings, CapabilityVerdict::raised, &CapabilityFinding::verdict);
    return raised > 0 && static_cast<std::size_t>(raised) == measurand_count(one);
}

/// Those of the analyses that are shown of which a U is stated as it was evaluated.
std::vector<EvaluatedAnalysis> as_evaluated(const MadeProject& made,
                                            const std::vector<EvaluatedAnalysis>& evaluated,
                                            const std::vector<EvaluatedAnalysis>& shown) {
    std::vector<EvaluatedAnalysis> some;
    for (const EvaluatedAnalysis& one : evaluated)
        if (is_among(one, shown) && !are_all_raised(made, one)) some.push_back(one);
    return some;
}

/// Says which U is the laboratory's capability in place of the evaluated one, and what is outside its scope,
/// of the analyses that are shown.
void add_capability_notes(Blocks& blocks, const MadeProject& made,
                          const std::vector<EvaluatedAnalysis>& evaluated,
                          const std::vector<EvaluatedAnalysis>& shown, const DocumentLanguage& in) {
    for (const EvaluatedAnalysis& one : evaluated) {
        if (!is_among(one, shown)) continue;
        for (const CapabilityFinding& finding : capability_findings(made, *one.result))
            blocks.push_back(ParagraphBlock{in.say(finding.for_customers) + "."});
    }
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

std::string report_parts::in_one_line(const std::string& text) {
    std::string out;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string line = text.substr(begin, end - begin);
        if (!is_blank(line)) out += (out.empty() ? "" : ", ") + line;
        begin = end + 1;
    }
    return out;
}

ReportDocument build_certificate(const MadeProject& made, const std::vector<EvaluatedAnalysis>& analyses,
                                 const std::vector<FailedAnalysis>& failed, CertifiedResults which,
                                 const DocumentLanguage& in) {
    const std::vector<EvaluatedAnalysis> stated_analyses = as_stated(made, analyses);
    const ReportSource source{made, stated_analyses, failed};
    const Certificate& certificate = made.project().certificate;
    const std::vector<EvaluatedAnalysis> shown =
        which == CertifiedResults::all ? stated_analyses : those_that_fit(stated_analyses);
    ReportDocument document;
    document.title =
        is_blank(certificate.number) ? in.say(words::untitled) : in.say(words::title, {certificate.number});
    document.language = in.code();
    document.author =
        is_blank(certificate.authorised_by) ? made.project().author : in_one_line(certificate.authorised_by);
    document.page_words = in.say(words::page);
    document.running_head = document.title;
    document.over = in_one_line(certificate.laboratory);
    document.head_on_every_page = true;
    if (auto logo = certificate_logo(made.project())) document.logo = *std::move(logo);
    const Blocks conformity = conformity_of(source, shown, in);
    FactsBlock review;
    review.literal = true;
    add_review(review, made.project(), in);
    const bool released = release_status(made.project()).state == ReleaseState::released;
    // A draft says so at its head; who released a certificate stands where it is signed.
    if (!released && !review.facts.empty()) document.blocks.push_back(review);
    add_administration(document.blocks, certificate, !conformity.empty(), in);
    add_results_of(document.blocks, source, shown, in);
    add_uncertainty_statement(document.blocks, as_evaluated(made, analyses, shown), in);
    add_capability_notes(document.blocks, made, analyses, shown, in);
    document.blocks.insert(document.blocks.end(), conformity.begin(), conformity.end());
    add_changes(document.blocks, source, shown, in);
    if (released) document.blocks.push_back(review);
    add_closing(document.blocks, source, shown, in);
    return document;
}

std::string said_in_place_of(std::string Certificate::*text, const DocumentLanguage& in) {
    return text == &Certificate::place ? in.say(words::in_the_laboratory) : std::string();
}

}  // namespace covaria
