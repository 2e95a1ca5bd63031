// The first offer for a new study or design.
#include "ui/document/inquiry_edits.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/made/load_project.h"
#include "core/project/study_target.h"

namespace covaria::ui::inquiry_edits_test {
namespace {

std::string first_variable(const std::string& example, const std::string& analysis) {
    const LoadedProject loaded = load_project(COVARIA_SOURCE_DIR "/projects/" + example + ".covaria");
    const Design design = new_design(loaded.project, *loaded.project.find_analysis(analysis));
    if (design.variables.empty()) return {};
    const StudyAxis& number = design.variables.front().number;
    EXPECT_EQ(number.change, StudyChange::value) << "one number, not a factor of a column";
    return number.asset + number.target;
}

TEST(NewDesign, AnInstrumentsPlaceIsChosenFirst) {
    EXPECT_EQ(first_variable("tracker-pose", "tracker-alone"), "tracker/setup/station/position/0");
    EXPECT_EQ(first_variable("lsm-network", "recommended"), "camera-1/setup/station/position/0");
}

TEST(NewStudy, MovesAnInstrumentByAMetre) {
    const LoadedProject loaded = load_project(COVARIA_SOURCE_DIR "/projects/tracker-pose.covaria");
    const Study study = new_study(loaded.project, *loaded.project.find_analysis("tracker-alone"));
    ASSERT_EQ(study.axes.size(), 1U);
    const StudyAxis& axis = study.axes.front();
    EXPECT_EQ(axis.asset + axis.target, "tracker/setup/station/position/0");
    EXPECT_DOUBLE_EQ(axis.unit.interval_to_si(axis.to - axis.from), 2.0);
    const LoadedProject typed = load_project(COVARIA_SOURCE_DIR "/projects/gum/h1-end-gauge.covaria");
    EXPECT_EQ(new_study(typed.project, typed.project.analyses.front()).axes.size(), 1U) << "nothing to move";
}

TEST(NewStudy, IsAMapOverTheSecondAndThirdJointOfARobot) {
    const LoadedProject loaded = load_project(COVARIA_SOURCE_DIR "/projects/er10l-c10.covaria");
    const Study study = new_study(loaded.project, *loaded.project.find_analysis("zero-pose-nominal"));
    ASSERT_EQ(study.axes.size(), 2U);
    EXPECT_TRUE(study.axes[0].target.ends_with("/q_2")) << study.axes[0].target;
    EXPECT_TRUE(study.axes[1].target.ends_with("/q_3")) << study.axes[1].target;
    for (const StudyAxis& axis : study.axes) {
        EXPECT_TRUE(axis.target.starts_with("/setup/poses/rows/0/")) << axis.target;
        EXPECT_DOUBLE_EQ(axis.unit.interval_to_si(axis.to - axis.from), 0.5 * std::numbers::pi);
    }
}

TEST(NewDesign, NothingThatWasMeasuredIsChosen) {
    for (const auto& [example, analysis] : {std::pair("ballbar-design", "points"),
                                            {"er10l-c10", "trajectories"},
                                            {"er10l-c10", "poses-measured"},
                                            {"force-moment-sensor", "reading"},
                                            {"gum/h1-end-gauge", "table"},
                                            {"gum/h3-thermometer", "residuals"}}) {
        const LoadedProject loaded =
            load_project(COVARIA_SOURCE_DIR "/projects/" + std::string(example) + ".covaria");
        const AnalysisEntry& entry = *loaded.project.find_analysis(analysis);
        std::vector<DesignVariable> chosen;
        for (int i = 0; i < 3; ++i) {
            const auto next = next_variable(loaded.project, entry, chosen);
            ASSERT_TRUE(next) << example;
            const auto target = find_study_target(loaded.project, entry, nullptr, next->number);
            ASSERT_TRUE(target) << next->number.target;
            EXPECT_FALSE(target->measured) << example << ": " << next->number.target;
            EXPECT_FALSE(target->whole) << example << ": " << next->number.target;
            for (const DesignVariable& before : chosen) EXPECT_NE(before.number.target, next->number.target);
            chosen.push_back(*next);
        }
    }
}

}  // namespace
}  // namespace covaria::ui::inquiry_edits_test
