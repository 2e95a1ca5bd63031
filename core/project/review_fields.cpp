#include "core/project/review_fields.h"

namespace covaria {

namespace {

JsonFields<ReviewStep> step_fields() {
    return JsonFields<ReviewStep>(tell<"a step of the review">(), JsonWriter::Style::one_line)
        .required("name", &ReviewStep::name)
        .add("date", &ReviewStep::date);
}

JsonFields<ReleasedPart> part_fields() {
    return JsonFields<ReleasedPart>(tell<"a part that was released">(), JsonWriter::Style::one_line)
        .required("place", &ReleasedPart::place)
        .add("name", &ReleasedPart::name)
        .required("digest", &ReleasedPart::digest);
}

JsonFields<ReviewEntry> entry_fields() {
    return JsonFields<ReviewEntry>(tell<"an entry of the log">(), JsonWriter::Style::one_line)
        .required("date", &ReviewEntry::date)
        .add("who", &ReviewEntry::who)
        .required("what", &ReviewEntry::what);
}

}  // namespace

const JsonFields<Review>& review_fields() {
    static const auto fields = [] {
        JsonFields<Review> all(tell<"the review">());
        for (const ReviewStepField& step : review_steps())
            all.add(step.key, step.member, ObjectOf{step_fields()});
        all.add("digest", &Review::digest);
        all.add("parts", &Review::parts, ListOf{part_fields()});
        all.add("log", &Review::log, ListOf{entry_fields()});
        return all;
    }();
    return fields;
}

}  // namespace covaria
