// The set-up of "network adjustment": points and readings as typed, and as they are adjusted.
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/adjustment/adjustment.h"
#include "core/adjustment/reliability.h"
#include "core/evidence/as_seen.h"
#include "core/model/layout.h"
#include "core/model/offered.h"
#include "core/quantity/input_quantity.h"
#include "core/setup/fields.h"
#include "core/text/table.h"

namespace covaria::network {

/// Knowledge of a coordinate before anything is read.
enum class CoordinateRole {
    unknown,  ///< nothing is known: it follows from the readings
    datum,    ///< nothing is known, and it shares what no reading tells with its like (free network)
    fixed,    ///< a value without uncertainty
    stated,   ///< a value with a standard uncertainty: one more reading
    none,     ///< no such coordinate in the network: a height in a plane network
};

enum class ReadingKind {
    slope_distance,
    horizontal_distance,
    direction,  ///< includes the unknown orientation of its round
    angle,
    azimuth,
    zenith_angle,
    height_difference,
    x,
    y,
    z,
    dx,
    dy,
    dz,
    frame_x,  ///< in an own frame of unknown pose, or of a plane or line
    frame_y,
    frame_z,
    tilt_x,  ///< how an instrument leans about x, then about y: stated, not read
    tilt_y,
    figure_length,  ///< a figure of an instrument: stated, not read
    figure_ratio,
    figure_angle,
};
inline constexpr std::size_t reading_kinds = 21;
bool is_of_angle(ReadingKind kind);
/// Whether it is read of points; false for what is stated of instruments.
bool is_read(ReadingKind kind);
/// Whether it is a reading within a frame.
bool is_in_frame(ReadingKind kind);
/// Unit in which residuals are shown.
Unit unit_of_residual(ReadingKind kind);
/// Whether it needs the heights of its points.
bool needs_heights(ReadingKind kind);
/// Whether it needs the places of its points in the plane.
bool needs_plane(ReadingKind kind);

using evidence::UncertaintiesFrom;
class SeenFiguresSource;  // core/kinds/network/seen_figures.h

/// Systematic effects of an instrument on all of its readings.
enum class FigureKind {
    zero,         ///< added to distances
    scale,        ///< relative change of distances: their factor less 1
    refraction,   ///< coefficient k of zenith angles
    index,        ///< added to zenith angles
    collimation,  ///< across the line of sight: directions by it over the sine of the zenith angle
};

enum class FigureKnowledge { unknown, stated, fixed };

/// What a frame that nobody stated is about: all of its axes, or no more than where something flat or
/// straight lies.
enum class FrameShape { axes, plane /** of x and y */, line /** along x */ };

/// The set-up as typed, SI.
struct StatedAdjustment {
    struct Point {
        std::string name;
        std::array<std::optional<double>, 3> p;
        CoordinateRole plane = CoordinateRole::unknown, height = CoordinateRole::unknown;
        std::array<std::optional<double>, 3> u;
    };
    struct Reading {
        std::string label = {};
        ReadingKind kind = ReadingKind::slope_distance;
        std::string from = {}, to = {}, second = {}, round = {}, frame = {}, instrument = {};
        std::optional<double> length = {}, angle = {}, u_length = {}, u_angle = {};
        double height_from = 0.0, height_to = 0.0;
        bool left_out = false;
        Message why_left_out = {};  ///< not by hand
    };
    struct Correlation {
        std::string first, second;
        double coefficient = 0.0;
    };
    struct Distance {
        std::string from, to;
    };
    struct Station {
        std::string point;
        bool stated = false;
        std::optional<double> u;
    };
    struct Figure {
        std::string instrument = {};
        FigureKind kind = FigureKind::zero;
        FigureKnowledge knowledge = FigureKnowledge::unknown;
        std::optional<double> length, ratio, angle, u_length, u_ratio, u_angle;
    };
    struct Frame {
        std::string name = {};
        FrameShape shape = FrameShape::axes;
        FigureKnowledge scale = FigureKnowledge::fixed;
        std::optional<double> ratio = {}, u_ratio = {}, u_tilt = {};
    };
    std::vector<Point> points;
    std::vector<Reading> readings;
    std::vector<Frame> frames;
    std::vector<Figure> figures;
    std::vector<Correlation> correlations;
    std::vector<Station> stations;
    std::vector<Distance> distances;
    bool clockwise = false;
    std::optional<double> earth_radius;
    double refraction = 0.0;
    std::optional<double> gross_limit;  ///< readings that miss the beginning by more are left out
    bool leaves_undetermined = false;   ///< points that nothing determines are left out
    bool robust = false;                ///< a robust start, and outliers are left out
    UncertaintiesFrom uncertainties = UncertaintiesFrom::stated;
    Offered<SeenFiguresSource> seen_in;  ///< empty: the table of readings states all of them
};
const Fields<StatedAdjustment>& adjustment_fields();

struct AdjustedPoint {
    std::string name;
    std::array<CoordinateRole, 3> role{};
    std::array<bool, 3> placed{};  ///< its coordinate was given
    std::size_t row = 0;           ///< row in the table of points
    bool has(std::size_t axis) const { return role[axis] != CoordinateRole::none; }
    bool is_found(std::size_t axis) const { return has(axis) && role[axis] != CoordinateRole::fixed; }
};

struct AdjustedReading {
    static constexpr std::size_t no_round = static_cast<std::size_t>(-1), no_tilt = no_round,
                                 no_frame = no_round;
    ReadingKind kind = ReadingKind::slope_distance;
    std::size_t from = 0, to = 0, second = 0;  ///< points
    std::size_t round = no_round;              ///< round of a direction
    std::size_t row = no_round;                ///< row in the table of readings
    std::size_t tilt = no_tilt;                ///< number of the instrument, if it is not levelled
    std::size_t frame = no_frame;              ///< in which it is, or whose tilt or scale it is
    double value = 0.0, u = 0.0;               ///< SI
    double height_from = 0.0, height_to = 0.0;
    std::vector<std::size_t> figures = {};  ///< figures of the instrument that change it
    std::string label = {};
    std::string instrument = {};
    /// Readings gave the u, as one estimate with others: its number, and how well it is known.
    std::size_t estimate = no_round;
    std::string seen_in = {}, seen_in_name = {};  ///< analysis whose readings gave it; empty: this one
    double factor = 1.0;                          ///< ratio of u to the u that was stated
    double degrees_of_freedom = infinity;
    std::string source = {};  ///< place in the set-up
    std::string symbol = {};  ///< symbol of its input quantity
};

/// Directions that were read without the circle being turned.
struct Round {
    std::size_t station = 0;
    std::string name = {};
};

/// A figure of an instrument, as it is adjusted.
struct InstrumentFigure {
    std::string instrument = {};
    FigureKind kind = FigureKind::zero;
    bool is_found = true;
};

/// A frame whose pose the readings tell: l = (1 + m) Aᵀ (p − p_0 − B t), A = A_0 R_z R_y R_x.
struct AdjustedFrame {
    static constexpr std::size_t figures = 7;  ///< t, turns about x, y, z, scale m
    std::string name = {};
    FrameShape shape = FrameShape::axes;
    bool is_flat = false;  ///< of points without heights
    std::array<bool, figures> is_found{};
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< A_0: as laid before the search
    Eigen::Matrix3d shifts =
        Eigen::Matrix3d::Identity();                   ///< B: those of the network, of planes and lines A_0
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< p_0
    std::string source = {};
};

/// A reading or point that is not adjusted, and why.
struct LeftOut {
    Message what, why;
    std::string source = {};
};

struct ReadingCorrelation {
    std::size_t first = 0, second = 0;
    double coefficient = 0.0;
};

/// The network is what its state says: coordinates of all points, then orientations of the rounds, then how
/// instruments lean that are not levelled: about x and, in its axes then, about y; then figures of
/// instruments; then frames.
struct AdjustedNetwork {
    static constexpr std::size_t known = static_cast<std::size_t>(-1);
    std::vector<AdjustedPoint> points;
    std::vector<AdjustedReading> readings;  ///< from the table, then those stated of coordinates
    std::vector<Round> rounds;
    std::vector<std::size_t> leaning;  ///< points of instruments that are not levelled
    std::vector<InstrumentFigure> figures;
    std::vector<AdjustedFrame> frames;
    std::vector<ReadingCorrelation> correlations;
    std::vector<std::array<std::size_t, 2>> distances;
    std::vector<LeftOut> left_out;
    std::vector<std::size_t> unplaced;  ///< points that the readings do not place
    double curvature = 0.0;             ///< curvature of the Earth, 1/m; 0: it does not count
    double refraction = 0.0;            ///< coefficient k where no figure says it
    bool clockwise = false;             ///< directions grow from y towards x, azimuths count from y

