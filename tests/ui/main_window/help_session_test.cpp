// F1 in the real window: every editor, cell and entry is answered by its own help.
#include <QDockWidget>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QTextBrowser>

#include "core/manual/help_page.h"
#include "core/text/symbol.h"
#include "tests/ui/main_window/session_fixture.h"
#include "ui/document/setup_address.h"
#include "ui/forms/setup_form.h"
#include "ui/forms/table_editor.h"
#include "ui/main_window/help_actions.h"
#include "ui/pages/help_pane.h"

namespace covaria::ui::help_session_test {
namespace {

class HelpSession : public Session {
protected:
    HelpPane& pane() { return window_->help().pane(); }
    void press_f1() {
        QWidget* focus = QApplication::focusWidget();
        QTest::keyClick(focus ? focus : window_.get(), Qt::Key_F1);
    }
    /// The pane is at the field and shows its title.
    void expect_help_of(const std::string& title, const QString& anchor) {
        EXPECT_EQ(to_std(pane().place()), to_std(anchor));
        const std::string words = to_std(pane().words_at_place());
        EXPECT_NE(words.find(running_text(title).letters()), std::string::npos)
            << anchor.toStdString() << ": " << words;
    }

    void ask_everywhere(const SetupAddress& entry) {
        window_->selection().select_entry(entry);
        const Project& project = window_->document().project();
        SetupForm* form = window_->properties().setup_form();
        ASSERT_NE(form, nullptr);
        for (const FieldSpec& field : find_schema(project, entry)->fields()) {
            if (!is_shown(*find_schema(project, entry), field, *find_setup(project, entry))) continue;
            ASSERT_TRUE(form->focus_field('/' + field.key)) << field.key;
            auto* table = dynamic_cast<TableEditor*>(form->editor(field.key));
            if (!table || table->model().rowCount() == 0) {
                press_f1();
                expect_help_of(field.title, help_anchor(project, entry, field.key));
                ++asked_;
                continue;
            }
            for (int c = 0; c < table->model().columnCount(); ++c) {
                const ColumnSpec& column = field.columns[std::size_t(c)];
                table->view().setCurrentIndex(table->model().index(0, c));
                press_f1();
                expect_help_of(column.title, help_anchor(project, entry, field.key, column.key));
                ++asked_;
            }
        }
    }

