#include "core/made/applicability.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "core/base/dates.h"
#include "core/base/in_quotes.h"
#include "core/project/kind_lookup.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

/// The assets that one analysis of a project uses by itself: those that it refers to, directly or through
/// others.
std::set<std::size_t> assets_of(const EntryGraph& graph, std::size_t number) {
    std::set<std::size_t> assets;
    std::vector<std::size_t> open{number};
    while (!open.empty()) {
        const std::size_t entry = open.back();
        open.pop_back();
        for (const EntryReference& reference : graph.references(entry))
            if (reference.is_edge() && graph.is_asset(reference.entry) &&
                assets.insert(reference.entry).second)
                open.push_back(reference.entry);
    }
    return assets;
}

/// Whether an asset brings figures into a result; context does not.
bool has_figures(const AssetEntry& asset, const AssetLibrary& assets) {
    const AssetLibrary::Entry* entry = assets.find(asset.id);
    return !entry || !entry->descriptor || entry->descriptor->category != AssetCategory::context;
}

/// A value that a range may be stated for.
struct UsedValue {
    double si = 0.0;
    Unit unit = {};  ///< unit of the value
};

void add_typed(const SetupSchema& schema, const Setup& setup, const std::string& of,
               std::vector<UsedValue>& values) {
    for (const FieldSpec& field : schema.fields()) {
        if (!is_shown(schema, field, setup)) continue;
        const SetupValue& value = value_of(field, setup);
        if (const auto* number = std::get_if<Quantity>(&value); number && field.key == of)
            values.push_back({number->si(), number->unit});
        const auto* table = std::get_if<SetupTable>(&value);
        const std::size_t column = table ? SetupSchema::column(field, of) : SetupSchema::npos;
        if (column == SetupSchema::npos || column >= table->units.size()) continue;
        for (const auto& row : table->rows)
            if (const double* number = column < row.size() ? std::get_if<double>(&row[column]) : nullptr)
                values.push_back({table->units[column].to_si(*number), table->units[column]});
    }
}

/// Values that the range of a certificate is about: quantities of the analysis of that symbol; where there
/// are none, fields and columns of that key in the set-up of the asset and of the analysis.
std::vector<UsedValue> used_values(const MadeProject& made, const AnalysisEntry& analysis,
                                   const AssetEntry* asset, const std::string& of) {
    std::vector<UsedValue> values;
    if (const auto prepared = made.analysis(analysis.id))
        for (std::size_t i = 0; i < prepared->inputs.quantities.size(); ++i)
            if (const InputQuantity& quantity = prepared->inputs.quantities[i]; quantity.symbol == of)
                values.push_back({estimate_of(prepared->inputs, i), quantity.unit});
    if (!values.empty()) return values;
    if (const SetupSchema* schema = asset ? schema_of(*asset) : nullptr)
        add_typed(*schema, asset->setup, of, values);
    if (const SetupSchema* schema = schema_of(analysis)) add_typed(*schema, analysis.setup, of, values);
    return values;
}

std::string text_of(const Quantity& quantity) {
    return quantity_words(quantity.value, quantity.unit);
}

std::string text_of(const CertifiedRange& range) {
    if (!range.lowest) return "≤ " + text_of(*range.highest);
    if (!range.highest) return "≥ " + text_of(*range.lowest);
    return text_of(*range.lowest) + " … " + text_of(*range.highest);
}

void judge_range(const CertifiedRange& range, const std::vector<UsedValue>& values,
                 ApplicabilityVerdict& verdict) {
    if (!range.lowest && !range.highest) return;
    const Unit unit = range.lowest ? range.lowest->unit : range.highest->unit;
    std::size_t known = 0;
    for (const UsedValue& value : values) {
        if (value.unit.dimension() != unit.dimension() || !std::isfinite(value.si)) continue;
        ++known;
        // A value that was typed in another unit is the same but for the last digits.
        const double slack = 1e-12 * std::abs(value.si);
        if ((range.lowest && value.si < range.lowest->si() - slack) ||
            (range.highest && value.si > range.highest->si() + slack))
            return verdict.find(Applicability::outside,
                                tell<"its figures hold for %1 of %2, and here it is %3">(
                                    range.of, text_of(range), text_of({unit.from_si(value.si), unit})));
    }
    if (known == 0)
        verdict.find(
            Applicability::unknown,
            tell<"its figures hold for %1 of %2, and nothing here is called so">(range.of, text_of(range)));
}