    Eigen::VectorXd state;                ///< the estimates; before the adjustment the start of the search
    Eigen::VectorXd stated;               ///< as typed, laid out like `state`: what the datum keeps
    std::vector<std::size_t> unknown_of;  ///< number of the unknown, or `known`
    std::vector<std::size_t> place_of;    ///< place of each unknown in the state
    std::vector<std::size_t> datum;       ///< unknowns that define the datum
    std::vector<adjustment::CovarianceBlock> blocks;
    adjustment::SparseRows whitening;
    std::shared_ptr<const adjustment::Adjustment> adjusted;  ///< adjustment at the estimates
    adjustment::Reliability reliability;                     ///< reliability at the estimates
    std::shared_ptr<const adjustment::Adjustment> unsolved;  ///< adjustment that left something open
    /// Evidence about the stated uncertainties where others are in use; null: those in use were stated.
    std::shared_ptr<const evidence::RedundantReadings> evidence;

    std::size_t at(std::size_t point, std::size_t axis) const { return 3 * point + axis; }
    std::size_t orientation(std::size_t round) const { return 3 * points.size() + round; }
    std::size_t tilt(std::size_t number, std::size_t axis) const {
        return 3 * points.size() + rounds.size() + 2 * number + axis;
    }
    std::size_t figure(std::size_t number) const {
        return 3 * points.size() + rounds.size() + 2 * leaning.size() + number;
    }
    std::size_t frame(std::size_t number, std::size_t of_figures) const {
        return figure(figures.size()) + AdjustedFrame::figures * number + of_figures;
    }
    Eigen::Vector3d position(std::size_t point) const {
        return state.segment<3>(static_cast<Eigen::Index>(3 * point));
    }
    /// Output quantities: coordinates that are found, orientations, tilts and figures, distances.
    std::size_t outputs() const { return place_of.size() + distances.size(); }
};

/// "slope distance A – B".
Message words_of(const AdjustedNetwork& network, const AdjustedReading& reading);
/// "the zero of T1".
Message words_of(const InstrumentFigure& figure);

/// "own frame F".
Message words_of(const AdjustedFrame& frame);

/// Checked; nothing is adjusted yet. Empty if `problems` got an error.
std::optional<AdjustedNetwork> adjusted_network(const StatedAdjustment& stated, Problems& problems);
/// Places what has no coordinates by the readings; errors name the points that cannot be.
void find_start(AdjustedNetwork& network, Problems& problems);
/// The least sum of squares: `state`, `adjusted` and `reliability`. Errors say what the readings leave open,
/// by name.
void adjust(AdjustedNetwork& network, Problems& problems);
/// Huber's weights from where the search begins: `state` near the least sum of the readings that agree.
void start_robustly(AdjustedNetwork& network);
/// A network that is checked, begun and adjusted. What the set-up lets go is left out, with its reason:
/// readings left out by hand, too far from the beginning, against the others; points that nothing tells.
std::optional<AdjustedNetwork> adjust_stated(StatedAdjustment stated, Problems& problems);
/// Sentences for the names of targets that one station seems to have exchanged.
std::vector<Message> exchanged_names(const AdjustedNetwork& adjusted);
/// Readings whose errors the test cannot tell from one of this reading, by name; empty: none.
Message alike_words(const AdjustedNetwork& network, std::size_t reading);
/// Residual of the reading at the state, in m; of an angle as a displacement at its target.
double offset_of(const AdjustedNetwork& network, const AdjustedReading& reading);
/// A sentence, where the readings are fewer than what they are to tell with the figures of instruments.
std::optional<Message> too_few_readings(const AdjustedNetwork& network);
/// Sentences for the directions that neither a reading nor the datum determines.
std::vector<Message> open_directions(const AdjustedNetwork& network, const adjustment::Adjustment& adjusted);

/// A derivative of one reading by one number of the state.
struct StateTerm {
    std::size_t place = 0;
    double coefficient = 0.0;
};
using StateTerms = std::vector<StateTerm>;
/// A coordinate in a frame, and its derivatives.
double predicted_in_frame(const AdjustedNetwork& network, const AdjustedReading& reading,
                          const double* state);
void derivatives_in_frame(const AdjustedNetwork& network, const AdjustedReading& reading, const double* state,
                          StateTerms& terms);
/// How the figures of a frame change when the network shifts by, turns about and grows from `middle`.
Eigen::Matrix<double, 7, 7> moves_of_frame(const AdjustedNetwork& network, std::size_t frame,
                                           const Eigen::Vector3d& middle);
/// The points of frame f whose coordinates are all there, as they are in it.
std::vector<std::pair<std::size_t, Eigen::Vector3d>> points_of_frame(const AdjustedNetwork& network,
                                                                     std::size_t f);
/// Lays the frame onto those of its points that are placed; false: they are too few, or on a line.
bool lay_frame(AdjustedNetwork& network, std::size_t f, const std::vector<char>& placed);
/// Where what has these coordinates in the frame is.
Eigen::Vector3d out_of_frame(const AdjustedNetwork& network, std::size_t f, const Eigen::Vector3d& in_frame);

/// The reading at that state; orientations and coordinates as in `AdjustedNetwork::state`.
double predicted(const AdjustedNetwork& network, const AdjustedReading& reading, const double* state);
/// Value less that; angles on the circle.
double residual_of(const AdjustedNetwork& network, const AdjustedReading& reading, double value,
                   const double* state);
void derivatives(const AdjustedNetwork& network, const AdjustedReading& reading, const double* state,
                 StateTerms& terms);
/// Derivatives of all readings by the unknowns.
adjustment::SparseRows design_of(const AdjustedNetwork& network, const double* state);
Eigen::VectorXd residuals_of(const AdjustedNetwork& network, const double* state);

/// The readings as evidence for or against their stated uncertainties: those of one kind by one instrument
/// rest on one figure, and kinds that are correlated with each other on one together.
evidence::RedundantReadings redundant_readings(const AdjustedNetwork& network);
/// The readings with the uncertainties that the residuals see, and the least sum of squares anew. A figure of
/// which they tell too little keeps what was stated; a warning says which.
void take_as_seen(AdjustedNetwork& network, UncertaintiesFrom from, Problems& problems);

InputSet adjustment_inputs(const AdjustedNetwork& network);
Layout adjustment_layout(const AdjustedNetwork& network);
inline const adjustment::Reliability& reliability_of(const AdjustedNetwork& network) {
    return network.reliability;
}
/// The adjustment in figures, residuals with their reliability.
std::vector<Table> adjustment_tables(const AdjustedNetwork& network);
/// Warns where residuals are larger than the uncertainties allow.
void check_adjustment(const AdjustedNetwork& network, Problems& problems);

}  // namespace covaria::network
