#include "app/window.h"

#include <QIcon>
#include <QScreen>
#include <QString>
#include <QStyle>
#include <cstdlib>

#include "app/application.h"
#include "app/exit_status.h"
#include "app/terminal.h"
#include "core/base/resource_path.h"
#include "ui/main_window/main_window.h"
#include "ui/theme/languages.h"

namespace covaria {
namespace {

bool has_display() {
    return std::getenv("DISPLAY") || std::getenv("WAYLAND_DISPLAY") || std::getenv("QT_QPA_PLATFORM");
}

// Prints Qt's messages. A fatal one (the display cannot be used: a wrong name, no permission, a missing
// plugin) ends the process with a sentence, where Qt would abort it.
void end_with_a_sentence(QtMsgType type, const QMessageLogContext&, const QString& message) {
    if (type != QtFatalMsg) return print_message(message.toStdString());
    QString first = message.section(QLatin1Char('\n'), 0, 0);
    print_message("the window cannot be opened: " + first.toStdString() +
                  " \"covaria --help\" lists the commands that need no display");
    std::_Exit(exit_bad_input);
}

/// Maximised where it would not fit onto the screen with its frame.
void show(QWidget& window) {
    const QSize screen = window.screen()->availableSize();
    const int title_bar = window.style()->pixelMetric(QStyle::PM_TitleBarHeight);
    if (window.width() > screen.width() || window.height() + title_bar > screen.height())
        window.showMaximized();
    else
        window.show();
}

}  // namespace

int run_window(const std::string& file, const std::string& language) {
    if (!has_display()) {
        print_message(
            "there is no display to open a window on; \"covaria --help\" lists the commands that need none");
        return exit_bad_input;
    }
    const QtMessageHandler before = qInstallMessageHandler(end_with_a_sentence);
    const auto application = make_application(Platform::of_the_desktop);
    qInstallMessageHandler(before);
    QApplication::setWindowIcon(
        QIcon(QString::fromStdString((data_directory() / "resources" / "icons" / "covaria.svg").string())));
    ui::speak_as_preferred(QString::fromStdString(language));
    ui::MainWindow window;
    show(window);
    window.begin(QString::fromStdString(file));
    return QApplication::exec();
}

std::string languages_of_window() {
    std::string codes;
    for (const ui::Language& offered : ui::offered_languages())
        codes += (codes.empty() ? "" : ", ") + offered.code.toStdString();
    return codes;
}

std::string complaint_about_language(const std::string& code) {
    if (!ui::offered_language(QString::fromStdString(code)).isEmpty()) return {};
    return "there is no language \"" + code + "\"; there are: " + languages_of_window();
}

}  // namespace covaria
