// Choosing the result of another analysis that an input quantity is.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QPushButton>

#include "tests/ui/qt_application.h"
#include "ui/forms/link_dialog.h"

namespace covaria::ui::link_dialog_test {

const std::vector<LinkChoice> choices{{"gauge", "End gauge", {{"gauge", "", "l"}, {"gauge", "", "d"}}},
                                      {"pose", "Pose", {{"pose", "pose 1", "x"}}}};

TEST(LinkDialog, OffersTheResultsOfTheAnalysisThatIsChosen) {
    LinkDialog dialog("L_S", choices, std::nullopt);
    ASSERT_EQ(dialog.analyses().count(), 2);
    EXPECT_EQ(dialog.outputs().count(), 2);
    EXPECT_EQ(dialog.link(), (InputLink{"L_S", {"gauge", "", "l"}, false}));
    dialog.analyses().setCurrentIndex(1);
    ASSERT_EQ(dialog.outputs().count(), 1);
    EXPECT_EQ(dialog.outputs().itemText(0), "pose 1: x");
    dialog.linearised().setChecked(true);
    EXPECT_EQ(dialog.link(), (InputLink{"L_S", {"pose", "pose 1", "x"}, true}));
}

TEST(LinkDialog, BeginsWithWhatIsLinkedNow) {
    const InputLink now{"L_S", {"gauge", "", "d"}, true};
    LinkDialog dialog("L_S", choices, now);
    EXPECT_EQ(dialog.link(), now);
}

TEST(LinkDialog, NothingToChooseIsNoLink) {
    LinkDialog dialog("L_S", {}, std::nullopt);
    EXPECT_EQ(dialog.link(), std::nullopt);
    EXPECT_FALSE(dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled());
}

}  // namespace covaria::ui::link_dialog_test
