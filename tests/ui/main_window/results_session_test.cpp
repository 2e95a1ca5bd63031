// A user looks for results over all groups, and for those that do not meet what is required.
#include <QCheckBox>
#include <QDir>
#include <QLineEdit>

#include "tests/ui/main_window/session_fixture.h"
#include "ui/models/roles.h"
#include "ui/pages/sortable_table.h"

namespace covaria::ui::results_session_test {
namespace {

class ResultsSession : public Session {
protected:
    const QAbstractItemModel& table() { return *window_->results().result_table().model(); }
    int column(const char* head) {
        for (int c = 0; c < table().columnCount(); ++c)
            if (table().headerData(c, Qt::Horizontal, id_role).toString() == QLatin1String(head)) return c;
        return -1;
    }
    QString words(int row, const char* head) { return table().index(row, column(head)).data().toString(); }
};

TEST_F(ResultsSession, AllGroupsAreFilteredBySearchAndByWhatIsNotMet) {
    open(project_copy());
    select(SetupOwner::analysis, "printed");
    window_->results().tabs().setCurrentIndex(0);
    trigger(QStringLiteral("Run This Analysis"));
    ASSERT_TRUE(wait_for([this] { return status().is_current(); }));
    window_->selection().select_group(QStringLiteral("pose 7"));
    ASSERT_EQ(table().rowCount(), 6);
    EXPECT_EQ(column("Requirement"), -1) << "nothing is required";
    EXPECT_FALSE(window_->results().only_not_met().isEnabled());
    QTest::mouseClick(&window_->results().all_groups(), Qt::LeftButton, {},
                      QPoint(8, window_->results().all_groups().height() / 2));
    ASSERT_EQ(table().rowCount(), 78);
    EXPECT_FALSE(window_->results().result_table().isColumnHidden(column("Group")));
    window_->results().filter().setFocus();
    QTest::keyClicks(&window_->results().filter(), QStringLiteral("pose 1 alpha"));
    for (int row = 0; row < table().rowCount(); ++row)
        EXPECT_TRUE(words(row, "Group").startsWith(QStringLiteral("pose 1"))) << row;
    ASSERT_EQ(table().rowCount(), 5) << "poses 1, 10, 11, 12, 13";

    const OutputResult& x = status().result->outputs[0];
    ASSERT_EQ(x.quantity.symbol, "x");
    const double half_mm = 500.0 * x.expanded_uncertainty, twice_mm = 2000.0 * x.expanded_uncertainty;
    window_->document().apply(QStringLiteral("Requirements"), [&](Project& project) {
        for (AnalysisEntry& analysis : project.analyses)
            if (analysis.id == "printed")
                analysis.requirements = {{x.quantity.group, "x", Quantity{half_mm, Unit::of("mm")}},
                                         {x.quantity.group, "y", Quantity{twice_mm * 10, Unit::of("mm")}}};
    });
    window_->results().filter().clear();
    ASSERT_EQ(table().rowCount(), 78);
    ASSERT_GE(column("Requirement"), 0) << "verdicts follow the requirements without a run";
    EXPECT_EQ(words(0, "Requirement"), QStringLiteral("not met"));
    EXPECT_EQ(words(0, "U / target"), QStringLiteral("2.00"));
    EXPECT_EQ(words(1, "Requirement"), QStringLiteral("met"));
    EXPECT_EQ(words(2, "Requirement"), QString());
    QTest::mouseClick(&window_->results().only_not_met(), Qt::LeftButton, {},
                      QPoint(8, window_->results().only_not_met().height() / 2));
    ASSERT_EQ(table().rowCount(), 1);
    EXPECT_EQ(words(0, "Requirement"), QStringLiteral("not met"));
    QDir().mkpath(QStringLiteral(COVARIA_BINARY_DIR "/screenshots"));
    window_->grab().save(QStringLiteral(COVARIA_BINARY_DIR "/screenshots/results-not-met.png"));
    window_->document().undo_stack().undo();
    EXPECT_EQ(table().rowCount(), 0) << "nothing is required any more";
    EXPECT_TRUE(window_->results().only_not_met().isEnabled()) << "so that it can be taken back";
}

}  // namespace
}  // namespace covaria::ui::results_session_test
