#include "core/kinds/sheets/verdict.h"

namespace covaria::sheets {

DataTable table_of_tests(std::string id, std::string title) {
    return {std::move(id),
            std::move(title),
            {{"test"}, {"figure", {}, false, 4}, {"from", {}, false, 4}, {"to", {}, false, 4}, {"verdict"}},
            {},
            {}};
}

void add_test(DataTable& table, const StatisticalTest& test) {
    const auto cell = [&](std::optional<double> si) {
        return si ? TableCell(Quantity{test.unit.interval_from_si(*si), test.unit}) : TableCell();
    };
    table.rows.push_back({test.question, cell(test.figure), cell(test.low), cell(test.high),
                          test.passed() ? tell<"passed">() : tell<"not passed">()});
}

}  // namespace covaria::sheets
