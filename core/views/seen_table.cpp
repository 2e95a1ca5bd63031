#include "core/views/seen_table.h"

#include <algorithm>
#include <cmath>

#include "core/text/numbers.h"

namespace covaria {
namespace {

using evidence::SeenFigure;
using evidence::StatedFigure;
using evidence::Verdict;

Cell u_of(const StatedFigure& figure, double si) {
    return Measured{si, Measured::Scale::interval, figure.unit};
}

Cell known(double value, bool is_known) {
    return is_known && std::isfinite(value) ? Cell(Measured(value)) : Cell();
}

bool is_range(const StatedFigure& figure) {
    return figure.most > figure.least;
}

void add_row(const StatedFigure& figure, const SeenFigure& seen, bool has_ranges, Table& table) {
    const bool told = seen.degrees_of_freedom > 0.0 || seen.clamped;
    std::vector<Cell> row{figure.name, Measured(static_cast<double>(figure.count)),
                          u_of(figure, figure.least)};
    if (has_ranges) row.push_back(is_range(figure) ? u_of(figure, figure.most) : Cell());
    const bool has_interval = told && !seen.clamped;
    row.insert(row.end(), {told && !is_range(figure) ? u_of(figure, seen.factor * figure.least) : Cell(),
                           known(seen.factor, told), known(seen.low, has_interval),
                           known(seen.high, has_interval), Measured(seen.redundancy),
                           known(seen.degrees_of_freedom, has_interval), verdict_words(seen.verdict)});
    table.row(std::move(row));
}

Message number(double value, int digits = 3) {
    return Message::number(format_significant(value, digits));
}

Message list_of(const evidence::RedundantReadings& readings, const std::vector<std::size_t>& figures) {
    Message words;
    for (const std::size_t k : figures)
        words += Message(words.empty() ? "" : ", ") + readings.figures[k].name;
    return words;
}

bool passes(const evidence::Seen& seen) {
    return seen.s0 >= seen.s0_low && seen.s0 <= seen.s0_high;
}

void add_notes_on_figures(const evidence::RedundantReadings& readings, const evidence::Seen& seen,
                          std::vector<Message>& notes) {
    std::vector<std::size_t> zero, contradicted;
    for (std::size_t k = 0; k < seen.figures.size(); ++k) {
        const SeenFigure& figure = seen.figures[k];
        if (figure.clamped) zero.push_back(k);
        if (figure.verdict == Verdict::larger || figure.verdict == Verdict::smaller)
            contradicted.push_back(k);
        if (figure.not_apart.empty() || figure.not_apart.front() < k) continue;
        std::vector<std::size_t> together{k};
        together.insert(together.end(), figure.not_apart.begin(), figure.not_apart.end());
        notes.push_back(
            tell<"The readings cannot tell apart, and give one factor to: %1.">(list_of(readings, together)));
    }
    if (!zero.empty())
        notes.push_back(tell<"The estimate of the variance was negative, so it is zero, of: %1.">(
            list_of(readings, zero)));
    if (passes(seen) && !contradicted.empty())
        notes.push_back(
            tell<"The global test does not see that figures which are too large and figures which "
                 "are too small make up for each other: %1.">(list_of(readings, contradicted)));
}

}  // namespace

Message verdict_words(Verdict verdict) {
    switch (verdict) {
        case Verdict::agrees:
            return tell<"agrees">();
        case Verdict::smaller:
            return tell<"seen is smaller">();
        case Verdict::larger:
            return tell<"seen is larger">();
        case Verdict::too_little:
            break;
    }
    return tell<"too little to say">();
}

Table seen_table(const evidence::RedundantReadings& readings, const evidence::Seen& seen,
                 const DocumentLanguage& in) {
    Table table{"seen", in.say(tell<"Stated and seen uncertainties">())};
    const auto head = [&](Column& column, const Message& words) -> Column& {
        column.head = words.english();
        column.title = running_text(in.say(words));
        return column;
    };
    head(table.add("figure"), tell<"figure">());
    head(table.add("readings"), tell<"readings">()).fixed(0);
    head(table.add("u_stated"), tell<"stated u">()).typed().with_unit();
    const bool has_ranges = std::ranges::any_of(readings.figures, is_range);
    if (has_ranges) head(table.add("u_stated_most"), tell<"to">()).typed().with_unit();
    head(table.add("u_seen"), tell<"seen u">()).figure(2).with_unit();
    head(table.add("factor"), tell<"factor">()).figure(3);
    head(table.add("factor_low"), tell<"from">()).figure(3);
    head(table.add("factor_high"), tell<"to">()).figure(3);
    head(table.add("redundancy"), tell<"redundancy">()).fixed(1);
    head(table.add("degrees_of_freedom"), tell<"degrees of freedom">()).degrees_of_freedom();
    head(table.add("verdict"), tell<"verdict">()).of_own_words();
    for (std::size_t k = 0; k < seen.figures.size(); ++k)
        add_row(readings.figures[k], seen.figures[k], has_ranges, table);
    table.notes = seen_notes(readings, seen);
    return table;
}

std::vector<Message> seen_notes(const evidence::RedundantReadings& readings, const evidence::Seen& seen) {
    if (seen.degrees_of_freedom <= 0) return {tell<"Nothing is redundant: the readings say nothing.">()};
    std::vector<Message> notes;
    if (!seen.found)
        notes.push_back(readings.names.size() > evidence::most_readings_of(readings)
                            ? tell<"More than %1 readings: their factors are not computed.">(
                                  evidence::most_readings_of(readings))
                            : tell<"The factors of the figures do not come to rest.">());
    notes.push_back(
        passes(seen)
            ? tell<"Global test: s₀ = %1 with %2 degrees of freedom passes (%3 to %4).">(
                  number(seen.s0, 4), seen.degrees_of_freedom, number(seen.s0_low), number(seen.s0_high))
            : tell<"Global test: s₀ = %1 with %2 degrees of freedom fails (%3 to %4).">(
                  number(seen.s0, 4), seen.degrees_of_freedom, number(seen.s0_low), number(seen.s0_high)));
    add_notes_on_figures(readings, seen, notes);
    if (seen.found && !readings.measurands.empty()) {
        const Unit& unit = readings.unit_of_measurands;
        const auto quantity = [&](double si) {
            return Message::number(format_significant(unit.interval_from_si(si), 3) + " " + unit.text());
        };
        notes.push_back(tell<"Mean u of a coordinate: %1 as stated, %2 as seen.">(
            quantity(seen.mean_u_stated), quantity(seen.mean_u_seen)));
    }
    return notes;
}

}  // namespace covaria
