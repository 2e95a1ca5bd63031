// Page breaks: runs that keep together, repeated heads, items taller than a page.
#include "ui/print/flow.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "ui/print/kept_spaces.h"
#include "ui/print/number_text.h"
#include "ui/print/table_layout.h"

namespace covaria::ui::flow_test {
namespace {

FlowItem item(double height, bool keep = false, double before = 0.0) {
    return {height, before, keep, [](QPainter&, QPointF) {}, {}};
}

std::vector<int> pages_of(const FlowedPages& flowed) {
    std::vector<int> pages;
    for (const PlacedItem& placed : flowed.items) pages.push_back(placed.page);
    return pages;
}

TEST(Flow, FillsPagesInOrder) {
    const FlowedPages flowed = flow({item(60), item(40), item(10)}, 100.0);
    EXPECT_EQ(pages_of(flowed), (std::vector<int>{0, 0, 1}));
    EXPECT_EQ(flowed.pages, 2);
    EXPECT_DOUBLE_EQ(flowed.items[1].y, 60.0);
    EXPECT_DOUBLE_EQ(flowed.items[2].y, 0.0);
}

TEST(Flow, SpaceBeforeIsDroppedAtTheTopOfAPage) {
    const FlowedPages flowed = flow({item(60, false, 10), item(40, false, 10)}, 100.0);
    EXPECT_DOUBLE_EQ(flowed.items[0].y, 0.0);
    EXPECT_EQ(flowed.items[1].page, 1);
    EXPECT_DOUBLE_EQ(flowed.items[1].y, 0.0);
}

TEST(Flow, HeadingsGoWithWhatFollows) {
    const FlowedPages flowed = flow({item(70), item(10, true), item(10, true), item(30)}, 100.0);
    EXPECT_EQ(pages_of(flowed), (std::vector<int>{0, 1, 1, 1}));
}

TEST(Flow, PartsBeginAPage) {
    FlowItem part = item(10, true);
    part.begins_page = true;
    const FlowedPages flowed = flow({part, item(10), part, item(10)}, 100.0);
    EXPECT_EQ(pages_of(flowed), (std::vector<int>{0, 0, 1, 1}));
}

TEST(Flow, RunsTallerThanAPageBreakWhereTheyMust) {
    const FlowedPages flowed = flow({item(20), item(50, true), item(50, true), item(50)}, 100.0);
    EXPECT_EQ(pages_of(flowed), (std::vector<int>{0, 0, 1, 1}));
}

TEST(Flow, HeadsAreRepeatedWhereATableGoesOn) {
    const auto head = std::make_shared<RepeatedHead>(RepeatedHead{10.0, [](QPainter&, QPointF) {}});
    std::vector<FlowItem> items = {item(10, true)};
    for (int i = 0; i < 12; ++i) {
        items.push_back(item(10));
        items.back().head = head;
    }
    const FlowedPages flowed = flow(items, 100.0);
    ASSERT_EQ(flowed.items.size(), 14U);  // 1 head, 9 rows; the head again, 3 rows
    EXPECT_EQ(flowed.items[10].page, 1);
    EXPECT_DOUBLE_EQ(flowed.items[10].y, 0.0);
    EXPECT_DOUBLE_EQ(flowed.items[11].y, 10.0);
}

TEST(ShareWidth, NaturalWidthsWhereTheyFit) {
    EXPECT_EQ(share_width({{30, 10, false}, {20, 20, true}}, 100.0), (std::vector<double>{30, 20}));
}

TEST(ShareWidth, TextGivesWayAndNumbersDoNot) {
    const std::vector<double> widths = share_width({{80, 20, false}, {40, 20, false}, {30, 30, true}}, 110.0);
    EXPECT_DOUBLE_EQ(widths[2], 30.0);
    EXPECT_DOUBLE_EQ(widths[0] + widths[1], 80.0);
    EXPECT_DOUBLE_EQ(widths[0], 50.0);  // 20 + half of what it wants beyond
}

TEST(ShareWidth, NothingIsNarrowerThanItsLongestWord) {
    EXPECT_EQ(share_width({{100, 100, true}, {100, 60, false}}, 100.0), (std::vector<double>{100, 60}));
}

TEST(DecimalSign, StandsBehindTheIntegerPartWhereThereIsNone) {
    const NumberLocale point, comma{","};
    const auto of = [](const QString& number, const NumberLocale& locale) {
        return number.left(decimal_sign_of(number, locale));
    };
    EXPECT_EQ(of("0.0012", point), "0");
    EXPECT_EQ(of("−1,5×10⁻⁵", comma), "−1");
    EXPECT_EQ(of("5×10⁻⁵", point), "5");
    EXPECT_EQ(of("−12\u202f345", point), "−12\u202f345");
    EXPECT_EQ(of("2 (5)", comma), "2");
    EXPECT_EQ(of("∞", point), "∞");
}

TEST(KeptSpaces, HoldNumbersUnitsAndRelationsTogether) {
    const auto kept = [](const QString& text) { return with_kept_spaces(text).replace(QChar::Nbsp, '~'); };
    EXPECT_EQ(kept("at 20 °C, −2000 mm to 3 mm."), "at 20~°C, −2000~mm to 3~mm.");
    EXPECT_EQ(kept("with 20 000 trials"), "with 20~000 trials");
    EXPECT_EQ(kept("so p = 99 % or w = U"), "so p~=~99~% or w~=~U");
    EXPECT_EQ(kept("d. h. Nr. 3, Table H. 1"), "d. h. Nr.~3, Table H.~1");
    EXPECT_EQ(kept("6 of 7 poses are kept"), "6 of 7 poses are kept");
}

TEST(KeptSpaces, DoNotMakeALongEquationOnePiece) {
    QString equation = "a";
    for (int i = 0; i < 40; ++i) equation += " = quantity";
    qsizetype longest = 0;
    for (const QString& piece : with_kept_spaces(equation).split(' '))
        longest = std::max(longest, piece.size());
    EXPECT_LE(longest, 40);
}

}  // namespace
}  // namespace covaria::ui::flow_test
