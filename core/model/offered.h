// A reference of a set-up to an asset, by what the asset can do.
#pragma once

#include <memory>
#include <string>

#include "core/base/in_quotes.h"
#include "core/model/asset.h"
#include "core/setup/bound.h"

namespace covaria {

/// A member of this type is a field for the id of an asset; the FieldSpec says what the asset is to offer.
/// Empty where an optional reference is not given.
struct Referred {
    std::string id = {};
    std::string name = {};                    ///< the asset's; its id if it has none
    std::shared_ptr<const Asset> asset = {};  ///< null: it could not be made
};

template <>
struct Bound<Referred> {
    static constexpr FieldKind kind = FieldKind::reference;
    static void read(Referred& member, const SetupValue& value, FieldReading& reading) {
        member.id = std::get<std::string>(value);
        const AssetLibrary::Entry* entry = reading.assets.find(member.id);
        member.name = entry && !entry->name.empty() ? entry->name : member.id;
        if (entry) member.asset = entry->asset;
    }
};

/// A member `Offered<SensorSource>` is a field for the id of an asset that is a sensor.
template <class C>
struct Offered : Referred {
    const C* source = nullptr;
    explicit operator bool() const { return source != nullptr; }
    const C& operator*() const { return *source; }
    const C* operator->() const { return source; }
};

template <class C>
struct Bound<Offered<C>> {
    static constexpr FieldKind kind = FieldKind::reference;
    static constexpr const char* capability = C::capability;
    static void read(Offered<C>& member, const SetupValue& value, FieldReading& reading) {
        Bound<Referred>::read(member, value, reading);
        member.source = offers<C>(member.asset);
        if (!member.source) reading.problems.error(reading.place, lacking(member.name));
    }
    /// Words about an asset that does not offer it: C::lacking, where C has words of its own.
    static Message lacking(const std::string& name) {
        if constexpr (requires { C::lacking; })
            return in_quotes(name) + " " + Message::declared(C::lacking);
        else
            return tell<"'%1' does not offer '%2'">(name, capability);
    }
};

}  // namespace covaria
