// Pages drawn for the screen: those of the PDF at any size, and the headings that begin on them.
#include <gtest/gtest.h>

#include <QDir>
#include <QPainter>
#include <QProcess>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>

#include "tests/core/report/sample_report.h"
#include "ui/print/pdf_report.h"
#include "ui/print/report_pages.h"
#include "ui/theme/fonts.h"

namespace covaria::ui::printed_pages_test {
namespace {

PdfOptions options() {
    PdfOptions made;
    made.paint_plot = [](QPainter& painter, const QRectF& rect, const PlotSpecification& plot) {
        painter.drawEllipse(rect);
        painter.setFont(QFont(text_family(), 8));
        painter.drawText(rect, Qt::AlignCenter, QString::fromStdString(plot.id));
    };
    made.render_scene = [](const SceneBlock&, QSize size) {
        QImage image(size, QImage::Format_RGB32);
        image.fill(Qt::darkGray);
        return image;
    };
    return made;
}

/// The pages of the PDF as poppler sees them.
std::vector<QImage> pages_of_pdf(const ReportDocument& document, int dots_per_inch) {
    const QTemporaryDir folder;
    const QString pdf = folder.filePath(QStringLiteral("report.pdf"));
    const auto written = write_pdf(document, options(), pdf.toStdString());
    EXPECT_TRUE(written);
    QProcess process;
    process.start(QStringLiteral("pdftoppm"),
                  {QStringLiteral("-r"), QString::number(dots_per_inch), QStringLiteral("-png"), pdf,
                   folder.filePath(QStringLiteral("page"))});
    EXPECT_TRUE(process.waitForFinished(120'000)) << "pdftoppm (package poppler-utils)";
    std::vector<QImage> pages;
    for (const QString& name :
         QDir(folder.path()).entryList({QStringLiteral("page-*.png")}, QDir::Files, QDir::Name))
        pages.emplace_back(folder.filePath(name));
    return pages;
}

/// The greatest difference of grey (0 to 255) between cells of a sixth of an inch.
double difference(const QImage& a, const QImage& b, int dots_per_inch) {
    const QSize cells(6 * a.width() / dots_per_inch, 6 * a.height() / dots_per_inch);
    const auto coarse = [&](const QImage& image) {
        return image.convertToFormat(QImage::Format_Grayscale8)
            .scaled(cells, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    };
    const QImage one = coarse(a), other = coarse(b);
    double most = 0.0;
    for (int y = 0; y < cells.height(); ++y)
        for (int x = 0; x < cells.width(); ++x)
            most = std::max(most, std::abs(double(qGray(one.pixel(x, y))) - qGray(other.pixel(x, y))));
    return most;
}

TEST(PrintedPages, AreThoseOfThePdfAtEverySize) {
    const ReportDocument document = test::sample_report();
    const std::vector<PrintedPage> pages = printed_pages(document, options());
    for (const int dots_per_inch : {96, 168}) {
        const std::vector<QImage> printed = pages_of_pdf(document, dots_per_inch);
        ASSERT_EQ(pages.size(), printed.size());
        for (std::size_t i = 0; i < pages.size(); ++i) {
            const QImage shown = page_image(pages[i], dots_per_inch);
            EXPECT_NEAR(shown.width(), printed[i].width(), 1);
            EXPECT_NEAR(shown.height(), printed[i].height(), 1);
            EXPECT_LE(difference(shown, printed[i], dots_per_inch), 40.0)
                << "page " << i + 1 << " at " << dots_per_inch;
        }
    }
}

TEST(PrintedPages, SayWhichHeadingsBeginOnThem) {
    const ReportDocument document = test::sample_report();
    const std::vector<PrintedPage> pages = printed_pages(document, options());
    std::vector<std::string> in_order, stated;
    for (const PrintedPage& page : pages)
        in_order.insert(in_order.end(), page.headings.begin(), page.headings.end());
    for (const ReportBlock& block : document.blocks)
        if (const auto* heading = std::get_if<HeadingBlock>(&block); heading && heading->level <= 2)
            stated.push_back(heading->text);
    EXPECT_GT(stated.size(), 5U);
    EXPECT_EQ(in_order.size(), stated.size());
    EXPECT_GT(std::count_if(pages.begin(), pages.end(),
                            [](const PrintedPage& page) { return !page.headings.empty(); }),
              2);
}

}  // namespace
}  // namespace covaria::ui::printed_pages_test
