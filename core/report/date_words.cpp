#include "core/report/date_words.h"

#include <array>
#include <charconv>
#include <optional>

#include "core/report/certificate_words.h"

namespace covaria {

namespace {

const std::array<Phrase, 12> months{Phrase{"January"}, Phrase{"February"}, Phrase{"March"},
                                    Phrase{"April"},   Phrase{"May"},      Phrase{"June"},
                                    Phrase{"July"},    Phrase{"August"},   Phrase{"September"},
                                    Phrase{"October"}, Phrase{"November"}, Phrase{"December"}};
/// A date by day, month and year.
const Phrase day_month_year{"%1 %2 %3"};

std::optional<unsigned> whole_number(std::string_view figures) {
    unsigned number = 0;
    const auto read = std::from_chars(figures.data(), figures.data() + figures.size(), number);
    if (read.ec != std::errc() || read.ptr != figures.data() + figures.size()) return std::nullopt;
    return number;
}

std::string day_words(const std::string& iso, const DocumentLanguage& in) {
    if (iso.size() != 10 || iso[4] != '-' || iso[7] != '-') return iso;
    const auto year = whole_number(iso.substr(0, 4)), month = whole_number(iso.substr(5, 2)),
               day = whole_number(iso.substr(8, 2));
    if (!year || !month || !day || *month < 1 || *month > months.size()) return iso;
    return in.say(day_month_year, {std::to_string(*day), in.say(months[*month - 1]), std::to_string(*year)});
}

}  // namespace

std::string date_words(const std::string& iso, const DocumentLanguage& in) {
    const std::size_t slash = iso.find('/');
    if (slash == std::string::npos) return day_words(iso, in);
    return in.say(certificate_words::dates,
                  {day_words(iso.substr(0, slash), in), day_words(iso.substr(slash + 1), in)});
}

}  // namespace covaria
