#include "core/report/report_extent.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>

#include "core/base/name.h"
#include "core/document/prose.h"

namespace covaria::report_parts {

namespace {

constexpr double letters_of_line = 105.0;
constexpr double letters_of_row = 118.0;
constexpr double tolerated = 1.25;  // times the extent that a table may have and stays whole

double lines_of_text(const std::string& text, double letters) {
    return std::max(1.0, std::ceil(double(text.size()) / letters));
}

double lines_of_row(const TableBlock& block, std::size_t row) {
    const Table& table = block.table;
    const std::size_t columns = table.is_subhead(row) ? 1 : table.shown_columns();
    const double letters = letters_of_row / double(std::max<std::size_t>(columns, 1));
    double most = 1.0;
    for (std::size_t c = 0; c < columns; ++c) {
        const Column& column = table.columns[c];
        if (number_in(column.cell(row))) continue;  // a number stands on one line
        const std::string text = written(table, column, row, block.view).letters();
        most = std::max(most, lines_of_text(text, std::max(letters, 9.0)));
    }
    return most;
}

/// The count of lines on pages of print of 56 lines.
struct LineCount {
    double operator()(const HeadingBlock& block) const { return block.level <= 2 ? 3.0 : 2.0; }
    double operator()(const ParagraphBlock& block) const {
        return lines_of_text(block.text, letters_of_line) + 0.6;
    }
    double operator()(const ListBlock& block) const {
        double lines = 0.6;
        for (const std::string& item : block.items) lines += lines_of_text(item, letters_of_line);
        return lines;
    }
    double operator()(const FactsBlock& block) const { return double(block.facts.size()) + 0.6; }
    double operator()(const EquationBlock&) const { return 2.5; }
    double operator()(const TableBlock& block) const {
        double lines = 4.5;
        for (std::size_t row = 0; row < block.table.rows; ++row) lines += 1.05 * lines_of_row(block, row);
        for (const Message& note : block.table.notes) lines += lines_of_text(note.english(), letters_of_line);
        return lines;
    }
    double operator()(const PlotBlock&) const { return 9.0; }  // two charts stand side by side
    double operator()(const SceneBlock&) const { return 28.0; }
    double operator()(const ProseBlock& block) const {
        return lines_of_text(prose_words(block.spans), letters_of_line) + 0.6;
    }
    double operator()(const CodeBlock& block) const {
        return 1.6 + double(std::count(block.text.begin(), block.text.end(), '\n'));
    }
    double operator()(const PictureBlock&) const { return 28.0; }
    double operator()(const ContentsBlock&) const { return 0.0; }  // the contents come last
    double operator()(const SignatureBlock&) const { return 12.0; }
};

/// The row in which those of a group, as its subhead says it, begin; 0 where the table has none of it.
std::size_t begin_of(const TableBlock& block, const std::string& group) {
    for (const auto& [row, text] : block.table.subheads)
        if (!group.empty() && text == group) return row;
    return 0;
}

bool is_budget(const TableBlock& block) {
    return block.table.id.starts_with("budget-");
}

/// The note on a table of `all` rows of which so many are shown.
Message rows_note(std::size_t all, std::size_t begin, std::size_t shown, const Message& group,
                  Elsewhere elsewhere) {
    const bool annex = elsewhere == Elsewhere::annex;
    if (begin > 0)
        return annex ? tell<"From '%1' on, %2 of %3 rows; the annex has all of them.">(group, shown, all)
                     : tell<
                           "From '%1' on, %2 of %3 rows; the CSV tables, and the annex on request, have all "
                           "of them.">(group, shown, all);
    return annex ? tell<"The first %1 of %2 rows; the annex has all of them.">(shown, all)
                 : tell<
                       "The first %1 of %2 rows; the CSV tables, and the annex on request, have all of "
                       "them.">(shown, all);
}

struct Shown {
    std::size_t some = 0, all = 0;
    bool is_all() const { return all <= some; }
};

Message shown_note(Shown tables, Shown charts, Elsewhere elsewhere) {
    const bool annex = elsewhere == Elsewhere::annex;
    const bool no_chart = charts.some == 0 && !charts.is_all();
    if (no_chart && tables.is_all())
        return annex ? tell<"The annex has the charts.">()
                     : tell<"The CSV tables, and the annex on request, have what the charts show.">();
    if (no_chart)
        return annex
                   ? tell<"Shown are %1 of %2 tables and no chart; the annex has the rest.">(tables.some,
                                                                                             tables.all)
                   : tell<
                         "Shown are %1 of %2 tables and no chart; the CSV tables, and the annex on request, "
                         "have the rest.">(tables.some, tables.all);
    if (charts.is_all())
        return annex ? tell<"Shown are %1 of %2 tables; the annex has the rest.">(tables.some, tables.all)
                     : tell<
                           "Shown are %1 of %2 tables; the CSV tables, and the annex on request, have the "
                           "rest.">(tables.some, tables.all);
    if (tables.is_all())
        return annex ? tell<"Shown are %1 of %2 charts; the annex has the rest.">(charts.some, charts.all)
                     : tell<
                           "Shown are %1 of %2 charts; the CSV tables, and the annex on request, have the "
                           "rest.">(charts.some, charts.all);
    return annex ? tell<"Shown are %1 of %2 tables and %3 of %4 charts; the annex has the rest.">(
                       tables.some, tables.all, charts.some, charts.all)
                 : tell<
                       "Shown are %1 of %2 tables and %3 of %4 charts; the CSV tables, and the annex on "
                       "request, have the rest.">(tables.some, tables.all, charts.some, charts.all);
}

/// The number of rows without sub-heads.
std::size_t rows_in(const Table& table) {
    return table.rows - table.subheads.size();
}

/// The end of the rows that are shown: not within a group, unless it alone is far longer.
std::size_t end_of(const Table& table, std::size_t begin, std::size_t most) {
    const std::size_t end = begin + std::min(most, table.rows - begin);
    if (end == table.rows || !table.is_subhead(begin)) return end;
    for (std::size_t row = end; row > begin; --row)
        if (table.is_subhead(row)) return row;
    for (std::size_t row = end; row <= std::min(table.rows, begin + 2 * most); ++row)
        if (row == table.rows || table.is_subhead(row)) return row;
    return end;
}

class Shortening {
public:
    Shortening(const Extent& extent, const Name& group, Elsewhere elsewhere, const DocumentLanguage& in)
        : extent_(extent), group_(group), elsewhere_(elsewhere), in_(in) {}

