// Bookmarks (ISO 32000-1 12.3.3) and link annotations (12.5.6.5), with destinations that no name stands for.
#include "core/pdf/pdf_navigation.h"

#include <qpdf/QPDF.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <stdexcept>

namespace covaria {

namespace {

using Pages = std::vector<QPDFPageObjectHelper>;

QPDFObjectHandle page_at(const Pages& pages, int page) {
    if (page < 0 || static_cast<std::size_t>(page) >= pages.size())
        throw std::runtime_error("a bookmark or link leads to a page that is not there");
    return pages[static_cast<std::size_t>(page)].getObjectHandle();
}

QPDFObjectHandle decimal(double points) {
    return QPDFObjectHandle::newReal(points, 1);
}

/// Destination at that height, at the size the reader has chosen.
QPDFObjectHandle destination(const Pages& pages, const PdfPlace& place) {
    const QPDFObjectHandle zero = QPDFObjectHandle::newInteger(0);
    return QPDFObjectHandle::newArray(
        {page_at(pages, place.page), QPDFObjectHandle::newName("/XYZ"), zero, decimal(place.y), zero});
}

/// A node of the outline: what is below it, in order.
struct OutlineNode {
    QPDFObjectHandle item;
    int level = 0;
    std::vector<std::size_t> below = {};
};

/// Node 0 is the root; node i + 1 is bookmark i.
std::vector<OutlineNode> outline_of(QPDF& pdf, const Pages& pages,
                                    const std::vector<PdfBookmark>& bookmarks) {
    const auto fresh = [&] { return pdf.makeIndirectObject(QPDFObjectHandle::newDictionary()); };
    std::vector<OutlineNode> nodes{{fresh()}};
    std::vector<std::size_t> path{0};  // levels from the root to the last bookmark
    for (const PdfBookmark& bookmark : bookmarks) {
        while (path.size() > 1 && nodes[path.back()].level >= bookmark.level) path.pop_back();
        nodes.push_back({fresh(), bookmark.level});
        OutlineNode& node = nodes.back();
        node.item.replaceKey("/Title", QPDFObjectHandle::newUnicodeString(bookmark.title));
        node.item.replaceKey("/Parent", nodes[path.back()].item);
        node.item.replaceKey("/Dest", destination(pages, bookmark.to));
        nodes[path.back()].below.push_back(nodes.size() - 1);
        path.push_back(nodes.size() - 1);
    }
    return nodes;
}

/// First, last and number of what is below a node, and who stands beside whom. Only the root is open.
void link_children(const std::vector<OutlineNode>& nodes, std::size_t at) {
    const OutlineNode& node = nodes[at];
    if (node.below.empty()) return;
    QPDFObjectHandle item = node.item;
    item.replaceKey("/First", nodes[node.below.front()].item);
    item.replaceKey("/Last", nodes[node.below.back()].item);
    const auto count = static_cast<long long>(node.below.size());
    item.replaceKey("/Count", QPDFObjectHandle::newInteger(at == 0 ? count : -count));
    for (std::size_t i = 1; i < node.below.size(); ++i) {
        QPDFObjectHandle before = nodes[node.below[i - 1]].item, here = nodes[node.below[i]].item;
        before.replaceKey("/Next", here);
        here.replaceKey("/Prev", before);
    }
}

void add_bookmarks(QPDF& pdf, const Pages& pages, const std::vector<PdfBookmark>& bookmarks) {
    if (bookmarks.empty()) return;
    std::vector<OutlineNode> nodes = outline_of(pdf, pages, bookmarks);
    nodes.front().item.replaceKey("/Type", QPDFObjectHandle::newName("/Outlines"));
    for (std::size_t i = 0; i < nodes.size(); ++i) link_children(nodes, i);
    pdf.getRoot().replaceKey("/Outlines", nodes.front().item);
    pdf.getRoot().replaceKey("/PageMode", QPDFObjectHandle::newName("/UseOutlines"));
}

/// Printed like the page (ISO 19005-3 6.3.2: of the flags only Print), without a frame.
void add_link(QPDF& pdf, const Pages& pages, const PdfLink& link) {
    QPDFObjectHandle annotation = QPDFObjectHandle::newDictionary();
    annotation.replaceKey("/Type", QPDFObjectHandle::newName("/Annot"));
    annotation.replaceKey("/Subtype", QPDFObjectHandle::newName("/Link"));
    annotation.replaceKey("/Rect", QPDFObjectHandle::newArray({decimal(link.left), decimal(link.bottom),
                                                               decimal(link.right), decimal(link.top)}));
    const QPDFObjectHandle zero = QPDFObjectHandle::newInteger(0);
    annotation.replaceKey("/Border", QPDFObjectHandle::newArray({zero, zero, zero}));
    annotation.replaceKey("/F", QPDFObjectHandle::newInteger(4));
    annotation.replaceKey("/Dest", destination(pages, link.to));
    QPDFObjectHandle page = page_at(pages, link.page);
    if (!page.getKey("/Annots").isArray()) page.replaceKey("/Annots", QPDFObjectHandle::newArray());
    page.getKey("/Annots").appendItem(pdf.makeIndirectObject(annotation));
}

}  // namespace

void add_navigation(QPDF& pdf, const PdfNavigation& navigation) {
    const Pages pages = QPDFPageDocumentHelper(pdf).getAllPages();
    add_bookmarks(pdf, pages, navigation.bookmarks);
    for (const PdfLink& link : navigation.links) add_link(pdf, pages, link);
}

}  // namespace covaria
