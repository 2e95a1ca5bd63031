#include "core/report/certificate_warnings.h"

#include <cmath>

#include "core/made/certificate_gaps.h"
#include "core/math/normal_quantile.h"
#include "core/report/report_parts.h"
#include "core/report/stated_uncertainty.h"
#include "core/result/result_line.h"
#include "core/views/result_statement.h"

namespace covaria {

namespace {

/// The measurand whose probability is farthest from 95 %, among those whose probability is not about that;
/// none where all are about 95 %.
std::optional<std::size_t> farthest_from_95(const UncertaintyResult& result) {
    std::optional<std::size_t> farthest;
    double most = 0.0;
    for (std::size_t i = 0; i < result.outputs.size(); ++i) {
        if (!result_words::is_measurand(result.outputs[i])) continue;
        const double p = stated_probability(result.outputs[i], result);
        if (!std::isfinite(p) || is_accredited_probability(p) || std::abs(p - 0.95) <= most) continue;
        most = std::abs(p - 0.95);
        farthest = i;
    }
    return farthest;
}

}  // namespace

Problems improbable_results(const ReportSource& source) {
    Problems warnings;
    const Project& project = source.made.project();
    if (is_blank(project.certificate.accreditation)) return warnings;
    for (const EvaluatedAnalysis& evaluated : source.analyses) {
        const UncertaintyResult& result = *evaluated.result;
        const std::optional<double>& k = result.fixed_coverage_factor;
        if (!k || !is_accredited_probability(2.0 * normal_distribution_function(*k) - 1.0)) continue;
        const auto output = farthest_from_95(result);
        if (!output) continue;
        const OutputResult& far = result.outputs[*output];
        warnings.warning("", tell<"%1: under an accreditation U is stated for a coverage probability of "
                                  "about 95 % (ILAC-P14 5.3); with k = %2 that of %3 is %4">(
                                 evaluated.analysis->name, Message::number(format_trimmed(*k, 4)),
                                 result_words::output_label(far.quantity),
                                 probability_text(stated_probability(far, result), NumberLocale{})));
    }
    return warnings;
}

Problems results_beyond_capability(const ReportSource& source) {
    Problems warnings;
    for (const EvaluatedAnalysis& evaluated : source.analyses)
        for (const CapabilityFinding& finding : capability_findings(source.made, *evaluated.result))
            warnings.warning("", tell<"%1: %2">(evaluated.analysis->name, finding.words));
    return warnings;
}

}  // namespace covaria
