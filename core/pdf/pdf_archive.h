// PDF/A-3b (ISO 19005-3): a page document that carries files.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"

namespace covaria {

/// Relation of an attached file to the document.
enum class AttachedAs {
    source,       ///< the document was made of it
    data,         ///< the document shows it
    alternative,  ///< the same for machines
};

struct AttachedFile {
    std::string name;  ///< may have folders: "data/points.csv"
    std::string bytes;
    std::string mime = {};  ///< "text/csv"
    std::string description = {};
    AttachedAs as = AttachedAs::data;
};

/// Properties of the document, also in its XMP metadata.
struct PdfProperties {
    std::string title, creator;
    std::string author = {};    ///< empty: nobody is named
    std::string language = {};  ///< language of its words: "de", "zh_CN"; empty: unknown
};

/// A height on a page.
struct PdfPlace {
    int page = 0;    ///< counts from 0
    double y = 0.0;  ///< height above the bottom of the page, in points
};
struct PdfBookmark {
    std::string title;  ///< UTF-8
    int level = 1;      ///< bookmarks of a higher level are within the last of a lower one
    PdfPlace to;
};
/// A rectangle that leads to another place of the document.
struct PdfLink {
    int page = 0;                                             ///< counts from 0
    double left = 0.0, bottom = 0.0, right = 0.0, top = 0.0;  ///< edges in points
    PdfPlace to;
};
/// Ways to places of the document.
struct PdfNavigation {
    std::vector<PdfBookmark> bookmarks = {};  ///< bookmarks in the order of the document
    std::vector<PdfLink> links = {};
};

/// Makes a PDF/A-1b (fonts embedded, output intent) a PDF/A-3b with these files, whose names are unique. No
/// clock: equal arguments give equal bytes. Error: it is no PDF that can be read, or a way leads to a page
/// that is not there.
Result<std::string> archived_pdf(const std::string& pdf, const PdfProperties& properties,
                                 const std::vector<AttachedFile>& files,
                                 const PdfNavigation& navigation = {});

/// The files that any PDF carries, by name. Bytes are those attached; `as` is not read. Error: no PDF, one
/// that is encrypted or broken, more than `largest_file` bytes of files.
Result<std::vector<AttachedFile>> files_in_pdf(const std::string& pdf);

}  // namespace covaria
