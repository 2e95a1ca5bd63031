// The set-up of "network adjustment": points and readings as they were typed, and as they are adjusted.
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/adjustment/adjustment.h"
#include "core/adjustment/reliability.h"
#include "core/base/dates.h"
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
    datum,    ///< nothing is known; coordinates of the datum share what no reading tells (free network)
    fixed,    ///< a value without uncertainty
    stated,   ///< a value with a standard uncertainty: one more reading
    none,     ///< the network has no such coordinate: a height in a plane network
    x_fixed,  ///< of x and y as they are typed: the one is fixed, the other unknown (datum 3-2-1)
    y_fixed,
};

enum class ReadingKind {
    slope_distance,
    horizontal_distance,
    direction,  ///< a direction includes the unknown orientation of its round
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
    frame_x,  ///< coordinate in an own frame of unknown pose, or in that of a plane or line
    frame_y,
    frame_z,
    tilt_x,  ///< lean of an instrument about x, then about y: stated, not read
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
    zero,        ///< offset added to distances
    scale,       ///< relative change of distances: their factor less 1
    refraction,  ///< coefficient k of zenith angles
    index,       ///< offset added to zenith angles
    /// Error across the line of sight: directions change by it over the sine of the zenith angle.
    collimation,
};

enum class FigureKnowledge { unknown, stated, fixed };

/// The shape of a frame that nobody stated: all of its axes count, or no more than where something flat or
/// straight lies.
enum class FrameShape { axes, plane /** of x and y */, line /** along x */ };

/// The set-up as it was typed, in SI.
struct StatedAdjustment {
    struct Point {
        std::string name;
        std::array<std::optional<double>, 3> p;
        CoordinateRole plane = CoordinateRole::unknown, height = CoordinateRole::unknown;
        std::array<std::optional<double>, 3> u;
    };
    struct Reading {
        /// A kind as it is typed; the adjustment has a zenith angle in its place.
        static constexpr ReadingKind elevation = static_cast<ReadingKind>(reading_kinds);
        std::string label = {};
        ReadingKind kind = ReadingKind::slope_distance;
        std::string from = {}, to = {}, second = {}, round = {}, frame = {}, instrument = {};
        std::optional<double> length = {}, angle = {}, u_length = {}, u_angle = {};
        double height_from = 0.0, height_to = 0.0;
        bool face_two = false;  ///< said to be of face two; a zenith angle beyond half a turn is so anyway
        bool is_elevation = false;  ///< a zenith angle that was typed as an elevation: its sign is the other
        bool left_out = false;
        Message why_left_out = {};  ///< reason, if it is not left out by hand
    };
    /// Makes zenith angles of elevations.
    void take_elevations();

