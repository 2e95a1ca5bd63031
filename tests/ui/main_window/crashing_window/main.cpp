// The window in a process of its own: opens a file, types an edit that autosave writes and half of another,
// and is killed. usage: crashing_window FILE RECOVERY_FOLDER
#include <QApplication>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <csignal>

#include "ui/main_window/main_window.h"
#include "ui/pages/properties_pane.h"

using namespace covaria::ui;

namespace {

QLineEdit* field(MainWindow& window, const char* name) {
    return window.properties().findChild<QLineEdit*>(QString::fromLatin1(name));
}

bool has_recovery_file(const QString& folder) {
    return !QDir(folder).entryList({QStringLiteral("*.recovery")}, QDir::Files).isEmpty();
}

}  // namespace

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("CovariaTest"));
    if (argc != 3) return 2;
    const QString folder = QString::fromLocal8Bit(argv[2]);
    MainWindow window{RecoveryStore(folder)};
    window.show();
    QSignalSpy opened(&window.document(), &Document::open_finished);
    window.begin(QString::fromLocal8Bit(argv[1]));
    if (!opened.wait(20'000) || !field(window, "base_u_x")) return 3;
    QLineEdit* edit = field(window, "base_u_x");
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, QStringLiteral("0.123 mm"));
    QTest::keyClick(edit, Qt::Key_Return);
    if (!QTest::qWaitFor([&] { return has_recovery_file(folder); }, 20'000)) return 4;
    QTest::keyClicks(field(window, "base_u_y"), QStringLiteral("9"));
    return std::raise(SIGKILL);
}
