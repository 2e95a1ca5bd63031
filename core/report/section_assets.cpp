// Evaluations of the artefacts, instruments and other assets an analysis uses.
#include "core/report/report_parts.h"

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
    if (part.empty() && before.empty()) return;
    blocks.push_back(HeadingBlock{2, source.in.say(tell<"Artefacts and instruments">())});
    if (!before.empty())
        blocks.push_back(ParagraphBlock{
            source.in.say(tell<"Evaluated with an earlier analysis: %1.">(short_list(before, 12)))});
    blocks.insert(blocks.end(), part.begin(), part.end());
}

}  // namespace covaria::report_parts
