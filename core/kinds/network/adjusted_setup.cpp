// The checks of the set-up of "network adjustment".
#include "core/kinds/network/adjusted_setup.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <unordered_map>

#include "core/base/disjoint_sets.h"

namespace covaria::network {

namespace {

using Typed = StatedAdjustment;

bool is_length(FigureKind kind) {
    return kind == FigureKind::zero;
}
bool is_ratio(FigureKind kind) {
    return kind == FigureKind::scale || kind == FigureKind::refraction;
}

double value_of(const Typed::Figure& typed, double otherwise) {
    const std::optional<double>& value = is_length(typed.kind)  ? typed.length
                                         : is_ratio(typed.kind) ? typed.ratio
                                                                : typed.angle;
    return value.value_or(otherwise);
}
const std::optional<double>& u_of(const Typed::Figure& typed) {
    return is_length(typed.kind) ? typed.u_length : is_ratio(typed.kind) ? typed.u_ratio : typed.u_angle;
}

bool is_changed(const InstrumentFigure& figure, const Typed::Reading& reading) {
    if (reading.left_out || reading.instrument != figure.instrument) return false;
    switch (figure.kind) {
        case FigureKind::zero:
        case FigureKind::scale:
            return reading.kind == ReadingKind::slope_distance ||
                   reading.kind == ReadingKind::horizontal_distance;
        case FigureKind::collimation:
            return reading.kind == ReadingKind::direction;
        default:
            return reading.kind == ReadingKind::zenith_angle;
    }
}

InstrumentFigure figure_of_row(const Typed& stated, std::size_t row, const AdjustedNetwork& made,
                               Problems& problems) {
    const Typed::Figure& typed = stated.figures[row];
    const std::string path = adjustment_fields().place(&Typed::figures, row);
    InstrumentFigure figure{typed.instrument, typed.kind, typed.knowledge != FigureKnowledge::fixed};
    const Message words = words_of(figure);
    for (const InstrumentFigure& other : made.figures)
        if (other.instrument == typed.instrument && other.kind == typed.kind)
            problems.error(path, tell<"%1 is stated twice">(words));
    if (typed.knowledge == FigureKnowledge::stated && !u_of(typed))
        problems.error(path, tell<"%1: its standard uncertainty is missing">(words));
    if (typed.kind == FigureKind::refraction && made.curvature == 0.0)
        problems.error(path, tell<"%1 needs the radius of the Earth">(words));
    const bool is_used =
        std::ranges::any_of(stated.readings, [&](const Typed::Reading& r) { return is_changed(figure, r); });
    if (!is_used)
        problems.error(path, tell<"there is no reading that %1 would change: readings say their "
                                  "instrument in their column">(words));
    return figure;
}

void add_stated_figures(const Typed& stated, AdjustedNetwork& made) {
    for (std::size_t row = 0; row < stated.figures.size(); ++row) {
        const Typed::Figure& typed = stated.figures[row];
        if (typed.knowledge != FigureKnowledge::stated) continue;
        AdjustedReading reading{.kind = is_length(typed.kind)  ? ReadingKind::figure_length
                                        : is_ratio(typed.kind) ? ReadingKind::figure_ratio
                                                               : ReadingKind::figure_angle};
        reading.value = value_of(typed, typed.kind == FigureKind::refraction ? made.refraction : 0.0);
        reading.u = *u_of(typed);
        reading.figures = {row};
        reading.source = adjustment_fields().place(&Typed::figures, row);
        made.readings.push_back(std::move(reading));
    }
}

/// Takes the frames of the table, then those that only readings name.
void take_own_frames(const Typed& stated, AdjustedNetwork& made, Problems& problems) {
    std::map<std::string, std::size_t> known;
    for (std::size_t row = 0; row < stated.frames.size(); ++row) {
        const Typed::Frame& typed = stated.frames[row];
        const std::string path = adjustment_fields().place(&Typed::frames, row);
        made.frames.push_back({.name = typed.name, .shape = typed.shape, .source = path});
        if (!known.try_emplace(typed.name, row).second)
            problems.error(path, tell<"two frames are called %1">(typed.name));
        const bool scaled = typed.scale != FigureKnowledge::fixed || typed.ratio || typed.u_ratio;
        if (typed.shape != FrameShape::axes && (scaled || typed.u_tilt))
            problems.error(path, tell<"%1 has no scale and no tilt to state">(words_of(made.frames.back())));
        if (typed.scale == FigureKnowledge::stated && !typed.u_ratio)
            problems.error(path,
                           tell<"%1: the u of its stated scale is missing">(words_of(made.frames.back())));
        if (std::ranges::none_of(stated.readings, [&](const Typed::Reading& r) {
                return is_in_frame(r.kind) && r.frame == typed.name && !r.left_out;
            }))
            problems.error(path, tell<"there is no reading in %1">(words_of(made.frames.back())));
    }
    for (std::size_t row = 0; row < stated.readings.size(); ++row) {
        const Typed::Reading& r = stated.readings[row];
        if (is_in_frame(r.kind) && !r.left_out && known.try_emplace(r.frame, made.frames.size()).second)
            made.frames.push_back(
                {.name = r.frame, .source = adjustment_fields().place(&Typed::readings, row)});
        if (!is_in_frame(r.kind) || r.left_out) continue;
        for (const AdjustedPoint& point : made.points)
            if (point.name == r.from && !point.has(2)) made.frames[known.at(r.frame)].is_flat = true;
    }
    for (std::size_t f = 0; f < made.frames.size(); ++f) {
        AdjustedFrame& frame = made.frames[f];
        const bool axes = frame.shape == FrameShape::axes, plane = frame.shape == FrameShape::plane,
                   space = !frame.is_flat;
        frame.is_found = {axes,
                          !plane,
                          (axes || space) && space,
                          axes ? space : plane,
                          space,
                          !plane,
                          f < stated.frames.size() && stated.frames[f].scale != FigureKnowledge::fixed};
        if (plane && frame.is_flat)
            problems.error(frame.source, tell<"%1 has points without heights">(words_of(frame)));
    }
}

std::size_t own_frame_of(const AdjustedNetwork& made, const Typed::Reading& typed, const std::string& path,
                         Problems& problems) {
    const auto found =
        std::ranges::find_if(made.frames, [&](const AdjustedFrame& f) { return f.name == typed.frame; });
    if (typed.frame.empty() || found == made.frames.end()) {
        problems.error(path,
                       tell<"a coordinate of %1 in a frame: the name of the frame is missing">(typed.from));
        return 0;
    }
    const bool none = (found->shape == FrameShape::plane && typed.kind != ReadingKind::frame_z) ||
                      (found->shape == FrameShape::line && typed.kind == ReadingKind::frame_x) ||
                      (found->is_flat && typed.kind == ReadingKind::frame_z);
    const auto point =
        std::ranges::find_if(made.points, [&](const AdjustedPoint& p) { return p.name == typed.from; });
    if (none) problems.error(path, tell<"%1 has no such coordinate of %2">(words_of(*found), typed.from));
    if (point != made.points.end() && !point->has(0))
        problems.error(path,
                       tell<"a coordinate in %1 needs x and y of %2, which are not part of the network">(
                           words_of(*found), typed.from));
    return static_cast<std::size_t>(found - made.frames.begin());
}

void add_stated_of_frames(const Typed& stated, AdjustedNetwork& made) {
    for (std::size_t row = 0; row < stated.frames.size(); ++row) {
        const Typed::Frame& typed = stated.frames[row];
        const auto add = [&](ReadingKind kind, double value, double u) {
            AdjustedReading reading{.kind = kind, .frame = row, .value = value, .u = u};
            reading.source = adjustment_fields().place(&Typed::frames, row);
            made.readings.push_back(std::move(reading));
        };
        if (typed.scale == FigureKnowledge::stated)
            add(ReadingKind::figure_ratio, typed.ratio.value_or(0.0), *typed.u_ratio);
        if (!typed.u_tilt || made.frames[row].is_flat) continue;
        add(ReadingKind::tilt_x, 0.0, *typed.u_tilt);
        add(ReadingKind::tilt_y, 0.0, *typed.u_tilt);
    }
}

void check_parts(const AdjustedNetwork& made, const AdjustedReading& reading, Problems& problems) {
    for (const std::size_t p : {reading.from, reading.to, reading.second}) {
        const AdjustedPoint& point = made.points[p];
        const bool by_all = reading.tilt != AdjustedReading::no_tilt ||
                            std::ranges::any_of(reading.figures, [&](std::size_t f) {
                                return made.figures[f].kind == FigureKind::collimation;
                            });
        if ((by_all || needs_heights(reading.kind)) && !point.has(2))
            return problems.error(reading.source,
                                  tell<"%1 needs the height of %2, which is not part of the network">(
                                      words_of(made, reading), point.name));
        if (needs_plane(reading.kind) && !point.has(0))
            return problems.error(reading.source,
                                  tell<"%1 needs x and y of %2, which are not part of the network">(
                                      words_of(made, reading), point.name));
    }
}

}  // namespace

void StatedAdjustment::take_elevations() {
    constexpr double quarter_turn = 0.5 * std::numbers::pi;
    for (Reading& reading : readings) {
        if (reading.kind != Reading::elevation) continue;
        reading.kind = ReadingKind::zenith_angle;
        reading.is_elevation = true;
        if (reading.angle) *reading.angle = quarter_turn - *reading.angle;
    }
}

namespace {

bool is_of_one_point(ReadingKind kind) {
    return kind == ReadingKind::x || kind == ReadingKind::y || kind == ReadingKind::z || is_in_frame(kind);
}

/// Whether a reading of that kind is by the own axes of an instrument that leans.
bool is_by_axes(ReadingKind kind) {
    return kind == ReadingKind::direction || kind == ReadingKind::angle || kind == ReadingKind::zenith_angle;
}

bool is_left_out(const Typed& stated, const std::string& label) {
    return std::ranges::any_of(stated.readings,
                               [&](const Typed::Reading& r) { return r.left_out && r.label == label; });
}

/// Brings an angle as read in face two to face one: of a zenith angle z it makes 2 pi - z, of a direction or
/// azimuth a the angle a - pi.
void bring_to_face_one(const AdjustedNetwork& made, const Typed::Reading& typed, AdjustedReading& reading,
                       Problems& problems) {
    constexpr double half_turn = std::numbers::pi;
    if (typed.face_two && (typed.kind == ReadingKind::direction || typed.kind == ReadingKind::azimuth)) {
        reading.value -= half_turn;
        reading.face_two = typed.kind == ReadingKind::direction;
    }
    if (typed.kind != ReadingKind::zenith_angle) return;
    reading.face_two = typed.face_two || reading.value > half_turn;
    if (reading.face_two) reading.value = 2.0 * half_turn - reading.value;
    if (reading.value > 0.0 && reading.value < half_turn) return;
    AdjustedReading as_typed = reading;
    as_typed.face_two = false;
    const Message words = words_of(made, as_typed);
    problems.error(
        reading.source,
        typed.face_two
            ? tell<"%1 of face two is not between half a turn and a whole one: type it as read">(words)
            : tell<"%1 is not between 0 and half a turn (face one), nor between half a turn and a "
                   "whole one (face two)">(words));
}

/// The correlation of two readings as typed, whose sign changes where one of them is a zenith angle of face
/// two or was typed as an elevation: its deviation has the opposite sign.
ReadingCorrelation correlation_of(const AdjustedNetwork& made, std::size_t first, std::size_t second,
                                  const Typed& stated, const Typed::Correlation& typed) {
    double coefficient = typed.coefficient;
    for (const std::size_t i : {first, second}) {
        const AdjustedReading& reading = made.readings[i];
        if (reading.kind != ReadingKind::zenith_angle) continue;
        if (reading.face_two != stated.readings[reading.row].is_elevation) coefficient = -coefficient;
    }
    return {first, second, coefficient};
}

CoordinateRole role_of(const Typed::Point& typed, std::size_t axis) {
    if (axis == 2) return typed.height;
    if (typed.plane != CoordinateRole::x_fixed && typed.plane != CoordinateRole::y_fixed) return typed.plane;
    return (typed.plane == CoordinateRole::x_fixed) == (axis == 0) ? CoordinateRole::fixed
                                                                   : CoordinateRole::unknown;
}

void tell_left_out(AdjustedNetwork& made, const AdjustedReading& reading, const Message& why) {
    made.left_out.push_back(
        {words_of(made, reading), why.empty() ? tell<"by hand">() : why, reading.source, why.empty()});
}

void begin_scales(const Typed& stated, AdjustedNetwork& made) {
    for (std::size_t f = 0; f < stated.frames.size(); ++f)
        made.state[static_cast<Eigen::Index>(made.frame(f, 6))] = stated.frames[f].ratio.value_or(0.0);
}

void take_value(const AdjustedNetwork& made, const Typed::Reading& typed, AdjustedReading& reading,
                Problems& problems) {
    const bool angle = is_of_angle(typed.kind);
    const auto& value = angle ? typed.angle : typed.length;
    const auto& u = angle ? typed.u_angle : typed.u_length;
    const auto words = [&] { return words_of(made, reading); };  // which only problems need
    if (!value || !u)
        return problems.error(reading.source, !value
                                                  ? tell<"%1: its value is missing">(words())
                                                  : tell<"%1: its standard uncertainty is missing">(words()));
    if (angle ? typed.length.has_value() : typed.angle.has_value())
        problems.error(reading.source, angle ? tell<"%1 is an angle and has a length">(words())
                                             : tell<"%1 is a length and has an angle">(words()));
    reading.value = *value;
    reading.u = *u;
    const bool distance =
        typed.kind == ReadingKind::slope_distance || typed.kind == ReadingKind::horizontal_distance;
    if (distance && !(*value > 0.0)) problems.error(reading.source, tell<"%1 is not positive">(words()));
    bring_to_face_one(made, typed, reading, problems);
}

void take_date(const Typed& stated, AdjustedNetwork& made, Problems& problems) {
    if (stated.read_on.empty()) return;
    made.read_on = date_of(stated.read_on);
    if (!made.read_on)
        problems.error(adjustment_fields().place(&Typed::read_on),
                       tell<"a date of the form 2026-04-17 is needed; it is '%1'">(stated.read_on));
}

class AdjustmentReading {
public:
    AdjustmentReading(const Typed& stated, Problems& problems) : stated_(stated), problems_(problems) {}

