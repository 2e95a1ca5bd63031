// The entries that an edit in the window makes and evaluates anew, counted.
#include "tests/core/made.h"
#include "tests/ui/main_window/session_fixture.h"

namespace covaria::ui::making_session_test {
namespace {

class MakingSession : public Session {
protected:
    MakingSession() {
        open(project_copy());
        wait_until_idle();
        remember();
    }
    const MadeProject& made() const { return *window_->document().maker().made(); }
    const AnalysisStatus& status_of(const char* id) const { return window_->runner().status(id); }
    void remember() {
        for (const char* id : {"printed", "from-artefacts"}) {
            result_[id] = status_of(id).result;
            law_[id] = &status_of(id).prepared->propagated->propagation();
            ASSERT_TRUE(status_of(id).is_current()) << id;
        }
    }
    /// Applies an edit; returns how much was made anew.
    MakingCounts edit(const ProjectEdit& change) {
        QSignalSpy made_anew(&window_->document().maker(), &ProjectMaker::made_changed);
        EXPECT_TRUE(window_->document().apply(QStringLiteral("Edit"), change));
        wait_until_idle();
        EXPECT_EQ(made_anew.count(), 1) << "one edit is made once for all who look at it";
        EXPECT_TRUE(status_of("printed").is_current() && status_of("from-artefacts").is_current());
        return made().counts();
    }
    bool has_same_result(const char* id) const { return status_of(id).result == result_.at(id); }
    bool has_same_law(const char* id) const {
        return &status_of(id).prepared->propagated->propagation() == law_.at(id);
    }

    std::map<std::string, ResultPointer> result_;
    std::map<std::string, const Result<Propagation>*> law_;
};

TEST_F(MakingSession, AFileIsMadeOnceWhenItIsOpened) {
    QSignalSpy made_anew(&window_->document().maker(), &ProjectMaker::made_changed);
    open(project_copy());
    wait_until_idle();
    EXPECT_EQ(made_anew.count(), 1);
    expect_counts(made().counts(), {.assets = 2, .models = 2, .inputs = 2, .taken = 0});
    EXPECT_EQ(made().snapshot(), window_->document().snapshot());
}

TEST_F(MakingSession, TitlesAndNotesMakeAndEvaluateNothing) {
    expect_counts(edit([](Project& p) {
                      p.title = "Another title";
                      p.assets[0].notes = p.analyses[0].notes = "noted";
                  }),
                  {.assets = 0, .models = 0, .inputs = 0, .taken = 4});
    EXPECT_TRUE(has_same_result("printed") && has_same_result("from-artefacts"));
    EXPECT_TRUE(has_same_law("printed") && has_same_law("from-artefacts"));
}

TEST_F(MakingSession, AnAssetMakesItselfAndItsDependents) {
    expect_counts(edit([](Project& p) {
                      for (AssetEntry& asset : p.assets)
                          if (asset.id == "artefact-2d")
                              asset.setup.values["temperature_deviation"] = Quantity{0.9, Unit::of("K")};
                  }),
                  {.assets = 1, .models = 1, .inputs = 1, .taken = 2});
    EXPECT_TRUE(has_same_result("printed") && has_same_law("printed"));
    EXPECT_FALSE(has_same_result("from-artefacts") || has_same_law("from-artefacts"));
}

TEST_F(MakingSession, ARenamedAssetIsEvaluatedNowhere) {
    edit([](Project& p) {
        for (AssetEntry& asset : p.assets) asset.name += " (new)";
    });
    EXPECT_EQ(made().counts().assets, 0u);
    EXPECT_TRUE(has_same_law("printed") && has_same_law("from-artefacts"));
    EXPECT_TRUE(has_same_result("printed"));
}

TEST_F(MakingSession, AnOptionMakesNoModelAndSharesTheLawOfPropagation) {
    expect_counts(edit([](Project& p) { p.analyses[0].options.trials = 10'000; }),
                  {.assets = 0, .models = 0, .inputs = 0, .taken = 4});
    EXPECT_FALSE(has_same_result("printed"));
    EXPECT_TRUE(has_same_law("printed"));
    EXPECT_TRUE(has_same_result("from-artefacts"));
}

TEST_F(MakingSession, ALimitIsJudgedWithoutARun) {
    Requirement limit{status_of("printed").result->outputs[0].quantity.group,
                      status_of("printed").result->outputs[0].quantity.symbol};
    limit.target_uncertainty = Quantity{1.0, status_of("printed").result->outputs[0].quantity.unit};
    expect_counts(edit([&](Project& p) { p.analyses[0].requirements = {limit}; }),
                  {.assets = 0, .models = 0, .inputs = 0, .taken = 4});
    EXPECT_TRUE(has_same_result("printed") && has_same_law("printed"));
}

}  // namespace
}  // namespace covaria::ui::making_session_test
