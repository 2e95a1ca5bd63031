// Builds the report of a project: its sections in order, then the numbers of headings, tables and figures.
#include "core/report/report.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "core/base/file_names.h"
#include "core/made/certificate_gaps.h"
#include "core/project/project_file.h"
#include "core/report/certificate_words.h"
#include "core/report/report_body.h"
#include "core/report/report_extent.h"

namespace covaria {
namespace {

using namespace report_parts;

/// The room of all but the annex, in lines: pages break where they must, so that these are up to twenty
/// pages.
constexpr std::ptrdiff_t most_of_two_levels = 40;  // lines of the contents
constexpr double room_of_contents = double(most_of_two_levels) + 3.0;
constexpr double room_of_sheet = 1.85 * lines_of_page;  ///< of two pages, which are not filled to the end
constexpr double room = 20.0 * lines_of_page - room_of_contents, room_before = 3.0 * lines_of_page;

/// Puts "2.1", "Table 3." and "Figure 2." before headings and captions, in order of appearance.
struct Numbering {
    const DocumentLanguage& in;
    std::array<int, 2> heading{};
    int tables = 0, figures = 0;

    void operator()(HeadingBlock& block) {
        if (block.level == 1)
            heading = {heading[0] + 1, 0};
        else if (block.level == 2)
            ++heading[1];
        if (block.level > 2) return;
        // A sheet of one analysis has no chapters above its sections.
        const std::string chapter = std::to_string(heading[0]), part = std::to_string(heading[1]);
        const std::vector<std::string> numbers = block.level == 1 ? std::vector{chapter}
                                                 : heading[0] > 0 ? std::vector{chapter, part}
                                                                  : std::vector{part};
        block.text =
            numbers.front() + (numbers.size() > 1 ? "." + numbers.back() : "") + "\u2002" + block.text;
        block.anchor = "section-" + numbers.front() + (numbers.size() > 1 ? "-" + numbers.back() : "");
    }
    void operator()(TableBlock& block) {
        block.table.title = in.say(tell<"Table %1. %2">(++tables, block.table.title));
        block.continued = in.say(tell<"Table %1, continued">(tables));
    }
    void operator()(PlotBlock& block) { block.caption = figure(block.caption); }
    void operator()(SceneBlock& block) { block.caption = figure(block.caption); }
    template <class Other>
    void operator()(Other&) {}

    std::string figure(const std::string& caption) {
        return in.say(tell<"Figure %1. %2">(++figures, caption));
    }
};

/// Names of figures, which are files: every id is there once, whatever the names of groups become.
struct FigureNaming {
    FileNames charts = {}, pictures = {};