    std::optional<AdjustedNetwork> read() {
        made_.clockwise = stated_.clockwise;
        if (stated_.earth_radius) made_.curvature = 1.0 / *stated_.earth_radius;
        made_.refraction = stated_.refraction;
        for (std::size_t row = 0; row < stated_.points.size(); ++row) take_point(row);
        if (problems_.has_errors()) return {};
        for (std::size_t row = 0; row < stated_.stations.size(); ++row) take_station(row);
        for (std::size_t row = 0; row < stated_.figures.size(); ++row)
            made_.figures.push_back(figure_of_row(stated_, row, made_, problems_));
        take_own_frames(stated_, made_, problems_);
        made_.readings.reserve(stated_.readings.size() + 3 * stated_.points.size());
        for (std::size_t row = 0; row < stated_.readings.size(); ++row) take_reading(row);
        for (std::size_t row = 0; row < stated_.distances.size(); ++row) take_distance(row);
        take_date(stated_, made_, problems_);
        if (problems_.has_errors()) return {};
        for (std::size_t row = 0; row < stated_.points.size(); ++row) add_stated_coordinates(row);
        add_stated_tilts();
        add_stated_figures(stated_, made_);
        add_stated_of_frames(stated_, made_);
        number();
        take_correlations();
        weigh();
        if (problems_.has_errors()) return {};
        return std::move(made_);
    }

private:
    static std::string point_place(std::size_t row) { return adjustment_fields().place(&Typed::points, row); }
    static std::string reading_place(std::size_t row) {
        return adjustment_fields().place(&Typed::readings, row);
    }

