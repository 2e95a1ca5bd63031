// Evaluations of the artefacts, instruments and other assets an analysis uses.
#include "core/report/report_parts.h"

namespace covaria::report_parts {
namespace {

void add_asset(Blocks& blocks, const ReportSource& source, const EvaluatedAnalysis& evaluated,
               const std::string& id, const AssetLibrary::Entry& entry) {
    blocks.push_back(HeadingBlock{3, entry.name});
    const AssetEntry* typed = source.project.find_asset(id);
    if (typed) add_paragraphs(blocks, typed->notes);
    if (typed && entry.descriptor) add_setup_fields(blocks, entry.descriptor->schema, typed->setup, source);
    for (DataTable& table : entry.asset->evaluation()) blocks.push_back(TableBlock{std::move(table), {}});
    for (PlotSpecification& plot : entry.asset->figures()) {
        plot.id = id + "-" + plot.id;
        std::string caption = to_unicode(plot.title) + ".";
        blocks.push_back(figure(std::move(plot), evaluated, std::move(caption)));
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
    const AnalysisEntry* analysis = source.project.find_analysis(evaluated.analysis->id);
    if (!analysis) return;
    Blocks part;
    std::vector<std::string> before;
    for (const std::string& id : assets_used_by(source.project, *analysis)) {
        const AssetLibrary::Entry* entry = source.assets.find(id);
        if (!entry) continue;
        if (shown.insert(id).second)
            add_asset(part, source, evaluated, id, *entry);
        else
            before.push_back(entry->name);
    }
    if (part.empty() && before.empty()) return;
    blocks.push_back(HeadingBlock{2, "Artefacts and instruments"});
    if (!before.empty())
        blocks.push_back(
            ParagraphBlock{"Evaluated with an earlier analysis: " + short_list(before, 12) + "."});
    blocks.insert(blocks.end(), part.begin(), part.end());
}

}  // namespace covaria::report_parts
