// Followers of a selection never see the half of a change.
#include "ui/document/selection.h"

#include <gtest/gtest.h>

#include <QStringList>

namespace covaria::ui::selection_test {

struct SelectionTest : testing::Test {
    SelectionTest() {
        QObject::connect(&selection, &Selection::entry_changed, [this] { look("entry"); });
        QObject::connect(&selection, &Selection::analysis_changed, [this] { look("analysis"); });
        selection.select_entry({SetupOwner::analysis, "a"});
        selection.select_output(3);
        selection.select_study("s");
        seen.clear();
    }
    void look(const char* told) {
        seen << QStringLiteral("%1: %2 %3 %4 %5")
                    .arg(told, QString::fromStdString(selection.entry().id), selection.analysis())
                    .arg(selection.output())
                    .arg(selection.study());
    }
    Selection selection;
    QStringList seen;
};

TEST_F(SelectionTest, WhoIsToldOfAnEntrySeesItsAnalysis) {
    selection.select_entry({SetupOwner::analysis, "b"});
    EXPECT_EQ(seen, (QStringList{"analysis: b b -1 ", "entry: b b -1 "}));
}

TEST_F(SelectionTest, AnAssetLeavesTheAnalysisInView) {
    selection.select_entry({SetupOwner::asset, "tracker"});
    EXPECT_EQ(seen, QStringList{"entry: tracker a 3 s"});
    selection.select_entry({SetupOwner::analysis, "a"});
    EXPECT_EQ(seen.last(), "entry: a a 3 s") << "nothing of it was forgotten";
}

}  // namespace covaria::ui::selection_test
