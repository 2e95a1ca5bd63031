// projects/lsm-network.covaria to be varied, and rows of numbers to be compared. Millimetres.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/resource_path.h"
#include "tests/core/made.h"

namespace covaria {

using Row = std::vector<double>;

struct Network {
    Network() : project(load_project(data_directory() / "projects/lsm-network.covaria").project) {}

    Setup& setup(const std::string& id = "paper") { return find(id).setup; }
    AnalysisEntry& find(const std::string& id) {
        for (AnalysisEntry& analysis : project.analyses)
            if (analysis.id == id) return analysis;
        throw std::out_of_range(id);
    }
    Setup& asset(const std::string& id) {
        for (AssetEntry& asset : project.assets)
            if (asset.id == id) return asset.setup;
        throw std::out_of_range(id);
    }
    SetupTable& table(const std::string& key, const std::string& id = "paper") {
        return std::get<SetupTable>(setup(id).values.at(key));
    }
    void keep_sensors(const std::vector<std::string>& ids, const std::string& analysis = "paper") {
        SetupTable& sensors = table("sensors", analysis);
        sensors.rows.clear();
        for (const std::string& id : ids) sensors.rows.push_back({id});
    }
    void keep_target(const std::string& name, const std::array<double, 3>& mm,
                     const std::string& analysis = "paper") {
        table("targets", analysis).rows = {{name, mm[0], mm[1], mm[2], false}};
        table("distances", analysis).rows.clear();
    }
    void fix_stations() {
        for (AssetEntry& entry : project.assets)
            for (auto& [key, value] : entry.setup.values)
                if (key.rfind("u_station", 0) == 0) std::get<Quantity>(value).value = 0.0;
    }

    std::shared_ptr<const PreparedAnalysis> prepare(const std::string& id = "paper") {
        problems = {};
        Problems of_assets;
        assets = made_assets(project, of_assets);
        return made_analysis(project, id, problems);
    }
    UncertaintyResult run(const std::string& id, std::uint64_t trials) {
        AnalysisEntry& analysis = find(id);
        analysis.options.method = trials == 0 ? Method::first_order : Method::monte_carlo;
        if (trials > 0) analysis.options.trials = trials;
        const auto prepared = prepare(id);
        if (!prepared) throw std::runtime_error(words());
        return *run_analysis(*prepared, {});
    }
    std::string words() const {
        std::string text;
        for (const Problem& problem : problems.items())
            text += problem.path + ": " + problem.message.english() + "\n";
        return text;
    }

    Project project;
    Problems problems;
    AssetLibrary assets;
};

inline Row u_of(const UncertaintyResult& result, const std::string& group) {
    Row row;
    for (const OutputResult& output : result.outputs)
        if (output.quantity.group == group) row.push_back(1e3 * output.standard_uncertainty);
    return row;
}

inline Row means_of(const UncertaintyResult& result, const std::string& group) {
    Row row;
    for (const OutputResult& output : result.outputs)
        if (output.quantity.group == group) row.push_back(1e3 * output.estimate);
    return row;
}

inline void expect_row(const Row& found, const Row& expected, double tolerance) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], tolerance) << i;
}
inline void expect_relative(const Row& found, const Row& expected, double tolerance) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_NEAR(found[i], expected[i], tolerance * expected[i]) << i;
}

inline void expect_error(Network& network, const std::vector<std::string>& words) {
    EXPECT_EQ(network.prepare(), nullptr);
    for (const std::string& word : words)
        EXPECT_NE(network.words().find(word), std::string::npos) << network.words();
}

/// The predicted readings as given ones; azimuths with whole turns added.
inline void give_readings(Network& network, const std::string& id, double turns) {
    const auto prepared = network.prepare(id);
    ASSERT_NE(prepared, nullptr) << network.words();
    SetupTable readings;
    readings.units = {Unit(), Unit(), Unit::of("mm"), Unit::of("rad"), Unit::of("rad")};
    const std::pair<const char*, const char*> sensors[] = {
        {"camera-1", "C1"}, {"camera-2", "C2"}, {"camera-3", "C3"}, {"laser-tracker", "LT"}};
    for (const char* target : {"A", "B", "C"})
        for (const auto& [sensor, label] : sensors) {
            const auto cell = [&](const std::string& letter, double factor, double offset) -> SetupCell {
                const std::size_t i = prepared->inputs.find(letter + "_" + target + "_" + label);
                if (i == InputSet::npos) return {};
                return factor * estimate_of(prepared->inputs, i) + offset;
            };
            readings.rows.push_back({std::string(target), std::string(sensor), cell("d", 1e3, 0),
                                     cell("theta", 1, 2 * std::numbers::pi * turns), cell("phi", 1, 0)});
        }
    network.setup(id).values["evaluation"] = std::string("a-posteriori");
    network.setup(id).values["readings"] = readings;
}

}  // namespace covaria
