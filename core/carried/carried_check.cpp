#include "core/carried/carried_check.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/carried/report_data.h"
#include "core/project/csv_reader.h"
#include "core/readers/entry_texts.h"

namespace covaria {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_differences = 20;

const AttachedFile* find_file(const std::vector<AttachedFile>& files, const std::string& name) {
    for (const AttachedFile& file : files)
        if (file.name == name) return &file;
    return nullptr;
}

/// JSON without what is nested deeper than results ever are.
Json parsed(const std::string& text) {
    const auto keep = [](int depth, Json::parse_event_t, Json&) { return depth <= 20; };
    return Json::parse(text, keep, false);
}

std::string text_at(const Json& json, const char* key) {
    return json.is_object() && json.contains(key) && json[key].is_string() ? json[key].get<std::string>()
                                                                           : "";
}

const Json& list_in(const Json& json, const char* key) {
    static const Json none = Json::array();
    return json.is_object() && json.contains(key) && json[key].is_array() ? json[key] : none;
}

/// Values that fit into a line.
std::string words_of(const Json& value) {
    std::string words = value.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (words.size() > 40) words = words.substr(0, 37) + "...";
    return plain_name(words);
}

class Comparer {
public:
    void different(const std::string& what) {
        if (comparison.differences.size() < most_differences)
            comparison.differences.push_back(plain_line(what));
        else
            ++comparison.beyond;
    }

    void results(Json then, Json now) {
        for (Json* one : {&then, &now})
            if (one->is_object() && one->contains("project")) (*one)["project"].erase("covariaVersion");
        entries(then, now, "analyses", "analysis",
                [this](const Json& a, const Json& b, const std::string& at) { analysis(a, b, at); });
        for (Json* one : {&then, &now})
            if (one->is_object()) one->erase("analyses");
        values(then, now, "results.json");
    }

    void tables(const std::string& name, const std::string& then, const std::string& now) {
        const auto a = read_csv(then, ','), b = read_csv(now, ',');
        if (!a || !b || a->rows.size() != b->rows.size() || a->rows.empty())
            return different(name + ": it has other rows");
        const auto& heads = b->rows.front().cells;
        for (std::size_t row = 0; row < a->rows.size(); ++row) {
            const auto &old_row = a->rows[row].cells, &new_row = b->rows[row].cells;
            if (old_row.size() != new_row.size()) return different(name + ": it has other columns");
            for (std::size_t c = 0; c < new_row.size(); ++c)
                if (old_row[c] != new_row[c])
                    different(name + ", line " + std::to_string(row + 1) + ", column " +
                              (c < heads.size() ? heads[c] : std::to_string(c + 1)) + ": " + old_row[c] +
                              " is " + new_row[c] + " now");
        }
    }

    Comparison comparison;

private:
    /// Lists of objects with an id or a symbol and a group, pair by pair.
    template <class Each>
    void entries(const Json& then, const Json& now, const char* key, const std::string& what,
                 const Each& each) {
        const Json &a = list_in(then, key), &b = list_in(now, key);
        for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
            const Json& named = i < a.size() ? a[i] : b[i];
            std::string name = what + " " + text_at(named, "id") + text_at(named, "symbol");
            if (const std::string group = text_at(named, "group"); !group.empty()) name += " (" + group + ")";
            if (i >= a.size())
                different(name + " was not there");
            else if (i >= b.size())
                different(name + " is no longer there");
            else
                each(a[i], b[i], name);
        }
    }

    void analysis(Json then, Json now, const std::string& at) {
        entries(then, now, "outputs", at + ", output",
                [this](const Json& a, const Json& b, const std::string& name) { values(a, b, name); });
        for (Json* one : {&then, &now})
            if (one->is_object()) one->erase("outputs");
        // A report of an earlier version does not have these, and nothing of it differs for that.
        for (const char* key : {"figures", "decisions"})
            if (then.is_object() && now.is_object() && !then.contains(key)) now.erase(key);
        values(then, now, at);
    }

    /// Compares two values by keys and places down to the numbers.
    void values(const Json& then, const Json& now, const std::string& at) {
        if (then == now) return;
        if (then.is_object() && now.is_object()) {
            for (const auto& [key, value] : then.items())
                if (now.contains(key))
                    values(value, now[key], at + ", " + key);
                else
                    different(at + ", " + key + " is no longer there");
            for (const auto& [key, value] : now.items())
                if (!then.contains(key)) different(at + ", " + key + " was not there");
        } else if (then.is_array() && now.is_array() && then.size() == now.size()) {
            for (std::size_t i = 0; i < then.size(); ++i)
                values(then[i], now[i], at + ", " + std::to_string(i + 1));
        } else {
            different(at + ": " + words_of(then) + " is " + words_of(now) + " now");
        }
    }
};

/// Whether a file is a result, made by this program or another version: results.json about the run is none.
bool is_result(const AttachedFile& file) {
    return file.as == AttachedAs::data && file.name != carried::results;
}

}  // namespace

Result<CarriedResults> carried_results(const std::vector<AttachedFile>& files) {
    const AttachedFile* file = find_file(files, carried::results);
    if (!file)
        return fail(ErrorCode::bad_input,
                    tell<"the report carries no results to compare with (results.json)">());
    const Json json = parsed(file->bytes);
    if (!json.is_object() || text_at(json, "format") != "covaria-results")
        return fail(ErrorCode::bad_input,
                    tell<"what the report carries as results.json is none of Covaria">());
    CarriedResults results{json.contains("project") ? text_at(json["project"], "covariaVersion") : "", {}};
    const auto add = [&](const std::string& id) {
        auto& ids = results.analyses;
        if (!id.empty() && std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
    };
    for (const Json& one : list_in(json, "analyses")) {
        add(text_at(one, "id"));
        for (const Json& study : list_in(one, "studies"))
            results.studies.emplace(text_at(one, "id"), text_at(study, "id"));
    }
    for (const Json& one : list_in(json, "failed")) {
        const std::string study = text_at(one, "study");
        if (study.empty())
            add(text_at(one, "analysis"));
        else
            results.studies.emplace(text_at(one, "analysis"), study);
    }
    return results;
}

Comparison compare_carried(const std::vector<AttachedFile>& then, const std::vector<AttachedFile>& now) {
    Comparer comparer;
    const AttachedFile *a = find_file(then, carried::results), *b = find_file(now, carried::results);
    if (!a || !b)
        comparer.different("results.json is not there");
    else if (a->bytes != b->bytes)
        comparer.results(parsed(a->bytes), parsed(b->bytes));
    for (const AttachedFile& file : now) {
        if (!is_result(file)) continue;
        const AttachedFile* before = find_file(then, file.name);
        if (!before)
            comparer.different(file.name + " was not there");
        else if (before->bytes != file.bytes)
            comparer.tables(file.name, before->bytes, file.bytes);
    }
    return comparer.comparison;
}

}  // namespace covaria
