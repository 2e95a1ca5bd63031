// Bookmarks and links of a PDF; internal to core/pdf.
#pragma once

#include "core/pdf/pdf_archive.h"

class QPDF;

namespace covaria {

/// Throws std::runtime_error where a way begins or ends on a page that is not there.
void add_navigation(QPDF& pdf, const PdfNavigation& navigation);

}  // namespace covaria
