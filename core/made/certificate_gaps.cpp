#include "core/made/certificate_gaps.h"

#include <algorithm>
#include <cmath>

#include "core/base/in_quotes.h"
#include "core/math/normal_quantile.h"
#include "core/project/option_fields.h"
#include "core/text/numbers.h"
#include "core/text/symbol.h"

namespace covaria {

namespace {

constexpr std::size_t most_symbols = 6;

bool is_unnamed(const OutputQuantity& output) {
    return output.role == OutputRole::measurand &&
           (output.name.empty() || output.name == Message(output.symbol));
}

/// Symbols of the outputs without a name, each once, whatever its groups.
std::vector<std::string> unnamed_symbols(const std::vector<OutputQuantity>& outputs) {
    std::vector<std::string> symbols;
    for (const OutputQuantity& output : outputs)
        if (is_unnamed(output) && std::find(symbols.begin(), symbols.end(), output.symbol) == symbols.end())
            symbols.push_back(output.symbol);
    return symbols;
}

std::string in_a_row(const std::vector<std::string>& symbols) {
    std::string row;
    for (std::size_t i = 0; i < std::min(symbols.size(), most_symbols); ++i)
        row += (i ? ", " : "") + symbol_to_unicode(symbols[i]);
    return symbols.size() > most_symbols ? row + " …" : row;
}

bool has_tolerance(const Requirement& requirement) {
    return requirement.lower_limit || requirement.upper_limit;
}

bool contains(const CertifiedIds& ids, const std::string& id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
}

const char* key_of_option(std::string_view key) {
    const auto& all = option_fields();
    return std::find_if(all.begin(), all.end(), [&](const OptionField& field) { return field.key == key; })
        ->key;
}

/// A gap for each analysis with results that have no name.
std::vector<CertificateGap> unnamed_results(const MadeProject& made, const CertifiedIds& ids) {
    std::vector<CertificateGap> gaps;
    const Project& project = made.project();
    for (std::size_t i = 0; i < project.analyses.size(); ++i) {
        const AnalysisEntry& analysis = project.analyses[i];
        const auto prepared = made.analysis(analysis.id);
        if (!prepared || !contains(ids, analysis.id)) continue;
        const std::vector<std::string> symbols = unnamed_symbols(prepared->model->outputs());
        if (symbols.empty()) continue;
        const std::string of = in_quotes(analysis.name);
        gaps.push_back({"/analyses/" + std::to_string(i) + "/setup",
                        symbols.size() == 1
                            ? tell<"the name of the result %1 of %2">(in_a_row(symbols), of)
                            : tell<"the names of the results %1 of %2">(in_a_row(symbols), of),
                        "7.8.2.1 m"});
    }
    return gaps;
}

}  // namespace

CertifiedIds certified_ids(const Project& project) {
    CertifiedIds ids;
    for (const AnalysisEntry& analysis : project.analyses)
        if (project.report.has_analysis(analysis.id)) ids.push_back(analysis.id);
    return ids;
}

Conformity stated_conformity(const Project& project, const CertifiedIds& ids) {
    for (const AnalysisEntry& analysis : project.analyses)
        if (contains(ids, analysis.id) &&
            std::any_of(analysis.requirements.begin(), analysis.requirements.end(), has_tolerance))
            return Conformity::stated;
    return Conformity::not_stated;
}

std::vector<CertificateGap> certificate_gaps(const MadeProject& made, const CertifiedIds& ids) {
    const Certificate& certificate = made.project().certificate;
    const Conformity conformity = stated_conformity(made.project(), ids);
    std::vector<CertificateGap> gaps;
    for (const CertificateField& field : certificate_fields())
        if (is_missing(field, certificate, conformity))
            gaps.push_back({pointer_of(field), Message::declared(field.title), field.clause});
    for (CertificateGap& gap : unnamed_results(made, ids)) gaps.push_back(std::move(gap));
    return gaps;
}

Problems missing_in(const MadeProject& made, const CertifiedIds& ids) {
    Problems missing = missing_in(made.project().certificate, stated_conformity(made.project(), ids));
    for (const CertificateGap& gap : unnamed_results(made, ids))
        missing.error(gap.path, tell<"the certificate calls it by its symbol alone: %1 must be stated "
                                     "(ISO/IEC 17025 %2)">(gap.what, gap.clause));
    return missing;
}

bool is_accredited_probability(double probability) {
    constexpr double least = 0.94, most = 0.96;
    return probability >= least && probability <= most;
}

void check_accredited_probability(const Project& project, Problems& problems) {
    if (is_blank(project.certificate.accreditation)) return;
    for (std::size_t i = 0; i < project.analyses.size(); ++i) {
        const AnalysisEntry& analysis = project.analyses[i];
        if (!project.report.has_analysis(analysis.id)) continue;
        const EvaluationOptions options = effective_options(project, analysis);
        const std::optional<double>& k = options.coverage_factor;
        const double p = k ? 2.0 * normal_distribution_function(*k) - 1.0 : options.coverage_probability;
        if (!std::isfinite(p) || is_accredited_probability(p)) continue;
        problems.warning(
            "/analyses/" + std::to_string(i) + "/options/" +
                key_of_option(k ? "coverageFactor" : "coverageProbability"),
            tell<
                "under an accreditation U is stated for a coverage probability of about 95 % (ILAC-P14 5.3); "
                "here it is %1">(percent_text(std::round(1e4 * p) * 1e-4)));
    }
}

}  // namespace covaria
