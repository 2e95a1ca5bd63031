// A user holds what is stated against what the residuals see, takes it over in one step and takes it back.
#include <QComboBox>

#include "tests/ui/main_window/session_fixture.h"
#include "ui/charts/chart_view.h"
#include "ui/pages/seen_tab.h"
#include "ui/pages/sortable_table.h"
#include "ui/pages/stage.h"

namespace covaria::ui::seen_session_test {
namespace {

class SeenSession : public Session {
protected:
    SeenTab& tab() { return window_->results().seen_tab(); }
    void open_network(const char* id) {
        open(project_copy(QStringLiteral("seen-network")));
        select(SetupOwner::analysis, id);
        ASSERT_TRUE(wait_for([this] { return status().is_current(); }));
        ASSERT_TRUE(wait_for([this] { return tab().seen() != nullptr; }));
        window_->results().stage().show_view(&tab());
    }
    QString cell(int row, const char* head) {
        const QAbstractItemModel& model = *tab().table().model();
        for (int c = 0; c < model.columnCount(); ++c)
            if (model.headerData(c, Qt::Horizontal).toString() == QLatin1String(head))
                return model.index(row, c).data().toString();
        ADD_FAILURE() << head;
        return {};
    }
    /// u of the length of the barrel, which hangs on the distances.
    double u_of_length() const {
        const AnalysisStatus now = status();
        for (std::size_t i = 0; now.result && i < now.result->outputs.size(); ++i)
            if (now.result->outputs[i].quantity.symbol == "P01–P17")
                return now.result->outputs[i].first_order.standard_uncertainty;
        return 0.0;
    }
};

TEST_F(SeenSession, FiguresAreHeldAgainstTheResiduals) {
    open_network("stated");
    ASSERT_EQ(tab().table().model()->rowCount(), 3);
    EXPECT_EQ(cell(0, "figure"), QStringLiteral("directions"));
    EXPECT_EQ(cell(0, "verdict"), QStringLiteral("seen is larger"));
    EXPECT_EQ(cell(1, "verdict"), QStringLiteral("agrees"));
    EXPECT_EQ(cell(2, "verdict"), QStringLiteral("seen is smaller"));
    EXPECT_TRUE(tab().summary().text().contains(QStringLiteral("passes")))
        << tab().summary().text().toStdString();
    for (ChartView* chart : tab().findChildren<ChartView*>()) EXPECT_FALSE(chart->plot().series.empty());
    // A level at which chance contradicts less often contradicts less.
    auto* level = tab().findChild<QComboBox*>(QStringLiteral("seen_level"));
    ASSERT_NE(level, nullptr);
    const double low = tab().seen()->figures[2].low;
    level->setCurrentIndex(2);
    ASSERT_TRUE(wait_for([&] { return tab().seen() && tab().seen()->figures[2].low < low; }));
}

TEST_F(SeenSession, ResidualsAreDrawnOverDistanceAndAsAHistogram) {
    open_network("stated");
    QComboBox& over = tab().abscissa();
    ASSERT_EQ(over.count(), 3);
    EXPECT_EQ(over.itemText(1), QStringLiteral("Over: distance"));
    const std::string order = tab().residuals().plot().id;
    over.setCurrentIndex(1);
    EXPECT_NE(tab().residuals().plot().id, order);
    EXPECT_EQ(tab().residuals().plot().x.unit, "m");
    EXPECT_FALSE(tab().residuals().plot().series.empty());
    EXPECT_EQ(tab().quantiles().plot().id, "seen-quantiles");
    tab().shape().setCurrentIndex(1);
    EXPECT_EQ(tab().quantiles().plot().id, "seen-histogram");
    EXPECT_FALSE(tab().quantiles().plot().series.empty());
    // Another level draws the same readings anew, over what was chosen.
    tab().findChild<QComboBox*>(QStringLiteral("seen_level"))->setCurrentIndex(1);
    ASSERT_TRUE(wait_for([this] { return tab().seen() != nullptr; }));
    EXPECT_EQ(over.currentIndex(), 1);
}

TEST_F(SeenSession, OneClickTakesThemOverAndOneUndoTakesThemBack) {
    open_network("stated");
    const double stated = u_of_length();
    QTest::mouseClick(&tab().take_over_button(), Qt::LeftButton);
    ASSERT_TRUE(wait_for([&] { return status().is_current() && u_of_length() != stated; }));
    EXPECT_LT(u_of_length(), stated);
    EXPECT_EQ(tab().take_over_button().text(), QStringLiteral("Back to Stated"));
    // The stated figures are still compared with the seen ones.
    ASSERT_TRUE(wait_for([this] { return tab().seen() != nullptr; }));
    EXPECT_EQ(cell(2, "verdict"), QStringLiteral("seen is smaller"));
    window_->document().undo();
    ASSERT_TRUE(wait_for([&] { return status().is_current() && u_of_length() == stated; }));
    EXPECT_EQ(tab().take_over_button().text(), QStringLiteral("Take Over as Seen"));
}

TEST_F(SeenSession, AModelWithoutRedundantReadingsHasNoSuchView) {
    open(QStringLiteral(COVARIA_SOURCE_DIR "/projects/gum/h1-end-gauge.covaria"));
    ASSERT_TRUE(wait_for([this] { return status().is_current(); }));
    EXPECT_FALSE(window_->results().tabs().isTabVisible(window_->results().stage().tab_of(&tab())));
}

}  // namespace
}  // namespace covaria::ui::seen_session_test
