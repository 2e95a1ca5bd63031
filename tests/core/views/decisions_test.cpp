// Verdicts of tables as rows of their own.
#include <gtest/gtest.h>

#include "core/views/decisions.h"

namespace covaria::decisions_test {
namespace {

TEST(DecidedRows, HaveTheWordsBeforeTheFiguresAsTheirSubject) {
    Table table{"decisions", "Decisions"};
    table.add("position");
    table.add("test");
    table.add("E").in(Unit::of("um")).symbol().fixed(1);
    table.add("limit").in(Unit::of("um")).fixed(0);
    table.add("decision");
    table.add("cycles that would decide");
    table.row({std::string("P1"), tell<"length">(), Measured(12.34e-6), Measured(10e-6),
               TestVerdict{TestVerdict::Is::not_met, tell<"does not conform">()}});
    table.subhead("of another day");
    table.row({std::string("P2"), tell<"length">(), Measured(1e-6), Cell(),
               TestVerdict{TestVerdict::Is::open, tell<"not decided">()}, tell<"none">()});
    table.row({std::string("P3"), tell<"length">(), Cell(), Cell(), Cell()});
    const std::vector<DecidedRow> rows = decisions_in({table, Table{"other", "Other", 3}});
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(to_unicode(rows[0].subject), "Decisions: P1, length");
    EXPECT_EQ(rows[0].verdict.is, TestVerdict::Is::not_met);
    EXPECT_EQ(to_unicode(rows[0].figures), "E = 12.3\u00a0µm, limit = 10\u00a0µm");
    EXPECT_EQ(to_unicode(rows[1].subject), "Decisions: P2, length");
    EXPECT_EQ(rows[1].verdict.words.english(), "not decided");
    EXPECT_EQ(to_unicode(rows[1].figures), "E = 1.0\u00a0µm");
}

}  // namespace
}  // namespace covaria::decisions_test
