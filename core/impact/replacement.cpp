#include "core/impact/replacement.h"

#include <algorithm>

#include "core/base/file_io.h"
#include "core/base/in_quotes.h"
#include "core/carried/carried_project.h"
#include "core/made/import_reading.h"
#include "core/project/kind_lookup.h"
#include "core/project/linked_files.h"
#include "core/readers/readers.h"

namespace covaria {

namespace {

namespace fs = std::filesystem;

template <class Entry>
void find_certificates(const std::vector<Entry>& entries, bool are_assets, const std::string& called,
                       std::vector<CertificateHolder>& holders) {
    for (std::size_t i = 0; i < entries.size(); ++i)
        for (std::size_t k = 0; k < entries[i].certificates.size(); ++k)
            if (is_called(entries[i].certificates[k], called)) holders.push_back({are_assets, i, k});
}

const std::string& id_of_kind(const AssetEntry& asset) {
    return asset.kind;
}
const std::string& id_of_kind(const AnalysisEntry& analysis) {
    return analysis.model;
}
const std::string& shown(const std::string& name, const std::string& id) {
    return name.empty() ? id : name;
}

/// The one of the others that can stand for the entry.
template <class Entry>
Result<const Entry*> counterpart(const Entry& entry, const std::vector<Entry>& others,
                                 const NewFigures& figures) {
    std::vector<const Entry*> fitting;
    for (const Entry& other : others) {
        if (id_of_kind(other) != id_of_kind(entry)) continue;
        if (other.id == entry.id) return &other;
        fitting.push_back(&other);
    }
    const std::string name = in_quotes(shown(entry.name, entry.id));
    if (fitting.empty())
        return fail(
            ErrorCode::not_found,
            tell<"%1 has no new figures for %2: nothing in it is of the same kind">(figures.source, name));
    if (fitting.size() > 1)
        return fail(
            ErrorCode::not_found,
            tell<"%1 has several figures that %2 could have: name the one behind '#'">(figures.source, name));
    return fitting.front();
}

/// Puts the new certificates in the place of the one that is replaced.
void replace_certificate(std::vector<AssetCertificate>& certificates, std::size_t place,
                         std::vector<AssetCertificate> others) {
    if (place != CertificateHolder::npos) {
        for (AssetCertificate& other : others) other.quantities = certificates[place].quantities;
        certificates.erase(certificates.begin() + static_cast<std::ptrdiff_t>(place));
    } else {
        certificates.clear();
        place = 0;
    }
    certificates.insert(certificates.begin() + static_cast<std::ptrdiff_t>(place), others.begin(),
                        others.end());
}

const std::string* symbol_in(const std::vector<SetupCell>& row, std::size_t column) {
    return column < row.size() ? std::get_if<std::string>(&row[column]) : nullptr;
}

/// Rows of a table that state quantities; the rows of these symbols are taken from the other table.
class StatedRows {
public:
    StatedRows(const FieldSpec& field, const std::vector<std::string>& symbols)
        : column_(SetupSchema::column(field, "symbol")), symbols_(symbols) {}

