// A context mesh added, its file chosen, seen, and hidden, through the window.
#include "core/base/file_io.h"
#include "tests/stl_files.h"
#include "tests/ui/main_window/session_fixture.h"
#include "ui/forms/file_editor.h"

namespace covaria::ui::context_session_test {
namespace {

using ContextSession = Session;

TEST_F(ContextSession, AMeshIsAddedChosenAndSeen) {
    open(project_copy());
    wait_until_idle();
    ASSERT_FALSE(scene_picture().isNull());
    const auto result = status().result;
    const QString file = folder_.filePath(QStringLiteral("floor.stl"));
    ASSERT_TRUE(
        write_file_atomically(to_path(file), test::binary_stl(test::rectangle(-500, -500, 500, 500, 0))));

    const QString analysis = window_->selection().analysis();
    trigger(QStringLiteral("Context mesh"));
    auto* editor = window_->properties().findChild<FileEditor*>();
    ASSERT_NE(editor, nullptr);
    editor->choose(file);
    EXPECT_EQ(field<QLineEdit>("file")->text(), QStringLiteral("floor.stl")) << "beside the project";
    wait_until_idle();
    EXPECT_TRUE(problems().isEmpty()) << problems().join(QLatin1Char('\n')).toStdString();
    EXPECT_EQ(window_->runner().status(analysis).result, result) << "the result is that of before";

    SceneView& view = window_->scene().view();
    ASSERT_TRUE(wait_for([&] { return view.scene() && view.scene()->meshes.size() == 1; }, 10'000));
    const QImage shown = scene_picture();
    view.set_visibility({{view.scene()->meshes.front().item.id}, {}});
    EXPECT_TRUE(wait_for([&] { return scene_picture() != shown; }, 10'000)) << "hidden";
    view.set_visibility({});
    EXPECT_TRUE(wait_for([&] { return scene_picture() == shown; }, 10'000));
    while (window_->document().undo_stack().canUndo()) window_->document().undo_stack().undo();
    EXPECT_TRUE(wait_for([&] { return view.scene() && view.scene()->meshes.empty(); }, 10'000));
}

}  // namespace
}  // namespace covaria::ui::context_session_test
