// Binding of a member of a typed set-up to what was given for its field or column.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <concepts>
#include <optional>
#include <string>
#include <variant>

#include "core/setup/setup_schema.h"

namespace covaria {

class AssetLibrary;  // core/model/asset.h

/// A reading of one field: its place in the set-up ("/points/rows/2/x"), and what it may refer to.
struct FieldReading {
    std::string place;
    const AssetLibrary& assets;
    Problems& problems;
};

/// The binding of each type of a member: the kind of its field, and `read`, which takes a value that is there
/// and has passed check_setup. A value of another kind is a programming error (std::bad_variant_access).
template <class M>
struct Bound;

template <>
struct Bound<double> {
    static constexpr FieldKind kind = FieldKind::number;
    static void read(double& member, const SetupValue& value, FieldReading&) {
        member = std::get<Quantity>(value).si();
    }
};

template <std::integral M>
struct Bound<M> {
    static constexpr FieldKind kind = FieldKind::integer;
    static void read(M& member, const SetupValue& value, FieldReading&) {
        member = static_cast<M>(std::llround(std::get<Quantity>(value).value));
    }
};

template <>
struct Bound<bool> {
    static constexpr FieldKind kind = FieldKind::flag;
    static void read(bool& member, const SetupValue& value, FieldReading&) { member = std::get<bool>(value); }
};

template <>
struct Bound<std::string> {
    static constexpr FieldKind kind = FieldKind::text;
    static void read(std::string& member, const SetupValue& value, FieldReading&) {
        member = std::get<std::string>(value);
    }
};

/// A text that names a unit.
template <>
struct Bound<Unit> {
    static constexpr FieldKind kind = FieldKind::text;
    static void read(Unit& member, const SetupValue& value, FieldReading& reading) {
        const auto parsed = Unit::parse(std::get<std::string>(value));
        if (!parsed) reading.problems.error(reading.place, parsed.error().message);
        member = parsed.value_or(Unit{});
    }
};

template <>
struct Bound<Eigen::Isometry3d> {
    static constexpr FieldKind kind = FieldKind::pose;
    static void read(Eigen::Isometry3d& member, const SetupValue& value, FieldReading&) {
        member = std::get<PoseValue>(value).si();
    }
};

/// A pose as typed.
template <>
struct Bound<PoseValue> {
    static constexpr FieldKind kind = FieldKind::pose;
    static void read(PoseValue& member, const SetupValue& value, FieldReading&) {
        member = std::get<PoseValue>(value);
    }
};

/// An optional member stays empty where nothing is given.
template <class M>
struct Bound<std::optional<M>> {
    static constexpr FieldKind kind = Bound<M>::kind;
    static void read(std::optional<M>& member, const SetupValue& value, FieldReading& reading) {
        Bound<M>::read(member.emplace(), value, reading);
    }
};

}  // namespace covaria
