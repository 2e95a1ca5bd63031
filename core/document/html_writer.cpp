// Report document as one HTML file with its style sheet inside; figures are files beside it.
#include <algorithm>
#include <cstdint>
#include <sstream>

#include "core/base/file_io.h"
#include "core/document/document_writers.h"
#include "core/document/html_style.h"
#include "core/document/prose.h"
#include "core/document/report_document.h"
#include "core/text/symbol.h"

namespace covaria {
namespace {

std::string element(const std::string& name, const std::string& inner, const std::string& css_class = "") {
    const std::string attribute = css_class.empty() ? "" : " class=\"" + css_class + "\"";
    return "<" + name + attribute + ">" + inner + "</" + name + ">";
}

/// Digits after the decimal point; -1: no point.
int aligned_decimals(const std::string& text) {
    const auto point = text.find('.');
    if (point == std::string::npos) return -1;
    return static_cast<int>(
        text.find_first_not_of("0123456789", point + 1) == std::string::npos ? text.size() - point - 1 : 0);
}

/// Blanks as wide as the digits (and the point) that are missing, so that decimal points stand in line.
std::string padding(int decimals, int widest) {
    std::string out;
    if (decimals < 0 && widest >= 0) out += "\u2008";
    for (int i = std::max(decimals, 0); i < widest; ++i) out += "\u2007";
    return out;
}

std::size_t length_of(const std::string& text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::size_t longest_word(const std::string& text) {
    std::size_t longest = 0;
    std::istringstream words(text);
    for (std::string word; words >> word;) longest = std::max(longest, length_of(word));
    return longest;
}

/// Room that a table needs on paper at the usual size, in mm: figures and words of 8.5 points.
double printed_width(const TableBlock& block) {
    constexpr double letter = 1.55, gap = 3.0;
    double width = 0.0;
    for (std::size_t c = 0; c < block.table.shown_columns(); ++c) {
        const Column& column = block.table.columns[c];
        const bool numbers = has_only_numbers(block.table, column);
        std::size_t longest = 0;
        for (std::size_t r = 0; r < block.table.rows; ++r) {
            if (block.table.is_subhead(r)) continue;
            const std::string text = written(block.table, column, r, block.view).letters();
            longest = std::max(longest, numbers ? length_of(text) : longest_word(text));  // words break
        }
        longest = std::max(longest, longest_word(column.title.letters()));
        width += letter * static_cast<double>(longest) + gap;
    }
    return width;
}

/// Class of a table by its width in print, where nothing scrolls: smaller, the widest on a page across.
std::string printed_class(const TableBlock& block) {
    constexpr double upright = 170.0, across = 257.0;
    const double width = printed_width(block);
    if (width <= upright) return {};
    if (width <= 1.35 * upright) return " print-smaller";
    if (width <= 1.35 * across) return " print-across";
    return " print-across print-smallest";
}

std::vector<int> widest_decimals(const TableBlock& block) {
    std::vector<int> widest(block.table.shown_columns(), -1);
    for (std::size_t c = 0; c < widest.size(); ++c)
        for (std::size_t r = 0; r < block.table.rows; ++r)
            if (const auto number = rounded(block.table, block.table.columns[c], r, block.view))
                widest[c] = std::max(widest[c], aligned_decimals(*number));
    return widest;
}

std::string rich(const std::string& words) {
    return to_html(running_text(words));
}

std::string identity(const std::string& anchor) {
    return anchor.empty() ? "" : " id=\"" + escape_html(anchor) + "\"";
}

/// Text browsers of the window find only these.
std::string target(const std::string& anchor) {
    return anchor.empty() ? "" : "<a name=\"" + escape_html(anchor) + "\"></a>";
}

std::string base64(const std::string& bytes) {
    static constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k) out += k <= count ? letters[group >> (18 - 6 * k) & 63] : '=';
    }
    return out;
}

struct HtmlWriter {
    const std::vector<ReportBlock>& blocks;
    std::string out = {};

