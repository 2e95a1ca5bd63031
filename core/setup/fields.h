// The fields of a set-up, each declared once and bound to the member that takes its value. Schema, reading
// and the places of problems follow; nobody writes a key twice.
#pragma once

#include <any>
#include <array>
#include <functional>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/setup/bound.h"
#include "core/setup/setup_schema.h"

namespace covaria {

/// A choice of a field whose member is an enumeration.
template <class E>
struct ChoiceOf {
    E value;
    const char* key;    ///< name in files
    std::string title;  ///< name for people
};

/// Further properties of a field or column beside key, title and help; see FieldSpec.
struct Further {
    Unit unit = {};
    Range range = {};
    SetupValue default_value = {};  ///< default of a field
    bool optional = false;
    std::size_t min_rows = 0;      ///< fewest rows of a table
    bool several_lines = false;    ///< a text has several lines
    std::string file_ending = {};  ///< ending of the file that a text names
    bool observed = false;         ///< a column has observations
    bool measured = false;         ///< a table has what was measured
};

/// Three columns alike with these keys as titles; '*' in the help is the axis, x, y or z.
using AxisKeys = std::array<const char*, 3>;
inline constexpr AxisKeys along_axes{"x", "y", "z"}, zyx_angles{"alpha", "beta", "gamma"};
std::array<ColumnSpec, 3> by_axis(const AxisKeys& keys, const std::string& help, const Further& more);

namespace detail {

template <class E>
std::vector<Choice> keys_and_titles(const std::vector<ChoiceOf<E>>& choices) {
    std::vector<Choice> words;
    for (const ChoiceOf<E>& choice : choices) words.push_back({choice.key, choice.title});
    return words;
}

template <class E>
const char* key_of(const std::vector<ChoiceOf<E>>& choices, E value) {
    for (const ChoiceOf<E>& choice : choices)
        if (choice.value == value) return choice.key;
    throw std::logic_error("a value of an enumeration is no choice of its field");
}

template <class E>
E choice_of(const std::vector<ChoiceOf<E>>& choices, const SetupValue& given) {
    for (const ChoiceOf<E>& choice : choices)
        if (std::get<std::string>(given) == choice.key) return choice.value;
    throw std::logic_error("a set-up that was not checked is read");
}

template <class Spec>
Spec spec_of(std::string key, std::string title, std::string help, Further more) {
    Spec spec{.key = std::move(key), .title = std::move(title), .help = std::move(help)};
    spec.unit = more.unit;
    spec.range = more.range;
    spec.optional = more.optional;
    if constexpr (std::is_same_v<Spec, FieldSpec>) {
        spec.default_value = std::move(more.default_value);
        spec.min_rows = more.min_rows;
        spec.several_lines = more.several_lines;
        spec.file_ending = std::move(more.file_ending);
        spec.measured = more.measured;
    } else {
        spec.observed = more.observed;
    }
    return spec;
}

/// Content of a cell as the value of a field.
SetupValue value_of_cell(const SetupCell& cell, const Unit& unit);
std::string row_place(const std::string& table_place, std::size_t row);

/// A declaration: `Spec` (FieldSpec, ColumnSpec) and what reads its value into an `Owner`.
template <class Owner, class Spec>
struct Declaration {
    Spec spec;
    std::any member;  ///< M Owner::*
    std::function<void(Owner&, const SetupValue&, FieldReading&)> read;
    std::any parts = {};      ///< std::vector<ChoiceOf<E>> of a choice, Columns<Row> of a table
    std::size_t element = 0;  ///< index in a member that has several
};

template <class Owner, class Spec, class M>
Declaration<Owner, Spec> declaration(M Owner::*member, Spec spec) {
    spec.kind = Bound<M>::kind;
    if (spec.kind == FieldKind::text && !spec.choices.empty()) spec.kind = FieldKind::choice;
    if constexpr (requires { Bound<M>::capability; }) spec.capabilities = {Bound<M>::capability};
    return {std::move(spec), member, [member](Owner& owner, const SetupValue& value, FieldReading& reading) {
                Bound<M>::read(owner.*member, value, reading);
            }};
}

/// Declaration of one element of an array or vector.
template <class Owner, class Spec, class A>
Declaration<Owner, Spec> element_declaration(A Owner::*member, std::size_t element, Spec spec) {
    using M = std::remove_pointer_t<decltype(std::declval<A&>().data())>;
    spec.kind = Bound<M>::kind;
    return {std::move(spec),
            member,
            [member, element](Owner& owner, const SetupValue& value, FieldReading& reading) {
                Bound<M>::read((owner.*member).data()[element], value, reading);
            },
            {},
            element};
}

/// Declaration of a part of the owner as one of the owner's.
template <class Owner, class Spec, class P>
Declaration<Owner, Spec> part_declaration(P Owner::*part, const Declaration<P, Spec>& one) {
    return {one.spec, part,
            [part, read = one.read](Owner& owner, const SetupValue& value, FieldReading& reading) {
                read(owner.*part, value, reading);
            }};
}

template <class Owner, class Spec, class E>
Declaration<Owner, Spec> choice_declaration(E Owner::*member, Spec spec,
                                            const std::vector<ChoiceOf<E>>& choices) {
    spec.kind = FieldKind::choice;
    spec.choices = keys_and_titles(choices);
    return {std::move(spec), member,
            [member, choices](Owner& owner, const SetupValue& value, FieldReading&) {
                owner.*member = choice_of(choices, value);
            },
            choices};
}

template <class Owner, class Spec, class M>
bool is_of(const Declaration<Owner, Spec>& one, M Owner::*member) {
    const auto* own = std::any_cast<M Owner::*>(&one.member);
    return own && *own == member;
}

/// Index of the declaration that is bound to the member, or to this element of it.
template <class Owner, class Spec, class M>
std::size_t index_of(const std::vector<Declaration<Owner, Spec>>& all, M Owner::*member,
                     std::size_t element = 0) {
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].element == element && is_of(all[i], member)) return i;
    throw std::logic_error("a member of a set-up has no field");
}

