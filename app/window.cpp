#include "app/window.h"

#include <QApplication>
#include <QIcon>
#include <cstdlib>

#include "app/exit_status.h"
#include "app/terminal.h"
#include "core/base/resource_path.h"
#include "ui/main_window/main_window.h"

namespace covaria {
namespace {

bool has_display() {
    return std::getenv("DISPLAY") || std::getenv("WAYLAND_DISPLAY") || std::getenv("QT_QPA_PLATFORM");
}

}  // namespace

int run_window(const std::string& file) {
    if (!has_display()) {
        print_message("there is no display to open a window on; \"covaria --help\" lists the commands that need none");
        return exit_bad_input;
    }
    int argc = 1;
    char name[] = "covaria";
    char* argv[] = {name, nullptr};
    QApplication application(argc, argv);
    QApplication::setOrganizationName(QStringLiteral("Covaria"));
    QApplication::setApplicationName(QStringLiteral("Covaria"));
    QApplication::setApplicationVersion(QStringLiteral(COVARIA_VERSION));
    QApplication::setWindowIcon(QIcon(QString::fromStdString((data_directory() / "resources" / "icons" / "covaria.svg").string())));
    ui::MainWindow window;
    window.show();
    window.begin(QString::fromStdString(file));
    return QApplication::exec();
}

}  // namespace covaria
