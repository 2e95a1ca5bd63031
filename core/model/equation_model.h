// Equations written once, compiled three times: for one trial (double), for a vector of trials (batch) and
// for exact sensitivity coefficients (Dual).
//
// A model derives from EquationModel<ItsClass> and provides
//     template <class Real>
//     mask_of<Real> equations(const Inputs<Real>& x, Outputs<Real>& y) const;
// It reads x[i], writes y.set(j, value), may read back what it has set, y.get(j), and returns whether the
// trial has a value (lane by lane). Values that are not finite make a trial invalid by themselves. The class
// belongs in a .cpp file, with its equations: the templates are instantiated there and nowhere else.
#pragma once

#include "core/math/dual.h"
#include "core/math/real.h"
#include "core/model/measurement_model.h"

namespace covaria {

template <class Real>
class Inputs;
template <class Real>
class Outputs;

/// The inputs of one trial.
template <>
class Inputs<double> {
public:
    explicit Inputs(const double* x) : x_(x) {}
    double operator[](std::size_t i) const { return x_[i]; }

private:
    const double* x_;
};

template <>
class Outputs<double> {
public:
    explicit Outputs(double* y) : y_(y) {}
    void set(std::size_t j, double value) {
        y_[j] = value;
        residue_ += value - value;
    }
    double get(std::size_t j) const { return y_[j]; }  ///< an output set before
    bool finite() const { return residue_ == 0.0; }

private:
    double* y_;
    double residue_ = 0.0;  ///< becomes NaN with the first value that is not finite
};

/// The trials t, t + 1 ... of a block, straight from its rows.
template <>
class Inputs<Batch> {
public:
    Inputs(const TrialBlock& block, std::size_t t) : x_(block.inputs + t), stride_(block.stride) {}
    Batch operator[](std::size_t i) const { return Batch::load_aligned(x_ + i * stride_); }

private:
    const double* x_;
    std::size_t stride_;
};

template <>
class Outputs<Batch> {
public:
    Outputs(const TrialBlock& block, std::size_t t) : y_(block.outputs + t), stride_(block.stride) {}
    void set(std::size_t j, const Batch& value) {
        value.store_aligned(y_ + j * stride_);
        residue_ += value - value;
    }
    Batch get(std::size_t j) const { return Batch::load_aligned(y_ + j * stride_); }
    mask_of<Batch> finite() const { return residue_ == Batch(0.0); }

private:
    double* y_;
    std::size_t stride_;
    Batch residue_ = Batch(0.0);
};

/// Inputs first ... first + 7 as variables, the others as constants.
template <>
class Inputs<Dual> {
public:
    Inputs(const double* x, std::size_t first) : x_(x), first_(first) {}
    Dual operator[](std::size_t i) const {
        return i >= first_ && i < first_ + Dual::size ? Dual::variable(x_[i], i - first_) : Dual(x_[i]);
    }

private:
    const double* x_;
    std::size_t first_;
};

/// Columns first ... first + 7 of the Jacobian.
template <>
class Outputs<Dual> {
public:
    Outputs(Eigen::MatrixXd& jacobian, std::size_t first)
        : jacobian_(&jacobian), first_(static_cast<Eigen::Index>(first)) {}
    void set(std::size_t j, const Dual& value) {
        const auto row = static_cast<Eigen::Index>(j);
        for (Eigen::Index k = 0; k < static_cast<Eigen::Index>(Dual::size); ++k)
            if (first_ + k < jacobian_->cols())
                put(row, first_ + k, value.partials()[static_cast<std::size_t>(k)]);
        residue_ += value.value() - value.value();
        if (j >= values_.size()) values_.resize(j + 1);
        values_[j] = value;
    }
    Dual get(std::size_t j) const { return values_[j]; }
    bool finite() const { return residue_ == 0.0; }

private:
    void put(Eigen::Index row, Eigen::Index column, double partial) {
        (*jacobian_)(row, column) = partial;
        residue_ += partial - partial;
    }
    Eigen::MatrixXd* jacobian_;
    Eigen::Index first_;
    double residue_ = 0.0;
    std::vector<Dual> values_;
};

template <class Derived>
class EquationModel : public MeasurementModel {
public:
    bool evaluate(std::span<const double> x, std::span<double> y) const final {
        Outputs<double> out(y.data());
        const bool valid = derived().template equations<double>(Inputs<double>(x.data()), out);
        return valid && out.finite();
    }

    void evaluate_block(const TrialBlock& block) const final {
        for (std::size_t t = 0; t < block.trials; t += Batch::size) {
            Outputs<Batch> out(block, t);
            const mask_of<Batch> has_value =
                derived().template equations<Batch>(Inputs<Batch>(block, t), out);
            bool valid[Batch::size];
            (has_value && out.finite()).store_unaligned(valid);
            for (std::size_t lane = 0; lane < Batch::size && t + lane < block.trials; ++lane)
                block.valid[t + lane] = valid[lane] ? 1 : 0;
        }
    }

    bool jacobian(std::span<const double> x, Eigen::MatrixXd& jacobian) const final {
        jacobian.resize(static_cast<Eigen::Index>(outputs().size()), static_cast<Eigen::Index>(x.size()));
        for (std::size_t first = 0; first < x.size(); first += Dual::size) {
            Outputs<Dual> out(jacobian, first);
            const bool valid = derived().template equations<Dual>(Inputs<Dual>(x.data(), first), out);
            if (!valid || !out.finite()) return false;
        }
        return true;
    }

private:
    const Derived& derived() const { return static_cast<const Derived&>(*this); }
};

}  // namespace covaria