/// The word for a value of a choice or flag in a Condition.
template <class Declared, class E>
std::string word_of(const Declared& decides, const E& value) {
    if constexpr (std::is_same_v<E, bool>)
        if (!decides.parts.has_value()) return value ? "true" : "false";
    return key_of(std::any_cast<const std::vector<ChoiceOf<E>>&>(decides.parts), value);
}

}  // namespace detail

/// The columns of a table, bound to the members of the struct that holds a row. Empty cells leave the
/// member's initialiser.
template <class Row>
class Columns {
public:
    template <class M>
    Columns& add(M Row::*member, ColumnSpec spec) {
        all_.push_back(detail::declaration(member, std::move(spec)));
        return *this;
    }
    template <class M>
    Columns& add(M Row::*member, std::string key, std::string title, std::string help, Further more = {}) {
        return add(member, detail::spec_of<ColumnSpec>(std::move(key), std::move(title), std::move(help),
                                                       std::move(more)));
    }
    template <class E>
    Columns& choice(E Row::*member, std::string key, std::string title, std::string help,
                    const std::vector<ChoiceOf<E>>& choices, Further more = {}) {
        all_.push_back(detail::choice_declaration(
            member,
            detail::spec_of<ColumnSpec>(std::move(key), std::move(title), std::move(help), std::move(more)),
            choices));
        return *this;
    }
    /// Adds a column for one element of a vector or array.
    template <class A>
    Columns& element(A Row::*member, std::size_t i, ColumnSpec spec) {
        all_.push_back(detail::element_declaration(member, i, std::move(spec)));
        return *this;
    }
    /// A column for each of them.
    template <class A, std::size_t N>
    Columns& each(A Row::*member, const std::array<ColumnSpec, N>& specs) {
        for (std::size_t i = 0; i < N; ++i) element(member, i, specs[i]);
        return *this;
    }
    /// The columns of a struct within the row.
    template <class P>
    Columns& part(P Row::*member, const Columns<P>& columns) {
        for (const auto& one : columns.all_) all_.push_back(detail::part_declaration(member, one));
        return *this;
    }

    std::vector<ColumnSpec> specs() const {
        std::vector<ColumnSpec> specs;
        for (const auto& one : all_) specs.push_back(one.spec);
        return specs;
    }
    template <class M>
    const std::string& key(M Row::*member, std::size_t element = 0) const {
        return all_[detail::index_of(all_, member, element)].spec.key;
    }
    /// `reading.place`: that of the table.
    std::vector<Row> read(const SetupTable& table, const FieldReading& reading) const {
        std::vector<Row> rows(table.rows.size());
        for (std::size_t row = 0; row < rows.size(); ++row) {
            const std::string place = detail::row_place(reading.place, row);
            for (std::size_t i = 0; i < all_.size() && i < table.rows[row].size(); ++i) {
                if (std::holds_alternative<std::monostate>(table.rows[row][i])) continue;
                FieldReading cell{place + "/" + all_[i].spec.key, reading.assets, reading.problems};
                all_[i].read(rows[row], detail::value_of_cell(table.rows[row][i], table.units[i]), cell);
            }
        }
        return rows;
    }

private:
    template <class>
    friend class Columns;
    std::vector<detail::Declaration<Row, ColumnSpec>> all_;
};