    void operator()(PlotBlock& block) { block.plot.id = charts.unique(block.plot.id, ""); }
    void operator()(SceneBlock& block) { block.id = pictures.unique(block.id, ""); }
    template <class Other>
    void operator()(Other&) {}
};

std::vector<EvaluatedAnalysis> those_in(const ReportContents& contents,
                                        const std::vector<EvaluatedAnalysis>& analyses) {
    std::vector<EvaluatedAnalysis> chosen;
    for (const EvaluatedAnalysis& one : analyses)
        if (contents.has_analysis(one.analysis->id)) chosen.push_back(one);
    return chosen;
}

bool is_heading(const ReportBlock& block) {
    return std::holds_alternative<HeadingBlock>(block);
}

/// Moves the picture of the only analysis, else the chart of its largest contributions, to the results on the
/// first page.
void move_answers_figure(Blocks& from, Blocks& to) {
    auto found = std::ranges::find_if(
        from, [](const ReportBlock& block) { return std::holds_alternative<SceneBlock>(block); });
    if (found == from.end())
        found = std::ranges::find_if(from, [](const ReportBlock& block) {
            const auto* plot = std::get_if<PlotBlock>(&block);
            return plot && plot->plot.id.find("-contributions") != std::string::npos;
        });
    if (found == from.end()) return;
    to.insert(std::ranges::find_if(to, is_heading), std::move(*found));
    const auto next = from.erase(found);
    const auto level = [](const ReportBlock& block) {
        const auto* heading = std::get_if<HeadingBlock>(&block);
        return heading ? heading->level : 0;
    };
    // A heading with nothing below it goes too.
    if (next == from.begin() || level(*(next - 1)) == 0) return;
    if (next == from.end() || (level(*next) > 0 && level(*next) <= level(*(next - 1)))) from.erase(next - 1);
}

/// Adds the contents. A report of a few pages needs none; of many sections those of the first level are
/// enough.
void add_contents(Blocks& blocks, const DocumentLanguage& in) {
    constexpr double least_lines = 3.0 * lines_of_page;
    const auto first = std::find_if(blocks.begin(), blocks.end(), is_heading);
    if (first == blocks.end() || lines_of(blocks) < least_lines) return;
    const auto count = std::count_if(blocks.begin(), blocks.end(), [](const ReportBlock& block) {
        const auto* heading = std::get_if<HeadingBlock>(&block);
        return heading && heading->level <= 2;
    });
    blocks.insert(first, {HeadingBlock{3, in.say(tell<"Contents">())},
                          ContentsBlock{count <= most_of_two_levels ? 2 : 1}});
}

ReportDocument empty_document(const Project& project, const Message& over, const DocumentLanguage& in) {
    ReportDocument document;
    document.title = project.title.empty() ? in.say(tell<"Uncertainty report">()) : project.title;
    document.running_head = document.title;
    document.over = in.say(over);
    document.author = project.author;
    document.language = in.code();
    document.page_words = in.say(certificate_words::page);
    document.numbers = in.numbers();
    return document;
}

/// Digits as the project states them, numbers of headings and captions, names of figures.
void finish(ReportDocument& document, const Project& project, const DocumentLanguage& in) {
    for (ReportBlock& block : document.blocks)
        if (auto* table = std::get_if<TableBlock>(&block))
            table->view.digits = project.results.style.digits.value_or(table->view.digits);
    Numbering numbering{in};
    for (ReportBlock& block : document.blocks) std::visit(numbering, block);
    FigureNaming naming;
    for (ReportBlock& block : document.blocks) std::visit(naming, block);
}

}  // namespace

ReportDocument build_report(const MadeProject& made, const std::vector<EvaluatedAnalysis>& all,
                            const std::vector<FailedAnalysis>& failed, const ReportContents& contents,
                            const DocumentLanguage& in) {
    const std::vector<EvaluatedAnalysis> analyses = those_in(contents, all);
    const ReportSource source{made, analyses, failed, in};
    const Project& project = made.project();
    ReportDocument document = empty_document(project, tell<"Report of an uncertainty evaluation">(), in);
    Blocks before, after;
    add_title(before, source);
    if (contents.has(ReportChapter::models)) add_models(before, source);
    if (contents.has(ReportChapter::notes)) add_notes(after, source);
    if (contents.has(ReportChapter::provenance)) add_provenance(after, source);
    before = shortened_to(room_before, before, Elsewhere::files, in);
    AnalysisChapters chapters =
        analysis_chapters(source, contents, room - lines_of(before) - lines_of(after));
    if (analyses.size() == 1) move_answers_figure(chapters.body, before);
    Blocks& blocks = document.blocks;
    for (Blocks* part : {&before, &chapters.body, &after})
        std::move(part->begin(), part->end(), std::back_inserter(blocks));
    if (!chapters.annex.empty()) blocks.push_back(HeadingBlock{1, in.say(tell<"Annex">())});
    std::move(chapters.annex.begin(), chapters.annex.end(), std::back_inserter(blocks));
    add_contents(blocks, in);
    finish(document, project, in);
    return document;
}

ReportDocument build_sheet(const MadeProject& made, const std::vector<EvaluatedAnalysis>& all,
                           const std::vector<FailedAnalysis>& failed, const ReportContents& contents,
                           const DocumentLanguage& in) {
    const std::vector<EvaluatedAnalysis> analyses = those_in(contents, all);
    const Project& project = made.project();
    ReportDocument document = empty_document(project, tell<"Sheet of a measurement">(), in);
    Blocks& blocks = document.blocks;
    add_facts(blocks, {made, analyses, failed, in});
    double lines = room_of_sheet - lines_of(blocks);
    for (const EvaluatedAnalysis& one : analyses) {
        if (analyses.size() > 1) blocks.push_back(HeadingBlock{1, one.analysis->name});
        const std::vector<EvaluatedAnalysis> alone{one};
        std::ranges::move(sheet_chapters({made, alone, failed, in}, contents, lines),
                          std::back_inserter(blocks));
        lines = room_of_sheet - 3.0;  // of its heading
    }
    finish(document, project, in);
    return document;
}

ReportDocument build_report(const MadeProject& made, const std::vector<EvaluatedAnalysis>& analyses,
                            const std::vector<FailedAnalysis>& failed, const DocumentLanguage& in) {
    return build_report(made, analyses, failed, made.project().report, in);
}

std::vector<std::string> reported_analyses(const Project& project) {
    return certified_ids(project);
}

ReportDocument build_document(DocumentKind kind, const MadeProject& made,
                              const std::vector<EvaluatedAnalysis>& analyses,
                              const std::vector<FailedAnalysis>& failed, bool chosen,
                              const DocumentLanguage& in) {
    ReportContents contents = made.project().report;
    const bool all = !chosen && contents.without_analyses.empty();
    if (chosen) contents.without_analyses.clear();
    if (kind == DocumentKind::report) return build_report(made, analyses, failed, contents, in);
    if (kind == DocumentKind::sheet) return build_sheet(made, analyses, failed, contents, in);
    return build_certificate(made, those_in(contents, analyses), failed,
                             all ? CertifiedResults::that_fit : CertifiedResults::all, in);
}

}  // namespace covaria
