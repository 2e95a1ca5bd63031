// Digital Calibration Certificate 3.2.1: administrative data of the project's certificate, results in D-SI.
#include "core/base/version.h"
#include "core/made/certificate_gaps.h"
#include "core/project/certificate.h"
#include "core/project/stated_requirements.h"
#include "core/report/certificate_parts.h"
#include "core/report/stated_uncertainty.h"
#include "core/result/representation.h"
#include "core/result/result_line.h"
#include "core/views/result_words.h"
#include "core/writers/dcc_xml.h"
#include "core/writers/dsi_values.h"
#include "core/writers/formats.h"

namespace covaria {

namespace {

using C = Certificate;
using pugi::xml_node;

/// The words for uncertainties: data have no "±" that U could stand after.
std::string uncertainty_words(const UncertaintyResult& result) {
    const std::string by = result.trials == 0
                               ? "The standard uncertainty was determined by the law of propagation of "
                                 "uncertainty in accordance with JCGM 100."
                               : "The distribution was determined by the propagation of distributions in "
                                 "accordance with JCGM 101.";
    switch (expanded_by(result)) {
        case ExpandedBy::fixed_factor:
            return "The expanded uncertainty is the standard uncertainty multiplied by the fixed "
                   "coverage "
                   "factor; the coverage probability is that of the interval of this half-width about "
                   "the value.\n" +
                   by;
        case ExpandedBy::interval:
            return "The expanded uncertainty is half the width of the probabilistically symmetric "
                   "coverage interval of the coverage probability; the coverage factor is its ratio to "
                   "the standard uncertainty.\n" +
                   by;
        case ExpandedBy::degrees_of_freedom:
            break;
    }
    return "The expanded uncertainty is the standard uncertainty multiplied by the coverage factor, "
           "which "
           "for a normal distribution, or for a t distribution of the effective degrees of freedom where "
           "they are stated, corresponds to the coverage probability.\n" +
           by;
}

class DccWriter {
public:
    explicit DccWriter(const WriterSource& source)
        : source_(source), certificate_(source.made.project().certificate) {}

    Result<WrittenFile> write() && {
        pugi::xml_document document;
        xml_node declaration = document.append_child(pugi::node_declaration);
        declaration.append_attribute("version") = "1.0";
        declaration.append_attribute("encoding") = "UTF-8";
        xml_node root = document.append_child("dcc:digitalCalibrationCertificate");
        root.append_attribute("xmlns:dcc") = "https://ptb.de/dcc";
        root.append_attribute("xmlns:si") = "https://ptb.de/si";
        root.append_attribute("xmlns:xsi") = "http://www.w3.org/2001/XMLSchema-instance";
        root.append_attribute("xsi:schemaLocation") = "https://ptb.de/dcc https://ptb.de/dcc/v3.2.1/dcc.xsd";
        root.append_attribute("schemaVersion") = "3.2.1";
        write_administration(root.append_child("dcc:administrativeData"));
        xml_node results = root.append_child("dcc:measurementResults");
        for (const EvaluatedAnalysis& evaluated : source_.analyses)
            if (auto added = write_analysis(results, evaluated); !added) return fail(added.error());
        if (!results.first_child())
            return fail(ErrorCode::bad_input, tell<"there are no results for the certificate to state">());
        WrittenFile file{text_of(document),
                         {"Digital Calibration Certificate " + certificate_.number +
                          ", schema version "
                          "3.2.1, not signed: " +
                          std::to_string(quantities_) + " results"}};
        file.said.insert(file.said.end(), said_.begin(), said_.end());
        return file;
    }

private:
    std::string line_of(std::string C::*member) const { return xml_line(certificate_.*member); }