    void take_point(std::size_t row) {
        const Typed::Point& typed = stated_.points[row];
        const std::string path = point_place(row);
        if (!names_.try_emplace(typed.name, row).second)
            problems_.error(path, tell<"two points are called %1">(typed.name));
        AdjustedPoint point{.name = typed.name, .row = row};
        for (std::size_t c = 0; c < 3; ++c) {
            point.role[c] = role_of(typed, c);
            point.placed[c] = typed.p[c].has_value();
            point.typed[c] = typed.p[c];
            const bool needs =
                point.role[c] == CoordinateRole::fixed || point.role[c] == CoordinateRole::stated;
            const std::string axis(along_axes[c]);
            if (needs && !typed.p[c])
                problems_.error(
                    path, tell<"point %1: its %2 is said to be known, and is missing">(typed.name, axis));
            if (point.role[c] == CoordinateRole::stated && !typed.u[c])
                problems_.error(path, tell<"point %1: the u of its stated %2 is missing">(typed.name, axis));
        }
        made_.points.push_back(std::move(point));
    }

    std::optional<std::size_t> called(const std::string& name, const std::string& path) {
        const auto found = names_.find(name);
        if (found != names_.end()) return found->second;
        problems_.error(path, name.empty() ? tell<"the name of a point is missing">()
                                           : tell<"there is no point %1">(name));
        return {};
    }

