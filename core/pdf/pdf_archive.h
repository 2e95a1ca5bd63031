// PDF/A-3b (ISO 19005-3): a page document that carries files.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"

namespace covaria {

/// What an attached file is to the document.
enum class AttachedAs {
    source,       ///< what the document was made of
    data,         ///< what it shows
    alternative,  ///< the same for machines
};

struct AttachedFile {
    std::string name;  ///< may have folders: "data/points.csv"
    std::string bytes;
    std::string mime = {};  ///< "text/csv"
    std::string description = {};
    AttachedAs as = AttachedAs::data;
};

/// What the document says of itself, in its properties and alike in its XMP metadata.
struct PdfProperties {
    std::string title, creator;
};

/// Makes a PDF/A-1b (fonts embedded, output intent) a PDF/A-3b with these files, whose names are unique. No
/// clock: equal arguments give equal bytes. Error{io}: it is no PDF that can be read.
Result<std::string> archived_pdf(const std::string& pdf, const PdfProperties& properties,
                                 const std::vector<AttachedFile>& files);

/// The files that any PDF carries, by name. Bytes are those attached; `as` is not read. Error: no PDF, one
/// that is encrypted or broken, more than `largest_file` bytes of files.
Result<std::vector<AttachedFile>> files_in_pdf(const std::string& pdf);

}  // namespace covaria
