// Linked into every test program of ui: the QApplication lives while its tests run, on no display.
#include "tests/ui/qt_application.h"

#include <gtest/gtest.h>

#include <QLocale>
#include <QTemporaryDir>
#include <memory>

namespace {

class ApplicationEnvironment : public testing::Environment {
public:
    void SetUp() override {
        if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
        if (!qEnvironmentVariableIsSet("XDG_RUNTIME_DIR"))
            qputenv("XDG_RUNTIME_DIR", runtime_.path().toLocal8Bit());
        application_ = std::make_unique<QApplication>(count_, words_);
        QLocale::setDefault(QLocale::c());
    }
    /// Before main ends: Qt's own statics must outlive it.
    void TearDown() override { application_.reset(); }

private:
    QTemporaryDir runtime_;
    int count_ = 1;
    char name_[16] = "covaria-test";
    char* words_[2] = {name_, nullptr};
    std::unique_ptr<QApplication> application_;
};

[[maybe_unused]] const auto* const environment =
    testing::AddGlobalTestEnvironment(std::make_unique<ApplicationEnvironment>().release());

}  // namespace
