// Evaluations of the artefacts, instruments and other assets an analysis uses.
#include "core/made/applicability.h"
#include "core/report/date_words.h"
#include "core/report/report_parts.h"
#include "core/text/symbol.h"

namespace covaria::report_parts {
namespace {

void add_asset(Blocks& blocks, const ReportSource& source, const EvaluatedAnalysis& evaluated,
               const std::string& id, const AssetLibrary::Entry& entry) {
    blocks.push_back(HeadingBlock{3, entry.name});
    const AssetEntry* typed = source.made.project().find_asset(id);
    if (typed) add_paragraphs(blocks, typed->notes);
    if (typed && entry.descriptor) add_setup_fields(blocks, entry.descriptor->schema, typed->setup, source);
    for (const Table& table : entry.asset->evaluation()) blocks.push_back(evaluation_block(table, source.in));
    for (PlotSpecification& plot : entry.asset->figures()) {
        plot.id = id + "-" + plot.id;
        blocks.push_back(titled_figure(source.in.say_plot(std::move(plot)), evaluated));
    }
    if (!entry.descriptor || entry.descriptor->references.empty()) return;
    ListBlock references;
    for (const Reference& reference : entry.descriptor->references)
        references.items.push_back(reference.text);
    blocks.push_back(std::move(references));
}

/// Adds the validity of the figures: each certificate that is used, with its verdict, and the figures that
/// are assumed.
void add_certificates(Blocks& blocks, const ReportSource& source, const EvaluatedAnalysis& evaluated) {
    const FiguresUsed used = figures_used(source.made, evaluated.analysis->id);
    const DocumentLanguage& in = source.in;
    if (!used.certificates.empty()) {
        TableBuilder table("certificates-" + evaluated.analysis->id, tell<"Certificates of the figures">(),
                           in);
        table.text(tell<"Figures of">());
        table.text(tell<"Certificate">());
        table.text(tell<"Calibrated">());
        table.text(tell<"Valid until">());
        table.text(tell<"Verdict">());
        for (const CertificateUse& use : used.certificates) {
            const AssetCertificate& one = use.certificate;
            const std::string& of = one.calibrated.empty() ? one.issued : one.calibrated;
            table.row({use.holder, in.say(name_of(one)), date_words(of, in), date_words(one.valid_until, in),
                       in.say(words_of(use.verdict.verdict))});
            for (const Message& reason : use.verdict.reasons)
                table.note(tell<"%1: %2.">(name_of(one), reason));
        }
        blocks.push_back(table.take());
    }
    if (!used.assumed.empty())
        blocks.push_back(ParagraphBlock{
            in.say(tell<"Of %1 artefacts and instruments %2 have no certificate; their figures are assumed: "
                        "%3.">(used.assets, used.assumed.size(), short_list(used.assumed, 12))),
            true});
    if (!used.assumed_quantities.empty()) {
        std::vector<std::string> symbols;
        for (const std::string& symbol : used.assumed_quantities)
            symbols.push_back(symbol_to_unicode(symbol));
        blocks.push_back(ParagraphBlock{
            in.say(tell<"Of %1 quantities that are stated %2 have no certificate; they are assumed: %3.">(
                used.stated, symbols.size(), short_list(symbols, 12))),
            true});
    }
}

}  // namespace

void add_assets(Blocks& blocks, const ReportSource& source, const EvaluatedAnalysis& evaluated,
                std::set<std::string>& shown) {
    Blocks part;
    std::vector<std::string> before;
    for (const std::string& id : source.made.assets_used_by(evaluated.analysis->id)) {
        const AssetLibrary::Entry* entry = source.made.assets().find(id);
        if (!entry) continue;
        if (shown.insert(id).second)
            add_asset(part, source, evaluated, id, *entry);
        else
            before.push_back(entry->name);
    }
    Blocks certificates;
    add_certificates(certificates, source, evaluated);
    if (part.empty() && before.empty() && certificates.empty()) return;
    blocks.push_back(HeadingBlock{2, source.in.say(tell<"Artefacts and instruments">())});
    blocks.insert(blocks.end(), certificates.begin(), certificates.end());
    if (!before.empty())
        blocks.push_back(ParagraphBlock{
            source.in.say(tell<"Evaluated with an earlier analysis: %1.">(short_list(before, 12)))});
    blocks.insert(blocks.end(), part.begin(), part.end());
}

}  // namespace covaria::report_parts
