// Assets: artefacts, instruments, robots, point sets. Defined once in a project, used by many analyses.
//
// A model asks an asset for a capability (an interface, core/model/capability.h), never for its kind.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/model/capability.h"
#include "core/model/layout.h"
#include "core/setup/setup_schema.h"
#include "core/text/plot_specification.h"
#include "core/text/table.h"

namespace covaria {

class AssetLibrary;

/// Made from a checked set-up; immutable.
class Asset {
public:
    Asset() = default;
    Asset(const Asset&) = delete;
    Asset& operator=(const Asset&) = delete;
    virtual ~Asset() = default;
    const std::vector<const Capability*>& capabilities() const { return capabilities_; }
    /// The asset's own evaluation as tables (budget of calibration, temperature, variability, bias;
    /// observations ...).
    virtual std::vector<Table> evaluation() const { return {}; }
    /// The same as charts; ids are unique in the asset.
    virtual std::vector<PlotSpecification> figures() const { return {}; }
    /// Layout to draw when the asset itself is looked at.
    virtual Layout layout() const { return {}; }

protected:
    /// Said in the constructor, of the asset itself or of a member.
    void offer(const Capability& capability) { capabilities_.push_back(&capability); }

private:
    std::vector<const Capability*> capabilities_;
};

/// The asset as a C (SensorSource ...); null if there is no asset or it cannot do that.
template <class C>
const C* offers(const Asset* asset) {
    if (asset)
        for (const Capability* capability : asset->capabilities())
            if (const auto* found = dynamic_cast<const C*>(capability)) return found;
    return nullptr;
}
template <class C, class Owner>
requires requires(const Owner& owner) {
    owner.get();
}
const C* offers(const Owner& asset) {  // a shared or unique pointer
    return offers<C>(asset.get());
}

enum class AssetCategory { artefact, instrument, robot, points, context, laboratory };

struct Reference {
    std::string text;  ///< "Porath, Gross, Eger: Experimental-numerical approach ..., Eqs 1-6"
};

struct AssetDescriptor {
    std::string kind;  ///< its name in files: "artefact-2d"
    std::string title;
    AssetCategory category = AssetCategory::artefact;
    std::string summary;
    std::vector<Reference> references;
    std::vector<std::string> notes;
    std::vector<std::string> capabilities;  ///< PointUncertaintySource::capability ...
    SetupSchema schema;
    /// Null if `problems` got an error. `setup` has passed check_setup; `assets` holds those it refers to.
    std::function<std::unique_ptr<Asset>(const SetupReader& setup, const AssetLibrary& assets,
                                         Problems& problems)>
        create;
};

/// The assets of a project, made; what models see.
class AssetLibrary {
public:
    struct Entry {
        std::string name;
        const AssetDescriptor* descriptor = nullptr;  ///< null: an analysis stands for an asset
        std::shared_ptr<const Asset> asset;
    };
    void add(const std::string& id, Entry entry) { entries_[id] = std::move(entry); }
    const Entry* find(const std::string& id) const {
        auto it = entries_.find(id);
        return it == entries_.end() ? nullptr : &it->second;
    }
    const std::map<std::string, Entry>& entries() const { return entries_; }
    /// Folder of the files that set-ups name.
    const std::filesystem::path& folder() const { return folder_; }
    void set_folder(std::filesystem::path folder) { folder_ = std::move(folder); }

private:
    std::filesystem::path folder_;
    std::map<std::string, Entry> entries_;
};

template <class C>
const C* offers(const AssetLibrary::Entry* entry) {
    return entry ? offers<C>(entry->asset) : nullptr;
}

}  // namespace covaria