    void take_station(std::size_t row) {
        const Typed::Station& typed = stated_.stations[row];
        const std::string path = adjustment_fields().place(&Typed::stations, row);
        const auto point = called(typed.point, path);
        if (!point) return;
        if (typed.stated && !typed.u)
            problems_.error(path, tell<"the instrument at %1: the u of its tilt is missing">(typed.point));
        if (!leaning_.try_emplace(*point, made_.leaning.size()).second)
            return problems_.error(path, tell<"two instruments stand at %1">(typed.point));
        made_.leaning.push_back(*point);
    }

    void add_stated_tilts() {
        for (std::size_t row = 0; row < stated_.stations.size(); ++row) {
            const Typed::Station& typed = stated_.stations[row];
            if (!typed.stated) continue;
            for (const ReadingKind kind : {ReadingKind::tilt_x, ReadingKind::tilt_y}) {
                AdjustedReading reading{.kind = kind, .tilt = row, .u = *typed.u};
                reading.from = reading.to = reading.second = made_.leaning[row];
                reading.source = adjustment_fields().place(&Typed::stations, row);
                made_.readings.push_back(std::move(reading));
            }
        }
    }

    void take_reading(std::size_t row) {
        const Typed::Reading& typed = stated_.readings[row];
        const std::string path = reading_place(row);
        AdjustedReading reading{.kind = typed.kind, .label = typed.label, .source = path};
        const auto from = called(typed.from, path);
        const auto to = is_of_one_point(typed.kind) ? from : called(typed.to, path);
        const auto second = typed.kind == ReadingKind::angle ? called(typed.second, path) : to;
        if (!from || !to || !second) return;
        reading.instrument = typed.instrument;
        reading.row = row;
        reading.from = *from, reading.to = *to, reading.second = *second;
        reading.height_from = typed.height_from;
        reading.height_to = typed.height_to;
        if (!is_of_one_point(typed.kind) && (*from == *to || *from == *second))
            return problems_.error(path, tell<"a reading from %1 to itself">(typed.from));
        if (typed.kind == ReadingKind::angle && *to == *second)
            return problems_.error(path, tell<"both legs of the angle at %1 go to %2">(typed.from, typed.to));
        take_value(made_, typed, reading, problems_);
        if (typed.left_out) return tell_left_out(made_, reading, typed.why_left_out);
        for (std::size_t f = 0; f < made_.figures.size(); ++f)
            if (is_changed(made_.figures[f], typed)) reading.figures.push_back(f);
        if (typed.kind == ReadingKind::direction) reading.round = round_of(*from, typed.round);
        if (const auto leaning = leaning_.find(*from); leaning != leaning_.end() && is_by_axes(typed.kind))
            reading.tilt = leaning->second;
        if (is_in_frame(typed.kind))
            reading.frame = own_frame_of(made_, typed, reading.source, problems_);
        else
            check_parts(made_, reading, problems_);
        made_.readings.push_back(std::move(reading));
    }