bool has_certificates(const Project& project) {
    const auto has = [](const auto& entry) { return !entry.certificates.empty(); };
    return std::ranges::any_of(project.assets, has) || std::ranges::any_of(project.analyses, has);
}

class UsedFigures {
public:
    UsedFigures(const MadeProject& made, FiguresUsed& used) : made_(made), used_(used) {}

    void add(std::size_t analysis) {
        const Project& project = made_.project();
        const AnalysisEntry& entry = project.analyses[analysis];
        add_uses(entry, nullptr, entry.certificates, "/analyses/" + std::to_string(analysis));
        if (has_certificates(project)) add_stated(entry);
        for (const std::size_t index : assets_of(made_.graph(), made_.graph().number_of_analysis(analysis))) {
            const AssetEntry& asset = project.assets[index];
            if (!has_figures(asset, made_.assets())) continue;
            if (assets_.insert(index).second) {
                ++used_.assets;
                if (asset.certificates.empty()) used_.assumed.push_back(name_of_asset(asset));
            }
            add_uses(entry, &asset, asset.certificates, "/assets/" + std::to_string(index));
        }
    }

private:
    void add_stated(const AnalysisEntry& analysis) {
        const SetupSchema* schema = schema_of(analysis);
        const FieldSpec* field = schema ? schema->find(&FieldSpec::states_quantities) : nullptr;
        const auto prepared = made_.analysis(analysis.id);
        if (!field || !prepared) return;
        const InputSet& inputs = prepared->inputs;
        for (const InputQuantity& quantity : inputs.quantities) {
            const bool is_of_table = quantity.source.starts_with("/" + field->key + "/");
            const bool is_stated = std::ranges::any_of(quantity.shares, [&](const Share& share) {
                const UncertaintyComponent& of = inputs.components[share.component];
                return of.type == EvaluationType::type_b && of.distribution.standard_uncertainty() > 0.0;
            });
            if (!is_of_table || !is_stated) continue;
            ++used_.stated;
            if (!std::ranges::any_of(analysis.certificates, [&](const AssetCertificate& one) {
                    return one.quantities.empty() || std::ranges::count(one.quantities, quantity.symbol) > 0;
                }))
                used_.assumed_quantities.push_back(quantity.symbol);
        }
    }

    static std::string name_of_asset(const AssetEntry& asset) {
        return asset.name.empty() ? asset.id : asset.name;
    }

    void add_uses(const AnalysisEntry& analysis, const AssetEntry* asset,
                  const std::vector<AssetCertificate>& certificates, const std::string& place) {
        for (std::size_t i = 0; i < certificates.size(); ++i) {
            CertificateUse use;
            use.asset = asset ? asset->id : "";
            use.analysis = analysis.id;
            use.holder = asset ? name_of_asset(*asset) : analysis.name.empty() ? analysis.id : analysis.name;
            use.path = place + "/certificates/" + std::to_string(i);
            use.certificate = certificates[i];
            use.verdict = applicable_at(certificates[i], measured_of(made_.project(), analysis));
            for (const CertifiedRange& range : certificates[i].ranges)
                judge_range(range, used_values(made_, analysis, asset, range.of), use.verdict);
            used_.certificates.push_back(std::move(use));
        }
    }

    const MadeProject& made_;
    FiguresUsed& used_;
    std::set<std::size_t> assets_;
};

}  // namespace

Message words_of(Applicability verdict) {
    switch (verdict) {
        case Applicability::applicable:
            return tell<"applicable">();
        case Applicability::unknown:
            return tell<"not known">();
        case Applicability::outside:
            return tell<"outside what it holds for">();
        case Applicability::expired:
            return tell<"expired">();
    }
    return {};
}

