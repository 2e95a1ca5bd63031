#include "core/kinds/sheets/verdict.h"

namespace covaria::sheets {

TestVerdict Decision::verdict() const {
    if (conforms) return {TestVerdict::Is::met, tell<"conforms">()};
    if (fails) return {TestVerdict::Is::not_met, tell<"does not conform">()};
    return {TestVerdict::Is::open, tell<"not decided">()};
}

Table table_of_tests(std::string id, std::string title) {
    Table table{std::move(id), std::move(title)};
    table.add("test");
    for (const char* head : {"figure", "from", "to"}) table.add(head).figure(4);
    table.add("verdict");
    return table;
}

void add_test(Table& table, const StatisticalTest& test) {
    const auto cell = [&](std::optional<double> si) {
        return si ? Cell(Quantity{test.unit.interval_from_si(*si), test.unit}) : Cell();
    };
    table.row({test.question, cell(test.figure), cell(test.low), cell(test.high),
               test.passed() ? TestVerdict{TestVerdict::Is::met, tell<"passed">()}
                             : TestVerdict{TestVerdict::Is::not_met, tell<"not passed">()}});
}

}  // namespace covaria::sheets