    std::size_t round_of(std::size_t station, const std::string& name) {
        const auto [known, added] = rounds_.try_emplace({station, name}, made_.rounds.size());
        if (added) made_.rounds.push_back({station, name});
        return known->second;
    }

    void take_distance(std::size_t row) {
        const std::string path = adjustment_fields().place(&Typed::distances, row);
        const auto from = called(stated_.distances[row].from, path),
                   to = called(stated_.distances[row].to, path);
        if (!from || !to) return;
        if (*from == *to) return problems_.error(path, tell<"a distance needs two points">());
        const Typed::Distance& typed = stated_.distances[row];
        if (typed.reference.has_value() != typed.u_reference.has_value())
            return problems_.error(path, tell<"a reference length and its u belong together">());
        if (typed.reference)
            made_.references.push_back({made_.distances.size(), *typed.reference, *typed.u_reference});
        made_.distances.push_back({*from, *to});
    }

    void add_stated_coordinates(std::size_t row) {
        constexpr std::array<ReadingKind, 3> of_axis{ReadingKind::x, ReadingKind::y, ReadingKind::z};
        const Typed::Point& typed = stated_.points[row];
        for (std::size_t c = 0; c < 3; ++c) {
            if (made_.points[row].role[c] != CoordinateRole::stated) continue;
            AdjustedReading reading{.kind = of_axis[c], .from = row, .to = row, .second = row};
            reading.value = *typed.p[c];
            reading.u = *typed.u[c];
            reading.source = point_place(row);
            made_.readings.push_back(std::move(reading));
        }
    }