/// The fields of the set-up `S`, in the order in which they are declared. The kind of a field follows from
/// the type of its member (core/setup/bound.h).
template <class S>
class Fields {
public:
    /// The heading of the fields that follow.
    Fields& section(std::string heading) {
        section_ = std::move(heading);
        return *this;
    }
    template <class M>
    Fields& add(M S::*member, FieldSpec spec) {
        return append(detail::declaration(member, std::move(spec)));
    }
    template <class M>
    Fields& add(M S::*member, std::string key, std::string title, std::string help, Further more = {}) {
        return add(member, detail::spec_of<FieldSpec>(std::move(key), std::move(title), std::move(help),
                                                      std::move(more)));
    }
    template <class E>
    Fields& choice(E S::*member, std::string key, std::string title, std::string help,
                   const std::vector<ChoiceOf<E>>& choices, const std::type_identity_t<E>& default_choice) {
        return append(detail::choice_declaration(
            member,
            detail::spec_of<FieldSpec>(
                std::move(key), std::move(title), std::move(help),
                {.default_value = std::string(detail::key_of(choices, default_choice))}),
            choices));
    }
    template <class Row>
    Fields& table(std::vector<Row> S::*member, FieldSpec spec, const Columns<Row>& columns) {
        spec.kind = FieldKind::table;
        spec.columns = columns.specs();
        return append({std::move(spec), member,
                       [member, columns](S& setup, const SetupValue& value, FieldReading& reading) {
                           setup.*member = columns.read(std::get<SetupTable>(value), reading);
                       },
                       columns});
    }
    template <class Row>
    Fields& table(std::vector<Row> S::*member, std::string key, std::string title, std::string help,
                  const Columns<Row>& columns, Further more = {}) {
        return table(
            member,
            detail::spec_of<FieldSpec>(std::move(key), std::move(title), std::move(help), std::move(more)),
            columns);
    }
    /// Adds a field for one element of an array.
    template <class A>
    Fields& element(A S::*member, std::size_t i, FieldSpec spec) {
        return append(detail::element_declaration(member, i, std::move(spec)));
    }
    /// A field for each element of an array.
    template <class A, std::size_t N>
    Fields& each(A S::*member, const std::array<FieldSpec, N>& specs) {
        for (std::size_t i = 0; i < N; ++i) element(member, i, specs[i]);
        return *this;
    }
    /// The fields of a struct within the set-up; `fields` has their places.
    template <class P>
    Fields& part(P S::*member, const Fields<P>& fields) {
        for (const auto& one : fields.all_) append(detail::part_declaration(member, one));
        return *this;
    }
    /// The fields of `members` are shown, needed and read only where `decides` has one of the values. A field
    /// of a part that has a condition of its own keeps it.
    template <class E, class... M>
    Fields& shown_where(E S::*decides, std::initializer_list<std::type_identity_t<E>> values,
                        M S::*... members) {
        const auto& deciding = all_[detail::index_of(all_, decides)];
        Condition condition{deciding.spec.key, {}};
        for (const E& value : values) condition.values.push_back(detail::word_of(deciding, value));
        (set_condition(&FieldSpec::shown_if, members, condition), ...);
        return *this;
    }
    /// The angles of a pose are omega, phi, kappa where a choice has this value.
    template <class E, class M>
    Fields& photogrammetric_where(E S::*decides, std::type_identity_t<E> value, M S::*pose) {
        const auto& deciding = all_[detail::index_of(all_, decides)];
        set_condition(&FieldSpec::photogrammetric_if, pose,
                      {deciding.spec.key, {detail::word_of(deciding, value)}});
        return *this;
    }

    SetupSchema schema() const {
        std::vector<FieldSpec> specs;
        for (const auto& one : all_) specs.push_back(one.spec);
        return SetupSchema(std::move(specs));
    }
    /// Reads a set-up that passed check_setup with this schema. A field that is not shown has its default.
    S read(const SetupReader& reader, const AssetLibrary& assets, Problems& problems) const {
        S made;
        for (const auto& one : all_) {
            const bool shown = is_shown(reader.schema(), one.spec, reader.setup());
            const SetupValue& value = shown ? value_of(one.spec, reader.setup()) : one.spec.default_value;
            if (std::holds_alternative<std::monostate>(value)) continue;
            FieldReading reading{"/" + one.spec.key, assets, problems};
            one.read(made, value, reading);
        }
        return made;
    }

    template <class M>
    const std::string& key(M S::*member) const {
        return all_[detail::index_of(all_, member)].spec.key;
    }
    /// Places for problems: "/unit", "/points/rows/2", "/points/rows/2/u_y".
    template <class M>
    std::string place(M S::*member) const {
        return "/" + key(member);
    }
    template <class Row>
    std::string place(std::vector<Row> S::*table, std::size_t row) const {
        return detail::row_place(place(table), row);
    }
    template <class Row, class M>
    std::string place(std::vector<Row> S::*table, std::size_t row, M Row::*column,
                      std::size_t element = 0) const {
        return place(table, row) + "/" + columns(table).key(column, element);
    }
    template <class Row>
    const Columns<Row>& columns(std::vector<Row> S::*table) const {
        return std::any_cast<const Columns<Row>&>(all_[detail::index_of(all_, table)].parts);
    }

private:
    template <class>
    friend class Fields;
    Fields& append(detail::Declaration<S, FieldSpec> one) {
        if (one.spec.section.empty()) one.spec.section = section_;
        all_.push_back(std::move(one));
        return *this;
    }
    template <class M>
    void set_condition(std::optional<Condition> FieldSpec::*which, M S::*member, const Condition& condition) {
        (void)detail::index_of(all_, member);
        for (auto& one : all_)
            if (detail::is_of(one, member) && !(one.spec.*which)) one.spec.*which = condition;
    }
    std::vector<detail::Declaration<S, FieldSpec>> all_;
    std::string section_;
};

}  // namespace covaria
