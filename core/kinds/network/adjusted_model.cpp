// Measurement model "network adjustment": the model class and its descriptor.
#include "core/kinds/network/adjusted_model.h"

#include <cmath>
#include <mutex>

#include "core/base/name.h"
#include "core/kinds/network/adjusted_checks.h"
#include "core/kinds/network/adjusted_sensitivities.h"
#include "core/kinds/network/adjusted_trials.h"
#include "core/kinds/network/seen_figures.h"
#include "core/kinds/points/output_points.h"
#include "core/model/dense_jacobian.h"

namespace covaria {

namespace {

using network::AdjustedNetwork;

/// The points of an adjusted network, and the figures that its residuals see, for other analyses.
class NetworkAsAsset : public OutputPoints, public network::SeenFiguresSource {
public:
    NetworkAsAsset(const std::string& analysis, const std::vector<OutputQuantity>& outputs,
                   std::shared_ptr<const network::NetworkEvidence> evidence)
        : OutputPoints(analysis, outputs), evidence_(std::move(evidence)) {}
    std::optional<network::SeenFigureOfReadings> figure_of(network::ReadingKind kind,
                                                           const std::string& instrument) const override {
        return evidence_->figure_of(kind, instrument);
    }
    std::optional<Days> day() const override { return evidence_->network.read_on; }

private:
    std::shared_ptr<const network::NetworkEvidence> evidence_;
};

OutputQuantity output_of(const network::InstrumentFigure& figure) {
    using network::FigureKind;
    const char* symbol = figure.kind == FigureKind::zero         ? "c"
                         : figure.kind == FigureKind::scale      ? "m"
                         : figure.kind == FigureKind::refraction ? "k"
                         : figure.kind == FigureKind::index      ? "i"
                                                                 : "q";
    const char* unit = figure.kind == FigureKind::zero         ? "mm"
                       : figure.kind == FigureKind::scale      ? "ppm"
                       : figure.kind == FigureKind::refraction ? "1"
                                                               : "arcsec";
    return {.symbol = figure.instrument.empty() ? symbol : symbol + ("_" + figure.instrument),
            .name = words_of(figure),
            .unit = Unit::of(unit),
            .group = own_name<"instruments">()};
}

bool is_turned(const network::AdjustedFrame& frame) {
    return frame.axes(0, 0) != 1.0;
}

/// The output quantity of a figure of a frame: its place, how it is turned, its scale; those of planes and
/// lines count from where the search began.
OutputQuantity output_of(const AdjustedNetwork& network, std::size_t number, const Unit& of_length) {
    const network::AdjustedFrame& frame = network.frames[number / network::AdjustedFrame::figures];
    const std::size_t k = number % network::AdjustedFrame::figures;
    const std::string axis(k < 6 ? along_axes[k % 3] : "");
    const bool axes = frame.shape == network::FrameShape::axes;
    const char* letter = k < 3 ? "" : k < 6 ? "r" : "m";
    const Message words = words_of(frame);
    return {.symbol = letter + axis + "_" + frame.name,
            .name = k == 6             ? tell<"the scale of %1">(words)
                    : k < 3            ? (axes ? tell<"%1, origin along %2">(words, axis)
                                               : tell<"%1, offset along its %2">(words, axis))
                    : !axes            ? tell<"%1, tilt about its %2">(words, axis)
                    : is_turned(frame) ? tell<"%1, turn about %2 after a right angle about y">(words, axis)
                                       : tell<"%1, turn about %2">(words, axis),
            .unit = k < 3 ? of_length : Unit::of(k < 6 ? "deg" : "ppm"),
            .group = own_name<"frames">(),
            .role = axes ? OutputRole::measurand : OutputRole::intermediate,
            .periodic = k > 2 && k < 6};
}

/// Whether coordinates are as large as those of surveyors, which are in metres.
bool is_large(const AdjustedNetwork& network) {
    constexpr double machine_hall = 100.0;  // m
    return network.state.head(static_cast<Eigen::Index>(3 * network.points.size())).cwiseAbs().maxCoeff() >
           machine_hall;
}

/// The model y of x: the unknowns where J₀ᵀ C⁻¹ (x − h(y)) = 0, with J₀ the derivatives at the estimates. At
/// these it is the least sum of squares, and its sensitivities are the rows of the gain Q J₀ᵀ C⁻¹; elsewhere
/// it differs from the least sum by terms of second order times the residuals.
class NetworkAdjustment : public MeasurementModel {
public:
    explicit NetworkAdjustment(AdjustedNetwork made)
        : evidence_(std::make_shared<const network::NetworkEvidence>(std::move(made))),
          network_(evidence_->network),
          inputs_(network::adjustment_inputs(network_)),
          trials_(network_) {
        describe_outputs();
    }

    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    Layout layout(std::span<const double>) const override { return network::adjustment_layout(network_); }
    std::vector<Table> evaluation() const override {
        std::call_once(tables_made_, [&] { tables_ = network::adjustment_tables(network_); });
        return tables_;
    }
    std::vector<PlotSpecification> figures() const override {
        return network::figures_over_campaigns(network_);
    }
    std::shared_ptr<const evidence::RedundantReadings> redundant_readings() const override {
        return evidence_->readings();
    }
    std::shared_ptr<const Asset> as_asset(const std::string& id) const override {
        return std::make_shared<NetworkAsAsset>(id, outputs_, evidence_);
    }