    struct Correlation {
        std::string first, second;
        double coefficient = 0.0;
    };
    struct Distance {
        std::string from, to;
        std::optional<double> reference = {}, u_reference = {};
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
    std::string read_on;                 ///< date of the readings; empty: not stated
    Offered<SeenFiguresSource> seen_in;  ///< empty where the table of readings states all of them
    struct Campaign {
        Offered<SeenFiguresSource> seen_in;
    };
    std::vector<Campaign> further_campaigns;  ///< what they see is combined with what `seen_in` does
};
const Fields<StatedAdjustment>& adjustment_fields();

struct AdjustedPoint {
    std::string name;
    std::array<CoordinateRole, 3> role{};
    std::array<bool, 3> placed{};  ///< whether each coordinate was given
    std::array<std::optional<double>, 3> typed{};
    std::size_t row = 0;  ///< row in the table of points
    bool has(std::size_t axis) const { return role[axis] != CoordinateRole::none; }
    bool is_typed() const { return typed[0] && typed[1] && typed[2]; }
    bool is_found(std::size_t axis) const { return has(axis) && role[axis] != CoordinateRole::fixed; }
};

struct AdjustedReading {
    static constexpr std::size_t no_round = static_cast<std::size_t>(-1), no_tilt = no_round,
                                 no_frame = no_round;
    ReadingKind kind = ReadingKind::slope_distance;
    std::size_t from = 0, to = 0, second = 0;  ///< indices of points
    std::size_t round = no_round;              ///< round of a direction
    std::size_t row = no_round;                ///< row in the table of readings
    std::size_t tilt = no_tilt;                ///< number of the instrument, if it is not levelled
    std::size_t frame = no_frame;              ///< frame in which it is, or whose tilt or scale it is
    double value = 0.0, u = 0.0;               ///< in SI; an angle of face two is brought to face one
    double height_from = 0.0, height_to = 0.0;
    bool face_two = false;                  ///< index and collimation enter with the opposite sign
    std::vector<std::size_t> figures = {};  ///< figures of the instrument that change it
    std::string label = {};
    std::string instrument = {};
    /// Number of the estimate by which readings gave the u, in common with others. How well it is known is
    /// `degrees_of_freedom`.
    std::size_t estimate = no_round;
    std::string seen_in = {}, seen_in_name = {};  ///< analysis whose readings gave it; empty: this one
    double factor = 1.0;                          ///< ratio of u to the u that was stated
    double between = 0.0;  ///< standard deviation of ln u between the campaigns that saw it
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
    bool is_flat = false;  ///< whether its points have no heights
    std::array<bool, figures> is_found{};
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< axes A_0, as laid before the search
    /// Directions B of t: those of the network, or of A_0 for planes and lines.
    Eigen::Matrix3d shifts = Eigen::Matrix3d::Identity();
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< origin p_0
    std::string source = {};
};

/// A reading or point that is not adjusted, and the reason.
struct LeftOut {
    Message what, why;
    std::string source = {};
    bool is_by_hand = false;
};

/// A calibrated length of a distance, which is not adjusted.
struct ReferenceLength {
    std::size_t distance = 0;  ///< number of the distance
    double length = 0.0, u = 0.0;
};

struct ReadingCorrelation {
    std::size_t first = 0, second = 0;
    double coefficient = 0.0;
};

/// A figure of readings as several campaigns saw it.
struct FigureOverCampaigns {
    struct Campaign {
        std::string name;
        std::optional<Days> day = {};
        double value = 0.0;  ///< SI
        double degrees_of_freedom = 0.0;
    };
    std::string kind = {};          ///< kind of the readings in English: "slope distances"
    std::string instrument = {};    ///< may be empty
    std::optional<Unit> unit = {};  ///< empty: factors of what is stated, as the campaigns state several u
    std::vector<Campaign> campaigns = {};
    Campaign combined = {};
};

/// A network, which is what its state says: coordinates of all points, then orientations of the rounds, then
/// the lean of instruments that are not levelled, about x and, in their axes then, about y; then figures of
/// instruments; then frames.
struct AdjustedNetwork {
    static constexpr std::size_t known = static_cast<std::size_t>(-1);
    std::vector<AdjustedPoint> points;
    std::vector<AdjustedReading> readings;  ///< readings of the table, then those stated of coordinates
    std::vector<Round> rounds;
    std::vector<std::size_t> leaning;  ///< points of instruments that are not levelled
    std::vector<InstrumentFigure> figures;
    std::vector<AdjustedFrame> frames;
    std::vector<ReadingCorrelation> correlations;
    std::vector<std::array<std::size_t, 2>> distances;
    std::vector<ReferenceLength> references;
    std::optional<Days> read_on;                      ///< day of the readings
    std::vector<FigureOverCampaigns> over_campaigns;  ///< figures that more than one campaign saw
    std::vector<LeftOut> left_out;
    std::vector<std::size_t> unplaced;  ///< points that the readings do not place
    double curvature = 0.0;             ///< curvature of the Earth, 1/m; 0: it does not count
    double refraction = 0.0;            ///< coefficient k where no figure says it
    bool clockwise = false;             ///< directions grow from y towards x, azimuths count from y

