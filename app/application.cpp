#include "app/application.h"

#include <unistd.h>

#include <QHash>
#include <QLocale>
#include <clocale>
#include <cstdlib>
#include <filesystem>

#include "core/base/version.h"

namespace covaria {
namespace {

/// A folder of a name that nobody can know before, for its owner only; gone with the program.
class PrivateFolder {
public:
    PrivateFolder() {
        std::error_code ignored;
        std::string name =
            (std::filesystem::temp_directory_path(ignored) / "covaria-runtime-XXXXXX").string();
        if (::mkdtemp(name.data())) path_ = name;
    }
    ~PrivateFolder() {
        std::error_code ignored;
        if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
    }
    PrivateFolder(const PrivateFolder&) = delete;
    PrivateFolder& operator=(const PrivateFolder&) = delete;

    const std::string& path() const { return path_; }

private:
    std::string path_;
};

/// Qt warns on the terminal where XDG_RUNTIME_DIR is missing or readable by others.
void provide_runtime_folder() {
    if (std::getenv("XDG_RUNTIME_DIR")) return;
    static const PrivateFolder folder;
    if (!folder.path().empty()) setenv("XDG_RUNTIME_DIR", folder.path().c_str(), 0);
}

}  // namespace

std::unique_ptr<QApplication> make_application(Platform platform) {
    if (platform == Platform::offscreen) setenv("QT_QPA_PLATFORM", "offscreen", 1);
    provide_runtime_folder();
    // A seed of its own would let each process take other fonts for letters that ours lack: other reports.
    QHashSeed::setDeterministicGlobalSeed();
    static int argc = 1;
    static char name[] = "covaria";
    static char* argv[] = {name, nullptr};
    auto application = std::make_unique<QApplication>(argc, argv);
    // Qt takes the locale of the environment for the functions of C, too: libraries would write 0,5 into
    // files.
    std::setlocale(LC_NUMERIC, "C");
    // Commands print and write in the language of the project, wherever they run.
    if (platform == Platform::offscreen) QLocale::setDefault(QLocale::c());
    QApplication::setOrganizationName(QStringLiteral("Covaria"));
    QApplication::setApplicationName(QStringLiteral("Covaria"));
    QApplication::setApplicationVersion(QString::fromLatin1(version()));
    return application;
}

}  // namespace covaria