    void add(const ReportBlock& block) {
        if (const auto* heading = std::get_if<HeadingBlock>(&block); heading && heading->level > 2) {
            end_section();
            section_ = out_.body.size();
        }
        if (const auto* table = std::get_if<TableBlock>(&block)) return add_table(*table);
        if (std::holds_alternative<PlotBlock>(block) && ++figures_ > extent_.figures)
            leave(block);
        else
            out_.body.push_back(block);
    }

    ShortenedChapter take() {
        end_section();
        const Shown tables{extent_.tables, tables_}, charts{extent_.figures, figures_};
        if (!tables.is_all() || !charts.is_all())
            out_.body.push_back(ParagraphBlock{in_.say(shown_note(tables, charts, elsewhere_)), true});
        return std::move(out_);
    }

private:
    void leave(const ReportBlock& block) {
        out_.rest.push_back(block);
        lost_ = true;
    }

    /// Ends a section: a heading below that of the chapter goes with the blocks that it was over.
    void end_section() {
        const auto begin = out_.body.begin() + static_cast<std::ptrdiff_t>(section_.value_or(0));
        const bool words = std::all_of(begin, out_.body.end(), [](const ReportBlock& block) {
            return std::holds_alternative<HeadingBlock>(block) ||
                   std::holds_alternative<ParagraphBlock>(block);
        });
        if (section_ && lost_ && words) out_.body.erase(begin, out_.body.end());
        section_.reset();
        lost_ = false;
    }

    void add_table(const TableBlock& table) {
        if (++tables_ > extent_.tables) return leave(table);
        const std::size_t rows = table.table.rows;
        if (is_budget(table) || double(rows) <= tolerated * double(extent_.rows))
            return out_.body.push_back(table);
        const std::size_t begin = begin_of(table, in_.say(said_name(group_))),
                          end = end_of(table.table, begin, extent_.rows);
        if (end - begin == rows) return out_.body.push_back(table);
        TableBlock part{table.table.part(begin, end), table.view};
        part.table.notes.push_back(in_.say(
            rows_note(rows_in(table.table), begin, rows_in(part.table), said_name(group_), elsewhere_)));
        out_.body.push_back(std::move(part));
        out_.rest.push_back(table);
    }

    const Extent& extent_;
    const Name& group_;
    const Elsewhere elsewhere_;
    const DocumentLanguage& in_;
    std::size_t tables_ = 0, figures_ = 0;
    std::optional<std::size_t> section_ = {};  ///< begin of a section below the chapter's heading
    bool lost_ = false;                        ///< whether something of the section went to the rest
    ShortenedChapter out_;
};

}  // namespace

double lines_of(const Blocks& blocks) {
    double lines = 0.0;
    for (const ReportBlock& block : blocks) lines += std::visit(LineCount{}, block);
    return lines;
}

const std::vector<Extent>& extents() {
    static const std::vector<Extent> steps{{},           {24, 40, 8, 24}, {16, 12, 6, 12}, {12, 8, 4, 8},
                                           {8, 3, 2, 6}, {6, 3, 0, 5}};
    return steps;
}

ShortenedChapter shorten(const Blocks& chapter, const Extent& extent, const Name& group, Elsewhere elsewhere,
                         const DocumentLanguage& in) {
    Shortening shortening(extent, group, elsewhere, in);
    for (const ReportBlock& block : chapter) shortening.add(block);
    return shortening.take();
}

Blocks shortened_to(double lines, const Blocks& blocks, Elsewhere elsewhere, const DocumentLanguage& in) {
    Blocks shown;
    for (Extent extent : extents()) {
        extent.tables = Extent::all;
        shown = shorten(blocks, extent, "", elsewhere, in).body;
        if (lines_of(shown) <= lines) break;
    }
    return shown;
}

std::vector<double> shares_of(double room, const std::vector<double>& needs) {
    std::vector<std::size_t> order(needs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return needs[a] < needs[b]; });
    std::vector<double> shares(needs.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        shares[order[i]] = std::min(needs[order[i]], room / double(order.size() - i));
        room -= shares[order[i]];
    }
    return shares;
}

}  // namespace covaria::report_parts
