#include "core/made/analysis_templates.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/base/guarded.h"
#include "core/base/resource_path.h"
#include "core/kinds/registries.h"
#include "core/made/load_project.h"
#include "core/project/entry_graph.h"
#include "core/project/linked_files.h"
#include "core/project/project_id.h"
#include "core/project/references.h"
#include "core/propagation/engine.h"

namespace covaria {

namespace {

using Ids = std::map<std::string, std::string>;  ///< id in the template -> id in the project

void refer_anew(const SetupSchema& schema, Setup& setup, const Ids& ids) {
    const auto anew = [&](std::string& id) {
        if (const auto found = ids.find(id); found != ids.end()) id = found->second;
    };
    for (const FieldSpec& field : schema.fields()) {
        const auto value = setup.values.find(field.key);
        if (value == setup.values.end()) continue;
        if (field.kind == FieldKind::reference) {
            if (auto* id = std::get_if<std::string>(&value->second)) anew(*id);
        } else if (auto* table = std::get_if<SetupTable>(&value->second)) {
            for (std::size_t column = 0; column < field.columns.size(); ++column)
                if (field.columns[column].kind == FieldKind::reference)
                    for (auto& row : table->rows)
                        if (column < row.size())
                            if (auto* id = std::get_if<std::string>(&row[column])) anew(*id);
        }
    }
}

/// Sort of an asset, for kinds of several sorts: a tracker is no camera.
std::string sort_of(const AssetEntry& asset) {
    const AssetDescriptor* kind = find_asset_kind(asset.kind);
    const FieldSpec* field = kind ? kind->schema.find("kind") : nullptr;
    const auto* sort = field ? std::get_if<std::string>(&value_of(*field, asset.setup)) : nullptr;
    return asset.kind + '/' + (sort ? *sort : std::string());
}

/// An asset of the project in the place of one of the template.
struct StandIn {
    std::string id;
    bool is_moved = false;  ///< it is put where the template's asset stands
};
using StandIns = std::map<std::string, StandIn>;  ///< by the template's asset

/// Fields that say where an asset stands: poses and what stands under one heading with them.
std::vector<const FieldSpec*> placing_fields(const SetupSchema& schema) {
    std::set<std::string> headings;
    for (const FieldSpec& field : schema.fields())
        if (field.kind == FieldKind::pose) headings.insert(field.section);
    std::vector<const FieldSpec*> placing;
    for (const FieldSpec& field : schema.fields())
        if (headings.contains(field.section)) placing.push_back(&field);
    return placing;
}

/// Whether the asset was given no place, as those from the library: nobody minds if it gets one.
bool stands_nowhere(const Project& project, const AssetEntry& asset) {
    const AssetDescriptor* kind = find_asset_kind(asset.kind);
    if (!kind) return false;
    bool has_pose = false;
    for (const FieldSpec& field : kind->schema.fields()) {
        if (field.kind != FieldKind::pose) continue;
        has_pose = true;
        if (value_of(field, asset.setup) != field.default_value) return false;
    }
    const EntryGraph graph(project);
    const auto itself = static_cast<std::size_t>(&asset - project.assets.data());
    for (std::size_t entry = 0; entry < graph.size(); ++entry)
        if (std::ranges::binary_search(graph.used_by(entry), itself)) return false;
    return has_pose;
}

void move_to(const AssetEntry& there, AssetEntry& own) {
    for (const FieldSpec* field : placing_fields(find_asset_kind(own.kind)->schema)) {
        const auto given = there.setup.values.find(field->key);
        if (given == there.setup.values.end())
            own.setup.values.erase(field->key);
        else
            own.setup.values[field->key] = given->second;
    }
}

class TemplateMerge {
public:
    TemplateMerge(const Project& project, const Project& part, StandIns stand_ins)
        : merged_(project), part_(part), stand_ins_(std::move(stand_ins)) {
        for (const AssetEntry& asset : project.assets) taken_.insert(asset.id);
        for (const AnalysisEntry& analysis : project.analyses) taken_.insert(analysis.id);
    }

    /// The project with the part's last analysis, and its id.
    std::pair<Project, std::string> merge() {
        const std::string id = add_analysis(part_.analyses.back());
        return {std::move(merged_), id};
    }

    /// Ids of the part's assets that are in it.
    std::set<std::string> merge_and_name_assets() {
        add_analysis(part_.analyses.back());
        std::set<std::string> named;
        for (const auto& [id, anew] : ids_)
            if (part_.find_asset(id)) named.insert(id);
        return named;
    }

private:
    std::string fresh(const std::string& wanted) {
        std::string id = free_id(wanted, [&](const std::string& known) { return taken_.contains(known); });
        taken_.insert(id);
        return id;
    }