    int asked_ = 0;
};

/// The place is in the picture, not only in the document: words below the tables of a page were not drawn.
TEST_F(HelpSession, ThePlaceIsSeen) {
    trigger(QStringLiteral("New Project"));
    trigger(QStringLiteral("Measurement equation"));
    QWidget* equations = window_->properties().findChild<QPlainTextEdit*>(QStringLiteral("equations"));
    ASSERT_TRUE(wait_for([&] { return equations->hasFocus(); }, 2000)) << "what was added takes the keyboard";
    for (const char* field : {"equations", "observations"}) {
        ASSERT_TRUE(window_->properties().setup_form()->focus_field(std::string("/") + field)) << field;
        press_f1();
        QWidget& view = *pane().browser().viewport();
        const auto ink = [&view] {
            const QImage picture = view.grab().toImage();
            int dark = 0;
            for (int y = 0; y < picture.height(); ++y)
                for (int x = 0; x < picture.width(); ++x) dark += qGray(picture.pixel(x, y)) < 100;
            return dark;
        };
        EXPECT_TRUE(wait_for([&] { return ink() > 200; }, 2000)) << field << ": " << ink();
        EXPECT_EQ(pane().browser().horizontalScrollBar()->value(), 0);
    }
}

TEST_F(HelpSession, EveryEditorOfTheExamplesAnswersWithItsOwnField) {
    const QDir projects(QStringLiteral(COVARIA_SOURCE_DIR "/projects"));
    QStringList names;
    for (const QString& file : projects.entryList({QStringLiteral("*.covaria")}))
        names << QFileInfo(file).completeBaseName();
    ASSERT_GE(names.size(), 8);
    for (const QString& name : names) {
        open(project_copy(name));
        window_->runner().stop_all();
        for (const AssetEntry& asset : Project(window_->document().project()).assets)
            ask_everywhere({SetupOwner::asset, asset.id});
        for (const AnalysisEntry& analysis : Project(window_->document().project()).analyses)
            ask_everywhere({SetupOwner::analysis, analysis.id});
    }
    EXPECT_GT(asked_, 500);
}

/// The place is in view even if the pane opens with it, whose text gets its width only then.
TEST_F(HelpSession, ThePlaceIsInView) {
    open(project_copy());
    select(SetupOwner::analysis, "printed");
    wait_until_idle();
    auto* table = sheet("base_points");
    table->setFocus();
    table->setCurrentIndex(table->model()->index(1, 1));
    press_f1();
    settle();
    auto* browser = pane().findChild<QTextBrowser*>();
    const auto is_in_view = [&] {
        const QTextCursor at = browser->extraSelections().value(0).cursor;
        const QRect place = browser->cursorRect(at);
        return !at.isNull() && browser->viewport()->rect().contains(place.center());
    };
    EXPECT_TRUE(wait_for(is_in_view, 2000));
    window_->grab().save(QStringLiteral(COVARIA_BINARY_DIR "/screenshots/help-of-a-cell.png"));
}

TEST_F(HelpSession, AnEntryOfTheTreeAnswersWithItsKind) {
    open(project_copy());
    click_in_tree(to_qt(window_->document().project().assets.front().name));
    press_f1();
    EXPECT_EQ(to_std(pane().place()), "asset-" + window_->document().project().assets.front().kind);
    EXPECT_TRUE(pane().isVisible());
}

TEST_F(HelpSession, ATextOfTheCertificateAnswersWithItsClause) {
    open(project_copy());
    window_->selection().select_entry(project_address);
    show_group(QStringLiteral("Certificate"));
    window_->properties().focus_field(QStringLiteral("/certificate/item/serialNumber"));
    press_f1();
    EXPECT_EQ(to_std(pane().place()), field_anchor("certificate", "certificate-item-serialnumber"));
    EXPECT_TRUE(pane().words_at_place().contains(QStringLiteral("serialNumber")))
        << to_std(pane().words_at_place());
}

TEST_F(HelpSession, ThePaneStandsBesideTheFormAndLeavesItTheFocus) {
    open(project_copy());
    wait_until_idle();
    const SetupAddress entry = window_->selection().entry();
    const FieldSpec& field = find_schema(window_->document().project(), entry)->fields().front();
    ASSERT_TRUE(window_->properties().setup_form()->focus_field('/' + field.key));
    QWidget* before = QApplication::focusWidget();
    press_f1();
    EXPECT_EQ(QApplication::focusWidget(), before);
    EXPECT_TRUE(before->isVisible());
    EXPECT_GT(pane().browser().viewport()->width(), 250);
    EXPECT_GT(pane().browser().viewport()->height(), 150);
}

TEST_F(HelpSession, AnOptionAnswersWithItsOwn) {
    open(project_copy());
    show_group(QStringLiteral("Options"));
    field("trials")->setFocus();
    press_f1();
    EXPECT_EQ(to_std(pane().place()), field_anchor("options", "trials"));
    EXPECT_TRUE(pane().words_at_place().startsWith(QStringLiteral("Trials")))
        << to_std(pane().words_at_place());
}

TEST_F(HelpSession, WithoutAProjectTheKeysAreShown) {
    ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get()));
    press_f1();
    EXPECT_TRUE(pane().browser().toPlainText().contains(QStringLiteral("F1")))
        << to_std(pane().place()) << to_std(pane().browser().toPlainText());
}

TEST_F(HelpSession, TheGlossaryIsInTheMenuAndLinksLeadOn) {
    trigger(QStringLiteral("Glossary"));
    EXPECT_TRUE(pane().browser().toPlainText().contains(QStringLiteral("sensitivity coefficient")));
    EXPECT_FALSE(pane().show_place(QStringLiteral("no-such-page")));
    EXPECT_TRUE(pane().show_place(QStringLiteral("glossary-coverage-factor")));
    EXPECT_EQ(to_std(pane().words_at_place()), "coverage factor");
}

TEST(HelpPages, EveryPlaceThatFormsNameIsThere) {
    HelpPane pane;
    for (const char* place : {"analysis-inputs", "options", "analysis-studies", "analysis-designs",
                              "analysis-requirements", "certificate", "glossary-uncertainty-budget"}) {
        EXPECT_TRUE(pane.show_place(QString::fromLatin1(place))) << place;
        EXPECT_FALSE(pane.words_at_place().isEmpty()) << place;
    }
}

}  // namespace
}  // namespace covaria::ui::help_session_test
