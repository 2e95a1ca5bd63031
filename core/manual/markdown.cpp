#include "core/manual/markdown.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

#include "core/document/prose.h"

namespace covaria {
namespace {

bool is_blank(const std::string& line) {
    return line.find_first_not_of(" \t\r") == std::string::npos;
}

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t\r");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

/// Length of the mark of an item, "* ", "- " or "12. ", at the beginning; 0: no item.
std::size_t item_mark(const std::string& line) {
    if (line.starts_with("* ") || line.starts_with("- ")) return 2;
    const std::size_t digits = std::min(line.find_first_not_of("0123456789"), line.size());
    return digits > 0 && line.compare(digits, 2, ". ") == 0 ? digits + 2 : 0;
}

bool is_heading(const std::string& line) {
    const std::size_t level = line.find_first_not_of('#');
    return level != std::string::npos && level > 0 && line[level] == ' ';
}

/// Text between bars; a bar in code or behind a backslash is a letter.
std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells(1);
    bool code = false;
    const std::string row = trimmed(line);
    for (std::size_t i = 1; i < row.size(); ++i) {
        if (row[i] == '`') code = !code;
        if (row[i] == '\\' && i + 1 < row.size() && row[i + 1] == '|')
            cells.back() += row[++i];
        else if (row[i] == '|' && !code)
            cells.emplace_back();
        else
            cells.back() += row[i];
    }
    if (is_blank(cells.back())) cells.pop_back();
    for (std::string& cell : cells) cell = prose_words(spans_of_markdown(trimmed(cell)));
    return cells;
}

class MarkdownReader {
public:
    MarkdownReader(const std::string& text, std::string page, const std::filesystem::path& folder)
        : page_(std::move(page)), folder_(folder) {
        std::istringstream in(text);
        for (std::string line; std::getline(in, line);) lines_.push_back(line);
    }

    std::vector<ReportBlock> read() {
        while (at_ < lines_.size()) {
            const std::string& line = lines_[at_];
            if (is_blank(line))
                ++at_;
            else if (is_heading(line))
                heading();
            else if (line.starts_with("```"))
                fenced_code();
            else if (line.starts_with("    "))
                indented_code();
            else if (line.starts_with("|"))
                table();
            else if (line.starts_with("!["))
                picture();
            else
                prose();
        }
        return std::move(blocks_);
    }

private:
    void heading() {
        const std::string line = lines_[at_++];
        const std::size_t level = line.find_first_not_of('#');
        const std::string words = prose_words(spans_of_markdown(trimmed(line.substr(level))));
        std::string anchor = used_.empty() ? page_ : page_ + "-" + anchor_words(words);
        while (!used_.insert(anchor).second) anchor += "-";
        blocks_.push_back(HeadingBlock{static_cast<int>(level), words, anchor});
    }

    void fenced_code() {
        std::string code;
        for (++at_; at_ < lines_.size() && !lines_[at_].starts_with("```"); ++at_)
            code += (code.empty() ? "" : "\n") + lines_[at_];
        ++at_;
        blocks_.push_back(CodeBlock{code});
    }

    void indented_code() {
        std::string code;
        for (; at_ < lines_.size() && lines_[at_].starts_with("    "); ++at_)
            code += (code.empty() ? "" : "\n") + lines_[at_].substr(4);
        blocks_.push_back(CodeBlock{code});
    }

    void table() {
        TableBlock block;
        for (std::size_t row = 0; at_ < lines_.size() && lines_[at_].starts_with("|"); ++at_, ++row) {
            const std::vector<std::string> cells = cells_of(lines_[at_]);
            if (row == 0)
                for (const std::string& cell : cells) block.table.add(cell).title = running_text(cell);
            if (row < 2) continue;  // the head and the rule below it
            block.table.row({cells.begin(), cells.end()});
        }
        blocks_.push_back(std::move(block));
    }