    std::string name_for(const std::string& wanted) const {
        const auto known = [&](const std::string& name) {
            const auto same = [&](const auto& entry) { return entry.name == name; };
            return std::any_of(merged_.assets.begin(), merged_.assets.end(), same) ||
                   std::any_of(merged_.analyses.begin(), merged_.analyses.end(), same);
        };
        std::string name = wanted;
        for (int number = 2; known(name); ++number) name = wanted + " (" + std::to_string(number) + ')';
        return name;
    }

    /// Adds what a set-up refers to: an asset where there is one with the id, else an analysis.
    void add(const std::string& id) {
        if (ids_.contains(id)) return;
        if (const AssetEntry* asset = part_.find_asset(id))
            add_asset(*asset);
        else if (const AnalysisEntry* analysis = part_.find_analysis(id))
            ids_[id] = add_analysis(*analysis);
    }

    void add_asset(const AssetEntry& asset) {
        if (const auto own = stand_ins_.find(asset.id); own != stand_ins_.end()) {
            ids_[asset.id] = own->second.id;
            for (AssetEntry& entry : merged_.assets)
                if (own->second.is_moved && entry.id == own->second.id) move_to(asset, entry);
            return;
        }
        AssetEntry copy = asset;
        copy.id = ids_[asset.id] = fresh(asset.id);
        copy.name = name_for(asset.name);
        if (const AssetDescriptor* kind = find_asset_kind(asset.kind)) {
            for (const AssetReference& reference : references_of(kind->schema, asset.setup))
                add(reference.id);
            refer_anew(kind->schema, copy.setup, ids_);
        }
        merged_.assets.push_back(std::move(copy));
    }

    std::string add_analysis(const AnalysisEntry& analysis) {
        if (const auto known = analyses_.find(analysis.id); known != analyses_.end()) return known->second;
        AnalysisEntry copy = analysis;
        copy.id = analyses_[analysis.id] = fresh(analysis.id);
        copy.name = name_for(analysis.name);
        if (const ModelDescriptor* model = find_model(analysis.model)) {
            for (const AssetReference& reference : references_of(model->schema, analysis.setup))
                add(reference.id);
            refer_anew(model->schema, copy.setup, ids_);
        }
        for (InputLink& link : copy.links)
            if (const AnalysisEntry* source = part_.find_analysis(link.output.analysis))
                link.output.analysis = add_analysis(*source);
        merged_.analyses.push_back(copy);
        return copy.id;
    }

    Project merged_;
    const Project& part_;
    StandIns stand_ins_;
    Ids ids_;       ///< ids that set-ups refer to
    Ids analyses_;  ///< an asset may have the same id
    std::set<std::string> taken_;
};

bool has_value(const Project& project, const std::string& analysis, const MadeProject::Pointer& before) {
    const auto prepared = MadeProject::make(project, before)->analysis(analysis);
    if (!prepared) return false;
    const auto result =
        guarded([&] { return evaluate_first_order(*prepared->propagated, prepared->options); });
    return result && *result;
}

/// Search for the assets of the project that stand in for the template's: all of the same sort, one for one,
/// where the analysis then has a value; else one by one each with which it has one. Where none has one, one
/// stands there all the same: an analysis that uses another robot than the project's looks right and is not,
/// one that says what the project's robot lacks can be mended.
class StandInSearch {
public:
    StandInSearch(const Project& project, const Project& part)
        : project_(project), part_(part), made_(MadeProject::make(project)) {}

    StandIns find() {
        for (const AssetEntry& asset : part_.assets)
            for (const AssetEntry& own : project_.assets)
                if (is_free(own, asset)) {
                    chosen_[asset.id] = {own.id};
                    break;
                }
        if (chosen_.empty() || works(chosen_)) return chosen_;
        chosen_.clear();
        // Assets that refer to others come first: with them, those are not needed.
        for (auto asset = part_.assets.rbegin(); asset != part_.assets.rend(); ++asset) choose_for(*asset);
        for (auto asset = part_.assets.rbegin(); asset != part_.assets.rend(); ++asset)
            if (!chosen_.contains(asset->id) && comes_with_the_analysis(asset->id)) take_any_for(*asset);
        return chosen_;
    }

private:
    bool is_free(const AssetEntry& own, const AssetEntry& asset) const {
        return sort_of(own) == sort_of(asset) &&
               std::ranges::none_of(chosen_, [&](const auto& one) { return one.second.id == own.id; });
    }

    void choose_for(const AssetEntry& asset) {
        for (const AssetEntry& own : project_.assets) {
            if (!is_free(own, asset)) continue;
            for (const bool is_moved : {false, true}) {
                if (is_moved && !stands_nowhere(project_, own)) continue;
                StandIns with = chosen_;
                with[asset.id] = {own.id, is_moved};
                if (!works(with)) continue;
                chosen_ = std::move(with);
                return;
            }
        }
    }

