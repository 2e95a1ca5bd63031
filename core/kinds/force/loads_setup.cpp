// Reads the cases of "force-moment loads"; the calibration matrix by least squares.
#include "core/kinds/force/loads_setup.h"

#include <Eigen/Dense>
#include <cmath>

#include "core/kinds/force/force_sensor.h"
#include "core/kinds/force/loads_equations.h"
#include "core/math/decompositions.h"
#include "core/quantity/distribution.h"
#include "core/setup/message_text.h"

namespace covaria::force_loads {

namespace {

constexpr double singular = 1e7, badly_conditioned = 100.0;  // condition number of A

/// Slope, and the coefficient of the square, of a channel's readings under one load.
class Regression {
public:
    void add(double load, double reading) {
        loads_.push_back(load);
        readings_.push_back(reading);
    }

    std::optional<Element> fit(bool quadratic) const {
        const Eigen::Index n = Eigen::Index(loads_.size()), p = quadratic ? 2 : 1;
        if (n <= p) return {};
        Eigen::MatrixXd X(n, p);
        X.col(0) = Eigen::Map<const Eigen::VectorXd>(loads_.data(), n);
        if (quadratic) X.col(1) = X.col(0).cwiseAbs2();
        const Eigen::Map<const Eigen::VectorXd> y(readings_.data(), n);
        const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(X);
        if (qr.rank() < p) return {};
        const Eigen::VectorXd beta = qr.solve(y);
        Element element{beta[0], quadratic ? beta[1] : 0.0, 0.0, 0.0, 0.0, double(n - p)};
        const double s = (y - X * beta).norm() / std::sqrt(double(n - p));
        const Eigen::MatrixXd F = s * Eigen::MatrixXd(cholesky((X.transpose() * X).inverse()).matrixL());
        element.aa = F(0, 0);
        if (quadratic) {
            element.ba = F(1, 0);
            element.bb = F(1, 1);
        }
        return element;
    }

private:
    std::vector<double> loads_, readings_;
};

/// The channel that answers as others do: largest part of the direction that A takes to almost nothing.
std::string channels_alike(const LoadsSetup& setup, const Eigen::VectorXd& null_vector) {
    std::vector<std::string> names;
    for (std::size_t c = 0; c < setup.size(); ++c)
        if (std::abs(null_vector[Eigen::Index(c)]) > 0.3) names.emplace_back(setup.channels()[c].kind().key);
    return listed(names);
}

void check_condition(LoadsSetup& setup, Problems& problems) {
    const auto svd = singular_values(Eigen::MatrixXd(setup.A()), Eigen::ComputeFullV);
    const Eigen::VectorXd& s = svd.singularValues();
    setup.condition = s[s.size() - 1] > 0.0 ? s[0] / s[s.size() - 1] : infinity;
    const std::string alike = channels_alike(setup, svd.matrixV().col(s.size() - 1));
    if (!(setup.condition < singular))
        return problems.error(fields().place(&LoadsSetup::sensor),
                              tell<"the calibration matrix is singular: the channels answer to loads on %1 "
                                   "alike, so these cannot be told apart">(alike));
    if (setup.condition > badly_conditioned)
        problems.warning(
            fields().place(&LoadsSetup::sensor),
            tell<"the calibration matrix has the condition number %1: loads on %2 are hardly told apart">(
                readable_number(std::round(setup.condition)), alike));
}

/// Rows by decreasing pivots, as partial pivoting would choose them at the estimates.
std::vector<std::size_t> row_order(Eigen::MatrixXd m) {
    std::vector<std::size_t> rows(std::size_t(m.rows()));
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = i;
    for (Eigen::Index k = 0; k < m.rows(); ++k) {
        Eigen::Index best = 0;
        m.col(k).tail(m.rows() - k).cwiseAbs().maxCoeff(&best);
        best += k;
        m.row(k).swap(m.row(best));
        std::swap(rows[std::size_t(k)], rows[std::size_t(best)]);
        for (Eigen::Index i = k + 1; i < m.rows(); ++i) m.row(i) -= m(i, k) / m(k, k) * m.row(k);
    }
    return rows;
}

class CaseReader {
public:
    CaseReader(LoadsSetup& setup, Problems& problems)
        : setup_(setup),
          table_(setup.by_loads ? &LoadsSetup::loads : &LoadsSetup::readings),
          problems_(problems) {}

    void run() {
        if ((setup_.*table_).empty())
            return problems_.error(fields().place(table_),
                                   setup_.by_loads ? tell<"add a row of loads to be evaluated">()
                                                   : tell<"add a row of readings to be decoupled">());
        for (std::size_t row = 0; row < (setup_.*table_).size(); ++row) add(row, (setup_.*table_)[row]);
    }

private:
    std::string cell(std::size_t row, std::size_t axis) const {
        return fields().place(table_, row, &LoadsSetup::Given::figures, axis);
    }

    void add(std::size_t row, const LoadsSetup::Given& given) {
        Case added;
        added.source = fields().place(table_, row);
        added.name = given.name;
        for (const Case& known : setup_.cases)
            if (known.name == added.name)
                return problems_.error(fields().place(table_, row, &LoadsSetup::Given::name),
                                       tell<"two cases are called '%1'">(added.name));
        Eigen::VectorXd& figures = setup_.by_loads ? added.l : added.v;
        figures.setZero(Eigen::Index(setup_.size()));
        for (std::size_t c = 0; c < setup_.size(); ++c) {
            const ForceChannel& channel = setup_.channels()[c];
            const double rated = setup_.by_loads ? channel.rated_load : channel.rated_output;
            if (const auto& figure = given.figures[channel.axis])
                figures[Eigen::Index(c)] = *figure / rated;
            else if (!setup_.by_loads)
                problems_.error(
                    cell(row, channel.axis),
                    tell<"channel %1 has no reading: all channels are needed">(channel.kind().key));
        }
        refuse_other_axes(row, given);
        complete(added);
        setup_.cases.push_back(std::move(added));
    }

