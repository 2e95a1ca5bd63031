#include "core/project/review.h"

#include "core/base/dates.h"

namespace covaria {

const std::vector<ReviewStepField>& review_steps() {
    static const std::vector<ReviewStepField> steps{
        {"prepared", "Prepared by", "Who set up and evaluated the project.", &Review::prepared},
        {"checked", "Checked by", "Who checked it.", &Review::checked},
        {"released", "Released by", "Who authorised it (ISO/IEC 17025 7.8.1.1).", &Review::released}};
    return steps;
}

void check_review(const Review& review, Problems& problems) {
    std::optional<Days> before;
    for (const ReviewStepField& step : review_steps()) {
        const std::string& date = (review.*step.member).date;
        const std::string path = std::string("/review/") + step.key + "/date";
        const auto day = date_of(date);
        if (!date.empty() && !day)
            problems.error(path, tell<"the date of '%1' must be of the form 2026-04-17; it is '%2'">(
                                     Message::declared(step.title), date));
        if (day && before && *day < *before)
            problems.warning(path, tell<"the date of '%1' is before that of the step before it">(
                                       Message::declared(step.title)));
        if (day) before = day;
    }
    for (std::size_t i = 0; i < review.log.size(); ++i)
        if (const std::string& date = review.log[i].date; !date_of(date))
            problems.error("/review/log/" + std::to_string(i) + "/date",
                           tell<"a date of the form 2026-04-17 is needed; it is '%1'">(date));
}

}  // namespace covaria
