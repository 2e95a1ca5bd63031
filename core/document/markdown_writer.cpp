// Report document as Markdown with pipe tables; figures are files beside it.
#include <algorithm>
#include <string_view>

#include "core/base/printable.h"
#include "core/document/document_writers.h"
#include "core/document/prose.h"
#include "core/document/report_document.h"
#include "core/text/symbol.h"

namespace covaria {
namespace {

/// Marks that Markdown or HTML would take as their own: emphasis, code, tables, mathematics, links (of
/// brackets only what makes one, so that intervals stay readable; addresses are not to become links by
/// themselves).
std::string escaped(const std::string& words) {
    const std::string text = printable(words);
    const auto rest = [&](std::size_t i) { return std::string_view(text).substr(i); };
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i], next = i + 1 < text.size() ? text[i + 1] : '\0';
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else if (c == '\n' || c == '\r')
            out += ' ';
        else if (std::string_view("|*`_\\$~").find(c) != std::string_view::npos ||
                 (c == ']' && (next == '(' || next == '[' || next == ':')) || rest(i).starts_with("://"))
            out += std::string("\\") + c;
        else if (rest(i).starts_with("www."))
            out += "www\\.", i += 3;
        else
            out += c;
    }
    return out;
}

/// Text at the beginning of a block, where some marks would make headings, lists, rules or code.
std::string escaped_block(const std::string& text) {
    const std::size_t first = std::min(text.find_first_not_of(" \t\r\n"), text.size());
    std::string out = escaped(text.substr(first));
    const std::size_t after_digits = std::min(out.find_first_not_of("0123456789"), out.size());
    if (!out.empty() && std::string_view("#-+=").find(out[0]) != std::string_view::npos)
        out.insert(0, "\\");
    else if (after_digits > 0 && after_digits < out.size() &&
             (out[after_digits] == '.' || out[after_digits] == ')') &&
             (after_digits + 1 == out.size() || out[after_digits + 1] == ' '))
        out.insert(after_digits, "\\");
    return out;
}

/// Symbols among the words as far as Unicode has their letters: "theta_1" as θ₁.
std::string words(const std::string& text) {
    return escaped(to_unicode(running_text(text)));
}

std::string words_of_block(const std::string& text) {
    return escaped_block(to_unicode(running_text(text)));
}

std::string table_cell(const TableBlock& block, std::size_t row, std::size_t column) {
    const Column& of = block.table.columns[column];
    if (const auto number = rounded(block.table, of, row, block.view))
        return escaped(with_decimal_sign(*number, block.view.language.numbers()));
    return escaped(to_unicode(written(block.table, of, row, block.view)));
}

struct MarkdownWriter {
    std::string out;

    void operator()(const HeadingBlock& heading) {
        out += std::string(static_cast<std::size_t>(heading.level) + 1, '#') + " " + words(heading.text) +
               "\n\n";
    }
    void operator()(const ParagraphBlock& paragraph) {
        out += (paragraph.note ? "> " : "") + words_of_block(paragraph.text) + "\n\n";
    }
    void operator()(const ListBlock& list) {
        for (const std::string& item : list.items) out += "- " + words_of_block(item) + "\n";
        out += "\n";
    }
    void operator()(const ProseBlock& prose) {
        out += (prose.mark.empty() ? "" : "- ") + escaped_block(prose_words(prose.spans)) + "\n\n";
    }
    void operator()(const CodeBlock& code) { out += "```\n" + printable(code.text) + "\n```\n\n"; }
    void operator()(const PictureBlock& picture) {
        out += "![" + escaped(picture.caption) + "](" + picture.file.generic_string() + ")\n\n";
    }
    void operator()(const ContentsBlock&) {}  // readers of Markdown make them
    void operator()(const FactsBlock& facts) {
        out += "| | |\n|---|---|\n";
        for (const auto& [key, value] : facts.facts)
            out += "| " + words(key) + " | " + (facts.literal ? escaped(value) : words(value)) + " |\n";
        out += "\n";
    }
    void operator()(const EquationBlock& equation) {
        out += escaped_block(equation.text);
        if (!equation.source.empty()) out += " (" + escaped(equation.source) + ")";
        out += "\n\n";
    }
    void operator()(const TableBlock& block) {
        const Table& table = block.table;
        if (!table.title.empty()) out += "**" + words(table.title) + "**\n\n";
        std::string rule;
        for (std::size_t c = 0; c < table.shown_columns(); ++c) {
            out += "| " + escaped(to_unicode(head_written(table.columns[c], block.view))) + " ";
            rule += has_only_numbers(table, table.columns[c]) ? "|---:" : "|---";
        }
        out += "|\n" + rule + "|\n";
        for (std::size_t r = 0; r < table.rows; ++r) {
            for (std::size_t c = 0; c < table.shown_columns(); ++c)
                out += "| " + table_cell(block, r, c) + " ";
            out += "|\n";
        }
        out += "\n";
        for (const Message& note : table.notes) out += words_of_block(note.english()) + "\n\n";
    }
    void operator()(const SignatureBlock& signature) {
        out += escaped_block(signature.statement) + "\n\n" + escaped(signature.date) + "\n\n" +
               std::string(40, '.') + "\n\n" + escaped(signature.name);
        if (!signature.function.empty()) out += ", " + escaped(signature.function);
        out += "\n\n---\n\n" + escaped(signature.end_mark) + "\n\n";
    }
    void operator()(const PlotBlock& plot) { figure(plot.plot.id + ".svg", plot.caption); }
    void operator()(const SceneBlock& scene) { figure(scene.id + ".png", scene.caption); }

    void figure(const std::string& file, const std::string& caption) {
        out += "![" + words(caption) + "](" + file + ")\n\n*" + words(caption) + "*\n\n";
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