    /// The table with the other's rows. Both must be in the same units: another unit of a column would change
    /// the rows that stay.
    Result<SetupTable> replaced(const SetupTable& old, const SetupTable& with) const {
        if (old.units != with.units)
            return fail(ErrorCode::bad_input, tell<"the tables of quantities have other units">());
        SetupTable made = old;
        made.rows.clear();
        made.csv_file.clear();
        made.csv_columns.clear();
        std::vector<std::string> taken;
        for (const auto& row : old.rows) {
            const std::string* symbol = symbol_in(row, column_);
            if (!symbol || !is_meant(*symbol)) {
                made.rows.push_back(row);
                continue;
            }
            if (std::find(taken.begin(), taken.end(), *symbol) != taken.end()) continue;
            taken.push_back(*symbol);
            const std::size_t before = made.rows.size();
            for (const auto& other : with.rows)
                if (const std::string* name = symbol_in(other, column_); name && *name == *symbol)
                    made.rows.push_back(other);
            if (made.rows.size() == before)
                return fail(ErrorCode::not_found,
                            tell<"the new figures say nothing of the quantity %1">(in_quotes(*symbol)));
        }
        if (taken.empty())
            return fail(ErrorCode::not_found, tell<"none of the quantities of the certificate is stated">());
        return made;
    }

private:
    bool is_meant(const std::string& symbol) const {
        return symbols_.empty() || std::find(symbols_.begin(), symbols_.end(), symbol) != symbols_.end();
    }
    std::size_t column_;
    const std::vector<std::string>& symbols_;
};

/// Gives the field its old value; a field that was left out is left out again.
void keep(Setup& made, const Setup& old, const std::string& key) {
    const auto value = old.values.find(key);
    if (value == old.values.end())
        made.values.erase(key);
    else
        made.values[key] = value->second;
}

/// Poses say where an item stands in this project, which no certificate of it knows.
void keep_places(Setup& made, const AssetEntry& asset) {
    const SetupSchema* schema = schema_of(asset);
    if (!schema) return;
    for (const FieldSpec& field : schema->fields()) {
        if (field.kind != FieldKind::pose) continue;
        keep(made, asset.setup, field.key);
        if (field.photogrammetric_if) keep(made, asset.setup, field.photogrammetric_if->key);
    }
}

Result<void> replace_figures(AssetEntry& asset, std::size_t certificate, const NewFigures& figures) {
    const auto other = counterpart(asset, figures.assets, figures);
    if (!other) return fail(other.error());
    Setup setup = (*other)->setup;
    keep_places(setup, asset);
    asset.setup = std::move(setup);
    replace_certificate(asset.certificates, certificate, (*other)->certificates);
    return {};
}

Result<void> replace_figures(AnalysisEntry& analysis, std::size_t certificate, const NewFigures& figures) {
    const auto other = counterpart(analysis, figures.analyses, figures);
    if (!other) return fail(other.error());
    const SetupSchema* schema = schema_of(analysis);
    const FieldSpec* field = schema ? schema->find(&FieldSpec::states_quantities) : nullptr;
    const auto table_of = [&](const AnalysisEntry& entry) {
        const auto value = field ? entry.setup.values.find(field->key) : entry.setup.values.end();
        return value == entry.setup.values.end() ? nullptr : std::get_if<SetupTable>(&value->second);
    };
    const SetupTable *old = table_of(analysis), *with = table_of(**other);
    if (!old || !with)
        return fail(ErrorCode::not_found,
                    tell<"%1 states no quantities in a table">(in_quotes(shown(analysis.name, analysis.id))));
    const std::vector<std::string> symbols = analysis.certificates[certificate].quantities;
    auto rows = StatedRows(*field, symbols).replaced(*old, *with);
    if (!rows) return fail(rows.error());
    analysis.setup.values[field->key] = *std::move(rows);
    std::vector<AssetCertificate> others = (*other)->certificates;
    replace_certificate(analysis.certificates, certificate, std::move(others));
    return {};
}

/// The figures of a file. Errors of the project that it makes are said when its figures are used.
Result<NewFigures> figures_of(LoadedProject loaded, const std::string& file) {
    if (!loaded.made)
        return fail(ErrorCode::bad_input,
                    tell<"%1: %2">(file, first_error(loaded.problems, tell<"it is no project">())));
    unlink_tables(loaded.project);
    return NewFigures{file, std::move(loaded.project.assets), std::move(loaded.project.analyses)};
}

Result<NewFigures> read_by_reader(const std::string& bytes, const std::string& file) {
    const std::string name = fs::path(file).filename().string();
    const auto reader = reader_for(bytes, name);
    if (!reader) return fail(reader.error().code, tell<"%1: %2">(file, reader.error().message));
    auto proposals = read_proposals(**reader, bytes, {.file_name = name});
    if (!proposals) return fail(ErrorCode::bad_input, tell<"%1: %2">(file, proposals.error().message));
    return NewFigures{file, std::move(proposals->assets), std::move(proposals->analyses)};
}

Result<NewFigures> read_figures(const std::string& file) {
    const auto bytes = read_file(file);
    if (!bytes) return fail(bytes.error());
    if (is_pdf(*bytes)) return figures_of(load_carried(file), file);
    if (fs::path(file).extension() == ".covaria") return figures_of(load_project(file), file);
    return read_by_reader(*bytes, file);
}

}  // namespace

std::vector<CertificateHolder> holders_of(const Project& project, const std::string& called) {
    std::vector<CertificateHolder> holders;
    find_certificates(project.assets, true, called, holders);
    find_certificates(project.analyses, false, called, holders);
    if (!holders.empty() || called.empty()) return holders;
    for (std::size_t i = 0; i < project.assets.size(); ++i)
        if (project.assets[i].id == called || project.assets[i].name == called)
            holders.push_back({true, i, CertificateHolder::npos});
    return holders;
}

Result<NewFigures> new_figures(const std::string& file_and_id) {
    std::error_code failure;
    const std::size_t mark = file_and_id.rfind('#');
    if (mark == std::string::npos || fs::exists(file_and_id, failure)) return read_figures(file_and_id);
    auto figures = read_figures(file_and_id.substr(0, mark));
    if (!figures) return figures;
    const std::string id = file_and_id.substr(mark + 1);
    std::erase_if(figures->assets, [&](const AssetEntry& asset) { return asset.id != id; });
    std::erase_if(figures->analyses, [&](const AnalysisEntry& analysis) { return analysis.id != id; });
    if (figures->assets.empty() && figures->analyses.empty())
        return fail(ErrorCode::not_found,
                    tell<"%1 has nothing with the id %2">(figures->source, in_quotes(id)));
    return figures;
}

Result<Project> with_new_figures(Project project, const std::vector<CertificateHolder>& holders,
                                 const NewFigures& figures) {
    // The certificates of an entry are replaced from the last to the first, so that their places stay.
    for (auto holder = holders.rbegin(); holder != holders.rend(); ++holder) {
        const auto done =
            holder->is_asset ? replace_figures(project.assets[holder->entry], holder->certificate, figures)
                             : replace_figures(project.analyses[holder->entry], holder->certificate, figures);
        if (!done) return fail(done.error());
    }
    return project;
}

}  // namespace covaria
