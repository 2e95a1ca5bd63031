// Report document as Markdown with pipe tables; figures are files beside it.
#include "core/report/report.h"
#include "core/report/table_text.h"

namespace covaria {
namespace {

/// Marks that Markdown or HTML would take as their own.
std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else if (c == '|' || c == '*' || c == '`' || c == '_' || c == '\\')
            out += std::string("\\") + c;
        else if (c == '\n')
            out += ' ';
        else
            out += c;
    }
    return out;
}

std::string table_cell(const TableBlock& block, std::size_t row, std::size_t column) {
    const std::string text = cell_text(block, row, column);
    const bool symbol = style_of(block, column).symbol && !is_subhead(block, row);
    return escaped(symbol ? symbols_to_unicode(text) : text);
}

struct MarkdownWriter {
    std::string out;

    void operator()(const HeadingBlock& heading) {
        out += std::string(static_cast<std::size_t>(heading.level) + 1, '#') + " " + escaped(heading.text) +
               "\n\n";
    }
    void operator()(const ParagraphBlock& paragraph) {
        out += (paragraph.note ? "> " : "") + escaped(paragraph.text) + "\n\n";
    }
    void operator()(const ListBlock& list) {
        for (const std::string& item : list.items) out += "- " + escaped(item) + "\n";
        out += "\n";
    }
    void operator()(const FactsBlock& facts) {
        out += "| | |\n|---|---|\n";
        for (const auto& [key, value] : facts.facts)
            out += "| " + escaped(key) + " | " + escaped(value) + " |\n";
        out += "\n";
    }
    void operator()(const EquationBlock& equation) {
        out += escaped(equation.text);
        if (!equation.source.empty()) out += " (" + escaped(equation.source) + ")";
        out += "\n\n";
    }
    void operator()(const TableBlock& block) {
        const DataTable& table = block.table;
        if (!table.title.empty()) out += "**" + escaped(table.title) + "**\n\n";
        std::string rule;
        for (std::size_t c = 0; c < table.columns.size(); ++c) {
            out += "| " + escaped(head_text(table.columns[c])) + " ";
            rule += is_numeric_column(block, c) ? "|---:" : "|---";
        }
        out += "|\n" + rule + "|\n";
        for (std::size_t r = 0; r < table.rows.size(); ++r) {
            for (std::size_t c = 0; c < table.columns.size(); ++c)
                out += "| " + table_cell(block, r, c) + " ";
            out += "|\n";
        }
        out += "\n";
        for (const std::string& note : table.notes) out += escaped(note) + "\n\n";
    }
    void operator()(const PlotBlock& plot) { figure(plot.plot.id + ".svg", plot.caption); }
    void operator()(const SceneBlock& scene) { figure(scene.id + ".png", scene.caption); }

    void figure(const std::string& file, const std::string& caption) {
        out += "![" + escaped(caption) + "](" + file + ")\n\n*" + escaped(caption) + "*\n\n";
    }
};

}  // namespace

std::string to_markdown(const ReportDocument& document) {
    MarkdownWriter writer;
    writer.out = "# " + escaped(document.title) + "\n\n";
    for (const ReportBlock& block : document.blocks) std::visit(writer, block);
    return writer.out;
}

}  // namespace covaria