    void write_administration(xml_node data) {
        xml_node software = data.append_child("dcc:dccSoftware").append_child("dcc:software");
        add_name(software, "Covaria");
        add_text(software, "dcc:release", version());
        add_text(software, "dcc:type", "application");
        write_core_data(data.append_child("dcc:coreData"));
        write_item(data.append_child("dcc:items").append_child("dcc:item"));
        xml_node laboratory = data.append_child("dcc:calibrationLaboratory");
        if (const std::string code = line_of(&C::accreditation); !code.empty())
            add_text(laboratory, "dcc:calibrationLaboratoryCode", code);
        write_contact(laboratory.append_child("dcc:contact"), &C::laboratory, &C::laboratory_address,
                      line_of(&C::country));
        xml_node person = data.append_child("dcc:respPersons").append_child("dcc:respPerson");
        add_name(person.append_child("dcc:person"), line_of(&C::authorised_by));
        if (const std::string role = line_of(&C::function); !role.empty()) add_text(person, "dcc:role", role);
        add_text(person, "dcc:mainSigner", "true");
        write_contact(data.append_child("dcc:customer"), &C::customer, &C::customer_address, "");
        write_statements(data.append_child("dcc:statements"));
    }

    void write_core_data(xml_node core) const {
        add_text(core, "dcc:countryCodeISO3166_1", line_of(&C::country));
        add_text(core, "dcc:usedLangCodeISO639_1", "en");
        add_text(core, "dcc:mandatoryLangCodeISO639_1", "en");
        add_text(core, "dcc:uniqueIdentifier", line_of(&C::number));
        if (const std::string date = line_of(&C::received); !date.empty())
            add_text(core, "dcc:receiptDate", date);
        const std::string calibrated = line_of(&C::calibrated);
        const std::size_t slash = calibrated.find('/');
        add_text(core, "dcc:beginPerformanceDate", calibrated.substr(0, slash));
        add_text(core, "dcc:endPerformanceDate",
                 slash == std::string::npos ? calibrated : calibrated.substr(slash + 1));
        add_text(core, "dcc:performanceLocation", site_of(certificate_).key);
        add_text(core, "dcc:issueDate", line_of(&C::issued));
        if (const std::string replaced = line_of(&C::replaces); !replaced.empty()) {
            xml_node change = core.append_child("dcc:reportAmendedSubstituted");
            add_text(change, "dcc:typeOfChange", "amended");
            add_text(change, "dcc:replacedUniqueIdentifier", replaced);
        }
    }

    void write_item(xml_node item) const {
        add_name(item, line_of(&C::item));
        if (const std::string maker = line_of(&C::manufacturer); !maker.empty())
            add_name(item.append_child("dcc:manufacturer"), maker);
        if (const std::string type = line_of(&C::type); !type.empty()) add_text(item, "dcc:model", type);
        xml_node list = item.append_child("dcc:identifications");
        const auto identify = [&](const char* issuer, std::string C::*member) {
            const std::string value = line_of(member);
            if (value.empty()) return;
            xml_node identification = list.append_child("dcc:identification");
            add_text(identification, "dcc:issuer", issuer);
            add_text(identification, "dcc:value", value);
            add_name(identification, certificate_field(member).title);
        };
        identify("manufacturer", &C::serial_number);
        identify("customer", &C::identification);
    }

    /// Writes a contact. An address as it was typed is not taken apart: its lines stand as further ones.
    void write_contact(xml_node contact, std::string C::*name, std::string C::*address,
                       const std::string& country) const {
        add_name(contact, line_of(name));
        xml_node location = contact.append_child("dcc:location");
        if (!country.empty()) add_text(location, "dcc:countryCode", country);
        add_contents(location.append_child("dcc:further"), certificate_.*address);
    }

    void write_statements(xml_node statements) const {
        for (const auto member : {&C::place, &C::specification, &C::condition, &C::deviations,
                                  &C::traceability, &C::adjustment, &C::remarks, &C::reasons}) {
            const bool of_amendment = member == &C::reasons;
            if (is_blank(certificate_.*member) || (of_amendment && is_blank(certificate_.replaces))) continue;
            xml_node statement = statements.append_child("dcc:statement");
            add_name(statement, certificate_field(member).title);
            add_contents(statement.append_child("dcc:declaration"), certificate_.*member);
        }
    }

