// Input quantities: shared components, rules of combination, degrees of freedom, correlations.
#include "core/quantity/input_quantity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace covaria::input_quantity_test {
namespace {

UncertaintyComponent component(std::string id, double u, double nu = infinity) {
    return {.id = std::move(id),
            .name = "test",
            .distribution = Distribution::normal(u),
            .degrees_of_freedom = nu};
}

InputQuantity quantity(std::string symbol, double offset, Combination combination = Combination::quadrature) {
    return {.symbol = std::move(symbol), .name = "test", .offset = offset, .combination = combination};
}

TEST(InputQuantity, ComponentsCombineInQuadrature) {
    InputSet inputs;
    EXPECT_EQ(inputs.add(quantity("x", 5.0), {component("x.a", 3.0), component("x.b", 4.0)}), 0u);
    EXPECT_EQ(standard_uncertainty_of(inputs, 0), 5.0);
    EXPECT_EQ(estimate_of(inputs, 0), 5.0);
    EXPECT_EQ(inputs.find("x"), 0u);
    EXPECT_EQ(inputs.find("y"), InputSet::npos);
    EXPECT_EQ(degrees_of_freedom_of(inputs, 0), infinity);
}

TEST(InputQuantity, ArithmeticCombinationAddsLinearly) {
    InputSet inputs;
    const std::size_t a = inputs.add(component("a", 3.0));
    const std::size_t b = inputs.add(component("b", 4.0));
    InputQuantity q = quantity("x", 0.0, Combination::arithmetic);
    q.shares = {{a, 1.0}, {b, -2.0}};
    inputs.quantities.push_back(q);
    EXPECT_DOUBLE_EQ(standard_uncertainty_of(inputs, 0), 11.0);
    const auto resolved = resolved_correlations(inputs);
    ASSERT_TRUE(resolved.has_value());
    ASSERT_EQ(resolved->size(), 1u);
    EXPECT_EQ(resolved->front().coefficient, -1.0);  // so that 1*a and -2*b pull the same way
}

TEST(InputQuantity, AnArithmeticPairIsCorrelatedInOtherQuantitiesToo) {
    InputSet inputs;
    inputs.add(quantity("x", 0.0, Combination::arithmetic), {component("a", 3.0), component("b", 4.0)});
    InputQuantity other = quantity("y", 0.0);
    other.shares = {{0, 1.0}, {1, -1.0}};
    inputs.quantities.push_back(other);
    EXPECT_DOUBLE_EQ(standard_uncertainty_of(inputs, 0), 7.0);
    EXPECT_DOUBLE_EQ(standard_uncertainty_of(inputs, 1), 1.0);
}

/// u by the whole matrix of correlation coefficients.
double uncertainty_by_matrix(const InputSet& inputs, std::size_t quantity) {
    const std::size_t n = inputs.components.size();
    std::vector<double> a(n, 0.0);
    for (const Share& share : inputs.quantities[quantity].shares)
        if (!inputs.components[share.component].held)
            a[share.component] +=
                share.factor * inputs.components[share.component].distribution.standard_uncertainty();
    const auto resolved = resolved_correlations(inputs);
    double square = 0.0;
    for (const double part : a) square += part * part;
    for (const ComponentCorrelation& r : *resolved) square += 2.0 * r.coefficient * a[r.first] * a[r.second];
    return std::sqrt(std::max(0.0, square));
}

TEST(InputQuantity, AnyUncertaintyIsThatOfTheWholeCorrelationMatrix) {
    std::mt19937_64 engine(11);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int k = 0; k < 200; ++k) {
        InputSet inputs;
        const std::size_t components = 2 + engine() % 12, quantities = 1 + engine() % 4;
        for (std::size_t c = 0; c < components; ++c)
            inputs.add(component("c" + std::to_string(c), 1.0 + std::abs(unit(engine))));
        for (std::size_t q = 0; q < quantities; ++q) {
            InputQuantity added = quantity("x" + std::to_string(q), 0.0);
            const std::size_t shares = 1 + engine() % 15;  // some components more than once
            for (std::size_t s = 0; s < shares; ++s)
                added.shares.push_back({engine() % components, unit(engine)});
            inputs.quantities.push_back(std::move(added));
        }
        if (k % 3 == 0) {  // one that adds the first two
            InputQuantity sum = quantity("sum", 0.0, Combination::arithmetic);
            sum.shares = {{0, unit(engine)}, {1, unit(engine)}};
            inputs.quantities.push_back(std::move(sum));
        }
        for (std::size_t c = 3; c < components; c += 2)
            inputs.correlations.push_back({c, c - 1, 0.9 * unit(engine)});
        if (k % 4 == 0) inputs.components[engine() % components].held = true;
        ASSERT_TRUE(resolved_correlations(inputs).has_value()) << k;
        for (std::size_t q = 0; q < inputs.quantities.size(); ++q)
            EXPECT_NEAR(standard_uncertainty_of(inputs, q), uncertainty_by_matrix(inputs, q), 1e-7) << k;
    }
}

