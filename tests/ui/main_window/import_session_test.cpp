// Importing a robot from URDF in the window: one undo step, a message where it cannot be.
#include <QFile>

#include "tests/ui/main_window/session_fixture.h"
#include "ui/main_window/import_actions.h"

namespace covaria::ui::import_session_test {
namespace {

class ImportSession : public Session {
protected:
    void import(const char* text) {
        answer_.file_to_import = folder_.filePath(QStringLiteral("arm.urdf"));
        QFile file(answer_.file_to_import);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
        file.close();
        window_->imports().urdf_action->trigger();
    }
};

TEST_F(ImportSession, ARobotBecomesAnAssetInOneStep) {
    open(project_copy());
    const std::size_t before = window_->document().project().assets.size();
    import(
        "<robot name=\"Arm\"><joint name=\"a\" type=\"continuous\"><parent link=\"base\"/><child link=\"l\"/>"
        "<axis xyz=\"0 0 1\"/></joint></robot>");
    EXPECT_TRUE(answer_.messages.isEmpty()) << answer_.messages.join(QLatin1Char('\n')).toStdString();
    ASSERT_EQ(window_->document().project().assets.size(), before + 1);
    const AssetEntry& robot = window_->document().project().assets.back();
    EXPECT_EQ(robot.name, "Arm");
    EXPECT_EQ(window_->selection().entry(), (SetupAddress{SetupOwner::asset, robot.id}));
    window_->document().undo_stack().undo();
    EXPECT_EQ(window_->document().project().assets.size(), before);
}

TEST_F(ImportSession, WhatIsNoRobotIsSaidAndLeftOut) {
    open(project_copy());
    const std::size_t before = window_->document().project().assets.size();
    import("<sdf/>");
    ASSERT_EQ(answer_.messages.size(), 1);
    EXPECT_TRUE(answer_.messages[0].contains(QStringLiteral("<robot> is missing")));
    EXPECT_EQ(window_->document().project().assets.size(), before);
}

}  // namespace
}  // namespace covaria::ui::import_session_test
