// A report as a sequence of blocks; writers turn it into Markdown, HTML, CSV or (ui/print) PDF.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/base/data_table.h"
#include "core/report/plot_specification.h"

namespace covaria {

struct HeadingBlock {
    int level = 1;
    std::string text;
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
};
struct EquationBlock {
    std::string text;
    std::string source;
};
/// `table` cells are SI numbers; writers format them with `format_cell`.
struct TableBlock {
    DataTable table;
};
struct PlotBlock {
    PlotSpecification plot;
    std::string caption;
};
/// A picture of the scene of an analysis; realised by the caller of the writer (id is its file name without
/// ending).
struct SceneBlock {
    std::string id, analysis, group, view;
    std::string caption;
};

using ReportBlock = std::variant<HeadingBlock, ParagraphBlock, ListBlock, FactsBlock, EquationBlock,
                                 TableBlock, PlotBlock, SceneBlock>;

struct ReportDocument {
    std::string title;
    std::string running_head;
    std::vector<ReportBlock> blocks;
};

}  // namespace covaria
