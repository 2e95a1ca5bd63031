// A report laid out on pages for one paint device: a PDF, or images for the preview on the screen.
#pragma once

#include <QImage>
#include <QPainter>
#include <vector>

#include "ui/print/flow.h"
#include "ui/print/pdf_outline.h"
#include "ui/print/pdf_report.h"

namespace covaria::ui {

/// Of the PDF, and of everything that shows its pages: lines and pages break in the same places.
constexpr int printed_dots_per_inch = 1200;

class ReportPages {
public:
    /// `document` and `options` must outlive the pages; `device` gives the resolution.
    ReportPages(const ReportDocument& document, const PdfOptions& options, QPaintDevice* device);

    int count() const { return pages_.pages; }
    void paint(int page, QPainter& painter) const;
    /// Headings of the first two levels.
    std::vector<Bookmark> bookmarks() const;

private:
    const ReportDocument& document_;
    const PdfOptions& options_;
    PageStyle style_;
    FlowedPages pages_;
};

/// The pages as they are printed, on white, with `dots_per_inch` pixels an inch.
std::vector<QImage> page_images(const ReportDocument& document, const PdfOptions& options, int dots_per_inch);

}  // namespace covaria::ui
