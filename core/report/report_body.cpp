#include "core/report/report_body.h"

#include <algorithm>
#include <array>
#include <functional>

#include "core/report/report_extent.h"

namespace covaria::report_parts {

namespace {

constexpr double frame_lines = 6.0;  // lines of an analysis: its heading, and the chapters that it is without

/// A chapter of an analysis; where it has nothing to show, it has no blocks.
struct AnalysisChapter {
    std::optional<ReportChapter> chapter;  ///< chapter; none: the results, which are always there
    Blocks whole;
    ShortenedChapter shortened = {};
    bool left_out = false;  ///< whether it is left out for its length
};

using Chapters = std::vector<AnalysisChapter>;

/// Puts a sentence in the place of an empty frame: a chart that has nothing to show says why in its title.
void say_what_is_not_drawn(Blocks& blocks) {
    for (ReportBlock& block : blocks)
        if (const auto* plot = std::get_if<PlotBlock>(&block); plot && plot->plot.series.empty())
            block = ParagraphBlock{to_unicode(plot->plot.title) + ".", true};
}

bool only_headings(const Blocks& blocks) {
    return std::all_of(blocks.begin(), blocks.end(),
                       [](const ReportBlock& block) { return std::holds_alternative<HeadingBlock>(block); });
}

/// The chapters of an analysis in the order of the report.
Chapters chapters_of(const ReportSource& source, const EvaluatedAnalysis& evaluated,
                     std::set<std::string>& shown_assets) {
    using enum ReportChapter;
    const DocumentLanguage& in = source.in;
    Chapters all;
    const auto begin = [&](std::optional<ReportChapter> chapter) -> Blocks& {
        all.push_back({chapter, {}});
        return all.back().whole;
    };
    add_setup(begin(setup), source, evaluated);
    Blocks& of_inputs = begin(inputs);
    add_links(of_inputs, evaluated, in);
    add_inputs(of_inputs, source, evaluated);
    add_assets(begin(assets), source, evaluated, shown_assets);
    add_budgets(begin(budgets), evaluated, in);
    add_results(begin(std::nullopt), source, evaluated);
    Blocks& of_influence = begin(influence);
    add_sobol(of_influence, evaluated, in);
    add_contributors(of_influence, evaluated, in);
    add_model_evaluation(begin(evaluation), evaluated, in);
    add_comparison(begin(comparison), evaluated, in);
    add_before(begin(before), evaluated, in);
    add_regions(begin(regions), evaluated, in);
    add_distributions(begin(distributions), evaluated, in);
    add_scene(begin(scene), evaluated, in);
    add_correlation(begin(correlation), evaluated, in);
    add_studies(begin(studies), evaluated, in);
    add_designs(begin(designs), evaluated, in);
    for (AnalysisChapter& chapter : all) say_what_is_not_drawn(chapter.whole);
    std::erase_if(all, [](const AnalysisChapter& chapter) { return only_headings(chapter.whole); });
    return all;
}

/// The rank of a chapter: the one that a reader misses most comes first.
int rank_of(const std::optional<ReportChapter>& chapter) {
    using enum ReportChapter;
    static const std::array order{budgets,    before,    setup,       evaluation, assets,
                                  scene,      inputs,    designs,     studies,    distributions,
                                  comparison, influence, correlation, regions};
    if (!chapter) return -1;
    return static_cast<int>(std::find(order.begin(), order.end(), *chapter) - order.begin());
}

/// The chapters of a sheet, in its order: decisions come first; without any the results, and what they are
/// made of.
std::vector<std::optional<ReportChapter>> sheet_order(const EvaluatedAnalysis& evaluated) {
    using enum ReportChapter;
    if (evaluated.analysis->descriptor->decides) return {evaluation, scene, setup, std::nullopt};
    return {std::nullopt, evaluation, budgets, scene, setup};
}

std::string title_of(const AnalysisChapter& chapter) {
    for (const ReportBlock& block : chapter.whole)
        if (const auto* heading = std::get_if<HeadingBlock>(&block)) return heading->text;
    return {};
}

/// Whether the blocks are only words that lead to something that is not there.
bool says_nothing(const Blocks& blocks) {
    return std::none_of(blocks.begin(), blocks.end(), [](const ReportBlock& block) {
        return !std::holds_alternative<HeadingBlock>(block) && !std::holds_alternative<ParagraphBlock>(block);
    });
}

double whole_lines(const Chapters& chapters) {
    double lines = 0.0;
    for (const AnalysisChapter& chapter : chapters) lines += lines_of(chapter.whole);
    return lines;
}

class AnalysisBody {
public:
    AnalysisBody(const ReportContents& contents, const EvaluatedAnalysis& evaluated, Chapters chapters,
                 const DocumentLanguage& in)
        : contents_(contents), evaluated_(evaluated), chapters_(std::move(chapters)), in_(in) {}

    /// Shows as much of the chapters as there is room for.
    void fit(double lines) {
        for (const Extent& extent : extents()) {
            shorten_all(extent);
            double needed = 0.0;
            for (const AnalysisChapter& chapter : chapters_) needed += lines_of(chapter.shortened.body);
            if (needed <= lines && extent.figures > 0) return;
        }
        leave_out(lines);
    }

    /// The chapters of a sheet.
    Blocks sheet(double lines) {
        Blocks blocks;
        for (const std::optional<ReportChapter>& wanted : sheet_order(evaluated_)) {
            const auto found = std::ranges::find(chapters_, wanted, &AnalysisChapter::chapter);
            if (found == chapters_.end() || !shorten_to(*found, lines)) continue;
            lines -= lines_of(found->shortened.body);
            std::ranges::move(found->shortened.body, std::back_inserter(blocks));
        }
        return blocks;
    }