TEST(InputQuantity, CorrelationsHeldComponentsAndMeans) {
    InputSet inputs;
    inputs.add(quantity("x", 1.0), {component("a", 3.0), component("b", 4.0)});
    inputs.correlations = {{1, 0, 0.5}};
    EXPECT_DOUBLE_EQ(standard_uncertainty_of(inputs, 0), std::sqrt(9.0 + 16.0 + 12.0));
    inputs.components[0].held = true;
    EXPECT_DOUBLE_EQ(standard_uncertainty_of(inputs, 0), 4.0);
    inputs.components[0].distribution = Distribution::of(Rectangular{1.0, 2.0});
    inputs.quantities[0].shares[0].factor = 2.0;
    EXPECT_DOUBLE_EQ(estimate_of(inputs, 0), 4.0);  // held at its mean
    inputs.components[1].held = true;
    EXPECT_EQ(standard_uncertainty_of(inputs, 0), 0.0);
    EXPECT_EQ(degrees_of_freedom_of(inputs, 0), infinity);
}

TEST(InputQuantity, AComponentNamedTwiceCountsOnce) {
    InputSet inputs;
    inputs.add(quantity("x", 0.0), {component("a", 1.0)});
    inputs.quantities[0].shares.push_back({0, 2.0});
    EXPECT_DOUBLE_EQ(standard_uncertainty_of(inputs, 0), 3.0);
}

TEST(InputQuantity, WelchSatterthwaite) {  // JCGM 100 H.1.3.2: u(d) = 9.7 nm
    InputSet inputs;
    inputs.add(quantity("d", 0.0), {component("repeatability", 5.8, 24), component("random", 3.9, 5),
                                    component("systematic", 6.7, 8)});
    EXPECT_NEAR(standard_uncertainty_of(inputs, 0), 9.7, 0.05);
    EXPECT_NEAR(degrees_of_freedom_of(inputs, 0),
                std::pow(5.8 * 5.8 + 3.9 * 3.9 + 6.7 * 6.7, 2) /
                    (std::pow(5.8, 4) / 24 + std::pow(3.9, 4) / 5 + std::pow(6.7, 4) / 8),
                1e-10);
}

TEST(InputQuantity, DegreesOfFreedomOfFullyCorrelatedComponents) {
    InputSet inputs;  // drawn as (u_a + u_b) t: what they share is one t distribution
    inputs.add(quantity("x", 0.0, Combination::arithmetic),
               {component("a", 1.0, 10), component("b", 1.0, 10)});
    EXPECT_NEAR(degrees_of_freedom_of(inputs, 0), 10.0, 1e-12);
}

TEST(InputQuantity, AStudentTBringsItsDegreesOfFreedomAndScale) {
    InputSet inputs;
    UncertaintyComponent t = component("t", 1.0);
    t.distribution = Distribution::of(StudentT{0.0, 2.0, 9.0});
    inputs.add(quantity("x", 0.0), {t});
    EXPECT_DOUBLE_EQ(standard_uncertainty_of(inputs, 0), 2.0);
    EXPECT_DOUBLE_EQ(degrees_of_freedom_of(inputs, 0), 9.0);
}

TEST(ResolvedCorrelations, NameContradictoryGroups) {
    InputSet inputs;
    for (const char* id : {"p", "q", "r", "s"}) inputs.add(component(id, 1.0));
    inputs.correlations = {{0, 1, 0.9}, {1, 2, 0.9}, {0, 2, -0.9}};
    const auto resolved = resolved_correlations(inputs);
    ASSERT_FALSE(resolved.has_value());
    const std::string& message = resolved.error().message.english();
    EXPECT_NE(message.find("\"p\", \"q\", \"r\" contradict"), std::string::npos) << message;
    EXPECT_NE(message.find("smallest eigenvalue of their correlation matrix is -0.8"), std::string::npos)
        << message;
    EXPECT_EQ(message.find("\"s\""), std::string::npos) << message;
}

TEST(ResolvedCorrelations, AcceptSingularAndSeparateGroups) {
    InputSet inputs;
    for (const char* id : {"a", "b", "c", "d", "e"}) inputs.add(component(id, 1.0));
    inputs.correlations = {{1, 0, 1.0}, {2, 0, -1.0}, {1, 2, -1.0}, {3, 4, 0.3}, {4, 3, 0.3}};
    const auto resolved = resolved_correlations(inputs);
    ASSERT_TRUE(resolved.has_value()) << resolved.error().message.english();
    EXPECT_EQ(resolved->size(), 4u);  // the repeated pair once
    EXPECT_TRUE(resolved_correlations(InputSet{})->empty());
}

TEST(ResolvedCorrelations, RefuseBadEntries) {
    InputSet inputs;
    inputs.add(quantity("x", 0.0), {component("a", 1.0), component("b", 1.0)});
    const auto message_for = [&](ComponentCorrelation c) {
        inputs.correlations = {c};
        const auto resolved = resolved_correlations(inputs);
        return resolved ? std::string("accepted") : resolved.error().message.english();
    };
    EXPECT_NE(message_for({0, 1, 1.01}).find("between -1 and 1"), std::string::npos);
    EXPECT_NE(message_for({0, 1, std::nan("")}).find("\"a\" and \"b\" must lie"), std::string::npos);
    EXPECT_NE(message_for({0, 7, 0.1}).find("number 7 of 2"), std::string::npos);
    EXPECT_NE(message_for({1, 1, 1.0}).find("\"b\" and itself"), std::string::npos);
    inputs.quantities[0].combination = Combination::arithmetic;
    EXPECT_NE(message_for({0, 1, 0.5}).find("two different correlations"), std::string::npos);
    EXPECT_EQ(message_for({0, 1, 1.0}), "accepted");
    inputs.quantities[0].shares.push_back({9, 1.0});
    EXPECT_NE(message_for({0, 1, 1.0}).find("number 9 of 2"), std::string::npos);
}

}  // namespace
}  // namespace covaria::input_quantity_test
