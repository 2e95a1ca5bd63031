#include "core/project/asides.h"

namespace covaria {

void take_asides(AssetEntry& entry, const AssetEntry& from) {
    entry.name = from.name;
    entry.notes = from.notes;
    entry.certificates = from.certificates;
}

void take_asides(AnalysisEntry& entry, const AnalysisEntry& from) {
    entry.name = from.name;
    entry.notes = from.notes;
    entry.requirements = from.requirements;
    entry.designs = from.designs;
    entry.views = from.views;
    entry.quantity_notes = from.quantity_notes;
    entry.measured = from.measured;
    entry.certificates = from.certificates;
}

}  // namespace covaria
