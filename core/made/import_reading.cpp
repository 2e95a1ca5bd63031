#include "core/made/import_reading.h"

#include <algorithm>
#include <cmath>

#include "core/base/guarded.h"
#include "core/made/made_project.h"
#include "core/propagation/engine.h"
#include "core/readers/readers.h"
#include "core/setup/message_text.h"
#include "core/text/numbers.h"

namespace covaria {

namespace {

// Shares that two digits of a stated uncertainty leave open; of a value, a tenth of its u.
constexpr double far_share = 0.05, far_of_u = 0.1;

std::string after_number(const Unit& unit) {
    return unit == Unit() ? std::string() : " " + unit.display();
}

std::string in_unit(double value, const Unit& unit, int digits) {
    return format_significant(value, digits) + after_number(unit);
}

/// Number with unit as it was written.
std::string stated_in(double value, const Unit& unit) {
    return shortest_number(value) + after_number(unit);
}

Message apart(const Message& of, const Message& stated, const std::string& here, const Message& by,
              bool is_far) {
    const Message line = tell<"%1: the file states %2, this budget gives %3, %4 apart">(of, stated, here, by);
    return is_far ? tell<"%1: FIND OUT WHY before it is used">(line) : line;
}

Message share_apart(double stated, double here) {
    if (stated == 0.0) return here == 0.0 ? "0 %" : "100 %";
    return format_significant(100.0 * std::abs(here / stated - 1.0), 2) + " %";
}

bool is_far(double stated, double here) {
    return !(std::abs(here - stated) <= far_share * std::abs(stated));
}

/// The lines of one result; figures of `result` are in SI.
void hold(const StatedOutcome& stated, const OutputResult& result, std::vector<Message>& lines) {
    const Unit interval = stated.unit.interval();
    const double u = interval.interval_from_si(result.standard_uncertainty);
    const std::string& symbol = stated.symbol;
    if (stated.value) {
        const double here = stated.unit.from_si(result.estimate), by = std::abs(here - *stated.value);
        lines.push_back(apart(symbol, stated_in(*stated.value, stated.unit),
                              readable_number(here) + after_number(stated.unit), in_unit(by, interval, 2),
                              !(by <= far_of_u * u)));
    }
    if (stated.u && stated.from_contributions)
        lines.push_back(apart(tell<"u(%1) by its contributions">(symbol), in_unit(*stated.u, interval, 4),
                              in_unit(u, interval, 4), share_apart(*stated.u, u), is_far(*stated.u, u)));
    else if (stated.u)
        lines.push_back(apart("u(" + symbol + ")", stated_in(*stated.u, interval), in_unit(u, interval, 4),
                              share_apart(*stated.u, u), is_far(*stated.u, u)));
    if (!stated.expanded) return;
    const double here = stated.k ? *stated.k * u : interval.interval_from_si(result.expanded_uncertainty);
    const std::string k = stated.k ? ", k = " + shortest_number(*stated.k) : std::string();
    lines.push_back(apart("U(" + symbol + ")" + k, stated_in(*stated.expanded, interval),
                          in_unit(here, interval, 4), share_apart(*stated.expanded, here),
                          is_far(*stated.expanded, here)));
}

}  // namespace

std::vector<Message> held_against_outcomes(const Proposals& proposals) {
    std::vector<Message> lines;
    if (proposals.outcomes.empty()) return lines;
    Project project;
    add_to_project(project, proposals);
    const auto made = MadeProject::make(std::move(project));
    for (const StatedOutcome& stated : proposals.outcomes) {
        if (!stated.value && !stated.u && !stated.expanded) {
            lines.push_back(
                tell<"%1: the file states no result that this budget could be held against">(stated.symbol));
            continue;
        }
        const auto prepared = made->analysis(stated.analysis);
        const auto result = prepared ? evaluate_first_order(*prepared->propagated, prepared->options)
                                     : Result<UncertaintyResult>(fail(ErrorCode::not_found, ""));
        if (!result) continue;  // the project says what is wrong with it
        for (const OutputResult& output : result->outputs)
            if (output.quantity.symbol == stated.symbol) hold(stated, output, lines);
    }
    return lines;
}

Result<Proposals> read_proposals(const Reader& reader, const std::string& text, const ReadChoice& choice) {
    auto read = guarded([&]() -> Result<Proposals> {
        auto proposals = reader.read(text, choice);
        if (!proposals) return proposals;
        for (Message& line : held_against_outcomes(*proposals)) proposals->found.push_back(std::move(line));
        return proposals;
    });
    if (!read) return fail(read.error());
    return std::move(*read);
}

}  // namespace covaria
