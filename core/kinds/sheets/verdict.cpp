#include "core/kinds/sheets/verdict.h"

namespace covaria::sheets {

Message Decision::words() const {
    return conforms ? tell<"conforms">() : fails ? tell<"does not conform">() : tell<"not decided">();
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
               test.passed() ? tell<"passed">() : tell<"not passed">()});
}

}  // namespace covaria::sheets
