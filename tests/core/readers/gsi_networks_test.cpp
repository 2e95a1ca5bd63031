// GSI files of several set-ups as networks: a simulated one against its coordinates, real ones evaluated.
#include <Eigen/Core>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <numbers>
#include <random>

#include "core/kinds/registries.h"
#include "core/readers/rounds.h"
#include "tests/core/readers/adjusted_import.h"

namespace covaria::readers_test {

namespace {

namespace fs = std::filesystem;

/// A file as a total station of GSI-16 writes it, one block a line.
class GsiFile {
public:
    GsiFile& block(const std::string& point) {
        char text[40];
        std::snprintf(text, sizeof text, "*11%04d+%16s ", ++number_ % 10000, point.c_str());
        std::string word = text;
        std::replace(word.begin() + 8, word.end() - 1, ' ', '0');
        text_ += (number_ > 1 ? "\n" : "") + word;
        return *this;
    }
    GsiFile& gon(int index, double value) {
        return word(index, "..02", std::fmod(value + 800.0, 400.0) * 1e5);
    }
    GsiFile& metres(int index, double value) { return word(index, "..08", value * 1e5); }
    const std::string& text() const { return text_; }

private:
    GsiFile& word(int index, const char* information, double digits) {
        char text[40];
        std::snprintf(text, sizeof text, "%02d%s%c%016.0f ", index, information, digits < 0.0 ? '-' : '+',
                      std::abs(std::round(digits)));
        text_ += text;
        return *this;
    }
    std::string text_;
    int number_ = 0;
};

struct Simulated {
    std::map<std::string, Eigen::Vector3d> stations{
        {"S1", {100.0, 200.0, 50.0}}, {"S2", {142.0, 231.0, 51.2}}, {"S3", {118.0, 262.0, 49.1}}},
        targets{{"T1", {90.0, 240.0, 55.0}},  {"T2", {150.0, 190.0, 47.0}}, {"T3", {130.0, 240.0, 60.0}},
                {"T4", {112.0, 225.0, 52.0}}, {"T5", {160.0, 265.0, 58.0}}, {"T6", {95.0, 275.0, 46.0}}};
    double u_angle = 0.0005, u_distance = 0.0006;  // gon, m
    int rounds = 3;
    bool told = false;

