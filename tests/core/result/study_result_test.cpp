// The quantities that a study shows: each has a name of its own, and its own numbers.
#include "core/result/study_result.h"

#include <gtest/gtest.h>

#include <set>

namespace covaria::study_result_test {
namespace {

/// One point in several poses, whose variances are 1, 2, 3 ... um^2.
StudyResult one_point_in(const std::vector<std::string>& groups) {
    StudyResult study;
    study.points.emplace_back();
    for (const std::string& group : groups) {
        StudyTriple triple{"o_p"};
        for (std::size_t i = 0; i < 3; ++i) {
            triple.outputs[i] = study.outputs.size();
            study.outputs.push_back(
                {.symbol = std::string(1, "xyz"[i]), .unit = Unit::of("mm"), .group = group});
            study.points[0].values.emplace_back();
        }
        study.triples.push_back(triple);
        StudyPlace place;
        place.covariance(0, 0) = 1e-12 * double(study.triples.size());
        study.points[0].places.push_back(place);
    }
    return study;
}

TEST(StudyQuantities, APointOfSeveralPosesIsToldApart) {
    const StudyResult study = one_point_in({"pose 1", "pose 6", "pose 12"});
    std::set<std::string> ids;
    std::set<double> values;
    for (const StudyQuantity& quantity : study_quantities(study)) {
        EXPECT_TRUE(ids.insert(quantity.id).second) << quantity.id << " stands twice";
        if (quantity.position) values.insert(value_at(study, quantity, 0));
    }
    EXPECT_EQ(values.size(), 3U);
    EXPECT_TRUE(ids.contains("u(3D), o_p, pose 6"));
}

TEST(StudyQuantities, OnePointNeedsNoPose) {
    EXPECT_EQ(study_quantities(one_point_in({"pose 1"})).front().id, "u(3D), o_p");
}

}  // namespace
}  // namespace covaria::study_result_test
