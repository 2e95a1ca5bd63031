#include "core/made/library.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "core/base/resource_path.h"
#include "core/kinds/registries.h"
#include "core/made/load_project.h"
#include "core/project/project_id.h"
#include "core/project/references.h"

namespace covaria {

namespace fs = std::filesystem;

namespace {

bool refers_to_others(const AssetEntry& asset) {
    const AssetDescriptor* kind = find_asset_kind(asset.kind);
    return kind && !references_of(kind->schema, asset.setup).empty();
}

void read_folder(const fs::path& folder, bool own, Library& library) {
    std::vector<fs::path> files;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
        if (entry.path().extension() == ".covaria") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
        const LoadedProject loaded = load_project(file);
        if (loaded.problems.has_errors()) {
            for (const Problem& problem : loaded.problems.items())
                if (problem.severity == Severity::error)
                    library.problems.error(problem.path, file.filename().string() + ": " + problem.message);
            continue;
        }
        for (const AssetEntry& asset : loaded.project.assets) {
            if (refers_to_others(asset)) continue;
            fs::path picture = folder / "pictures" / (asset.id + ".png");
            if (!fs::exists(picture, ignored)) picture.clear();
            library.items.push_back({asset, loaded.project.title, own, std::move(picture)});
        }
    }
}

std::string lowered(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

}  // namespace

bool has_words(const std::vector<std::string>& texts, const std::string& words) {
    std::string all;
    for (const std::string& text : texts) all += lowered(text) + '\n';
    std::istringstream wanted(lowered(words));
    for (std::string word; wanted >> word;)
        if (all.find(word) == std::string::npos) return false;
    return true;
}

std::vector<std::string> searched_texts(const LibraryItem& item) {
    const AssetDescriptor* kind = find_asset_kind(item.asset.kind);
    return {item.asset.id, item.asset.name, item.collection, item.asset.notes,
            kind ? kind->title : std::string()};
}

fs::path own_library_folder() {
    if (const char* set = std::getenv("COVARIA_LIBRARY_DIR")) return set;
    if (const char* data = std::getenv("XDG_DATA_HOME"); data && *data)
        return fs::path(data) / "covaria/library";
    const char* home = std::getenv("HOME");
    return fs::path(home ? home : ".") / ".local/share/covaria/library";
}

Library load_library() {
    Library library;
    read_folder(data_directory() / "resources/library", false, library);
    read_folder(own_library_folder(), true, library);
    return library;
}

Result<void> add_to_own_library(const AssetEntry& asset) {
    if (refers_to_others(asset))
        return fail(ErrorCode::bad_input,
                    tell<"%1 refers to other assets of the project and cannot be kept alone">(asset.name));
    const fs::path file = own_library_folder() / "my-library.covaria";
    Project project;
    project.title = "My library";
    std::error_code problem;
    if (fs::exists(file, problem)) {
        LoadedProject loaded = load_project(file);
        if (loaded.problems.has_errors())
            return fail(ErrorCode::bad_input,
                        tell<"%1 has errors; open it and repair it before adding to it">(file.string()));
        project = std::move(loaded.project);
    }
    std::erase_if(project.assets, [&](const AssetEntry& known) {
        return known.kind == asset.kind && known.name == asset.name;
    });
    AssetEntry added = asset;
    added.id = free_id(asset.id, [&](const std::string& id) { return project.find_asset(id) != nullptr; });
    project.assets.push_back(std::move(added));
    fs::create_directories(file.parent_path(), problem);
    return save_project(project, file);
}

}  // namespace covaria