    void add_body(Blocks& blocks) const {
        blocks.push_back(HeadingBlock{1, evaluated_.analysis->name});
        std::string left_out;
        for (const AnalysisChapter& chapter : chapters_) {
            if (chapter.left_out)
                left_out += (left_out.empty() ? "" : ", ") + title_of(chapter);
            else
                blocks.insert(blocks.end(), chapter.shortened.body.begin(), chapter.shortened.body.end());
        }
        if (!left_out.empty())
            blocks.push_back(
                ParagraphBlock{in_.say(contents_.annex ? tell<"In the annex: %1.">(left_out)
                                                       : tell<"In the annex, on request: %1.">(left_out)),
                               true});
    }

    void add_annex(Blocks& blocks) const {
        for (const AnalysisChapter& chapter : chapters_) {
            const Blocks& rest = chapter.left_out ? chapter.whole : chapter.shortened.rest;
            if (rest.empty()) continue;
            blocks.push_back(HeadingBlock{2, evaluated_.analysis->name + ": " + title_of(chapter)});
            for (const ReportBlock& block : rest) {
                const auto* heading = std::get_if<HeadingBlock>(&block);
                if (!heading || heading->level > 2) blocks.push_back(block);
            }
        }
    }

private:
    void shorten_all(const Extent& extent) {
        for (AnalysisChapter& chapter : chapters_) shorten_one(chapter, extent);
    }

    void shorten_one(AnalysisChapter& chapter, const Extent& extent) {
        const Elsewhere elsewhere = contents_.annex ? Elsewhere::annex : Elsewhere::files;
        const std::vector<Name> groups = groups_in_full(*evaluated_.result);
        const Name group = groups.size() == 1 ? groups.front() : Name();
        const bool other_budgets =
            chapter.chapter == ReportChapter::budgets && extent.budget_rows != most_budget_rows;
        Blocks blocks = chapter.whole;
        if (other_budgets) {
            blocks.clear();
            add_budgets(blocks, evaluated_, in_, extent.budget_rows);
        }
        chapter.shortened = shorten(blocks, extent, group, elsewhere, in_);
        if (other_budgets) chapter.shortened.rest = chapter.whole;
    }

    /// Shortens the chapter until it fits; false: not even the shortest says something in so few lines.
    bool shorten_to(AnalysisChapter& chapter, double lines) {
        for (const Extent& extent : extents()) {
            shorten_one(chapter, extent);
            if (lines_of(chapter.shortened.body) <= lines) return !says_nothing(chapter.shortened.body);
        }
        return false;
    }

    /// Leaves chapters out: the results stay, and others in their rank while they fit.
    void leave_out(double lines) {
        std::vector<AnalysisChapter*> ranked;
        for (AnalysisChapter& chapter : chapters_) ranked.push_back(&chapter);
        std::stable_sort(ranked.begin(), ranked.end(),
                         [](const AnalysisChapter* a, const AnalysisChapter* b) {
                             return rank_of(a->chapter) < rank_of(b->chapter);
                         });
        for (AnalysisChapter* chapter : ranked) {
            const double needed = lines_of(chapter->shortened.body);
            const bool empty = says_nothing(chapter->shortened.body) && !says_nothing(chapter->whole);
            chapter->left_out = chapter->chapter && (needed > lines || empty);
            if (!chapter->left_out) lines -= needed;
        }
    }

    const ReportContents& contents_;
    const EvaluatedAnalysis& evaluated_;
    Chapters chapters_;
    const DocumentLanguage& in_;
};

/// The chapters that the contents do not leave out.
Chapters chapters_in(const ReportSource& source, const EvaluatedAnalysis& evaluated,
                     const ReportContents& contents, std::set<std::string>& shown_assets) {
    Chapters chapters = chapters_of(source, evaluated, shown_assets);
    std::erase_if(chapters, [&](const AnalysisChapter& one) {
        return one.whole.empty() || (one.chapter && !contents.has(*one.chapter));
    });
    return chapters;
}

}  // namespace

Blocks sheet_chapters(const ReportSource& source, const ReportContents& contents, double lines) {
    std::set<std::string> shown_assets;
    const EvaluatedAnalysis& evaluated = source.analyses.front();
    return AnalysisBody(contents, evaluated, chapters_in(source, evaluated, contents, shown_assets),
                        source.in)
        .sheet(lines);
}

AnalysisChapters analysis_chapters(const ReportSource& source, const ReportContents& contents, double lines) {
    std::set<std::string> shown_assets;
    std::vector<AnalysisBody> bodies;
    std::vector<double> needs;
    for (const EvaluatedAnalysis& evaluated : source.analyses) {
        Chapters chapters = chapters_in(source, evaluated, contents, shown_assets);
        needs.push_back(whole_lines(chapters));
        bodies.emplace_back(contents, evaluated, std::move(chapters), source.in);
    }
    const double lines_of_frames = frame_lines * double(bodies.size());
    const std::vector<double> shares = shares_of(lines - lines_of_frames, needs);
    AnalysisChapters all;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        bodies[i].fit(shares[i]);
        bodies[i].add_body(all.body);
        if (contents.annex) bodies[i].add_annex(all.annex);
    }
    return all;
}

}  // namespace covaria::report_parts
