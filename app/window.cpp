#include "app/window.h"

#include <QIcon>
#include <cstdlib>

#include "app/application.h"
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
        print_message(
            "there is no display to open a window on; \"covaria --help\" lists the commands that need none");
        return exit_bad_input;
    }
    const auto application = make_application(Platform::of_the_desktop);
    QApplication::setWindowIcon(
        QIcon(QString::fromStdString((data_directory() / "resources" / "icons" / "covaria.svg").string())));
    ui::MainWindow window;
    window.show();
    window.begin(QString::fromStdString(file));
    return QApplication::exec();
}

}  // namespace covaria
