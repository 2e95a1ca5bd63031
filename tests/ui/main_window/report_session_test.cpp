// Documents leave the window: the report on paper is that of the preview and of the command line, page by
// page, and only results leave it, no previews.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineEdit>
#include <QPainter>
#include <QProcess>
#include <QSvgRenderer>

#include "core/base/file_io.h"
#include "core/pdf/pdf_archive.h"
#include "tests/ui/main_window/session_fixture.h"
#include "ui/main_window/export_actions.h"
#include "ui/pages/outputs_tab.h"
#include "ui/pages/report_preview.h"
#include "ui/pages/sortable_table.h"
#include "ui/pages/stage.h"

namespace covaria::ui::report_session_test {
namespace {

class ReportSession : public Session {
protected:
    /// Writes the report from the window and waits for it.
    void export_report(const QString& file, ReportFormat format) {
        QSignalSpy finished(&window_->exports(), &ExportActions::finished);
        window_->exports().export_document_to(file, DocumentKind::report, format);
        ASSERT_TRUE(wait_for([&] { return !finished.empty(); }, 120'000));
        EXPECT_EQ(finished[0][1].toString(), QString());
    }
    const std::vector<QImage>& preview() {
        auto* report = window_->results().findChild<ReportPreview*>();
        window_->results().stage().show_view(report);
        EXPECT_TRUE(wait_for([&] { return report->page_count() > 0; }, 120'000));
        return report->pages();
    }
    static void run(const QString& program, const QStringList& arguments) {
        QProcess process;
        process.start(program, arguments);
        EXPECT_TRUE(process.waitForFinished(300'000)) << program.toStdString();
        EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
    }
    /// The pages of a PDF as pictures of 96 dots an inch.
    std::vector<QImage> pages_of(const QString& pdf) {
        const QString stem = pdf + QStringLiteral("-page");
        run(QStringLiteral("pdftoppm"),
            {QStringLiteral("-r"), QStringLiteral("96"), QStringLiteral("-png"), pdf, stem});
        const QFileInfo info(stem);
        std::vector<QImage> pages;
        for (const QString& name :
             info.dir().entryList({info.fileName() + QStringLiteral("-*.png")}, QDir::Files, QDir::Name))
            pages.emplace_back(info.dir().filePath(name));
        return pages;
    }
    /// The greatest difference of grey (0 to 255) between cells of 16 pixels: text set in another way differs
    /// by little, text in another place or of another size by much.
    static double difference(const QImage& a, const QImage& b) {
        const QSize cells(a.width() / 16, a.height() / 16);
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
    void expect_same_pages(const std::vector<QImage>& a, const std::vector<QImage>& b, double most,
                           const char* what) {
        ASSERT_EQ(a.size(), b.size()) << what;
        for (std::size_t i = 0; i < a.size(); ++i) {
            const double found = difference(a[i], b[i]);
            EXPECT_LE(found, most) << what << ", page " << i + 1;
            if (found <= most) continue;
            leave(a[i], "one", i);
            leave(b[i], "other", i);
        }
    }
    /// Leaves the picture in the build folder, for people.
    static void leave(const QImage& image, const char* what, std::size_t page) {
        const QDir folder(QStringLiteral(COVARIA_BINARY_DIR "/screenshots"));
        folder.mkpath(QStringLiteral("."));
        image.save(
            folder.filePath(QStringLiteral("report-%1-%2.png").arg(QString::fromLatin1(what)).arg(page + 1)));
    }
};

TEST_F(ReportSession, TheWindowsPdfIsThePreviewAndThatOfTheCommandLine) {
    const QString project = project_copy();
    open(project);
    wait_until_idle();
    const QString pdf = folder_.filePath(QStringLiteral("window.pdf"));
    export_report(pdf, ReportFormat::pdf);
    const std::vector<QImage> of_window = pages_of(pdf);
    ASSERT_GT(of_window.size(), 10U);
    for (std::size_t i = 0; i < of_window.size(); ++i) leave(of_window[i], "window", i);
    expect_same_pages(of_window, preview(), 40.0, "window and preview");
    const QString out = folder_.filePath(QStringLiteral("out"));
    run(QStringLiteral(COVARIA_PROGRAM), {QStringLiteral("report"), project, QStringLiteral("--format"),
                                          QStringLiteral("pdf"), QStringLiteral("--out"), out});
    expect_same_pages(of_window, pages_of(out + QStringLiteral("/report.pdf")), 0.0,
                      "window and command line");
    const auto carried = [](const QString& file) {
        return files_in_pdf(read_file(to_path(file)).value()).value();
    };
    const auto by_window = carried(pdf), by_program = carried(out + QStringLiteral("/report.pdf"));
    ASSERT_EQ(by_window.size(), by_program.size());
    ASSERT_GE(by_window.size(), 3U) << "project, results, budgets";
    for (std::size_t i = 0; i < by_window.size(); ++i) {
        EXPECT_EQ(by_window[i].name, by_program[i].name);
        EXPECT_EQ(by_window[i].bytes, by_program[i].bytes) << by_window[i].name;
    }
    open(pdf);
    EXPECT_TRUE(window_->windowTitle().contains(QStringLiteral("(from window.pdf)")))
        << window_->windowTitle().toStdString();
}

TEST_F(ReportSession, ChartsOfTheHtmlReportFillTheirFrames) {
    open(project_copy(QStringLiteral("lsm-network")));
    wait_until_idle();
    export_report(folder_.filePath(QStringLiteral("report.html")), ReportFormat::html);
    const QStringList charts = QDir(folder_.path()).entryList({QStringLiteral("*.svg")}, QDir::Files);
    ASSERT_FALSE(charts.isEmpty());
    for (const QString& name : charts) {
        QSvgRenderer svg(folder_.filePath(name));
        QImage image(svg.defaultSize(), QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        svg.render(&painter);
        painter.end();
        int right = 0, bottom = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                if (qGray(image.pixel(x, y)) < 200) {
                    right = std::max(right, x);
                    bottom = std::max(bottom, y);
                }
        EXPECT_GT(right, 0.8 * image.width()) << name.toStdString();
        EXPECT_GT(bottom, 0.85 * image.height()) << name.toStdString();
    }
}

TEST_F(ReportSession, APreviewIsNoResult) {
    open(project_copy());
    wait_until_idle();
    show_group(QStringLiteral("Options"));
    type_into("trials", QStringLiteral("30000000"));
    ASSERT_TRUE(wait_for([this] { return status().stage == ResultStage::preview; }));
    EXPECT_FALSE(status().is_current());
    const QString preview = window_->results().outputs().table().csv();
    EXPECT_TRUE(preview.contains(QStringLiteral("Preview"))) << "a table that is saved says what it is";

    const QString pdf = folder_.filePath(QStringLiteral("early.pdf"));
    window_->exports().export_document_to(pdf, DocumentKind::report, ReportFormat::pdf);
    EXPECT_FALSE(window_->exports().is_busy()) << "the export waits";
    trigger(QStringLiteral("Stop"));
    ASSERT_TRUE(window_->runner().wait_until_idle(10'000));
    EXPECT_EQ(status().stage, ResultStage::preview) << "what there was is still shown";
    EXPECT_FALSE(status().is_current());

    // The second analysis has its result: it alone is reported, and the report names the other.
    const QString page = folder_.filePath(QStringLiteral("report.html"));
    ASSERT_TRUE(wait_for([this] { return !window_->exports().is_busy(); }, 120'000));
    trigger(QStringLiteral("Live"));
    export_report(page, ReportFormat::html);
    QFile file(page);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QString html = QString::fromUtf8(file.readAll());
    EXPECT_TRUE(html.contains(QStringLiteral("Not in this report")));
    EXPECT_FALSE(html.contains(QStringLiteral("12\u202f000 trials, 30"))) << "no preview in it";
}

/// The failures that a results.json lists.
QJsonArray failed_in(const QString& folder) {
    QFile file(folder + QStringLiteral("/results.json"));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << file.fileName().toStdString();
    return QJsonDocument::fromJson(file.readAll()).object()[QStringLiteral("failed")].toArray();
}

TEST_F(ReportSession, ResultsNameWhatFailedAsTheCommandLineDoes) {
    Project project = load_project(COVARIA_SOURCE_DIR "/tests/fuzz/corpus/att3.covaria").project;
    for (AnalysisEntry& analysis : project.analyses) analysis.options.method = Method::first_order;
    const QString file = folder_.filePath(QStringLiteral("att3.covaria"));
    ASSERT_TRUE(save_project(project, to_path(file)));
    open(file);
    window_->runner().run_all();
    wait_until_idle();
    const QString ours = folder_.filePath(QStringLiteral("window")),
                  theirs = folder_.filePath(QStringLiteral("line"));
    ASSERT_TRUE(QDir().mkpath(ours));
    QSignalSpy finished(&window_->exports(), &ExportActions::finished);
    window_->exports().export_results_to(ours);
    ASSERT_TRUE(wait_for([&] { return !finished.empty(); }, 120'000));
    QProcess process;
    process.start(QStringLiteral(COVARIA_PROGRAM),
                  {QStringLiteral("run"), file, QStringLiteral("--out"), theirs});
    ASSERT_TRUE(process.waitForFinished(300'000));
    EXPECT_EQ(process.exitCode(), 1) << "one analysis has no result";
    ASSERT_FALSE(failed_in(theirs).isEmpty());
    EXPECT_EQ(failed_in(ours), failed_in(theirs));
}

TEST_F(ReportSession, WhatIsTypedCountsInRunsAndExports) {
    open(project_copy());
    wait_until_idle();
    trigger(QStringLiteral("Live"));
    const double before = expanded_uncertainty(2);
    auto* edit = field<QLineEdit>("base_u_z");
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, QStringLiteral("1.05 mm"));
    QTest::keyClick(window_.get(), Qt::Key_F5);
    wait_until_idle();
    EXPECT_GT(expanded_uncertainty(2), 2.0 * before);
    EXPECT_TRUE(status().is_current());

    edit->selectAll();
    QTest::keyClicks(edit, QStringLiteral("1.5 mm"));
    answer_.file_to_save = folder_.filePath(QStringLiteral("typed.pdf"));
    trigger(QStringLiteral("Report as PDF"));
    EXPECT_TRUE(bytes().find("1.5") != std::string::npos) << "taken over before the report is made";
}

TEST_F(ReportSession, ResultsCarryTheNamesOfNow) {
    open(project_copy());
    wait_until_idle();
    select(SetupOwner::analysis, "from-artefacts");
    const ResultPointer before = status().result;
    const Project& project = window_->document().project();
    std::string asset;
    for (const AssetEntry& entry : project.assets)
        for (const auto& component : before->inputs->components)
            if (asset.empty() && !entry.name.empty() && component.contributor == entry.id) asset = entry.id;
    ASSERT_FALSE(asset.empty()) << "the example has a contributor";
    window_->document().apply(QStringLiteral("Rename"), [&](Project& changed) {
        for (AssetEntry& entry : changed.assets)
            if (entry.id == asset) entry.name = "Quite another name";
    });
    wait_until_idle();
    EXPECT_TRUE(status().is_current()) << "a name makes no result out of date";
    EXPECT_EQ(status().result->trials, before->trials);
    const auto has = [this](const std::string& name) {
        const auto& all = status().result->inputs->components;
        return std::any_of(all.begin(), all.end(), [&](const auto& c) { return c.contributor_name == name; });
    };
    EXPECT_TRUE(has("Quite another name"));
    for (const ContributorResult& one : status().result->contributors) EXPECT_TRUE(has(one.contributor));
}

}  // namespace
}  // namespace covaria::ui::report_session_test