    void operator()(const HeadingBlock& heading) {
        const std::string name = "h" + std::to_string(std::min(heading.level + 1, 6));
        out += "<" + name + identity(heading.anchor) + ">" + target(heading.anchor) +
               escape_html(heading.text) + "</" + name + ">\n";
    }
    void operator()(const ProseBlock& prose) {
        const std::string mark =
            prose.mark.empty() ? "" : element("span", escape_html(prose.mark), "mark") + " ";
        out += std::string("<p") + (prose.mark.empty() ? "" : " class=\"item\"") + identity(prose.anchor) +
               ">" + target(prose.anchor) + mark + prose_html(prose.spans, Links::shown) + "</p>\n";
    }
    void operator()(const CodeBlock& code) { out += element("pre", escape_html(code.text)) + "\n"; }
    void operator()(const PictureBlock& picture) {
        const auto bytes = read_file(picture.file);
        if (!bytes) return;
        out += "<figure><img src=\"data:image/png;base64," + base64(*bytes) + "\" alt=\"" +
               escape_html(picture.caption) + "\">" + element("figcaption", escape_html(picture.caption)) +
               "</figure>\n";
    }
    void operator()(const ContentsBlock& contents) {
        out += "<nav id=\"contents\">";
        if (contents.searched) out += "<input type=\"search\" placeholder=\"Search\" aria-label=\"Search\">";
        out += "\n<ul>\n";
        for (const ReportBlock& block : blocks) {
            const auto* heading = std::get_if<HeadingBlock>(&block);
            if (!heading || heading->anchor.empty()) continue;
            if (heading->level > contents.levels && !contents.searched) continue;
            out += "<li class=\"level-" + std::to_string(heading->level) + "\"" +
                   (heading->level > contents.levels ? " hidden" : "") + "><a href=\"#" + heading->anchor +
                   "\">" + escape_html(heading->text) + "</a></li>\n";
        }
        out += "</ul></nav>\n" + (contents.searched ? std::string(html_search) : std::string());
    }
    void operator()(const ParagraphBlock& paragraph) {
        out += element("p", rich(paragraph.text), paragraph.note ? "note" : "") + "\n";
    }
    void operator()(const ListBlock& list) {
        out += "<ul>\n";
        for (const std::string& item : list.items) out += element("li", rich(item)) + "\n";
        out += "</ul>\n";
    }
    void operator()(const FactsBlock& facts) {
        out += "<dl>\n";
        for (const auto& [key, value] : facts.facts)
            out += element("dt", rich(key)) +
                   element("dd", facts.literal ? escape_html(value) : rich(value)) + "\n";
        out += "</dl>\n";
    }
    void operator()(const EquationBlock& equation) {
        out += element("p",
                       element("span",
                               equation.formula.empty() ? to_html(equation_text(equation.text))
                                                        : to_mathml(equation.formula),
                               "formula") +
                           (equation.source.empty() ? "" : element("span", rich(equation.source), "source")),
                       "equation") +
               "\n";
    }
    void operator()(const TableBlock& block) {
        const Table& table = block.table;
        out += "<div class=\"wide" + printed_class(block) + "\"><table>\n";
        if (!table.title.empty()) out += element("caption", rich(table.title)) + "\n";
        out += "<thead><tr>";
        for (std::size_t c = 0; c < table.shown_columns(); ++c)
            out += element("th", to_html(head_written(table.columns[c], block.view)), css_class(table, c));
        out += "</tr></thead>\n<tbody>\n";
        const std::vector<int> widest = widest_decimals(block);
        for (std::size_t r = 0; r < table.rows; ++r) row(block, r, widest);
        out += "</tbody></table>\n";
        for (const Message& note : table.notes) out += element("p", rich(note.english()), "note") + "\n";
        out += "</div>\n";
    }
    void operator()(const SignatureBlock& signature) {
        const std::string function =
            signature.function.empty() ? "" : "<br>" + escape_html(signature.function);
        const std::string line = element("p", escape_html(signature.name) + function, "line");
        out += element("p", escape_html(signature.statement)) + "\n" +
               element("div", element("p", escape_html(signature.date)) + line, "signature") + "\n" +
               element("p", escape_html(signature.end_mark), "end") + "\n";
    }
    void operator()(const PlotBlock& plot) { figure(plot.plot.id + ".svg", plot.caption); }
    void operator()(const SceneBlock& scene) { figure(scene.id + ".png", scene.caption); }

