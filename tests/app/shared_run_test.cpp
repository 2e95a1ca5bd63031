// Runs that several processes share: parts, merging, ranks.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "program.h"

namespace covaria::shared_run_test {

namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

Words joined(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

/// A run of one process, and the same in parts.
class SharedRun {
public:
    SharedRun(const std::string& name, const std::string& project, Words options)
        : folder_(fresh_folder(name)),
          project_(shipped_project(project).string()),
          options_(std::move(options)) {
        const Outcome run =
            run_program(joined(joined({"run", project_}, options_), {"--out", (folder_ / "one").string()}));
        EXPECT_EQ(run.status, 0) << run.err;
    }
    Outcome part(int k, int n, const Words& more = {}) const {
        return run_program(
            joined(joined({"part", project_, "--part", std::to_string(k) + "/" + std::to_string(n), "--out",
                           parts().string()},
                          options_),
                   more));
    }
    Outcome merge(const Words& more = {}) const {
        fs::remove_all(folder_ / "merged");
        return run_program(joined({"merge", parts().string(), "--out", (folder_ / "merged").string()}, more));
    }
    void expect_same_bits(const Outcome& merged) const {
        ASSERT_EQ(merged.status, 0) << merged.err;
        EXPECT_TRUE(read_text(folder_ / "one" / "results.json") ==
                    read_text(folder_ / "merged" / "results.json"))
            << "other bits than those of one process";
    }
    fs::path parts() const { return folder_ / "parts"; }
    const std::string& project() const { return project_; }

private:
    fs::path folder_;
    std::string project_;
    Words options_;
};

}  // namespace

TEST(SharedRun, PartsGiveTheBitsOfOneProcess) {
    for (const char* reduction : {"none", "control-variate", "sobol"}) {
        SCOPED_TRACE(reduction);
        const SharedRun run(std::string("parts-") + reduction, "stewart-platform.covaria",
                            {"--trials", "55000", "--variance-reduction", reduction});
        for (const int k : {3, 1, 2}) EXPECT_EQ(run.part(k, 3, {"--threads", std::to_string(k)}).status, 0);
        run.expect_same_bits(run.merge());
    }
}

TEST(SharedRun, AnAdaptiveRunNeedsThePartsThatItWouldHaveMade) {
    const SharedRun run("parts-adaptive", "gum/s1-9.3-mass.covaria", {"--adaptive"});
    // No more than those are computed: of a hundred million trials that it may have made, all would take
    // hours.
    for (const int k : {1, 2, 3}) EXPECT_EQ(run.part(k, 3).status, 0);
    run.expect_same_bits(run.merge());
}

TEST(SharedRun, APartThatIsAllOfAnAdaptiveRunStopsWithIt) {
    const SharedRun run("parts-adaptive-alone", "gum/s1-9.3-mass.covaria", {"--adaptive"});
    EXPECT_EQ(run.part(1, 1).status, 0);
    run.expect_same_bits(run.merge());
}

TEST(SharedRun, PointsOfStudiesAreShared) {
    const SharedRun run("parts-study", "lsm-network.covaria", {"--trials", "20000"});
    for (const int k : {1, 2}) EXPECT_EQ(run.part(k, 2).status, 0);
    run.expect_same_bits(run.merge());
}

TEST(SharedRun, WhatIsMissingIsNamedAndResumed) {
    const SharedRun run("parts-missing", "stewart-platform.covaria", {"--trials", "60000"});
    for (const int k : {1, 3}) EXPECT_EQ(run.part(k, 3).status, 0);
    const Outcome refused = run.merge();
    EXPECT_EQ(refused.status, 1);
    EXPECT_NE(refused.err.find("missing: 3-4"), std::string::npos) << refused.err;
    run.expect_same_bits(run.merge({"--resume"}));
    // The units that were computed are in the folder now.
    run.expect_same_bits(run.merge());
    const Outcome there = run.part(1, 3, {"--resume"});
    EXPECT_NE(there.out.find("is there"), std::string::npos) << there.out;
}

TEST(SharedRun, PartsOfSomethingElseAreRefusedByName) {
    const SharedRun run("parts-foreign", "gum/s1-9.3-mass.covaria", {"--trials", "30000"});
    ASSERT_EQ(run.part(1, 2).status, 0);
    ASSERT_EQ(run.part(2, 2).status, 0);
    const fs::path file = run.parts() / "part-2-of-2.part";
    const std::string good = read_text(file);
    const auto expect_refused = [&](const std::string& word) {
        const Outcome refused = run.merge();
        EXPECT_EQ(refused.status, 1);
        EXPECT_NE(refused.err.find("part-2-of-2.part"), std::string::npos) << refused.err;
        EXPECT_NE(refused.err.find(word), std::string::npos) << refused.err;
    };
    std::string damaged = good;
    damaged[damaged.size() / 2] ^= 1;
    write_text(file, damaged);
    expect_refused("damaged");
    write_text(file, good.substr(0, good.size() / 2));
    expect_refused("damaged");
    const std::string stewart = shipped_project("stewart-platform.covaria").string();
    ASSERT_EQ(
        run_program({"part", stewart, "--trials", "30000", "--part", "2/2", "--out", run.parts().string()})
            .status,
        0);
    expect_refused("another project");
    ASSERT_EQ(run_program({"part", run.project(), "--trials", "30000", "--seed", "7", "--part", "2/2",
                           "--out", run.parts().string()})
                  .status,
              0);
    expect_refused("another state");
}

TEST(SharedRun, OneUnitIsReplayedAlone) {
    const std::string project = shipped_project("gum/s1-9.3-mass.covaria").string();
    const Outcome replayed = run_program({"part", project, "--trials", "30000", "--unit", "3"});
    EXPECT_EQ(replayed.status, 0) << replayed.err;
    EXPECT_NE(replayed.out.find("unit 3 of "), std::string::npos) << replayed.out;
    EXPECT_EQ(run_program({"part", project}).status, 2);
    EXPECT_EQ(run_program({"part", project, "--part", "3/2"}).status, 2);
}

TEST(SharedRun, TheScriptsOfBatchSystemsAreWhatAShellReads) {
    const std::string project = shipped_project("gum/s1-9.3-mass.covaria").string();
    for (const char* system : {"--slurm", "--parallel", "--mpi"}) {
        const Outcome script =
            run_program({"submit", project, "--set", "/title=it's", "--parts", "7", system});
        ASSERT_EQ(script.status, 0) << script.err;
        const fs::path file = fresh_folder("submit") / "script";
        write_text(file, script.out);
        EXPECT_EQ(std::system(("bash -n " + file.string()).c_str()), 0) << script.out;
    }
    EXPECT_EQ(run_program({"submit", project}).status, 2);
}

#ifdef COVARIA_MPI_PROGRAM

namespace {

int run_ranks(int ranks, const std::string& arguments) {
    const std::string command =
        "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 timeout 120 mpirun --oversubscribe "
        "--allow-run-as-root -n " +
        std::to_string(ranks) + " " COVARIA_MPI_PROGRAM " run " + arguments + " >/dev/null 2>&1";
    return std::system(command.c_str());
}

}  // namespace

TEST(SharedRun, RanksGiveTheBitsOfOneProcess) {
    const fs::path folder = fresh_folder("ranks");
    const std::string project = shipped_project("stewart-platform.covaria").string();
    ASSERT_EQ(run_program({"run", project, "--trials", "60000", "--out", (folder / "one").string()}).status,
              0);
    for (const int ranks : {1, 3}) {
        const fs::path parts = folder / ("parts-" + std::to_string(ranks)), out = folder / "many";
        fs::remove_all(out);
        const std::string arguments =
            project + " --trials 60000 --journal " + parts.string() + " --out " + out.string();
        ASSERT_EQ(run_ranks(ranks, arguments), 0);
        EXPECT_TRUE(read_text(folder / "one" / "results.json") == read_text(out / "results.json"));
        // A journal is not mixed with another run by accident; what it lacks is computed when asked for.
        EXPECT_NE(run_ranks(ranks, arguments), 0);
        fs::remove(fs::directory_iterator(parts)->path());
        fs::remove_all(out);
        ASSERT_EQ(run_ranks(ranks, arguments + " --resume"), 0);
        EXPECT_TRUE(read_text(folder / "one" / "results.json") == read_text(out / "results.json"));
    }
}

#endif

}  // namespace covaria::shared_run_test
