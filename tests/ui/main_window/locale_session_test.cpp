// The window writes alike, whatever locale the desktop gives to the functions of C.
#include <QDir>
#include <QDirIterator>
#include <clocale>
#include <map>

#include "core/base/file_io.h"
#include "core/writers/writers.h"
#include "tests/locales.h"
#include "tests/ui/main_window/session_fixture.h"
#include "ui/main_window/export_actions.h"
#include "ui/theme/strings.h"

namespace covaria::ui::locale_session_test {
namespace {

/// The locale of the process, while this lives: as Qt sets it where nobody takes care.
class ProcessLocale {
public:
    explicit ProcessLocale(const std::string& name) : before_(std::setlocale(LC_ALL, nullptr)) {
        EXPECT_NE(std::setlocale(LC_ALL, name.c_str()), nullptr) << "the locale " << name << " is not there";
    }
    ~ProcessLocale() { std::setlocale(LC_ALL, before_.c_str()); }
    ProcessLocale(const ProcessLocale&) = delete;
    ProcessLocale& operator=(const ProcessLocale&) = delete;

private:
    std::string before_;
};

class LocaleSession : public Session {
protected:
    using Files = std::map<QString, std::string>;

    void export_all(const QString& folder) {
        ExportActions& exports = window_->exports();
        const auto wait = [&](const auto& begin) {
            QSignalSpy finished(&exports, &ExportActions::finished);
            begin();
            ASSERT_TRUE(wait_for([&] { return !finished.empty(); }, 120'000));
            EXPECT_EQ(finished[0][1].toString(), QString());
        };
        wait([&] {
            exports.export_document_to(folder + "/report.pdf", DocumentKind::report, ReportFormat::pdf);
        });
        wait([&] {
            exports.export_document_to(folder + "/report.html", DocumentKind::report, ReportFormat::html);
        });
        wait([&] { exports.export_results_to(folder + "/results"); });
        for (const Writer& writer : writer_registry())
            if (writer.name == "xlsx")
                wait([&] { exports.export_for_others(writer, folder + "/budget.xlsx"); });
    }

    Files exported_in(const std::string& locale) {
        const ProcessLocale process(locale);
        const QString folder = folder_.filePath(QStringLiteral("out"));
        QDir(folder).removeRecursively();
        QDir().mkpath(folder + QStringLiteral("/results"));
        export_all(folder);
        Files files;
        for (QDirIterator entry(folder, QDir::Files, QDirIterator::Subdirectories); entry.hasNext();) {
            const QString file = entry.next();
            files[QDir(folder).relativeFilePath(file)] = *read_file(to_path(file));
        }
        return files;
    }
};

TEST_F(LocaleSession, EveryFileIsTheSame) {
    covaria::test::locale_folder();
    ASSERT_FALSE(HasFailure());
    open(project_copy(QStringLiteral("chain")));
    window_->runner().run_all();
    wait_until_idle();
    const Files plain = exported_in("C");
    EXPECT_TRUE(plain.contains("budget.xlsx") && plain.contains("report.pdf"));
    for (const std::string& locale : covaria::test::foreign_locales()) {
        const Files foreign = exported_in(locale + ".UTF-8");
        EXPECT_EQ(foreign.size(), plain.size()) << locale;
        for (const auto& [name, bytes] : plain)
            EXPECT_TRUE(foreign.contains(name) && foreign.at(name) == bytes)
                << locale << ": " << name.toStdString();
    }
}

}  // namespace
}  // namespace covaria::ui::locale_session_test
