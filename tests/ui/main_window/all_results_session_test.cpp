// A user looks at the results of all analyses at once, finds what is not met, and goes there.
#include <QCheckBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>

#include "tests/ui/main_window/session_fixture.h"
#include "ui/models/project_tree_model.h"
#include "ui/models/roles.h"
#include "ui/pages/all_results_tab.h"
#include "ui/pages/outputs_tab.h"
#include "ui/pages/sortable_table.h"
#include "ui/pages/stage.h"

namespace covaria::ui::all_results_session_test {
namespace {

class AllResultsSession : public Session {
protected:
    AllResultsTab& tab() { return window_->results().all_results_tab(); }
    const QAbstractItemModel& table() { return *tab().table().model(); }
    int column(const QString& head) {
        for (int c = 0; c < table().columnCount(); ++c)
            if (table().headerData(c, Qt::Horizontal, id_role).toString() == head) return c;
        return -1;
    }
    QString words(int row, const char* head) {
        return table().index(row, column(QString::fromLatin1(head))).data().toString();
    }
    QString verdict_in_tree(const std::string& id) {
        const QAbstractItemModel& tree = *window_->project_pane().model();
        for (int c = 0; c < tree.rowCount(); ++c)
            for (int r = 0; r < tree.rowCount(tree.index(c, 0)); ++r) {
                const QModelIndex entry = tree.index(r, 0, tree.index(c, 0));
                if (to_std(entry.data(id_role).toString()) == id) return entry.data(verdict_role).toString();
            }
        ADD_FAILURE() << id << " is not in the tree";
        return {};
    }
};

TEST_F(AllResultsSession, WhatIsNotMetInAnyAnalysisIsFoundAndGoneTo) {
    open(project_copy());
    trigger(QStringLiteral("Run All"));
    wait_until_idle();
    window_->results().stage().show_view(&tab());
    ASSERT_TRUE(wait_for([this] { return table().rowCount() == 2 * 78; })) << table().rowCount();
    EXPECT_GE(column(QStringLiteral("95\u00a0% interval, low")), 0);
    EXPECT_GE(column(QStringLiteral("95\u00a0% interval, high")), 0);
    EXPECT_EQ(column(QStringLiteral("Requirement")), -1) << "nothing is required";
    EXPECT_FALSE(tab().only_not_met().isEnabled());

    const auto result = window_->runner().status(QStringLiteral("from-artefacts")).result;
    const OutputResult& last = result->outputs.back();
    window_->document().apply(QStringLiteral("Requirements"), [&](Project& project) {
        for (AnalysisEntry& analysis : project.analyses)
            if (analysis.id == "from-artefacts")
                analysis.requirements = {
                    {last.quantity.group, last.quantity.symbol,
                     Quantity{0.5 * last.quantity.unit.interval_from_si(last.expanded_uncertainty),
                              last.quantity.unit}}};
    });
    ASSERT_TRUE(wait_for([this] { return tab().only_not_met().isEnabled(); }));
    EXPECT_TRUE(tab().count().text().startsWith(QStringLiteral("0 of 1 requirements met")))
        << to_std(tab().count().text());
    EXPECT_EQ(verdict_in_tree("from-artefacts"), QStringLiteral("1 of 1 requirements not met"));
    EXPECT_EQ(verdict_in_tree("printed"), QString());
    tab().only_not_met().setChecked(true);
    ASSERT_EQ(table().rowCount(), 1);
    EXPECT_EQ(words(0, "Requirement"), QStringLiteral("not met"));
    EXPECT_EQ(words(0, "U / target"), QStringLiteral("2.00"));
    QDir().mkpath(QStringLiteral(COVARIA_BINARY_DIR "/screenshots"));
    tab().only_not_met().setChecked(false);
    settle();
    window_->grab().save(QStringLiteral(COVARIA_BINARY_DIR "/screenshots/all-results.png"));
    tab().only_not_met().setChecked(true);
    select(SetupOwner::analysis, "printed");
    emit tab().table().activated(table().index(0, 0));
    EXPECT_EQ(window_->selection().analysis(), QStringLiteral("from-artefacts"));
    EXPECT_EQ(window_->selection().group(), to_qt(last.quantity.group));
    EXPECT_EQ(window_->selection().output(), int(result->outputs.size()) - 1);
    EXPECT_TRUE(window_->results().stage().shows(window_->results().outputs().table()));
}

TEST_F(AllResultsSession, TheFilterSearchesAnalysesToo) {
    open(project_copy());
    trigger(QStringLiteral("Run All"));
    wait_until_idle();
    window_->results().stage().show_view(&tab());
    ASSERT_TRUE(wait_for([this] { return table().rowCount() == 2 * 78; }));
    const QString name = to_qt(window_->document().project().analyses.front().name);
    tab().filter().setFocus();
    tab().filter().setText(name + QStringLiteral(" pose 13 alpha"));
    ASSERT_EQ(table().rowCount(), 1);
    EXPECT_EQ(words(0, "Analysis"), name);
    EXPECT_EQ(words(0, "Group"), QStringLiteral("pose 13"));
    EXPECT_EQ(words(0, "State"), QStringLiteral("up to date"));
}

}  // namespace
}  // namespace covaria::ui::all_results_session_test