    void picture() {
        const std::string line = lines_[at_++];
        const std::size_t middle = line.find("]("), end = line.rfind(')');
        if (middle == std::string::npos || end == std::string::npos) return;
        blocks_.push_back(
            PictureBlock{(folder_ / line.substr(middle + 2, end - middle - 2)).lexically_normal(),
                         line.substr(2, middle - 2)});
    }

    /// A paragraph or an item, with the lines that go on.
    void prose() {
        const std::size_t mark = item_mark(lines_[at_]);
        ProseBlock block;
        if (mark > 0) block.mark = mark == 2 ? "–" : lines_[at_].substr(0, mark - 1);
        std::string text = trimmed(lines_[at_++].substr(mark));
        for (; at_ < lines_.size() && goes_on(lines_[at_]); ++at_) text += " " + trimmed(lines_[at_]);
        block.spans = spans_of_markdown(text);
        blocks_.push_back(std::move(block));
    }

    static bool goes_on(const std::string& line) {
        return !is_blank(line) && !is_heading(line) && !line.starts_with("|") && !line.starts_with("```") &&
               item_mark(line) == 0;
    }

    std::string page_;
    const std::filesystem::path& folder_;
    std::vector<std::string> lines_;
    std::size_t at_ = 0;
    std::set<std::string> used_;
    std::vector<ReportBlock> blocks_;
};

/// Text with marks, piece by piece.
class SpanReader {
public:
    explicit SpanReader(const std::string& text) : text_(text) {}

    std::vector<ProseSpan> read() {
        while (at_ < text_.size())
            if (!code() && !marked("**", &ProseSpan::strong) && !marked("*", &ProseSpan::emphasis) && !link())
                plain_ += text_[at_++];
        flush();
        return std::move(spans_);
    }

private:
    void flush() {
        if (!plain_.empty()) spans_.push_back({plain_});
        plain_.clear();
    }

    bool code() {
        if (text_[at_] != '`') return false;
        const std::size_t end = text_.find('`', at_ + 1);
        if (end == std::string::npos) return false;
        flush();
        spans_.push_back({.text = text_.substr(at_ + 1, end - at_ - 1), .code = true});
        at_ = end + 1;
        return true;
    }

    bool marked(const std::string& mark, bool ProseSpan::*style) {
        if (text_.compare(at_, mark.size(), mark) != 0) return false;
        const std::size_t begin = at_ + mark.size(), end = text_.find(mark, begin);
        if (end == std::string::npos || end == begin || text_[begin] == ' ' || text_[end - 1] == ' ')
            return false;
        flush();
        for (ProseSpan span : spans_of_markdown(text_.substr(begin, end - begin))) {
            span.*style = true;
            spans_.push_back(std::move(span));
        }
        at_ = end + mark.size();
        return true;
    }

    bool link() {
        if (text_[at_] != '[') return false;
        const std::size_t middle = text_.find("](", at_);
        if (middle == std::string::npos || text_.find('[', at_ + 1) < middle) return false;
        const std::size_t end = text_.find(')', middle);
        if (end == std::string::npos) return false;
        flush();
        for (ProseSpan span : spans_of_markdown(text_.substr(at_ + 1, middle - at_ - 1))) {
            span.link = text_.substr(middle + 2, end - middle - 2);
            spans_.push_back(std::move(span));
        }
        at_ = end + 1;
        return true;
    }

    const std::string& text_;
    std::size_t at_ = 0;
    std::string plain_;
    std::vector<ProseSpan> spans_;
};

}  // namespace

std::vector<ReportBlock> blocks_of_markdown(const std::string& text, const std::string& page,
                                            const std::filesystem::path& folder) {
    return MarkdownReader(text, page, folder).read();
}

std::vector<ProseSpan> spans_of_markdown(const std::string& text) {
    return SpanReader(text).read();
}

std::string anchor_words(const std::string& heading) {
    std::string anchor;
    for (const char c : heading)
        if (std::isalnum(static_cast<unsigned char>(c)) || (c & 0x80))
            anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (!anchor.empty() && anchor.back() != '-')
            anchor += '-';
    while (!anchor.empty() && anchor.back() == '-') anchor.pop_back();
    return anchor;
}

}  // namespace covaria