    void number() {
        const std::size_t coordinates = 3 * made_.points.size(),
                          instruments = coordinates + made_.rounds.size() + 2 * made_.leaning.size(),
                          places = instruments + made_.figures.size() +
                                   AdjustedFrame::figures * made_.frames.size();
        made_.state = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(places));
        made_.unknown_of.assign(places, AdjustedNetwork::known);
        for (std::size_t p = 0; p < made_.points.size(); ++p)
            for (std::size_t c = 0; c < 3; ++c) {
                const std::size_t place = made_.at(p, c);
                made_.state[static_cast<Eigen::Index>(place)] = stated_.points[p].p[c].value_or(0.0);
                if (!made_.points[p].is_found(c)) continue;
                if (made_.points[p].role[c] == CoordinateRole::datum)
                    made_.datum.push_back(made_.place_of.size());
                add_unknown(place);
            }
        bool finds = !made_.place_of.empty();
        for (std::size_t place = coordinates; place < instruments; ++place) add_unknown(place);
        for (std::size_t f = 0; f < made_.figures.size(); ++f) {
            const bool refracts = made_.figures[f].kind == FigureKind::refraction;
            made_.state[static_cast<Eigen::Index>(made_.figure(f))] =
                value_of(stated_.figures[f], refracts ? made_.refraction : 0.0);
            if (!made_.figures[f].is_found) continue;
            add_unknown(made_.figure(f));
            finds = true;
        }
        begin_scales(stated_, made_);
        for (std::size_t f = 0; f < made_.frames.size(); ++f)
            for (std::size_t k = 0; k < AdjustedFrame::figures; ++k)
                if (made_.frames[f].is_found[k]) add_unknown(made_.frame(f, k));
        finds = finds || !made_.frames.empty();
        if (!finds)
            problems_.error(adjustment_fields().place(&Typed::points),
                            tell<"all points are fixed: there is nothing to be found">());
        static constexpr std::array<const char*, reading_kinds> letters{
            "s",  "d",  "r",  "a",  "t",  "v",  "h",  "x", "y", "z", "dx",
            "dy", "dz", "xf", "yf", "zf", "lx", "ly", "f", "f", "f"};
        for (std::size_t i = 0; i < made_.readings.size(); ++i)
            made_.readings[i].symbol =
                letters[static_cast<std::size_t>(made_.readings[i].kind)] + ("_" + std::to_string(i + 1));
    }