    void take_any_for(const AssetEntry& asset) {
        for (const AssetEntry& own : project_.assets)
            if (is_free(own, asset)) {
                chosen_[asset.id] = {own.id};
                return;
            }
    }

    /// Whether the asset comes with the analysis; those that stand-ins refer to do not.
    bool comes_with_the_analysis(const std::string& id) const {
        return TemplateMerge(project_, part_, chosen_).merge_and_name_assets().contains(id);
    }

    bool works(const StandIns& stand_ins) const {
        const auto [merged, id] = TemplateMerge(project_, part_, stand_ins).merge();
        return has_value(merged, id, made_);
    }

    const Project& project_;
    const Project& part_;
    MadeProject::Pointer made_;
    StandIns chosen_;
};

/// Whether the project has the same ids, so that others would be needed where designs and studies name them.
bool has_same_ids(const Project& project, const Project& part) {
    const auto in_project = [&](const auto& entry) {
        return project.find_asset(entry.id) || project.find_analysis(entry.id);
    };
    return std::any_of(part.assets.begin(), part.assets.end(), in_project) ||
           std::any_of(part.analyses.begin(), part.analyses.end(), in_project);
}

}  // namespace

const std::vector<AnalysisTemplate>& analysis_templates() {
    using Topic = AnalysisTemplate::Topic;
    static const std::vector<AnalysisTemplate> templates{
        {Topic::equation, "Typed measurement equation",
         "The uncertainty of a quantity computed from others by an equation.", "gum/s1-9.3-mass", "mass"},
        {Topic::equation, "Gauge block by comparison",
         "The length of a gauge block compared with a standard of the same length.", "gum/h1-end-gauge",
         "statements"},
        {Topic::equation, "Two quantities from the same readings",
         "Resistance and reactance from simultaneous readings, with their correlation.", "gum/h2-impedance",
         "impedance"},
        {Topic::equation, "Calibration line of a thermometer",
         "The correction at any reading, from a line through calibration points.", "gum/h3-thermometer",
         "residuals"},
        {Topic::equation, "Observations on several days",
         "The mean of readings in groups, and whether the groups differ.", "gum/h5-zener", "days"},
        {Topic::pose, "Pose of a platform from a tracker",
         "Where a robot's flange or platform is, from nests measured by a laser tracker.", "tracker-pose",
         "tracker-alone"},
        {Topic::pose, "Pose from two instruments together",
         "The same pose measured by a tracker and a total station as one network.", "tracker-pose",
         "network"},
        {Topic::pose, "Pose from calibrated artefacts",
         "A pose whose point uncertainties come from measurements of artefacts.", "stewart-platform",
         "from-artefacts"},
        {Topic::points, "Points by cameras and a tracker",
         "Coordinates of targets that several instruments measure together.", "lsm-network", "paper"},
        {Topic::points, "Network with unknown stations",
         "Places of targets and of the instruments themselves, from readings to control points.",
         "levelled-network", "held"},
        {Topic::points, "Network method for a tracker",
         "What a tracker's readings are worth, from the same targets seen from several unknown places, and "
         "E_n against calibrated lengths.",
         "tracker-network", "tracker"},
        {Topic::points, "Geometry from points",
         "Planes, circles, axes and balls through measured points, with form deviations.", "robot-flange",
         "features"},
        {Topic::points, "Frame, distances and angles of features",
         "A frame as shops make it of a face, a bore and a hole, and where other features are from it.",
         "robot-flange", "frame"},
        {Topic::points, "Where do I put the station?",
         "The place of an instrument that makes the uncertainties smallest.", "lsm-network", "recommended",
         true},
        {Topic::robot, "Tool by ballbars",
         "A robot's tool centre point from rotations measured by telescopic ballbars.", "ballbar-tcp",
         "paper"},
        {Topic::robot, "Which points do I measure?",
         "The dozen of a plan of points that makes the uncertainty smallest.", "ballbar-design", "points",
         true},
        {Topic::robot, "Tool position of a robot",
         "Where the tool is, from joint readings and Denavit-Hartenberg parameters.", "er10l-c10",
         "zero-pose-nominal"},
        {Topic::robot, "Robot by joint trajectories",
         "Parameters of an arm from circles that its joints describe one by one.", "er10l-c10",
         "trajectories"},
        {Topic::robot, "Robot from measured poses",
         "Parameters of an arm from measured places of its flange.", "er10l-c10", "poses-measured"},
        {Topic::robot, "Robot from distances, planes and balls",
         "Parameters of an arm from what can be measured without poses.", "robot-readings", "distances"},
        {Topic::robot, "Hand-eye calibration",
         "Where a camera is on the flange, or a tracker beside the robot.", "eye-on-hand", "camera"},
        {Topic::equation, "Calibration of a force/moment sensor",
         "Errors and uncertainty of the channels of a multi-axis sensor.", "force-moment-sensor", "combined"},
        {Topic::equation, "Forces and moments from readings",
         "Loads from the readings of a multi-axis sensor by its calibration matrix.", "force-moment-sensor",
         "loads"},
        {Topic::equation, "Calibration of a force transducer",
         "Errors, interpolation, class and uncertainty of a transducer from three positions, after ISO 376.",
         "force-transducer", "calibration"},
        {Topic::points, "Distance meter on a baseline",
         "Zero offset and standard deviation of a distance meter, with the tests of ISO 17123-4.",
         "distance-meter", "zero-offset"},
        {Topic::points, "Theodolite in rounds",
         "Standard deviations of directions and zenith angles and the index error, with the tests of ISO "
         "17123-3.",
         "theodolite", "rounds"},
        {Topic::robot, "Accuracy and repeatability of a robot",
         "AP and RP of ISO 9283 from measured poses, and whether the maker's figures are met.",
         "robot-performance", "five-poses"},
        {Topic::points, "Acceptance test of a tracker",
         "Two-face and length tests against their limits, with the uncertainty of the test.", "tracker-test",
         "acceptance"},
        {Topic::equation, "History of an instrument",
         "Drift from as-found values, the component for its next use, its next calibration.",
         "gauge-block-history", "drift"}};
    return templates;
}

namespace {

/// A template with what its example says of it.
struct ReadTemplate {
    const AnalysisTemplate* known;
    std::string model;
    std::set<std::string> sorts;  ///< of the assets that it uses
};

/// Those that are not about studies and designs; their examples are read when they are first asked for.
const std::vector<ReadTemplate>& read_templates() {
    static const std::vector<ReadTemplate> all = [] {
        std::vector<ReadTemplate> read;
        for (const AnalysisTemplate& known : analysis_templates()) {
            const auto part = template_project(known);
            if (!part || known.with_designs) continue;
            ReadTemplate& one = read.emplace_back(ReadTemplate{&known, part->analyses.back().model, {}});
            for (const AssetEntry& used : part->assets) one.sorts.insert(sort_of(used));
        }
        return read;
    }();
    return all;
}

}  // namespace

const AnalysisTemplate* template_of(const std::string& model) {
    const auto found = std::ranges::find(read_templates(), model, &ReadTemplate::model);
    return found == read_templates().end() ? nullptr : found->known;
}

std::vector<const AnalysisTemplate*> templates_with(const AssetEntry& asset) {
    std::vector<const AnalysisTemplate*> with;
    for (const ReadTemplate& one : read_templates())
        if (one.sorts.contains(sort_of(asset))) with.push_back(one.known);
    return with;
}

Result<Project> template_project(const AnalysisTemplate& wanted, const DocumentLanguage& in) {
    const std::filesystem::path file = data_directory() / "projects" / (wanted.example + ".covaria");
    LoadedProject loaded = load_project(file);
    if (loaded.problems.has_errors())
        return fail(ErrorCode::io,
                    file.string() + ": " + first_error(loaded.problems, tell<"it cannot be read">()));
    const AnalysisEntry* analysis = loaded.project.find_analysis(wanted.analysis);
    if (!analysis)
        return fail(ErrorCode::not_found, tell<"%1 has no analysis \"%2\"">(file.string(), wanted.analysis));
    Project whole = loaded.project;
    whole.analyses.push_back(*analysis);  // last, which is what is merged
    const Project nothing;
    Project part = TemplateMerge(nothing, whole, {}).merge().first;
    unlink_tables(part);
    AnalysisEntry& last = part.analyses.back();
    last.name = in.say_declared(wanted.title);
    last.notes = in.say_declared(wanted.question);
    for (AnalysisEntry& entry : part.analyses) {
        if (&entry == &last && wanted.with_designs) continue;
        entry.studies.clear();
        entry.designs.clear();
    }
    return part;
}

Result<std::string> add_template(Project& project, const AnalysisTemplate& wanted,
                                 const DocumentLanguage& in) {
    auto part = template_project(wanted, in);
    if (!part) return fail(part.error());
    AnalysisEntry& last = part->analyses.back();
    if (wanted.with_designs && has_same_ids(project, *part)) {
        last.studies.clear();
        last.designs.clear();
    }
    const bool names_assets = !last.studies.empty() || !last.designs.empty();
    StandIns stand_ins = names_assets ? StandIns() : StandInSearch(project, *part).find();
    auto [merged, id] = TemplateMerge(project, *part, std::move(stand_ins)).merge();
    project = std::move(merged);
    return id;
}

}  // namespace covaria
