// Units of work whose partial results are computed in several processes and merged in one of them.
#pragma once

#include <memory>

#include "core/base/bytes.h"
#include "core/base/unit_store.h"
#include "core/propagation/parallel_blocks.h"

namespace covaria::detail {

/// Partial results as bytes, and back into one that `make_partial` made.
template <class Partial>
struct PartialBytes {
    std::function<void(const Partial&, ByteWriter&)> write;
    std::function<void(ByteReader&, Partial&)> read;
};

/// Computes the ranges that the store asks for. Nothing is merged, but for work that ends when it has enough:
/// a range from its beginning knows when that is.
template <class Partial>
WorkEnd compute_for_store(const OrderedWork<Partial>& work, const PartialBytes<Partial>& bytes,
                          UnitStore& store, RunMonitor& monitor) {
    while (const std::optional<UnitRange> range = store.next_range()) {
        const std::uint64_t first = range->first;
        OrderedWork<Partial> part = work;
        part.units = range->size();
        part.make_worker = [&work, &store, first] {
            return [&store, first, worker = work.make_worker()](std::uint64_t i, Partial& partial) {
                store.begins(first + i);
                return worker(first + i, partial);
            };
        };
        part.merge = [&bytes, &store, &work, first](std::uint64_t i, Partial& partial) {
            ByteWriter writer;
            bytes.write(partial, writer);
            if (!store.keep(first + i, writer.take())) return false;
            return first > 0 || !work.ends_with_enough || work.merge(i, partial);
        };
        if (run_in_order(part, monitor) != WorkEnd::complete) break;
    }
    return WorkEnd::cancelled;
}

/// A partial result, where it comes from, and what is wrong with it.
template <class Partial>
struct FoundPartial {
    Partial partial;
    enum class Origin { computed, found, missing, unreadable } origin = Origin::computed;
};

/// Merges what the store has, and computes the rest if it shall.
template <class Partial>
WorkEnd merge_from_store(const OrderedWork<Partial>& work, const PartialBytes<Partial>& bytes,
                         UnitStore& store, RunMonitor& monitor) {
    using Found = FoundPartial<Partial>;
    using Origin = typename Found::Origin;
    OrderedWork<Found> all;
    all.units = work.units;
    all.make_partial = [&work] { return Found{work.make_partial()}; };
    all.make_worker = [&] {
        return [&, worker = work.make_worker()](std::uint64_t unit, Found& found) {
            if (const auto kept = store.find(unit)) {
                ByteReader reader(*kept);
                bytes.read(reader, found.partial);
                found.origin = reader.complete() ? Origin::found : Origin::unreadable;
                return monitor.advance(0);
            }
            found.origin = store.computes_missing(unit) ? Origin::computed : Origin::missing;
            if (found.origin == Origin::missing) return true;
            store.begins(unit);
            return worker(unit, found.partial);
        };
    };
    bool usable = true;
    all.merge = [&](std::uint64_t unit, Found& found) {
        if (found.origin == Origin::missing) store.lacks(unit);
        if (found.origin == Origin::unreadable) store.cannot_read(unit);
        if (found.origin == Origin::computed) {
            ByteWriter writer;
            bytes.write(found.partial, writer);
            usable = store.keep(unit, writer.take());
        }
        usable = usable && found.origin <= Origin::found;
        return usable && work.merge(unit, found.partial);
    };
    const WorkEnd end = run_in_order(all, monitor);
    return usable ? end : WorkEnd::cancelled;
}

/// `run_in_order`, or the share of this process where there are several (`monitor.units()`).
template <class Partial>
WorkEnd run_units(const OrderedWork<Partial>& work, const PartialBytes<Partial>& bytes, RunMonitor& monitor) {
    UnitStore* store = monitor.units();
    if (!store) return run_in_order(work, monitor);
    return store->only_computes() ? compute_for_store(work, bytes, *store, monitor)
                                  : merge_from_store(work, bytes, *store, monitor);
}

}  // namespace covaria::detail