    /// Writes the method of the calibration, then that of the uncertainties; and the conditions.
    void write_methods(xml_node node, const UncertaintyResult& result) const {
        xml_node methods = node.append_child("dcc:usedMethods");
        xml_node method = methods.append_child("dcc:usedMethod");
        add_name(method, certificate_field(&C::method).title);
        add_contents(method.append_child("dcc:description"), certificate_.method);
        method = methods.append_child("dcc:usedMethod");
        const bool trials = result.trials > 0;
        add_name(method, trials ? "Propagation of distributions" : "Law of propagation of uncertainty");
        add_contents(method.append_child("dcc:description"), uncertainty_words(result));
        add_text(method, "dcc:norm", trials ? "JCGM 101:2008" : "JCGM 100:2008");
        xml_node condition =
            node.append_child("dcc:influenceConditions").append_child("dcc:influenceCondition");
        add_name(condition, certificate_field(&C::environment).title);
        add_contents(condition.append_child("dcc:data").append_child("dcc:text"), certificate_.environment);
    }

    Result<void> write_analysis(xml_node results, const EvaluatedAnalysis& evaluated) {
        const UncertaintyResult& result = *evaluated.result;
        const PreparedAnalysis& analysis = *evaluated.analysis;
        if (!represents_measurand(result)) {
            said_.push_back("not stated: analysis " + analysis.id + ", whose result " + does_not_represent);
            return {};
        }
        const std::vector<RequirementResult> verdicts = verdicts_on(evaluated);
        xml_node node = results.append_child("dcc:measurementResult");
        const std::string name = xml_line(analysis.name.empty() ? analysis.id : analysis.name);
        add_name(node, name);
        write_methods(node, result);
        xml_node list = node.append_child("dcc:results");
        for (const std::string& group : result_words::measurand_groups(result)) {
            const auto outputs = result_words::measurands_of(result, group);
            xml_node one = list.append_child("dcc:result");
            add_name(one, xml_line(group).empty() ? name : xml_line(group));
            auto added = add_quantities(one.append_child("dcc:data"), result, group, outputs,
                                        {verdicts, line_of(&C::specification)});
            if (!added) return with_analysis(added.error(), analysis.id);
            quantities_ += outputs.size();
        }
        if (!list.first_child()) results.remove_child(node);
        return {};
    }

    /// The verdicts on an analysis. A target uncertainty is an aim of the laboratory: it is not stated.
    std::vector<RequirementResult> verdicts_on(const EvaluatedAnalysis& evaluated) {
        const AnalysisEntry* entry = source_.made.project().find_analysis(evaluated.analysis->id);
        if (!entry) return {};
        std::vector<RequirementResult> verdicts = judge(*evaluated.result, *entry);
        for (const RequirementResult& verdict : verdicts)
            if (!verdict.not_judged.empty() && (verdict.lower_limit || verdict.upper_limit))
                said_.push_back("not stated: conformity of " +
                                xml_line(evaluated.result->outputs[verdict.output].quantity.symbol) +
                                " of analysis " + entry->id + ": " + verdict.not_judged.english());
        return verdicts;
    }

    static tl::unexpected<Error> with_analysis(Error error, const std::string& id) {
        error.message = "analysis " + id + ": " + error.message;
        return fail(std::move(error));
    }

    const WriterSource& source_;
    const Certificate& certificate_;
    std::size_t quantities_ = 0;
    std::vector<std::string> said_;
};

Problems missing_for_dcc(const Project& project) {
    return missing_in_digital(project.certificate, stated_conformity(project, certified_ids(project)));
}

Result<WrittenFile> write_dcc(const WriterSource& source) {
    const Project& project = source.made.project();
    const Problems missing =
        missing_in_digital(project.certificate, stated_conformity(project, ids_of(source.analyses)));
    if (missing.has_errors())
        return fail(ErrorCode::bad_input, first_error(missing, ""), missing.items().front().path);
    for (const EvaluatedAnalysis& one : source.analyses)
        for (const CapabilityFinding& finding : capability_findings(source.made, *one.result))
            if (finding.verdict == CapabilityVerdict::refused)
                return fail(ErrorCode::bad_input, finding.words);
    const std::vector<EvaluatedAnalysis> stated = as_stated(source.made, source.analyses);
    return DccWriter({source.made, stated}).write();
}

}  // namespace

Writer dcc_writer() {
    return {.name = "dcc",
            .title = "Digital Calibration Certificate 3.2.1",
            .ending = ".xml",
            .writes =
                "measurands with U, k and p, those of a group with their covariance matrix; laboratory, "
                "item and customer of the project's certificate",
            .write = write_dcc,
            .missing = missing_for_dcc};
}

}  // namespace covaria
