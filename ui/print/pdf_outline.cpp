#include "ui/print/pdf_outline.h"

#include <QString>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "core/text/numbers.h"

namespace covaria::ui {
namespace {

std::string reference(std::size_t object) {
    return std::to_string(object) + " 0 R";
}

/// UTF-16 with its mark, in hexadecimal: any letters.
std::string text_string(const std::string& utf8) {
    std::string hex = "<FEFF";
    const QString text = QString::fromStdString(utf8);
    for (const QChar c : text) {
        char digits[5];
        std::snprintf(digits, sizeof digits, "%04X", unsigned(c.unicode()));
        hex += digits;
    }
    return hex + ">";
}

/// The number behind the last occurrence of a key; none without it.
std::optional<std::size_t> number_after(const std::string& pdf, const std::string& key) {
    const std::size_t at = pdf.rfind(key);
    if (at == std::string::npos) return std::nullopt;
    char* end = nullptr;
    const char* begin = pdf.c_str() + at + key.size();
    const unsigned long long number = std::strtoull(begin, &end, 10);
    return end == begin ? std::nullopt : std::optional<std::size_t>(number);
}

/// What stands between "7 0 obj" and "endobj".
std::optional<std::string> object(const std::string& pdf, std::size_t number) {
    const std::string head = "\n" + std::to_string(number) + " 0 obj";
    const std::size_t at = pdf.find(head), end = pdf.find("endobj", at);
    if (at == std::string::npos || end == std::string::npos) return std::nullopt;
    return pdf.substr(at + head.size(), end - at - head.size());
}

/// Objects of the pages in their order.
std::vector<std::size_t> pages_of(const std::string& list) {
    std::vector<std::size_t> pages;
    const std::size_t begin = list.find("/Kids"), end = list.find(']', begin);
    if (begin == std::string::npos || end == std::string::npos) return pages;
    const char* at = list.c_str() + list.find('[', begin) + 1;
    while (true) {
        char* next = nullptr;
        const unsigned long long number = std::strtoull(at, &next, 10);
        if (next == at || next > list.c_str() + end) return pages;
        pages.push_back(number);
        std::strtoull(next, &next, 10);  // generation
        at = next;
        while (*at == ' ' || *at == 'R' || *at == '\n') ++at;
    }
}

/// Bookmark i is object `first` + 1 + i; `first` is the root.
class Outline {
public:
    Outline(const std::vector<Bookmark>& bookmarks, const std::vector<std::size_t>& pages, std::size_t first)
        : bookmarks_(bookmarks), pages_(pages), first_(first) {}

    std::string root() const {
        const auto tops = children(std::nullopt);
        return "<<\n/Type /Outlines\n/First " + ref(tops.front()) + "\n/Last " + ref(tops.back()) +
               "\n/Count " + std::to_string(tops.size()) + "\n>>";
    }

    std::string item(std::size_t i) const {
        const Bookmark& bookmark = bookmarks_[i];
        const auto above = parent(i);
        const auto among = children(above), below = children(i);
        const auto self = std::find(among.begin(), among.end(), i);
        std::string text = "<<\n/Title " + text_string(bookmark.title) + "\n/Parent " +
                           (above ? ref(*above) : reference(first_));
        if (self != among.begin()) text += "\n/Prev " + ref(*(self - 1));
        if (self + 1 != among.end()) text += "\n/Next " + ref(*(self + 1));
        if (!below.empty())  // closed
            text += "\n/First " + ref(below.front()) + "\n/Last " + ref(below.back()) + "\n/Count -" +
                    std::to_string(below.size());
        return text + "\n/Dest [" + reference(pages_[std::size_t(bookmark.page)]) + " /XYZ 0 " +
               format_decimals(bookmark.y, 1) + " 0]\n>>";
    }

private:
    std::string ref(std::size_t i) const { return reference(first_ + 1 + i); }

    std::optional<std::size_t> parent(std::size_t i) const {
        for (std::size_t j = i; j-- > 0;)
            if (bookmarks_[j].level < bookmarks_[i].level) return j;
        return std::nullopt;
    }
    std::vector<std::size_t> children(const std::optional<std::size_t>& of) const {
        std::vector<std::size_t> found;
        for (std::size_t i = of ? *of + 1 : 0; i < bookmarks_.size(); ++i)
            if (parent(i) == of) found.push_back(i);
        return found;
    }

    const std::vector<Bookmark>& bookmarks_;
    const std::vector<std::size_t>& pages_;
    std::size_t first_;
};

/// Appends objects and remembers where they begin.
class Update {
public:
    explicit Update(std::string& pdf) : pdf_(pdf) {}

    void add(std::size_t number, const std::string& contents) {
        char entry[64];
        std::snprintf(entry, sizeof entry, "%zu 1\n%010zu 00000 n \n", number, pdf_.size());
        entries_ += entry;
        pdf_ += std::to_string(number) + " 0 obj\n" + contents + "\nendobj\n";
    }
    void finish(std::size_t size, std::size_t root, std::size_t info, std::size_t before) {
        const std::size_t at = pdf_.size();
        pdf_ += "xref\n" + entries_ + "trailer\n<<\n/Size " + std::to_string(size) + "\n/Info " +
                reference(info) + "\n/Root " + reference(root) + "\n/Prev " + std::to_string(before) +
                "\n>>\nstartxref\n" + std::to_string(at) + "\n%%EOF\n";
    }

private:
    std::string& pdf_;
    std::string entries_;
};

}  // namespace

Result<std::string> with_bookmarks(std::string pdf, const std::vector<Bookmark>& bookmarks) {
    if (bookmarks.empty()) return pdf;
    const auto unknown = [] { return fail(ErrorCode::numeric, "the PDF is not as expected: no bookmarks"); };
    const auto size = number_after(pdf, "/Size "), root = number_after(pdf, "/Root "),
               info = number_after(pdf, "/Info "), before = number_after(pdf, "startxref\n");
    if (!size || !root || !info || !before) return unknown();
    auto catalog = object(pdf, *root);
    const auto list = catalog ? number_after(*catalog, "/Pages ") : std::nullopt;
    const auto kids = list ? object(pdf, *list) : std::nullopt;
    const std::vector<std::size_t> pages = kids ? pages_of(*kids) : std::vector<std::size_t>();
    const std::size_t end = catalog ? catalog->rfind(">>") : std::string::npos;
    if (end == std::string::npos) return unknown();
    for (const Bookmark& bookmark : bookmarks)
        if (bookmark.page < 0 || std::size_t(bookmark.page) >= pages.size()) return unknown();
    if (pdf.back() != '\n') pdf += '\n';
    const Outline outline(bookmarks, pages, *size);
    Update update(pdf);
    update.add(*root,
               catalog->substr(0, end) + "/Outlines " + reference(*size) + "\n/PageMode /UseOutlines\n>>");
    update.add(*size, outline.root());
    for (std::size_t i = 0; i < bookmarks.size(); ++i) update.add(*size + 1 + i, outline.item(i));
    update.finish(*size + 1 + bookmarks.size(), *root, *info, *before);
    return pdf;
}

}  // namespace covaria::ui
