// The review of a project as its documents state it.
#include "core/project/release.h"
#include "core/report/date_words.h"
#include "core/report/report_parts.h"

namespace covaria::report_parts {

void add_review(FactsBlock& facts, const Project& project, const DocumentLanguage& in) {
    const ReleaseStatus status = release_status(project);
    const Review& review = project.review;
    const auto by_and_on = [&](const ReviewStep& step) {
        return step.date.empty() ? step.name : step.name + ", " + date_words(step.date, in);
    };
    const std::string draft = in.say(tell<"Draft">());
    if (status.state == ReleaseState::unreviewed) return;
    if (status.state == ReleaseState::draft)
        facts.facts.emplace_back(draft, in.say(tell<"it was not released">()));
    if (status.state == ReleaseState::changed) {
        facts.facts.emplace_back(draft, in.say(tell<"changed since the release by %1: %2">(
                                            by_and_on(review.released), list_of_changes(status))));
        return;
    }
    for (const ReviewStepField& step : review_steps())
        if (const ReviewStep& done = review.*step.member; !done.name.empty())
            facts.facts.emplace_back(in.say_declared(step.title), by_and_on(done));
    if (status.state == ReleaseState::released)
        facts.facts.emplace_back(in.say(tell<"Digest of the release">()), review.digest);
}

}  // namespace covaria::report_parts
