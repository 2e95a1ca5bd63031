// Networks of Comp3D, which are two files or more: the observations (.obs) with the coordinates beside them,
// or the settings (.comp) that name both.
#include <algorithm>
#include <set>

#include "core/base/in_quotes.h"
#include "core/base/text_places.h"
#include "core/readers/comp3d_lists.h"
#include "core/readers/comp3d_network.h"
#include "core/readers/comp3d_project.h"
#include "core/readers/delimited_text.h"
#include "core/readers/entry_texts.h"
#include "core/readers/formats.h"
#include "core/readers/unstated_units.h"

namespace covaria {

namespace {

constexpr std::size_t most_settings = 20;  ///< files of settings that are looked into

bool ends_as(const std::string& name, const char* small, const char* capital) {
    return name.ends_with(small) || name.ends_with(capital);
}

/// The settings beside the file of observations that name it; empty where there are none, or several.
std::optional<Comp3dProject> settings_beside(const ReadChoice& choice, std::string& name) {
    std::optional<Comp3dProject> found;
    std::size_t looked = 0;
    for (const std::string& other : choice.beside.names) {
        if (!ends_as(other, ".comp", ".COMP") || ++looked > most_settings) continue;
        const auto text = choice.beside.read(other);
        const auto project = text ? comp3d_project(*text) : Result<Comp3dProject>(fail(text.error()));
        if (!project || project->observations != choice.file_name) continue;
        if (found) return std::nullopt;
        found = *project;
        name = other;
    }
    return found;
}

/// The file of coordinates beside one of observations: of the same name, or the only one.
std::string coordinates_beside(const ReadChoice& choice) {
    std::vector<std::string> all;
    for (const std::string& name : choice.beside.names)
        if (ends_as(name, ".cor", ".COR")) all.push_back(name);
    const std::string stem = choice.file_name.substr(0, choice.file_name.rfind('.'));
    for (const std::string& name : all)
        if (name.substr(0, name.rfind('.')) == stem) return name;
    return all.size() == 1 ? all.front() : std::string();
}

/// The cells of each line with content, without comments.
std::vector<std::vector<std::string>> cells_of_lines(std::string_view text) {
    std::vector<std::vector<std::string>> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        auto cells = blank_separated(comp3d_content(text.substr(0, end)));
        if (!cells.empty()) lines.push_back(std::move(cells));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

/// Whether a file of coordinates may be that of the observations: they name one of its points, or either of
/// them includes a further file that is there.
bool may_belong(const std::string& coordinates, const std::string& observations, const ReadChoice& choice) {
    const auto is_there = [&](const std::string& included) {
        return included.starts_with('@') && std::ranges::count(choice.beside.names, included.substr(1)) > 0;
    };
    std::set<std::string> points;
    for (const auto& cells : cells_of_lines(coordinates)) {
        if (is_there(cells[0])) return true;
        if (cells.size() > 1) points.insert(cells[1]);
    }
    for (const auto& cells : cells_of_lines(observations)) {
        if (is_there(cells[0])) return true;
        for (std::size_t i = 1; i < std::min<std::size_t>(3, cells.size()); ++i)
            if (points.contains(cells[i]) || (i == 2 && is_there(cells[i]))) return true;
    }
    return false;
}

class PairReader {
public:
    PairReader(Comp3dProject project, const ReadChoice& choice)
        : project_(std::move(project)), choice_(choice), files_(choice.beside, survey_, proposals_) {
        proposals_.title = plain_name(project_.name);
        if (proposals_.title.empty()) proposals_.title = without_ending(choice.file_name);
        if (proposals_.title.empty()) proposals_.title = "Network";
    }

    /// `coordinates` and `observations` are the texts; the file that is read has no name in remarks.
    Result<Proposals> read(const std::string& coordinates, const std::string& observations,
                           bool is_of_settings) {
        const std::string named = is_of_settings ? project_.observations : std::string();
        if (auto done = files_.read_points(coordinates, project_.coordinates); !done)
            return fail(done.error());
        if (auto done = files_.read_observations(observations, named); !done) return fail(done.error());
        if (choice_.length_unit)
            proposals_.leave_out(0, tell<"the stated unit of lengths: Comp3D has metres">());
        proposals_.found.push_back(
            tell<"observations of %1 with the coordinates of %2, in metres: x east, y north, z the height">(
                plain_name(project_.observations), plain_name(project_.coordinates)));
        if (auto done = take_angle_unit(); !done) return fail(done.error());
        Comp3dNetwork network(survey_, project_.settings, files_, proposals_);
        if (auto done = take_covariance(network); !done) return fail(done.error());
        if (project_.is_simulated) return without_network(coordinates, observations);
        const std::string source =
            "Comp3D, " + plain_name(project_.observations) + " and " + plain_name(project_.coordinates);
        if (network.propose(proposals_.title, source)) return std::move(proposals_);
        return without_network(coordinates, observations);
    }

private:
    Result<void> take_angle_unit() {
        const bool any = !survey_.subframes.empty() ||
                         std::ranges::any_of(survey_.observations, [](const Comp3dObservation& o) {
                             return o.code >= 5 && o.code <= 8;
                         });
        if (project_.has_angle_unit || !any) return {};
        const Unit unit = unstated_unit(choice_, "angles", "angles", Unit::of("gon"), proposals_);
        if (unit.dimension() != Unit::of("rad").dimension())
            return fail(ErrorCode::usage,
                        tell<"the unit of angles must be one of an angle: gon, deg, rad">());
        project_.settings.angle_unit = unit;
        return {};
    }

    Result<void> take_covariance(Comp3dNetwork& network) {
        if (project_.covariance.empty()) return {};
        const auto text = choice_.beside.read(project_.covariance);
        if (text) return network.take_covariance(*text, project_.covariance);
        files_.leave_out({project_.covariance, 0}, text.error().message);
        return {};
    }

    /// What is made where nothing is adjusted: quantities of the observations; without these, points.
    Result<Proposals> without_network(const std::string& coordinates, const std::string& observations) {
        ReadChoice alone = choice_;
        alone.file_name = survey_.has_observations() && !project_.is_simulated ? project_.observations
                                                                               : project_.coordinates;
        auto made = alone.file_name == project_.observations ? read_comp3d_quantities(observations, alone)
                                                             : read_comp3d_coordinates(coordinates, alone);
        if (!made) return made;
        if (project_.is_simulated)
            made->left_out.push_back(
                {0, tell<"a simulation: the values of its observations are none that were read">()});
        made->found.push_back(tell<"no network: the readings of the file would change none of its points">());
        if (alone.file_name == project_.coordinates)
            for (LeftOut& left : proposals_.left_out) made->leave_out(left.line, std::move(left.what));
        return made;
    }

    Comp3dProject project_;
    const ReadChoice& choice_;
    Comp3dSurvey survey_;
    Proposals proposals_;
    Comp3dSurveyReader files_;
};

Recognition recognise_obs(std::string_view, const std::string& file_name) {
    return ends_as(file_name, ".obs", ".OBS") ? Recognition::certain : Recognition::no;
}

Result<Proposals> read_obs(const std::string& text, const ReadChoice& choice) {
    std::string settings_name;
    std::optional<Comp3dProject> known;
    if (choice.beside.read) known = settings_beside(choice, settings_name);
    Comp3dProject project = known.value_or(Comp3dProject());
    project.observations = choice.file_name;
    if (project.coordinates.empty()) project.coordinates = coordinates_beside(choice);
    const auto coordinates = project.coordinates.empty()
                                 ? Result<std::string>(fail(ErrorCode::not_found, Message()))
                                 : choice.beside.read(project.coordinates);
    const bool is_named = known || project.coordinates.substr(0, project.coordinates.rfind('.')) ==
                                       choice.file_name.substr(0, choice.file_name.rfind('.'));
    if (!coordinates || (!is_named && !may_belong(*coordinates, text, choice))) {
        auto quantities = read_comp3d_quantities(text, choice);
        if (quantities)
            quantities->found.push_back(!coordinates && !project.coordinates.empty()
                                            ? tell<"no network: %1">(coordinates.error().message)
                                            : tell<"no network: there is no file of coordinates of the same "
                                                   "name (.cor) beside it, nor "
                                                   "a single one with its points">());
        return quantities;
    }
    auto read = PairReader(project, choice).read(*coordinates, text, false);
    if (!read) return read;
    read->found.push_back(known ? tell<"settings of the computation from %1">(plain_name(settings_name))
                                : tell<"no settings beside it (.comp): latitude 48.8°, refraction 0.12, as "
                                       "Comp3D has them at first">());
    return read;
}

Recognition recognise_comp(std::string_view beginning, const std::string& file_name) {
    return ends_as(file_name, ".comp", ".COMP") && is_comp3d_project(beginning) ? Recognition::certain
                                                                                : Recognition::no;
}

Result<Proposals> read_comp(const std::string& text, const ReadChoice& choice) {
    const auto project = comp3d_project(text);
    if (!project) return fail(project.error());
    if (project->coordinates.empty() || project->observations.empty())
        return refused_at(1, tell<"the settings name no files of coordinates and observations">());
    std::string texts[2];
    for (std::size_t i = 0; i < 2; ++i) {
        const std::string& name = i == 0 ? project->coordinates : project->observations;
        auto read = choice.beside.read
                        ? choice.beside.read(name)
                        : Result<std::string>(
                              fail(ErrorCode::usage, tell<"%1, which the settings name, must lie "
                                                          "beside them">(in_quotes(plain_name(name)))));
        if (!read) return refused_at(1, read.error().message);
        texts[i] = std::move(*read);
    }
    return PairReader(*project, choice).read(texts[0], texts[1], true);
}

}  // namespace

Reader comp3d_observations_reader() {
    return {.name = "comp3d-obs",
            .title = "Comp3D observations",
            .pattern = "*.obs",
            .takes =
                "distances, height differences, angles, coordinates in own frames, with the coordinates "
                "beside them (.cor) -> a network that is adjusted; without -> quantities of a measurement "
                "equation",
            .recognise = recognise_obs,
            .read = read_obs};
}

Reader comp3d_project_reader() {
    return {.name = "comp3d-comp",
            .title = "Comp3D settings",
            .pattern = "*.comp",
            .takes = "settings of a computation with the files that they name -> a network that is adjusted",
            .recognise = recognise_comp,
            .read = read_comp};
}

}  // namespace covaria
