// The editor of equations: typing, the place of a mistake, rows for new names.
#include "ui/forms/lines_editor.h"

#include <gtest/gtest.h>

#include "core/kinds/registries.h"
#include "tests/ui/qt_application.h"
#include "ui/forms/setup_form.h"

namespace covaria::ui::lines_editor_test {
namespace {

// The model whose set-up has a text of several lines.
const ModelDescriptor& model_of_lines() {
    for (const ModelDescriptor& model : model_registry())
        for (const FieldSpec& field : model.schema.fields())
            if (field.several_lines && model.completed) return model;
    throw std::runtime_error("no model has a text of several lines");
}

struct LinesEditorTest : testing::Test {
    LinesEditorTest() {
        Project project;
        AnalysisEntry entry;
        entry.id = "a";
        entry.model = model_of_lines().id;
        entry.setup.values["equations"] = std::string("y = a + b\nz = 2*y");
        project.analyses.push_back(entry);
        document.replace(project);
        form = std::make_unique<SetupForm>(document, SetupAddress{SetupOwner::analysis, "a"});
        form->resize(600, 900);
        form->show();
        editor = dynamic_cast<LinesEditor*>(form->editor("equations"));
    }
    std::string text() const {
        return std::get<std::string>(document.project().analyses[0].setup.values.at("equations"));
    }
    Problems found;
    Document document{[this](const MadeProject&) { return found; }, nullptr};
    std::unique_ptr<SetupForm> form;
    LinesEditor* editor = nullptr;
};

TEST_F(LinesEditorTest, TypingChangesTheProject) {
    ASSERT_NE(editor, nullptr);
    EXPECT_EQ(editor->text_edit()->toPlainText(), "y = a + b\nz = 2*y");
    editor->text_edit()->moveCursor(QTextCursor::End);
    QTest::keyClicks(editor->text_edit(), " + 1");
    EXPECT_EQ(text(), "y = a + b\nz = 2*y + 1");
    document.undo_stack().undo();
    EXPECT_EQ(editor->text_edit()->toPlainText(), "y = a + b\nz = 2*y");
}

TEST_F(LinesEditorTest, MarksThePlaceOfAMistake) {
    found.error("/analyses/0/setup/equations/1/5-7", "line 2, columns 5-7: a length and a temperature");
    document.check_now();
    const auto marks = editor->text_edit()->extraSelections();
    ASSERT_EQ(marks.size(), 1);
    EXPECT_EQ(marks[0].cursor.selectedText(), "2*y");
    EXPECT_EQ(marks[0].cursor.blockNumber(), 1);
    ASSERT_TRUE(form->focus_field("/equations/1/5-7"));
    EXPECT_EQ(editor->text_edit()->textCursor().positionInBlock(), 4);
    found = {};
    document.check_now();
    EXPECT_TRUE(editor->text_edit()->extraSelections().isEmpty());
}

TEST_F(LinesEditorTest, AddsRowsForNewNames) {
    ASSERT_TRUE(editor->completion_button()->isEnabled());
    QTest::mouseClick(editor->completion_button(), Qt::LeftButton);
    const auto& table = std::get<SetupTable>(document.project().analyses[0].setup.values.at("quantities"));
    ASSERT_EQ(table.rows.size(), 2u);
    EXPECT_EQ(table.rows[0][0], SetupCell(std::string("a")));
    EXPECT_EQ(table.rows[1][0], SetupCell(std::string("b")));
    EXPECT_FALSE(editor->completion_button()->isEnabled());
}

}  // namespace
}  // namespace covaria::ui::lines_editor_test