    bool evaluate(std::span<const double> x, std::span<double> y) const override {
        return trials_.evaluate(x, y);
    }
    void evaluate_block(const TrialBlock& block) const override { trials_.evaluate(block); }

    bool sensitivities(std::span<const double> x, SensitivityRows& rows) const override {
        const auto source = sensitivity_source(x);
        rows.assign(outputs_.size(), {});
        for (std::size_t k = 0; source && k < rows.size(); ++k)
            if (!source->row(k, rows[k])) return false;
        return source != nullptr;
    }
    std::unique_ptr<const SensitivitySource> sensitivity_source(std::span<const double> x) const override {
        return network::sensitivities_at(network_, trials_, x);
    }

    bool jacobian(std::span<const double> x, Eigen::MatrixXd& jacobian) const override {
        SensitivityRows rows;
        if (!sensitivities(x, rows)) return false;
        set_dense(rows, x.size(), jacobian);
        return true;
    }

private:
    void describe_outputs() {
        const Unit unit = Unit::of(is_large(network_) ? "m" : "mm");
        for (const std::size_t place : network_.place_of) {
            if (place >= network_.frame(0, 0)) {
                outputs_.push_back(output_of(network_, place - network_.frame(0, 0), unit));
                continue;
            }
            if (place >= network_.figure(0)) {
                outputs_.push_back(output_of(network_.figures[place - network_.figure(0)]));
                continue;
            }
            if (place >= network_.tilt(0, 0)) {
                const std::size_t k = (place - network_.tilt(0, 0)) / 2,
                                  axis = (place - network_.tilt(0, 0)) % 2;
                const std::string& station = network_.points[network_.leaning[k]].name;
                const std::string along(along_axes[axis]);
                outputs_.push_back({.symbol = "tilt_" + along + "_" + station,
                                    .name = tell<"tilt at %1 about %2">(station, along),
                                    .unit = Unit::of("gon"),
                                    .group = own_name<"orientations">(),
                                    .role = OutputRole::intermediate});
                continue;
            }
            if (place >= 3 * network_.points.size()) {
                const network::Round& round = network_.rounds[place - 3 * network_.points.size()];
                const std::string& station = network_.points[round.station].name;
                outputs_.push_back(
                    {.symbol = round.name.empty() ? "o_" + station : "o_" + station + "_" + round.name,
                     .name = round.name.empty() ? tell<"orientation at %1">(station)
                                                : tell<"orientation at %1, round %2">(station, round.name),
                     .unit = Unit::of("gon"),
                     .group = own_name<"orientations">(),
                     .role = OutputRole::intermediate,
                     .periodic = true});
                continue;
            }
            const std::string& name = network_.points[place / 3].name;
            const std::string axis(along_axes[place % 3]);
            outputs_.push_back(
                {.symbol = axis, .name = tell<"%1, coordinate %2">(name, axis), .unit = unit, .group = name});
        }
        for (const auto& [from, to] : network_.distances)
            outputs_.push_back(
                {.symbol = network_.points[from].name + "–" + network_.points[to].name,
                 .name = tell<"distance from %1 to %2">(network_.points[from].name, network_.points[to].name),
                 .unit = unit,
                 .group = own_name<"distances">()});
    }

