// The canonical text of a project, and its fingerprint.
#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/project/amendment_fields.h"
#include "core/project/analysis_fields.h"
#include "core/project/asides.h"
#include "core/project/asset_certificate_fields.h"
#include "core/project/certificate_json.h"
#include "core/project/json_writer.h"
#include "core/project/kind_lookup.h"
#include "core/project/project_file.h"
#include "core/project/project_results_json.h"
#include "core/project/project_text.h"
#include "core/project/report_contents_fields.h"
#include "core/project/review_fields.h"
#include "core/project/setup_json.h"

namespace covaria {

namespace {

void member_if_given(JsonWriter& out, const char* key, const std::string& text) {
    if (!text.empty()) out.member(key, text);
}

template <class Entry>
void write_setup_of(JsonWriter& out, const Entry& entry) {
    out.key("setup");
    const SetupSchema* schema = schema_of(entry);
    write_setup(out, entry.setup, schema ? *schema : SetupSchema{});
}

void write_asset(JsonWriter& out, const AssetEntry& asset) {
    out.begin_object();
    out.member("id", asset.id);
    out.member("kind", asset.kind);
    member_if_given(out, "name", asset.name);
    member_if_given(out, "notes", asset.notes);
    write_setup_of(out, asset);
    if (!asset.certificates.empty()) {
        out.key("certificates");
        ListOf{asset_certificate_fields()}.write(out, asset.certificates);
    }
    out.end();
}

void write_analysis(JsonWriter& out, const AnalysisEntry& analysis) {
    out.begin_object();
    out.member("id", analysis.id);
    out.member("model", analysis.model);
    member_if_given(out, "name", analysis.name);
    member_if_given(out, "notes", analysis.notes);
    write_setup_of(out, analysis);
    analysis_fields().write_members(out, analysis, {});
    out.end();
}

void write_entries(JsonWriter& out, const Project& project) {
    out.key("assets");
    out.begin_list();
    for (const AssetEntry& asset : project.assets) write_asset(out, asset);
    out.end();
    out.key("analyses");
    out.begin_list();
    for (const AnalysisEntry& analysis : project.analyses) write_analysis(out, analysis);
    out.end();
}

void write_results_of(JsonWriter& out, const Project& project) {
    if (project.results.empty()) return;
    out.key("results");
    write_project_results(out, project.results);
}

void write_kept(JsonWriter& out, const KeptState& state) {
    out.begin_object();
    out.member("analysis", state.analysis);
    out.member("at", state.at);
    if (!state.other.empty()) {
        out.member("other", state.other);
        out.member("otherName", state.other_name);
    }
    write_results_of(out, *state.project);
    write_entries(out, *state.project);
    out.end();
}

// Takes away the parts that have no influence on numbers, and puts CSV rows in place of the file's name.
void keep_numbers(Setup& setup) {
    for (auto& [key, value] : setup.values)
        if (SetupTable* table = std::get_if<SetupTable>(&value)) {
            table->csv_file.clear();
            table->csv_columns.clear();
        }
}

Project numbers_only(Project project) {
    for (AnalysisEntry& analysis : project.analyses) analysis.options = effective_options(project, analysis);
    project.title = project.notes = project.author = project.number = {};
    project.review = {};
    project.certificate = {};
    project.amendment = {};
    project.report = {};
    project.results = {};
    project.kept.clear();
    std::ranges::sort(project.assets, {}, &AssetEntry::id);
    for (AssetEntry& asset : project.assets) {
        take_asides(asset, {});
        keep_numbers(asset.setup);
    }
    for (AnalysisEntry& analysis : project.analyses) {
        take_asides(analysis, {});
        for (Study& study : analysis.studies) study.name.clear();
        keep_numbers(analysis.setup);
        for (InputEdit& edit : analysis.inputs) {
            if (!edit.components) continue;
            for (ComponentEdit& component : *edit.components) component.name = component.origin = {};
        }
    }
    return project;
}

// The hash is FNV-1a, 64 bit (Fowler, Noll, Vo).
std::uint64_t hash_of(const std::string& text) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return hash;
}

}  // namespace

WrittenProject write_project(const Project& project) {
    JsonWriter out;
    out.begin_object();
    out.member("format", "covaria");
    out.key("schemaVersion");
    out.integer(project_schema_version);
    out.member("title", project.title);
    member_if_given(out, "notes", project.notes);
    member_if_given(out, "author", project.author);
    member_if_given(out, "number", project.number);
    if (!project.review.empty()) {
        out.key("review");
        review_fields().write(out, project.review);
    }
    if (!project.certificate.empty()) {
        out.key("certificate");
        write_certificate(out, project.certificate);
    }
    if (!project.amendment.empty()) {
        out.key("amendment");
        amendment_fields().write(out, project.amendment);
    }
    if (!project.report.empty()) {
        out.key("report");
        report_contents_fields().write(out, project.report);
    }
    write_results_of(out, project);
    write_entries(out, project);
    if (!project.kept.empty()) {
        out.key("kept");
        out.begin_list();
        for (const KeptState& state : project.kept) write_kept(out, state);
        out.end();
    }
    out.end();
    return {out.take(), !out.has_unwritable()};
}

std::string project_text(const Project& project) {
    return write_project(project).text;
}

std::string fingerprint(Project project) {
    std::uint64_t hash = hash_of(project_text(numbers_only(std::move(project))));
    std::string digits(16, '0');
    for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit, hash >>= 4)
        *digit = "0123456789abcdef"[hash & 0xf];
    return digits;
}

bool same_numbers(Project a, Project b) {
    return numbers_only(std::move(a)) == numbers_only(std::move(b));
}

}  // namespace covaria