    void row(const TableBlock& block, std::size_t r, const std::vector<int>& widest) {
        out += "<tr>";
        const Table& table = block.table;
        if (table.is_subhead(r)) {
            out += "<td class=\"subhead\" colspan=\"" + std::to_string(widest.size()) + "\">" +
                   to_html(written(table, table.columns.front(), r, block.view)) + "</td>";
        } else {
            for (std::size_t c = 0; c < widest.size(); ++c) {
                const Column& column = table.columns[c];
                const auto number = rounded(table, column, r, block.view);
                const std::string pad = number ? padding(aligned_decimals(*number), widest[c]) : "";
                out +=
                    element("td", to_html(written(table, column, r, block.view)) + pad, css_class(table, c));
            }
        }
        out += "</tr>\n";
    }

    static std::string css_class(const Table& table, std::size_t column) {
        return has_only_numbers(table, table.columns[column]) ? "number" : "";
    }

    void figure(const std::string& file, const std::string& caption) {
        out += "<figure><img src=\"" + escape_html(file) + "\" alt=\"" + escape_html(caption) + "\">" +
               element("figcaption", rich(caption)) + "</figure>\n";
    }
};

}  // namespace

namespace {

/// A text of a style sheet in its quotes.
std::string css_text(const std::string& text) {
    std::string out = "\"";
    for (const char c : text)
        out += c == '"' || c == '\\' || c == '<' || c == '\n'
                   ? std::string("\\") + "0123456789abcdef"[c / 16] + "0123456789abcdef"[c % 16] + " "
                   : std::string(1, c);
    return out + "\"";
}

/// "Page %1 of %2" with the counters of the style sheet.
std::string page_counter(const std::string& words) {
    const std::size_t page = words.find("%1"), pages = words.find("%2");
    if (page == std::string::npos || pages == std::string::npos || pages < page)
        return "counter(page) \"/\" counter(pages)";
    return css_text(words.substr(0, page)) + " counter(page) " +
           css_text(words.substr(page + 2, pages - page - 2)) + " counter(pages) " +
           css_text(words.substr(pages + 2));
}

/// "zh_CN" as a page says it.
std::string language_tag(std::string code) {
    std::replace(code.begin(), code.end(), '_', '-');
    return code;
}

/// Style of the margins of every printed page.
std::string page_heads(const ReportDocument& document) {
    if (!document.head_on_every_page) return {};
    return "@page { @top-left { content: " + css_text(document.running_head) +
           "; font-size: 8pt; } @top-right { content: " + page_counter(document.page_words) +
           "; font-size: 8pt; } }\n";
}

std::string logo_of(const ReportDocument& document) {
    if (document.logo.empty()) return {};
    return "<img class=\"logo\" alt=\"" + escape_html(document.over) +
           "\" src=\"data:" + document.logo.media_type + ";base64," + base64(document.logo.bytes) + "\">\n";
}

}  // namespace

std::string html_body(const std::vector<ReportBlock>& blocks) {
    HtmlWriter writer{blocks};
    for (const ReportBlock& block : blocks) std::visit(writer, block);
    return std::move(writer.out);
}

std::string to_html(const ReportDocument& document) {
    return "<!DOCTYPE html>\n<html lang=\"" + language_tag(document.language) +
           "\">\n<head>\n<meta charset=\"utf-8\">\n<title>" + escape_html(document.title) +
           "</title>\n<style>" + std::string(html_style) + page_heads(document) +
           "</style>\n</head>\n<body>\n" + logo_of(document) + "<h1>" + escape_html(document.title) +
           "</h1>\n" + html_body(document.blocks) + "</body>\n</html>\n";
}

}  // namespace covaria
