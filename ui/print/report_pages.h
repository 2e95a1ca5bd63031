// A report laid out on pages for one paint device: a PDF, or drawings for the preview on the screen.
#pragma once

#include <QImage>
#include <QPainter>
#include <QPicture>
#include <string>
#include <vector>

#include "ui/print/flow.h"
#include "ui/print/pdf_report.h"

namespace covaria::ui {

/// Resolution of the PDF, and of everything that shows its pages: lines and pages break in the same places.
constexpr int printed_dots_per_inch = 1200;

class ReportPages {
public:
    /// `document` and `options` must outlive the pages; `device` gives the resolution.
    ReportPages(const ReportDocument& document, const PdfOptions& options, QPaintDevice* device);

    int count() const { return pages_.pages; }
    void paint(int page, QPainter& painter) const;
    /// Headings of the first two levels.
    std::vector<PdfBookmark> bookmarks() const;
    /// Links of the lines of contents to their headings.
    std::vector<PdfLink> links() const;

private:
    /// Height above the bottom of the page in points; `y`: below the top of the text area.
    double height_in_points(double y) const;
    PdfPlace place_of(const PlacedHeading& heading) const;

    const ReportDocument& document_;
    const PdfOptions& options_;
    PageStyle style_;
    FlowedPages pages_;
};

/// A page as it is printed: what was drawn on it, for any size on a screen.
struct PrintedPage {
    QSizeF inches;
    QPicture drawing;                        ///< in units of the printed resolution
    std::vector<std::string> headings = {};  ///< UTF-8: of the first two levels, that begin on it
};

std::vector<PrintedPage> printed_pages(const ReportDocument& document, const PdfOptions& options);

/// The page on white, with `dots_per_inch` pixels an inch.
QImage page_image(const PrintedPage& page, double dots_per_inch);

}  // namespace covaria::ui
