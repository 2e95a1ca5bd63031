#include "app/application.h"

#include <unistd.h>

#include <QHash>
#include <cstdlib>
#include <filesystem>

#include "core/base/version.h"

namespace covaria {
namespace {

/// Qt warns on the terminal where XDG_RUNTIME_DIR is missing or readable by others.
void provide_runtime_folder() {
    if (std::getenv("XDG_RUNTIME_DIR")) return;
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::path folder =
        fs::temp_directory_path(ignored) / ("covaria-runtime-" + std::to_string(getuid()));
    fs::create_directory(folder, ignored);
    fs::permissions(folder, fs::perms::owner_all, ignored);
    setenv("XDG_RUNTIME_DIR", folder.c_str(), 0);
}

}  // namespace

std::unique_ptr<QApplication> make_application(Platform platform) {
    if (platform == Platform::offscreen) setenv("QT_QPA_PLATFORM", "offscreen", 1);
    provide_runtime_folder();
    // With seeds of its own each process would take other fonts for letters that ours lack: other reports.
    QHashSeed::setDeterministicGlobalSeed();
    static int argc = 1;
    static char name[] = "covaria";
    static char* argv[] = {name, nullptr};
    auto application = std::make_unique<QApplication>(argc, argv);
    QApplication::setOrganizationName(QStringLiteral("Covaria"));
    QApplication::setApplicationName(QStringLiteral("Covaria"));
    QApplication::setApplicationVersion(QString::fromLatin1(version()));
    return application;
}

}  // namespace covaria