void ApplicabilityVerdict::find(Applicability found, Message reason) {
    verdict = std::max(verdict, found);
    reasons.push_back(std::move(reason));
}

ApplicabilityVerdict applicable_at(const AssetCertificate& certificate, std::string_view measured) {
    ApplicabilityVerdict verdict;
    const auto at = period_of(measured);
    const auto until = date_of(certificate.valid_until);
    const auto calibrated = period_of(certificate.calibrated);
    const auto issued = date_of(certificate.issued);
    if (!until && (certificate.kind == FiguresFrom::certificate || !certificate.valid_until.empty()))
        verdict.find(Applicability::unknown, tell<"until when it is valid is not stated">());
    if (!at) {
        // A figure that holds until it is replaced needs no date of the measurement.
        if (until || calibrated || issued || certificate.kind == FiguresFrom::certificate)
            verdict.find(Applicability::unknown, tell<"the date of the measurement is not stated">());
        return verdict;
    }
    if (calibrated && at->first < calibrated->first)
        verdict.find(Applicability::outside, tell<"it is of %1, and the measurement of %2 before it">(
                                                 certificate.calibrated, std::string(measured)));
    else if (!calibrated && issued && at->first < *issued)
        verdict.find(Applicability::outside, tell<"it is of %1, and the measurement of %2 before it">(
                                                 certificate.issued, std::string(measured)));
    if (until && *until < at->last)
        verdict.find(Applicability::expired, tell<"it was valid until %1, and the measurement is of %2">(
                                                 certificate.valid_until, std::string(measured)));
    return verdict;
}

const std::string& measured_of(const Project& project, const AnalysisEntry& analysis) {
    return analysis.measured.empty() ? project.certificate.calibrated : analysis.measured;
}

FiguresUsed figures_used(const MadeProject& made, const std::string& analysis) {
    FiguresUsed used;
    const Project& project = made.project();
    const AnalysisEntry* entry = project.find_analysis(analysis);
    if (!entry) return used;
    const auto own = static_cast<std::size_t>(entry - project.analyses.data());
    UsedFigures figures(made, used);
    figures.add(own);
    for (const std::size_t number : made.graph().used_by(made.graph().number_of_analysis(own)))
        if (!made.graph().is_asset(number)) figures.add(number - project.assets.size());
    return used;
}

Message sentence_of(const CertificateUse& use) {
    Message reasons;
    for (const Message& reason : use.verdict.reasons)
        reasons = reasons.empty() ? reason : tell<"%1; %2">(reasons, reason);
    const Message name = name_of(use.certificate);
    return reasons.empty() ? tell<"%1: %2">(name, words_of(use.verdict.verdict))
                           : tell<"%1: %2: %3">(name, words_of(use.verdict.verdict), reasons);
}

void check_figures(const MadeProject& made, Problems& problems) {
    const Project& project = made.project();
    for (std::size_t i = 0; i < project.assets.size(); ++i)
        check_certificates(project.assets[i].certificates, "/assets/" + std::to_string(i) + "/certificates",
                           problems);
    for (std::size_t i = 0; i < project.analyses.size(); ++i) {
        const std::string place = "/analyses/" + std::to_string(i);
        check_certificates(project.analyses[i].certificates, place + "/certificates", problems);
        check_measured(project.analyses[i].measured, place + "/measured", problems);
    }
    if (!has_certificates(project)) return;
    std::map<std::string, CertificateUse> worst;
    std::vector<std::string> order;
    for (const AnalysisEntry& analysis : project.analyses)
        for (CertificateUse& use : figures_used(made, analysis.id).certificates) {
            const auto [known, is_new] = worst.try_emplace(use.path, use);
            if (is_new) order.push_back(use.path);
            if (known->second.verdict.verdict < use.verdict.verdict) known->second = std::move(use);
        }
    for (const std::string& path : order)
        if (const CertificateUse& use = worst.at(path); is_refused(use.verdict.verdict))
            problems.warning(path, sentence_of(use));
}

}  // namespace covaria
