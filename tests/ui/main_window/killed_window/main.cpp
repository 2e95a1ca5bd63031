// The window in a process of its own that types and saves until it is killed; scripts/kill_window does that
// and reads the journal. What an earlier kill left is recovered first. usage: killed_window FILE
// RECOVERY_FOLDER JOURNAL
#include <fcntl.h>
#include <unistd.h>

#include <QApplication>
#include <QDateTime>
#include <QLineEdit>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <cmath>
#include <random>

#include "ui/main_window/main_window.h"
#include "ui/pages/properties_pane.h"

using namespace covaria;
using namespace covaria::ui;

namespace {

/// Lines that are in the file when the call returns, kill or not: "WORD NUMBER MILLISECONDS ...".
class Journal {
public:
    explicit Journal(const char* file) : file_(::open(file, O_WRONLY | O_CREAT | O_APPEND, 0644)) {}
    ~Journal() { ::close(file_); }
    void write(const char* word, long number, long more = 0) const {
        const QByteArray line = QByteArray(word) + ' ' + QByteArray::number(qlonglong(number)) + ' ' +
                                QByteArray::number(QDateTime::currentMSecsSinceEpoch()) + ' ' +
                                QByteArray::number(qlonglong(more)) + '\n';
        if (::write(file_, line.constData(), size_t(line.size())) != line.size()) std::abort();
    }

private:
    int file_;
};

/// The typed number: base_u_x in micrometres.
long number_of(const Project& project) {
    const auto& values = project.analyses.front().setup.values;
    const auto found = values.find("base_u_x");
    const auto* quantity = found == values.end() ? nullptr : std::get_if<Quantity>(&found->second);
    return quantity ? std::lround(quantity->si() * 1e6) : -1;
}

/// Number of files that a killed window left: temporary ones, and recovery entries but this window's own.
long leftovers(const QString& file, const QString& recovery) {
    long found = 0;
    for (const QString& name : QFileInfo(file).dir().entryList(QDir::Files | QDir::Hidden))
        if (name.endsWith(QStringLiteral(".tmp"))) ++found;
    long entries = 0;
    for (const QString& name : QDir(recovery).entryList(QDir::Files | QDir::Hidden)) {
        if (name.endsWith(QStringLiteral(".tmp"))) ++found;
        if (name.endsWith(QStringLiteral(".recovery"))) ++entries;
    }
    return found + std::max(0L, entries - 1);
}

}  // namespace

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("CovariaKilled"));
    if (argc != 4) return 2;
    const QString file = QString::fromLocal8Bit(argv[1]), recovery = QString::fromLocal8Bit(argv[2]);
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, recovery);
    const Journal journal(argv[3]);
    MainWindow window{RecoveryStore(recovery)};
    bool recovered = false;
    window.files().dialogs.recover = [&](const QStringList&) {
        recovered = true;
        return RecoverAnswer{RecoverAnswer::What::recover};
    };
    window.files().dialogs.show_message = [](const QString&, const QString&) {};
    window.show();
    QSignalSpy opened(&window.document(), &Document::open_finished);
    window.begin(file);
    if (!recovered && !opened.wait(60'000)) return 3;
    auto* edit = window.properties().findChild<QLineEdit*>(QStringLiteral("base_u_x"));
    if (!edit) return 4;
    long number = number_of(window.document().project());
    journal.write("start", number, leftovers(file, recovery));
    std::mt19937 random{std::random_device{}()};
    for (int i = 1;; ++i) {
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, QString::number(++number) + QStringLiteral(" um"));
        QTest::keyClick(edit, Qt::Key_Return);
        if (number_of(window.document().project()) != number) return 5;
        journal.write("typed", number);
        if (random() % 12 == 0) {
            if (!window.files().save()) return 6;
            journal.write("saved", number);
        }
        QTest::qWait(int(random() % 60));
    }
}
