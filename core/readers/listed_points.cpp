#include "core/readers/listed_points.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/base/in_quotes.h"
#include "core/base/text_places.h"
#include "core/project/project_id.h"
#include "core/readers/entry_texts.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

constexpr const char* artefact_kind = "artefact-points";
constexpr std::array<const char*, 3> axis_names{"x", "y", "z"};
constexpr std::size_t most_groups = 100;

Message counted_points(std::size_t n) {
    return n == 1 ? tell<"1 point">() : tell<"%1 points">(n);
}

/// Gives points with the same name numbers, and says so: names are unique in an artefact.
void name_apart(std::vector<ListedPoint>& points, Proposals& proposals) {
    std::set<std::pair<std::string, std::string>> taken;
    std::map<std::pair<std::string, std::string>, int> last;
    std::size_t again = 0;
    Message example;
    for (ListedPoint& point : points) {
        point.name = plain_name(point.name);
        if (point.name.empty()) point.name = "line " + std::to_string(point.line);
        std::string name = point.name;
        int& n = last.try_emplace({point.group, point.name}, 1).first->second;
        while (!taken.insert({point.group, name}).second)
            name = point.name + " (" + std::to_string(++n) + ")";
        if (name == point.name) continue;
        if (again++ == 0) example = tell<"%1 in line %2">(in_quotes(name), point.line);
        point.name = name;
    }
    if (again > 0)
        proposals.found.push_back(
            again == 1 ? tell<"1 name occurs again and has got a number: first %1">(example)
                       : tell<"%1 names occur again and have got a number: first %2">(again, example));
}

/// Joins groups where there are too many of them, which are then told apart by the names of their points.
void join_groups(PointList& list, Proposals& proposals) {
    std::set<std::string> groups;
    for (ListedPoint& point : list.points) groups.insert(point.group = plain_name(point.group));
    if (groups.size() <= most_groups) return;
    for (ListedPoint& point : list.points) {
        if (!point.group.empty()) point.name = point.group + "/" + point.name;
        point.group.clear();
    }
    proposals.found.push_back(
        tell<"%1 groups in one artefact: their names stand before those of the points">(groups.size()));
}

struct GroupFigures {
    std::array<double, 3> largest{};
    std::size_t stated = 0, points = 0;
    bool differ = false;
};

GroupFigures figures_of(const std::vector<const ListedPoint*>& points) {
    GroupFigures figures;
    figures.points = points.size();
    for (const ListedPoint* point : points) {
        if (point->u[0] || point->u[1] || point->u[2]) ++figures.stated;
        figures.differ = figures.differ || point->u != points.front()->u;
        for (std::size_t i = 0; i < 3; ++i)
            figures.largest[i] = std::max(figures.largest[i], point->u[i].value_or(0.0));
    }
    return figures;
}

Message words_of(const GroupFigures& figures, const Unit& unit) {
    if (figures.stated == 0) return tell<"no uncertainties are stated: u_cal is 0 until you state it">();
    std::string u_cal;
    for (std::size_t i = 0; i < 3; ++i)
        u_cal += (i > 0 ? ", " : "") + std::string(axis_names[i]) + " " + readable_number(figures.largest[i]);
    u_cal += " " + unit.display();
    Message words = figures.differ
                        ? tell<"u_cal is the largest of the stated standard uncertainties: %1">(u_cal)
                        : tell<"u_cal as stated: %1">(u_cal);
    if (figures.stated < figures.points)
        words += "; " + tell<"%1 without a stated one">(counted_points(figures.points - figures.stated));
    return words;
}

void propose_artefact(const PointList& list, const std::string& group,
                      const std::vector<const ListedPoint*>& points, Proposals& proposals) {
    TableRows rows(table_of(artefact_kind, "points")), components(table_of(artefact_kind, "components"));
    for (const char* column : axis_names) rows.set_unit(column, list.unit);
    for (const char* column : {"u_cal", "u_T", "u_var", "b"}) components.set_unit(column, list.unit);
    for (const ListedPoint* point : points)
        rows.add({{"name", point->name}, {"x", point->p[0]}, {"y", point->p[1]}, {"z", point->p[2]}});
    const GroupFigures figures = figures_of(points);
    for (std::size_t i = 0; i < 3; ++i)
        components.add({{"coordinate", std::string(axis_names[i])},
                        {"u_cal", figures.largest[i]},
                        {"u_T", 0.0},
                        {"u_var", 0.0},
                        {"b", 0.0}});
    AssetEntry asset{.kind = artefact_kind, .name = group.empty() ? list.title : group};
    asset.id = free_id(id_of(asset.name, "points"), [&](const std::string& id) {
        return std::any_of(proposals.assets.begin(), proposals.assets.end(),
                           [&](const AssetEntry& other) { return other.id == id; });
    });
    asset.notes = "From " + list.source + ". " + words_of(figures, list.unit).english() +
                  ". u_T, u_var and b are 0: nothing is known of temperature and of measurements of it.";
    asset.setup.values["points"] = rows.table();
    asset.setup.values["evaluation"] = std::string("components");
    asset.setup.values["components"] = components.table();
    proposals.found.push_back(in_quotes(asset.name) + ": " + counted_points(points.size()) + "; " +
                              words_of(figures, list.unit));
    proposals.assets.push_back(std::move(asset));
}

void propose_figures(const PointList& list, Proposals& proposals) {
    if (3 * list.points.size() > most_stated_quantities)
        return proposals.leave_out(
            0, tell<"the uncertainty of each point by itself, and correlations: only up to %1 have an "
                    "analysis of their own">(counted_points(most_stated_quantities / 3)));
    std::vector<StatedQuantity> quantities;
    for (std::size_t i = 0; i < list.points.size(); ++i)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const ListedPoint& point = list.points[i];
            StatedQuantity q{.symbol = std::string(axis_names[axis]) + "_" + std::to_string(i + 1),
                             .name = point.name + ", " + axis_names[axis],
                             .value = point.p[axis],
                             .unit = list.unit};
            q.group = point.group.empty() ? point.name : point.group + "/" + point.name;
            if (point.u[axis]) {
                q.statement = "standard";
                q.a = point.u[axis];
            }
            quantities.push_back(std::move(q));
        }
    std::vector<StatedCorrelation> correlations;
    for (const PointCorrelation& c : list.correlations)
        correlations.push_back({c.first, c.second, c.coefficient});
    proposals.analyses.push_back(analysis_of(
        "points", "Points as stated", "From " + list.source + ": every coordinate with its own uncertainty.",
        quantities, correlations));
    proposals.found.push_back(
        tell<"analysis 'Points as stated': every coordinate with its own uncertainty%1">(
            correlations.empty()       ? Message()
            : correlations.size() == 1 ? tell<" and 1 correlation coefficient">()
                                       : tell<" and %1 correlation coefficients">(correlations.size())));
}

}  // namespace

Result<void> propose_points(PointList list, Proposals& proposals) {
    if (list.points.empty()) return fail(ErrorCode::bad_input, tell<"the file has no points">());
    join_groups(list, proposals);
    name_apart(list.points, proposals);
    std::vector<std::string> order;
    std::map<std::string, std::vector<const ListedPoint*>> groups;
    for (const ListedPoint& point : list.points) {
        auto& group = groups[point.group];
        if (group.empty()) order.push_back(point.group);
        group.push_back(&point);
    }
    bool differ = !list.correlations.empty();
    for (const std::string& group : order) {
        propose_artefact(list, group, groups[group], proposals);
        differ = differ || figures_of(groups[group]).differ;
    }
    if (differ) propose_figures(list, proposals);
    return {};
}

}  // namespace covaria
