// Figures of instruments as unknowns with or without a prior: zero, scale, refraction, index, collimation.
#include <random>

#include "tests/core/kinds/network/adjusted_network.h"

namespace covaria::network {
namespace {

using Figure = StatedAdjustment::Figure;
constexpr auto found_one = CoordinateRole::unknown, held_one = CoordinateRole::fixed,
               datum_one = CoordinateRole::datum;

Figure figure(FigureKind kind, FigureKnowledge knowledge, std::optional<double> value = {},
              std::optional<double> u = {}) {
    Figure row;
    row.instrument = "T";
    row.kind = kind;
    row.knowledge = knowledge;
    const bool ratio = kind == FigureKind::scale || kind == FigureKind::refraction;
    (kind == FigureKind::zero ? row.length : ratio ? row.ratio : row.angle) = value;
    (kind == FigureKind::zero ? row.u_length : ratio ? row.u_ratio : row.u_angle) = u;
    return row;
}

/// The hall, read by an instrument whose distances are 20 mm and 50 ppm too long.
StatedAdjustment faulty_hall() {
    StatedAdjustment stated = hall(held_one, {}).stated;
    for (StatedAdjustment::Reading& r : stated.readings) {
        r.instrument = "T";
        if (r.length) r.length = *r.length * (1.0 + 50e-6) + 0.02;
    }
    return stated;
}

double state_of(const Adjusted& made, std::size_t number) {
    return made.network->state[static_cast<Eigen::Index>(made.network->figure(number))];
}

double u_of(const AdjustedNetwork& network, std::size_t place) {
    const auto k = static_cast<Eigen::Index>(network.unknown_of[place]);
    const auto n = static_cast<Eigen::Index>(network.place_of.size());
    return std::sqrt(network.adjusted->cofactors(Eigen::VectorXd::Unit(n, k))[k]);
}

TEST(InstrumentFigures, ZeroAndScaleAreFoundFromTheReadings) {
    StatedAdjustment stated = faulty_hall();
    EXPECT_NE(Adjusted(stated).words().find("larger than the uncertainties allow"), std::string::npos);
    stated.figures = {figure(FigureKind::zero, FigureKnowledge::unknown),
                      figure(FigureKind::scale, FigureKnowledge::unknown)};
    const Adjusted made(stated);
    ASSERT_TRUE(made.network && made.network->adjusted) << made.words();
    EXPECT_EQ(made.words(), "");
    EXPECT_EQ(made.network->adjusted->degrees_of_freedom(), 39 - 14 - 2);
    EXPECT_NEAR(state_of(made, 0), 0.02, 4.0 * u_of(*made.network, made.network->figure(0)));
    EXPECT_NEAR(state_of(made, 1), 50e-6, 4.0 * u_of(*made.network, made.network->figure(1)));
}

TEST(InstrumentFigures, APriorOfLargeUIsNoneAndOfSmallUIsFixed) {
    StatedAdjustment stated = faulty_hall();
    const auto with = [&](FigureKnowledge knowledge, std::optional<double> u) {
        stated.figures = {figure(FigureKind::zero, knowledge, 0.021, u)};
        return Adjusted(stated);
    };
    const Adjusted none = with(FigureKnowledge::unknown, {}), large = with(FigureKnowledge::stated, 1e6),
                   small = with(FigureKnowledge::stated, 1e-10), held = with(FigureKnowledge::fixed, {});
    for (const Adjusted* made : {&none, &large, &small, &held})
        ASSERT_TRUE(made->network && made->network->adjusted) << made->words();
    EXPECT_LT((none.network->state - large.network->state).norm(), 1e-9);
    EXPECT_LT((held.network->state - small.network->state).norm(), 1e-9);
    EXPECT_NEAR(state_of(held, 0), 0.021, 1e-15);
    EXPECT_GT(std::abs(state_of(none, 0) - 0.021), 1e-5) << "the readings say something else";
    EXPECT_NEAR(u_of(*none.network, none.network->figure(0)), u_of(*large.network, large.network->figure(0)),
                1e-12);
}

// All derivatives, differences of what is predicted, of an instrument that leans too.
TEST(InstrumentFigures, DerivativesAreThoseOfThePrediction) {
    StatedAdjustment stated = faulty_hall();
    for (const std::size_t i : {0, 1, 6, 7}) {  // a direction and a zenith angle each
        StatedAdjustment::Reading& r = stated.readings[i];
        r.angle = r.kind == ReadingKind::zenith_angle ? 2.0 * std::numbers::pi - *r.angle
                                                      : *r.angle + std::numbers::pi;
        r.face_two = true;
    }
    stated.earth_radius = 2000.0;
    stated.stations = {{.point = "S", .stated = false, .u = {}}};
    for (const FigureKind kind : {FigureKind::zero, FigureKind::scale, FigureKind::refraction,
                                  FigureKind::index, FigureKind::collimation})
        stated.figures.push_back(figure(kind, FigureKnowledge::unknown));
    Problems problems;
    std::optional<AdjustedNetwork> network = adjusted_network(stated, problems);
    ASSERT_TRUE(network);
    find_start(*network, problems);
    ASSERT_FALSE(problems.has_errors());
    for (std::size_t f = 0; f < 5; ++f)
        network->state[static_cast<Eigen::Index>(network->figure(f))] = 0.01 + 0.02 * double(f);
    network->state[static_cast<Eigen::Index>(network->tilt(0, 0))] = 0.05;
    StateTerms terms;
    for (const AdjustedReading& reading : network->readings) {
        derivatives(*network, reading, network->state.data(), terms);
        Eigen::VectorXd by = Eigen::VectorXd::Zero(network->state.size());
        for (const StateTerm& term : terms) by[static_cast<Eigen::Index>(term.place)] += term.coefficient;
        for (Eigen::Index place = 0; place < by.size(); ++place) {
            constexpr double h = 1e-5;
            Eigen::VectorXd up = network->state, down = network->state;
            up[place] += h;
            down[place] -= h;
            const double slope = (residual_of(*network, reading, reading.value, down.data()) -
                                  residual_of(*network, reading, reading.value, up.data())) /
                                 (2.0 * h);
            EXPECT_NEAR(by[place], slope, 2e-6 * std::max(1.0, std::abs(slope)))
                << words_of(*network, reading).english() << ", place " << place;
        }
    }
}

// z = atan(s / Δh) with Δh less (1 - k) s² / 2R: far away a height without it is wrong by decimetres.
TEST(InstrumentFigures, TheCurvatureOfTheEarthAndRefractionLowerWhatIsFar) {
    constexpr double R = 6.38e6, k = 0.2, s = 2000.0, rise = 50.0;
    TrueNetwork net;
    net.point("S", {0, 0, 100}, held_one, held_one, 0.0);
    net.point("P", {s, 0, 100 + rise}, held_one, found_one, {});
    net.called("P").p[0] = s, net.called("P").p[1] = 0.0;
    net.read(ReadingKind::zenith_angle, "S", "P");
    net.stated.readings[0].angle = std::atan2(s, rise - (1.0 - k) * s * s / (2.0 * R));
    net.stated.earth_radius = R;
    net.stated.refraction = k;
    const Adjusted made(net.stated);
    ASSERT_TRUE(made.network && made.network->adjusted) << made.words();
    EXPECT_NEAR(made.network->position(1).z(), 100.0 + rise, 1e-9);
    net.stated.earth_radius = {};
    const Adjusted flat(net.stated);
    ASSERT_TRUE(flat.network && flat.network->adjusted) << flat.words();
    EXPECT_NEAR(flat.network->position(1).z() - made.network->position(1).z(), -(1.0 - k) * s * s / (2.0 * R),
                1e-9);
}

/// Stations and targets without a datum, ranges alone; each station has an instrument of its own.
StatedAdjustment range_network(std::size_t stations, std::size_t targets, bool scales) {
    TrueNetwork net;
    net.deviations = 0.0;
    std::vector<std::string> from, to;
    for (std::size_t i = 0; i < stations; ++i) {
        from.push_back("S" + std::to_string(i));
        const double a = 2.3 * double(i);
        net.point(from.back(), {6.0 * std::cos(a), 5.0 * std::sin(a), 1.0 + 1.7 * double(i % 3)}, datum_one,
                  datum_one, 0.0);
    }
    for (std::size_t i = 0; i < targets; ++i) {
        to.push_back("P" + std::to_string(i));
        const double a = 0.9 * double(i);
        net.point(to.back(), {2.5 * std::cos(a), 2.0 * std::sin(2.1 * a), 0.5 * double(i % 7)}, datum_one,
                  datum_one, 0.0);
    }
    for (const std::string& station : from) net.read_all({ReadingKind::slope_distance}, station, to);
    for (StatedAdjustment::Reading& r : net.stated.readings) r.instrument = r.from;
    for (const std::string& station : from) {
        StatedAdjustment::Figure of_station;
        of_station.instrument = station;
        net.stated.figures.push_back(of_station);
        of_station.kind = FigureKind::scale;
        if (scales) net.stated.figures.push_back(of_station);
    }
    return net.stated;
}

// s n ranges, 3 s + 3 n coordinates less 7 of the datum (no range tells the scale), 2 s figures.
TEST(InstrumentFigures, TooFewRangesForTheirZerosAndScalesAreCounted) {
    const Adjusted few(range_network(3, 4, true));
    EXPECT_NE(few.words().find("12 readings cannot tell 20 unknowns"), std::string::npos) << few.words();
    const Adjusted enough(range_network(6, 14, true));
    ASSERT_TRUE(enough.network && enough.network->adjusted) << enough.words();
    EXPECT_EQ(enough.network->adjusted->degrees_of_freedom(), 6 * 14 - (18 + 42 - 7) - 12);
}

TEST(InstrumentFigures, ZerosOfSelfCalibratingRangesAreCovered) {
    const std::size_t stations = 6, targets = 14;
    const Adjusted made(range_network(stations, targets, false));
    ASSERT_TRUE(made.network && made.network->adjusted) << made.words();
    const AdjustedNetwork& net = *made.network;
    const adjustment::SparseRows weighted = net.whitening.transpose() * net.adjusted->whitened();
    std::mt19937_64 generator(20);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> spread(-0.01, 0.01);
    std::size_t covered = 0, tried = 0;
    for (int campaign = 0; campaign < 500; ++campaign) {
        Eigen::VectorXd x(static_cast<Eigen::Index>(net.readings.size()));
        std::vector<double> zeros(stations);
        for (double& zero : zeros) zero = spread(generator);
        for (std::size_t i = 0; i < net.readings.size(); ++i) {
            const AdjustedReading& r = net.readings[i];
            x[static_cast<Eigen::Index>(i)] = r.value + zeros[r.figures.front()] + r.u * normal(generator);
        }
        Eigen::VectorXd state = net.state;
        for (int step = 0; step < 8; ++step) {
            Eigen::VectorXd r(x.size());
            for (std::size_t i = 0; i < net.readings.size(); ++i)
                r[static_cast<Eigen::Index>(i)] =
                    residual_of(net, net.readings[i], x[static_cast<Eigen::Index>(i)], state.data());
            const Eigen::VectorXd change = net.adjusted->step(weighted.transpose() * r);
            for (std::size_t k = 0; k < net.place_of.size(); ++k)
                state[static_cast<Eigen::Index>(net.place_of[k])] += change[static_cast<Eigen::Index>(k)];
        }
        for (std::size_t f = 0; f < stations; ++f, ++tried)
            covered += std::abs(state[static_cast<Eigen::Index>(net.figure(f))] - zeros[f]) <
                       1.95996 * u_of(net, net.figure(f));
    }
    const double share = double(covered) / double(tried);
    EXPECT_GT(share, 0.93);
    EXPECT_LT(share, 0.97);
}

TEST(InstrumentFigures, WhatNothingTellsOfAnInstrumentIsSaidByName) {
    const auto said = [](const std::vector<Figure>& figures) {
        StatedAdjustment stated = hall(held_one, {}).stated;
        for (StatedAdjustment::Reading& r : stated.readings) r.instrument = "T";
        stated.figures = figures;
        return Adjusted(stated).words();
    };
    EXPECT_NE(said({figure(FigureKind::refraction, FigureKnowledge::unknown)})
                  .find("the refraction coefficient of T needs the radius of the Earth"),
              std::string::npos);
    EXPECT_NE(said({figure(FigureKind::zero, FigureKnowledge::stated, 0.0)})
                  .find("the zero of T: its standard uncertainty is missing"),
              std::string::npos);
    EXPECT_NE(said({figure(FigureKind::zero, FigureKnowledge::unknown),
                    figure(FigureKind::zero, FigureKnowledge::fixed)})
                  .find("the zero of T is stated twice"),
              std::string::npos);
    Figure other = figure(FigureKind::zero, FigureKnowledge::unknown);
    other.instrument = "V";
    EXPECT_NE(said({other}).find("no reading that the zero of V would change"), std::string::npos);
    // One distance between known points tells one of the two.
    TrueNetwork net;
    net.point("A", {0, 0, 0}, held_one, held_one, 0.0);
    net.point("B", {9, 0, 0}, held_one, held_one, 0.0);
    net.read(ReadingKind::slope_distance, "A", "B");
    net.read(ReadingKind::slope_distance, "B", "A");
    for (StatedAdjustment::Reading& r : net.stated.readings) r.instrument = "T";
    net.stated.figures = {figure(FigureKind::zero, FigureKnowledge::unknown),
                          figure(FigureKind::scale, FigureKnowledge::unknown)};
    const std::string alike = Adjusted(net.stated).words();
    EXPECT_NE(alike.find("the zero of T and the scale of T"), std::string::npos) << alike;
}

}  // namespace
}  // namespace covaria::network