    Eigen::VectorXd state;                ///< the estimates; before the adjustment the start of the search
    Eigen::VectorXd stated;               ///< values as typed, laid out like `state`, which the datum keeps
    std::vector<std::size_t> unknown_of;  ///< number of the unknown, or `known`
    std::vector<std::size_t> place_of;    ///< place of each unknown in the state
    std::vector<std::size_t> datum;       ///< unknowns that define the datum
    std::vector<adjustment::CovarianceBlock> blocks;
    adjustment::SparseRows whitening;
    std::shared_ptr<const adjustment::Adjustment> adjusted;  ///< adjustment at the estimates
    adjustment::Reliability reliability;                     ///< reliability at the estimates
    std::shared_ptr<const adjustment::Adjustment> unsolved;  ///< adjustment that left something open
    /// Evidence about the stated uncertainties where others are in use; null where those in use were stated.
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
    /// The number of output quantities: coordinates that are found, orientations, tilts and figures,
    /// distances.
    std::size_t outputs() const { return place_of.size() + distances.size(); }
};

/// The reading in words: "slope distance A – B".
Message words_of(const AdjustedNetwork& network, const AdjustedReading& reading);
/// The figure in words: "the zero of T1".
Message words_of(const InstrumentFigure& figure);

/// The frame in words: "own frame F".
Message words_of(const AdjustedFrame& frame);

/// The network of a set-up that was checked; nothing is adjusted yet. It is empty if `problems` got an error.
std::optional<AdjustedNetwork> adjusted_network(const StatedAdjustment& stated, Problems& problems);
/// Places points and stations without coordinates by the readings; errors name the points that cannot be
/// placed.
void find_start(AdjustedNetwork& network, Problems& problems);
/// Finds the least sum of squares: `state`, `adjusted` and `reliability`. Errors say what the readings leave
/// open, by name.
void adjust(AdjustedNetwork& network, Problems& problems);
/// Searches with Huber's weights from the beginning, so that `state` is near the least sum of the readings
/// that agree.
void start_robustly(AdjustedNetwork& network);
/// The network of a set-up, checked, begun and adjusted. Readings and points that the set-up lets go are left
/// out, with the reasons: readings left out by hand, too far from the beginning, against the others; points
/// that nothing tells.
std::optional<AdjustedNetwork> adjust_stated(StatedAdjustment stated, Problems& problems);
/// Sentences for the names of targets that one station seems to have exchanged.
std::vector<Message> exchanged_names(const AdjustedNetwork& adjusted);
/// The sentence for two targets of a station whose names are exchanged.
Message words_of_exchange(const AdjustedNetwork& network, std::size_t station, std::size_t a, std::size_t b);
/// Sentences for mistakes without which all readings agree: gon typed as degrees, mm as m, names exchanged at
/// a station, coordinates exchanged. `network` was begun; whether its search ended does not matter.
std::vector<Message> likely_mistakes(const AdjustedNetwork& network);
/// Readings whose errors the test cannot tell from one of this reading, by name; empty where there are none.
Message alike_words(const AdjustedNetwork& network, std::size_t reading);
/// The residual of the reading at the state, in m; that of an angle is a displacement at its target.
double offset_of(const AdjustedNetwork& network, const AdjustedReading& reading);
/// A sentence for readings that are fewer than the unknowns which they are to tell, figures of instruments
/// among them; none where they are enough.
std::optional<Message> too_few_readings(const AdjustedNetwork& network);
/// Sentences for the directions that neither a reading nor the datum determines.
std::vector<Message> open_directions(const AdjustedNetwork& network, const adjustment::Adjustment& adjusted);

/// A derivative of one reading by one number of the state.
struct StateTerm {
    std::size_t place = 0;
    double coefficient = 0.0;
};
using StateTerms = std::vector<StateTerm>;
/// The prediction of a coordinate in a frame, and its derivatives.
double predicted_in_frame(const AdjustedNetwork& network, const AdjustedReading& reading,
                          const double* state);
void derivatives_in_frame(const AdjustedNetwork& network, const AdjustedReading& reading, const double* state,
                          StateTerms& terms);
/// Changes of the figures of a frame when the network shifts by, turns about and grows from `middle`.
Eigen::Matrix<double, 7, 7> moves_of_frame(const AdjustedNetwork& network, std::size_t frame,
                                           const Eigen::Vector3d& middle);
/// The points of frame f whose coordinates were all read, with these coordinates.
std::vector<std::pair<std::size_t, Eigen::Vector3d>> points_of_frame(const AdjustedNetwork& network,
                                                                     std::size_t f);
/// Lays the frame onto those of its points that are placed; false where they are too few, or on a line.
bool lay_frame(AdjustedNetwork& network, std::size_t f, const std::vector<char>& placed);
/// The place in the network of these coordinates in the frame.
Eigen::Vector3d out_of_frame(const AdjustedNetwork& network, std::size_t f, const Eigen::Vector3d& in_frame);

/// The prediction of the reading at that state; orientations and coordinates are as in
/// `AdjustedNetwork::state`.
double predicted(const AdjustedNetwork& network, const AdjustedReading& reading, const double* state);
/// The value less the prediction of the reading; that of angles is on the circle.
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
/// Gives the readings the uncertainties that the residuals see, and finds the least sum of squares anew. A
/// figure of which they tell too little keeps the stated uncertainty; a warning says which.
void take_as_seen(AdjustedNetwork& network, UncertaintiesFrom from, Problems& problems);

InputSet adjustment_inputs(const AdjustedNetwork& network);
Layout adjustment_layout(const AdjustedNetwork& network);
inline const adjustment::Reliability& reliability_of(const AdjustedNetwork& network) {
    return network.reliability;
}
/// The tables of the figures of the adjustment, and of residuals with their reliability.
std::vector<Table> adjustment_tables(const AdjustedNetwork& network);
/// Warns where residuals are larger than the uncertainties allow.
void check_adjustment(const AdjustedNetwork& network, Problems& problems);

}  // namespace covaria::network