    std::shared_ptr<const network::NetworkEvidence> evidence_;
    const AdjustedNetwork& network_;  ///< the network of `evidence_`
    InputSet inputs_;
    mutable std::once_flag tables_made_;
    mutable std::vector<Table> tables_;  ///< made when they are first asked for
    network::AdjustedTrials trials_;
    std::vector<OutputQuantity> outputs_;
};

std::unique_ptr<MeasurementModel> create_adjustment(const SetupReader& reader, const AssetLibrary& assets,
                                                    Problems& problems) {
    network::StatedAdjustment stated = network::adjustment_fields().read(reader, assets, problems);
    if (problems.has_errors()) return nullptr;
    const auto uncertainties = stated.uncertainties;
    std::optional<AdjustedNetwork> made = network::adjust_stated(std::move(stated), problems);
    if (!made) return nullptr;
    network::take_as_seen(*made, uncertainties, problems);
    network::check_adjustment(*made, problems);
    if (problems.has_errors()) return nullptr;
    return std::make_unique<NetworkAdjustment>(std::move(*made));
}

std::vector<ModelEquation> adjustment_equations() {
    return {
        {"l + v = h(x)", tell<"readings l, their residuals v, unknowns x">()},
        {"min vᵀ C⁻¹ v", tell<"least squares, Gauss-Newton method">()},
        {"Q = (Jᵀ C⁻¹ J)⁻,  u² = diag Q", tell<"law of propagation; generalised inverse of the datum">()},
        {"Q_S = S Q Sᵀ,  S = I − G (GᵀBG)⁻¹ GᵀB", tell<"free network: W. Baarda, S-transformations, 1973">()},
        {"d = (1 + m) |p_B − p_A| + c,  z = z_0 + i,  Δh = s cot z + (1 − k) s²/2R",
         tell<"zero c and scale m of distances, index i, refraction k">()},
        {"r_i = (Q_vv C⁻¹)_ii,  w_i = (C⁻¹ v)_i / √(C⁻¹ Q_vv C⁻¹)_ii",
         tell<"redundancy and test of a reading: W. Baarda, A testing procedure, 1968">()},
        {"∇l_i = δ₀ / √(C⁻¹ Q_vv C⁻¹)_ii", tell<"smallest error of a reading that the test finds">()},
        {"E_n = |l − l_ref|/U",
         tell<"calibrated lengths, held back from the adjustment; U of the difference, k = 2">()},
        {"s₀² = vᵀ C⁻¹ v / f",
         tell<"a posteriori; uncertainties are those that were stated, not times s₀">()}};
}

}  // namespace

ModelDescriptor network_adjustment_model() {
    ModelDescriptor d;
    d.id = "network-adjustment";
    d.title = "Network adjustment";
    d.summary =
        "Coordinates of stations and targets from the distances, directions, angles and height differences "
        "that were "
        "read between them: heights, plane or space, free or held by known points, with the reliability of "
        "each "
        "reading.";
    d.references = {{"W. Baarda: A testing procedure for use in geodetic networks, 1968"},
                    {"W. Baarda: S-transformations and criterion matrices, 1973"},
                    {"JCGM 100:2008 (GUM), JCGM 101:2008, JCGM 102:2011"}};
    d.equations = adjustment_equations();
    d.notes = {
        "Uncertainties follow from those that were stated for the readings; they are not multiplied by s_0, "
        "which "
        "is a test of them.",
        "In a free network what no reading tells is taken from the approximate coordinates of the points of "
        "the "
        "datum: the sum of squares of their changes is least. Residuals, s_0 and redundancies do not depend "
        "on the "
        "datum.",
        "Each round of directions has an orientation that is not known. Instruments are levelled "
        "unless the set-up says how they lean: zenith angles count from the vertical, the z-axis at all "
        "points.",
        "Smallest detectable errors are those of a test at 0.1 % with a power of 80 % (delta_0 = 4.132), "
        "with the "
        "uncertainties that were stated.",
        "In Monte Carlo each trial is a solution with the derivatives at the estimates, repeated until it "
        "stands "
        "still.",
        "Zero, scale, refraction, index and collimation of an instrument are unknowns with or without a "
        "prior, which all of its readings share.",
        "Map projections are not part of it: reduce the readings before. The curvature of the Earth counts "
        "in "
        "zenith angles where its radius is given."};
    d.help_page = "network-adjustment.md";
    d.example = "levelled-network.covaria";
    d.capabilities = {"point-uncertainty", "seen-figures"};
    d.schema = network::adjustment_fields().schema();
    d.create = create_adjustment;
    return d;
}

}  // namespace covaria
