// A report as a sequence of blocks; writers turn it into Markdown, HTML, CSV or (ui/print) PDF.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/project/certificate_logo.h"
#include "core/text/cell.h"
#include "core/text/formula.h"
#include "core/text/numbers.h"
#include "core/text/plot_specification.h"

namespace covaria {

struct HeadingBlock {
    int level = 1;
    std::string text;
    std::string anchor = {};   ///< name by which contents and links find it; empty: they do not
    bool begins_page = false;  ///< begins a page in print
};
/// A piece of a page of help.
struct ProseSpan {
    std::string text;  ///< typeset symbols included, unless it is code
    bool strong = false, emphasis = false, code = false;
    std::string link = {};  ///< "#anchor" or an address
};
struct ProseBlock {
    std::vector<ProseSpan> spans;
    std::string mark = {};  ///< mark of an item of a list: "–", "2."
    std::string anchor = {};
};
/// Lines as they stand.
struct CodeBlock {
    std::string text;
};
/// A picture that exists as a file.
struct PictureBlock {
    std::filesystem::path file;
    std::string caption;
};
/// The headings of the document, with their pages in print.
struct ContentsBlock {
    int levels = 2;
    bool searched = false;  ///< on a screen, has a field to search the headings of all levels
};
struct ParagraphBlock {
    std::string text;
    bool note = false;
};
struct ListBlock {
    std::vector<std::string> items;
};
/// Key and value pairs: the title block, provenance.
struct FactsBlock {
    std::vector<std::pair<std::string, std::string>> facts;
    bool literal = false;  ///< values are what was typed ("A_7" of a serial number), not symbols
};
/// The end of a certificate: last statement, who signs it, room to do so, and its end; they never part.
struct SignatureBlock {
    std::string statement;
    std::string date, name, function;
    std::string end_mark;
};
struct EquationBlock {
    std::string text;
    std::string source;
    Formula formula = {};  ///< tree for writers that can set it; empty: `text` is all
};

/// A table with the view that writers set it in: the title of a column is its head, `written` its cells.
struct TableBlock {
    Table table;
    TableView view = {};
    std::string continued = {};  ///< title on pages where it goes on: "Table 12, continued"
};
/// A table of a model, an asset or a design.
inline TableBlock evaluation_block(Table table, const DocumentLanguage& in) {
    return {evaluation_table(std::move(table), in), {{}, 2, in}};
}
struct PlotBlock {
    PlotSpecification plot;
    std::string caption;
};
/// A picture of the scene of an analysis; realised by the caller of the writer (id is its file name without
/// ending).
struct SceneBlock {
    std::string id, analysis, group, view;
    std::string caption;
    std::string design = {};  ///< design of the analysis whose findings it shows, in place of the result
};

using ReportBlock =
    std::variant<HeadingBlock, ParagraphBlock, ListBlock, FactsBlock, EquationBlock, TableBlock, PlotBlock,
                 SceneBlock, SignatureBlock, ProseBlock, CodeBlock, PictureBlock, ContentsBlock>;

struct ReportDocument {
    std::string title;
    std::string running_head;
    std::vector<ReportBlock> blocks;
    std::string over = "Report of an uncertainty evaluation";  ///< above the title, in print
    LogoPicture logo = {};                                     ///< beside the title
    std::string author = {};                                   ///< author in its properties
    std::string language = "en";                               ///< code of its language: "pt", "zh_CN"
    std::string page_words = "Page %1 of %2";
    NumberLocale numbers = {};        ///< written form of numbers in charts and scenes
    bool head_on_every_page = false;  ///< the running head stands on the first page too
};

}  // namespace covaria