    void refuse_other_axes(std::size_t row, const LoadsSetup::Given& given) {
        for (std::size_t axis = 0; axis < most_channels; ++axis) {
            const bool known = std::any_of(setup_.channels().begin(), setup_.channels().end(),
                                           [&](const ForceChannel& c) { return c.axis == axis; });
            if (!known && given.figures[axis])
                problems_.error(cell(row, axis), tell<"the sensor has no channel %1">(force_axes[axis].key));
        }
    }

    void complete(Case& added) {
        if (!setup_.by_loads) {
            added.l = decoupled(setup_, added.v);
            if (!added.l.allFinite())
                return problems_.error(added.source,
                                       tell<"no load gives these readings by the calibration matrix">());
        } else {
            const auto n = Eigen::Index(setup_.size());
            added.v = setup_.A() * added.l;
            for (Eigen::Index h = 0; setup_.quadratic && h < n; ++h)
                for (Eigen::Index c = 0; c < n; ++c)
                    added.v[h] += setup_.element(std::size_t(h), std::size_t(c)).b * added.l[c] * added.l[c];
        }
        Eigen::Index most = 0;
        if (added.l.cwiseAbs().maxCoeff(&most) > 1.001)
            problems_.warning(
                added.source,
                tell<"the load on %1 is %2 % of its rated load: the calibration says nothing about it">(
                    std::string(setup_.channels()[std::size_t(most)].kind().key),
                    readable_number(std::round(100.0 * std::abs(added.l[most])))));
    }

    LoadsSetup& setup_;
    std::vector<LoadsSetup::Given> LoadsSetup::*table_;
    Problems& problems_;
};

}  // namespace

Eigen::MatrixXd LoadsSetup::A() const {
    const auto n = Eigen::Index(size());
    Eigen::MatrixXd matrix(n, n);
    for (Eigen::Index i = 0; i < n * n; ++i) matrix(i / n, i % n) = elements[std::size_t(i)].a;
    return matrix;
}

double LoadsSetup::scale(std::size_t h, std::size_t c, int power) const {
    return channels()[h].rated_output / std::pow(channels()[c].rated_load, power);
}

void fit_matrix(LoadsSetup& setup, Problems& problems) {
    const std::size_t n = setup.size();
    std::vector<Regression> regressions(n * n);
    for (const LoadedReading& r : setup.sensor->increasing())
        for (std::size_t h = 0; h < n; ++h)
            regressions[h * n + r.loaded].add(r.load / setup.channels()[r.loaded].rated_load,
                                              r.net[h] / setup.channels()[h].rated_output);
    setup.elements.assign(n * n, {});
    const bool summary = setup.sensor->increasing().empty();
    for (std::size_t i = 0; i < n * n && !summary; ++i) {
        const auto element = regressions[i].fit(setup.quadratic);
        if (!element)
            return problems.error(fields().place(&LoadsSetup::quadratic),
                                  tell<"loads on %1 are too few for this calibration matrix">(
                                      std::string(setup.channels()[i % n].kind().key)));
        setup.elements[i] = *element;
    }
    for (std::size_t h = 0; h < n && summary; ++h)
        for (std::size_t c = 0; c < n; ++c) {
            const ForceChannel& channel = setup.channels()[h];
            Element& element = setup.element(h, c);
            element.a =
                setup.sensor->rated_outputs()(Eigen::Index(h), Eigen::Index(c)) / channel.rated_output;
            element.aa = channel.u_a / std::abs(channel.rated_output);
            element.degrees_of_freedom = channel.degrees_of_freedom;
        }
    check_condition(setup, problems);
    if (!problems.has_errors()) setup.rows = row_order(setup.A());
}

Eigen::VectorXd decoupled(const LoadsSetup& setup, const Eigen::VectorXd& v) {
    const std::size_t n = setup.size();
    const auto a = [&](std::size_t h, std::size_t c) { return setup.element(h, c).a; };
    const auto b = [&](std::size_t h, std::size_t c) { return setup.element(h, c).b; };
    Vector<double> readings{};
    for (std::size_t h = 0; h < n; ++h) readings[h] = v[Eigen::Index(h)];
    Vector<double> l = Factors<double>(setup.rows, a).solve(readings);
    const bool found = !setup.quadratic || refine<double>(setup, a, b, readings, l);
    Eigen::VectorXd loads(static_cast<Eigen::Index>(n));
    for (std::size_t c = 0; c < n; ++c) loads[Eigen::Index(c)] = found ? l[c] : std::nan("");
    return loads;
}

std::optional<LoadsSetup> read(const SetupReader& setup, const AssetLibrary& assets, Problems& problems) {
    LoadsSetup read = fields().read(setup, assets, problems);
    if (!read.sensor) return {};
    if (!read.sensor->has_signs())
        problems.error(fields().place(&LoadsSetup::sensor),
                       tell<"the interference of %1 is known without signs: it cannot be compensated. Give "
                            "raw readings, or a table with signs">(read.sensor.name));
    else if (read.quadratic && read.sensor->increasing().empty())
        problems.error(fields().place(&LoadsSetup::quadratic),
                       tell<"quadratic terms need raw readings; %1 has a summary only">(read.sensor.name));
    else
        fit_matrix(read, problems);
    if (!problems.has_errors()) CaseReader(read, problems).run();
    if (problems.has_errors()) return {};
    return read;
}

}  // namespace covaria::force_loads
