#include "core/report/stated_uncertainty.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>

#include "core/kinds/registries.h"
#include "core/model/best_capability.h"
#include "core/text/numbers.h"
#include "core/text/readable_unit.h"
#include "core/views/result_words.h"

namespace covaria {

namespace {

struct NamedCapability {
    std::string name;
    const BestCapability* capability;
};

struct Capabilities {
    std::string unknown;  ///< one with errors, so that nobody knows what may be stated; empty: none
    std::vector<NamedCapability> known;
};

bool is_of_laboratory(const AssetEntry& asset) {
    const AssetDescriptor* kind = find_asset_kind(asset.kind);
    return kind && kind->category == AssetCategory::laboratory;
}

Capabilities capabilities_of(const MadeProject& made) {
    Capabilities found;
    for (const AssetEntry& asset : made.project().assets) {
        const AssetLibrary::Entry* entry = made.assets().find(asset.id);
        if (const auto* capability = entry ? offers<BestCapability>(entry->asset) : nullptr)
            found.known.push_back({asset.name, capability});
        else if (!entry && found.unknown.empty() && is_of_laboratory(asset))
            found.unknown = asset.name.empty() ? asset.id : asset.name;
    }
    return found;
}

/// The value that decides: of the result, of another one (of its group before others), of an input.
std::optional<double> deciding_value(const BestCapability& capability, const UncertaintyResult& result,
                                     const OutputResult& output) {
    const std::string& symbol = capability.over();
    if (symbol.empty()) return output.estimate;
    std::optional<double> found;
    for (const OutputResult& other : result.outputs)
        if (other.quantity.symbol == symbol && (!found || other.quantity.group == output.quantity.group))
            found = other.estimate;
    if (found) return found;
    const std::size_t input = result.inputs->find(symbol);
    return input == InputSet::npos ? std::nullopt : std::optional(estimate_of(result.inputs, input));
}

std::string in_words(double U, const Unit& usual) {
    const Unit unit = readable_unit(U, usual);
    return format_significant(unit.interval_from_si(U), 2) + " " + unit.text();
}

/// A best capability is stated for k = 2 and about 95 % (ILAC-P14), not for the distribution that was
/// evaluated.
constexpr double k_of_capabilities = 2.0;

/// U of an output as capabilities are stated: as evaluated where that is for about 95 %, else 2 u.
double expanded_as_capabilities(const UncertaintyResult& result, const OutputResult& output) {
    const bool is_usual =
        !result.fixed_coverage_factor && std::abs(result.coverage_probability - 0.95) < 0.01;
    return is_usual ? output.expanded_uncertainty : k_of_capabilities * output.standard_uncertainty;
}

std::optional<CapabilityFinding> finding_of(const Capabilities& capabilities, const UncertaintyResult& result,
                                            std::size_t i) {
    const OutputResult& output = result.outputs[i];
    if (!result_words::is_measurand(output)) return std::nullopt;
    const Message name = result_words::output_label(output.quantity);
    if (!capabilities.unknown.empty()) {
        const Message words =
            tell<"%1 has errors: it is not known which U may be stated for %2">(capabilities.unknown, name);
        return CapabilityFinding{i, CapabilityVerdict::refused, 0.0, words, words};
    }
    if (capabilities.known.empty()) return std::nullopt;
    for (const auto& [of, capability] : capabilities.known) {
        if (!capability->is_about(output.quantity)) continue;
        const auto value = deciding_value(*capability, result, output);
        const auto smallest = value ? capability->smallest(*value) : std::nullopt;
        if (!smallest) continue;
        const double expanded = expanded_as_capabilities(result, output);
        if (!(expanded < *smallest)) return std::nullopt;
        const Unit& unit = output.quantity.unit;
        const std::string U = in_words(expanded, unit);
        const std::string least = in_words(*smallest, unit);
        if (capability->raises())
            return CapabilityFinding{
                i, CapabilityVerdict::raised, *smallest,
                tell<"U of %1, %2, is below the best capability (%4): certificates state %3">(name, U, least,
                                                                                              of),
                tell<"U of %1 is the best measurement capability of the laboratory, with k = 2">(name)};
        return CapabilityFinding{
            i, CapabilityVerdict::refused, *smallest,
            tell<"U of %1, %2, is below the best capability of %3 (%4): it may not be stated">(name, U, least,
                                                                                               of),
            tell<"%1 is not stated: U is below the best measurement capability of the laboratory">(name)};
    }
    const Message outside = tell<"%1 is outside the scope: the laboratory has no capability for it">(name);
    return CapabilityFinding{i, CapabilityVerdict::outside, 0.0, outside, outside};
}

void state(OutputResult& output, double U) {
    constexpr double k = k_of_capabilities;
    output.monte_carlo.reset();
    FirstOrderOutput& first = output.first_order;
    output.standard_uncertainty = first.standard_uncertainty = U / k;
    output.coverage_factor = first.coverage_factor = k;
    output.expanded_uncertainty = first.expanded_uncertainty = U;
    first.effective_degrees_of_freedom = infinity;
}

}  // namespace

std::optional<CapabilityFinding> capability_finding(const MadeProject& made, const UncertaintyResult& result,
                                                    std::size_t output) {
    return finding_of(capabilities_of(made), result, output);
}

std::vector<CapabilityFinding> capability_findings(const MadeProject& made, const UncertaintyResult& result) {
    const Capabilities capabilities = capabilities_of(made);
    std::vector<CapabilityFinding> found;
    for (std::size_t i = 0; i < result.outputs.size(); ++i)
        if (auto finding = finding_of(capabilities, result, i)) found.push_back(*std::move(finding));
    return found;
}

std::vector<EvaluatedAnalysis> as_stated(const MadeProject& made, std::vector<EvaluatedAnalysis> analyses) {
    for (EvaluatedAnalysis& one : analyses) {
        const std::vector<CapabilityFinding> findings = capability_findings(made, *one.result);
        if (findings.empty()) continue;
        auto stated = std::make_shared<UncertaintyResult>(*one.result);
        for (const CapabilityFinding& finding : findings) {
            OutputResult& output = stated->outputs[finding.output];
            if (finding.verdict == CapabilityVerdict::raised) state(output, finding.smallest);
            if (finding.verdict == CapabilityVerdict::refused)
                output.quantity.role = OutputRole::intermediate;
        }
        one.result = std::move(stated);
    }
    return analyses;
}

}  // namespace covaria