    std::string file() const {
        std::mt19937_64 random(20261129);
        const auto noise = [&random] {
            const double a = (double(random() >> 11) + 0.5) * 0x1p-53, b = double(random() >> 11) * 0x1p-53;
            return std::sqrt(-2.0 * std::log(a)) * std::cos(2.0 * std::numbers::pi * b);
        };
        GsiFile gsi;
        for (const char* control : {"T1", "T2"}) {
            const Eigen::Vector3d& p = targets.at(control);
            gsi.block(control).metres(81, p.x()).metres(82, p.y()).metres(83, p.z());
        }
        const double gon = 200.0 / std::numbers::pi, hi = 1.55, ht = 0.1, index = 0.004, collimation = -0.003;
        double zero = 13.0;
        for (const auto& [station, s] : stations) {
            gsi.block(station);
            if (told) gsi.metres(84, s.x() + 0.02).metres(85, s.y() - 0.01).metres(86, s.z());
            gsi.metres(88, hi);
            for (int round = 0; round < rounds; ++round, zero += 67.0)
                for (const bool second : {false, true})
                    for (const auto& [target, p] : targets) {
                        Eigen::Vector3d v = p - s;
                        v.z() += ht - hi - 0.87 * v.head<2>().squaredNorm() / (2.0 * 6371e3);
                        const double zenith = std::atan2(v.head<2>().norm(), v.z()) * gon,
                                     side = second ? -1.0 : 1.0;
                        const double read = zenith + u_angle * noise() + side * index;
                        gsi.block(target)
                            .gon(21, std::atan2(v.x(), v.y()) * gon + zero + (second ? 200.0 : 0.0) +
                                         side * collimation / std::sin(zenith / gon) + u_angle * noise())
                            .gon(22, second ? 400.0 - read : read)
                            .metres(31, v.norm() + u_distance * noise())
                            .metres(87, ht);
                    }
        }
        return gsi.text() + "\n";
    }
};

void expect_truth(const AdjustedImport& made, const std::map<std::string, Eigen::Vector3d>& points,
                  bool are_control_fixed) {
    for (const auto& [name, p] : points)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::string key = name + "_" + "xyz"[axis];
            if (are_control_fixed && (name == "T1" || name == "T2")) {
                EXPECT_FALSE(made.estimate.contains(key)) << key;
                continue;
            }
            ASSERT_TRUE(made.estimate.contains(key)) << key << "\n" << made.found;
            EXPECT_LT(std::abs(made.estimate.at(key) - p[static_cast<Eigen::Index>(axis)]),
                      4.0 * made.u.at(key))
                << key;
            EXPECT_LT(made.u.at(key), 1e-3) << key;
        }
}

TEST(GsiNetworks, ThreeStationsWithTwoControlPointsAreFound) {
    const Simulated site;
    const AdjustedImport made = adjusted(read_with("gsi", site.file(), {.file_name = "site.gsi"}));
    expect_truth(made, site.stations, false);
    expect_truth(made, site.targets, true);
    // 3 stations with 3 rounds of 6 targets in 2 faces, 3 readings each; unknowns: 3 x 3 and 4 x 3
    // coordinates, 9 orientations, index, collimation.
    EXPECT_EQ(made.degrees_of_freedom, 324.0 - (9 + 12 + 9 + 2)) << made.found;
    EXPECT_GT(made.s0, 0.85);
    EXPECT_LT(made.s0, 1.15);
    for (const char* words : {"from 3 set-ups in 9 rounds", "rounds repeat",
                              "coordinates of their own are fixed", "index and collimation are unknown"})
        EXPECT_NE(made.found.find(words), std::string::npos) << words << "\n" << made.found;
}

TEST(GsiNetworks, CoordinatesThatTheInstrumentWasToldAreApproximate) {
    Simulated site;
    site.told = true;
    site.rounds = 1;
    const AdjustedImport made = adjusted(read_with("gsi", site.file(), {.file_name = "site.gsi"}));
    EXPECT_NE(made.found.find("nothing is repeated"), std::string::npos) << made.found;
    EXPECT_NE(made.found.find("are approximate ones beside 2 points"), std::string::npos) << made.found;
    for (const auto& [name, p] : site.stations)
        EXPECT_NEAR(made.estimate.at(name + "_x"), p.x(), 4.0 * made.u.at(name + "_x"));
}

TEST(GsiNetworks, SetUpsThatSeeNoCommonPointsStayApart) {
    const auto read = read_with(
        "gsi",
        "*110001+00000000000000S1 84..06+0000000000100000 85..06+0000000000200000 86..06+0000000000010000 \n"
        "*110002+00000000000000T1 21..02+0000000000000000 22..02+0000000010000000 31..06+0000000000100000 \n"
        "*110003+00000000000000S2 84..06+0000000000300000 85..06+0000000000200000 86..06+0000000000010000 \n"
        "*110004+00000000000000T2 21..02+0000000000000000 22..02+0000000010000000 31..06+0000000000100000 "
        "\n");
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_TRUE(read->analyses.empty());
    EXPECT_EQ(read->assets.size(), 2u);
}

class GsiExamples : public testing::Test {
protected:
    const fs::path examples = "/work/shared/formats/gsi";
    void SetUp() override {
        if (!fs::exists(examples)) GTEST_SKIP() << "real files of GSI are not beside the checkout";
    }
};

TEST_F(GsiExamples, ATraverseInTwoFacesIsAFreeNetwork) {
    const AdjustedImport made = adjusted(import(examples / "rounds-two-faces.gsi"));
    EXPECT_NE(made.found.find("from 5 set-ups"), std::string::npos) << made.found;
    EXPECT_NE(made.found.find("no coordinates tell"), std::string::npos)
        << "five stations at one place were told none\n"
        << made.found;
    for (const char* point : {"6", "7", "8", "9", "10", "11"})
        EXPECT_TRUE(made.estimate.contains(std::string(point) + "_z")) << point;
    EXPECT_GT(made.degrees_of_freedom, 300.0);
    EXPECT_NE(made.found.find("close without them"), std::string::npos)
        << "1.645 m at 8, and 0 where 8 is sighted\n"
        << made.found;
    EXPECT_LT(made.s0, 3.0);
}

TEST_F(GsiExamples, SurveysOfSingleStationsKeepTheirPoints) {
    for (const char* name : {"RILIEVO.gsi", "leica_gsi16_gurob.gsi", "leica_gsi8_ertola.gsi"}) {
        const auto read = import(examples / name);
        ASSERT_TRUE(read) << name;
        EXPECT_EQ(errors_of(*read), "") << name;
        EXPECT_FALSE(read->assets.empty()) << name;
    }
}

}  // namespace

}  // namespace covaria::readers_test
