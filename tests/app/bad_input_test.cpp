// Broken files and hostile places: a clear message, status 1, and nothing lost.
#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "tests/app/program.h"

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

class BadInput : public testing::Test {
protected:
    void SetUp() override {
        folder_ =
            fresh_folder(std::string("bad-") + testing::UnitTest::GetInstance()->current_test_info()->name());
        const fs::path projects = shipped_project("");
        for (const auto& entry : fs::directory_iterator(projects))
            if (entry.is_regular_file()) fs::copy_file(entry.path(), folder_ / entry.path().filename());
        file_ = folder_ / "stewart-platform.covaria";
    }

    void edit(const std::function<void(ordered_json&)>& change) {
        ordered_json project = ordered_json::parse(read_text(file_));
        change(project);
        write_text(file_, project.dump(1));
    }
    void replace(const std::string& what, const std::string& with) {
        std::string text = read_text(file_);
        const auto at = text.find(what);
        ASSERT_NE(at, std::string::npos) << what;
        write_text(file_, text.replace(at, what.size(), with));
    }
    /// Validates and runs: both must refuse with a message that contains all the words.
    void expect_refusal(const std::vector<std::string>& words) {
        const std::string before = read_text(file_);
        for (const Outcome& outcome : {run_program({"validate", file_.string()}),
                                       run_program({"run", file_.string(), "--trials", "1000", "--out",
                                                    (folder_ / "out").string()})}) {
            EXPECT_EQ(outcome.status, 1) << outcome.err;
            for (const std::string& word : words)
                EXPECT_NE(outcome.err.find(word), std::string::npos) << word << " is not in: " << outcome.err;
        }
        EXPECT_EQ(read_text(file_), before);
    }

    fs::path folder_, file_;
};

TEST_F(BadInput, CollinearPoints) {
    edit([](ordered_json& p) {
        auto& rows = p["analyses"][0]["setup"]["base_points"]["rows"];
        for (int i = 1; i <= 3; ++i) rows[2][i] = 0.5 * (rows[0][i].get<double>() + rows[1][i].get<double>());
    });
    expect_refusal({"b3", "base_points"});
}

TEST_F(BadInput, CoincidentPoints) {
    edit([](ordered_json& p) {
        auto& rows = p["analyses"][0]["setup"]["base_points"]["rows"];
        for (int i = 1; i <= 3; ++i) rows[1][i] = rows[0][i];
    });
    expect_refusal({"b1", "b2"});
}

TEST_F(BadInput, UnknownKey) {
    edit([](ordered_json& p) { p["analyses"][0]["setup"]["base_poinst"] = 1; });
    expect_refusal({"base_poinst", "base_points"});
}

TEST_F(BadInput, NewerVersion) {
    edit([](ordered_json& p) { p["schemaVersion"] = 7; });
    expect_refusal({"newer", "7"});
}

TEST_F(BadInput, MissingCsv) {
    fs::remove(folder_ / "stewart-platform-artefact.csv");
    expect_refusal({"stewart-platform-artefact.csv"});
}

TEST_F(BadInput, TruncatedFile) {
    const std::string text = read_text(file_);
    write_text(file_, text.substr(0, text.size() / 2));
    expect_refusal({"stewart-platform.covaria"});
}

TEST_F(BadInput, NanInTheFile) {
    replace("-344", "NaN");
    expect_refusal({"stewart-platform.covaria:"});
}

TEST_F(BadInput, InfinityInTheFile) {
    replace("-344", "1e999");
    expect_refusal({"stewart-platform.covaria"});
}

TEST_F(BadInput, WrongUnit) {
    replace("x [mm]", "x [K]");
    expect_refusal({"length"});
}

TEST_F(BadInput, CorrelationMatrixThatIsNotPositiveSemiDefinite) {
    const fs::path out = folder_ / "out";
    run_program({"run", file_.string(), "--trials", "1000", "--out", out.string()});
    edit([](ordered_json& p) {
        p["analyses"][0]["correlations"] = ordered_json::array();
        const std::string ids[] = {"b_1x.typed", "b_1y.typed", "b_1z.typed"};
        for (auto [a, b, r] : {std::tuple{0, 1, 0.9}, std::tuple{1, 2, 0.9}, std::tuple{0, 2, -0.9}})
            p["analyses"][0]["correlations"].push_back(
                {{"first", ids[a]}, {"second", ids[b]}, {"coefficient", r}});
    });
    expect_refusal({"correlation"});
}

TEST_F(BadInput, FileThatDoesNotExist) {
    const Outcome run =
        run_program({"run", (folder_ / "nothing.covaria").string(), "--out", folder_.string()});
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.err.find("nothing.covaria"), std::string::npos);
}

TEST_F(BadInput, OutputFolderThatCannotBeMade) {
    const Outcome run =
        run_program({"run", file_.string(), "--trials", "1000", "--out", (file_ / "out").string()});
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.err.find("cannot make the folder"), std::string::npos) << run.err;
}

TEST_F(BadInput, FullDiskKeepsTheOldResults) {
    const Outcome run =
        run_program({"render", file_.string(), "--trials", "1000", "-o", "/dev/full/picture.png"});
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.err.find("/dev/full"), std::string::npos) << run.err;
}

}  // namespace
