#include "core/result_files/design_json.h"

#include <cctype>
#include <optional>

#include "core/base/version.h"
#include "core/result_files/json_values.h"
#include "core/text/cell.h"
#include "core/views/design_results.h"

namespace covaria {
namespace {

OrderedJson cell_json(const Cell& cell) {
    if (const auto number = number_in(cell)) return json_number(*number);
    return std::holds_alternative<std::monostate>(cell) ? OrderedJson(nullptr)
                                                        : OrderedJson(english_of(cell));
}

/// "U by Monte Carlo" -> "UByMonteCarlo"; x in mm -> "xMm".
std::string key_of(const Column& column) {
    const std::string head = column.key + (column.unit ? " " + column.unit->text() : "");
    std::string key;
    bool capital = false;
    for (const char c : head) {
        if (!std::isalnum(static_cast<unsigned char>(c))) {
            capital = true;
            continue;
        }
        key += capital ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
        capital = false;
    }
    return key;
}

OrderedJson optional_json(const std::optional<double>& number) {
    return number ? json_number(*number) : OrderedJson(nullptr);
}

}  // namespace

std::string design_json(const DesignResult& result) {
    OrderedJson json{{"format", "covaria-design"},
                     {"schemaVersion", 1},
                     {"covariaVersion", version()},
                     {"analysis", result.analysis},
                     {"id", result.id},
                     {"name", result.name},
                     {"fingerprint", result.fingerprint},
                     {"seed", std::to_string(result.seed)},
                     {"objective", result.objective_words},
                     {"found", result.found},
                     {"met", result.met()},
                     {"proved", result.proved},
                     {"before", optional_json(result.before)},
                     {"whyNotBefore", result.why_not_before.english()},
                     {"best", result.found ? json_number(result.objective) : OrderedJson(nullptr)},
                     {"cost", optional_json(result.cost)},
                     {"candidates", result.candidates},
                     {"evaluations", result.evaluations},
                     {"trials", result.trials},
                     {"failedTrials", result.failed_trials},
                     {"notVerified", result.not_verified.english()},
                     {"coverageProbability", result.coverage_probability}};
    for (const Table& table : design_tables(result)) {
        OrderedJson rows = OrderedJson::array();
        for (std::size_t r = 0; r < table.rows; ++r) {
            OrderedJson row = OrderedJson::object();
            for (const Column& column : table.columns) row[key_of(column)] = cell_json(column.cell(r));
            rows.push_back(std::move(row));
        }
        json[table.id] = std::move(rows);
    }
    return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace covaria