    void add_unknown(std::size_t place) {
        made_.unknown_of[place] = made_.place_of.size();
        made_.place_of.push_back(place);
    }

    void take_correlations() {
        std::map<std::string, std::size_t> labels;
        for (std::size_t i = 0; i < made_.readings.size(); ++i)
            if (const AdjustedReading& reading = made_.readings[i];
                !reading.label.empty() && !labels.try_emplace(reading.label, i).second)
                problems_.error(reading.source, tell<"two readings have the label %1">(reading.label));
        for (std::size_t row = 0; row < stated_.correlations.size(); ++row) {
            const Typed::Correlation& typed = stated_.correlations[row];
            const std::string path = adjustment_fields().place(&Typed::correlations, row);
            const auto first = labels.find(typed.first), second = labels.find(typed.second);
            for (const auto& [found, name] : {std::pair(first, typed.first), std::pair(second, typed.second)})
                if (found == labels.end() && !is_left_out(stated_, name))
                    problems_.error(path, tell<"there is no reading with the label %1">(name));
            if (first == labels.end() || second == labels.end()) continue;
            if (first->second == second->second)
                problems_.error(path, tell<"reading %1 with itself">(typed.first));
            else
                made_.correlations.push_back(
                    correlation_of(made_, first->second, second->second, stated_, typed));
        }
    }

    /// Weighs the readings; those that are correlated, directly or through others, have one covariance
    /// matrix.
    void weigh() {
        DisjointSets sets(made_.readings.size());
        for (const ReadingCorrelation& c : made_.correlations) sets.join(c.first, c.second);
        std::map<std::size_t, std::size_t> blocks;
        std::vector<std::pair<std::size_t, Eigen::Index>> where(made_.readings.size());
        for (const ReadingCorrelation& c : made_.correlations) blocks.try_emplace(sets.leader_of(c.first), 0);
        for (auto& [first, number] : blocks) {
            number = made_.blocks.size();
            made_.blocks.emplace_back();
        }
        for (std::size_t i = 0; i < made_.readings.size(); ++i) {
            const auto block = blocks.find(sets.leader_of(i));
            if (block == blocks.end()) continue;
            auto& readings = made_.blocks[block->second].readings;
            where[i] = {block->second, static_cast<Eigen::Index>(readings.size())};
            readings.push_back(i);
        }
        Eigen::VectorXd u(static_cast<Eigen::Index>(made_.readings.size()));
        for (std::size_t i = 0; i < made_.readings.size(); ++i)
            u[static_cast<Eigen::Index>(i)] = made_.readings[i].u;
        for (adjustment::CovarianceBlock& block : made_.blocks) {
            const Eigen::VectorXd own = u(block.readings);
            block.covariance = own.cwiseAbs2().asDiagonal();
        }
        for (const ReadingCorrelation& c : made_.correlations) {
            Eigen::MatrixXd& covariance = made_.blocks[where[c.first].first].covariance;
            const Eigen::Index i = where[c.first].second, j = where[c.second].second;
            covariance(i, j) = covariance(j, i) =
                c.coefficient * made_.readings[c.first].u * made_.readings[c.second].u;
        }
        made_.whitening = adjustment::whitening(u, made_.blocks);
        if (made_.whitening.rows() == 0 && !problems_.has_errors())
            problems_.error(adjustment_fields().place(&Typed::correlations),
                            tell<"the correlation coefficients are not possible together">());
    }

    const Typed& stated_;
    Problems& problems_;
    AdjustedNetwork made_;
    std::unordered_map<std::string, std::size_t> names_;
    std::map<std::size_t, std::size_t> leaning_;  ///< number of the instrument that leans, by its point
    std::map<std::pair<std::size_t, std::string>, std::size_t> rounds_;
};

}  // namespace

std::optional<AdjustedNetwork> adjusted_network(const StatedAdjustment& stated, Problems& problems) {
    return AdjustmentReading(stated, problems).read();
}

}  // namespace covaria::network
