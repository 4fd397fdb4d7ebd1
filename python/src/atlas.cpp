#include "atlas.hpp"

#include <pybind11/stl.h>

#include <mutex>

#include "family_section.hpp"
#include "faults.hpp"
#include "patience.hpp"
#include "scene.hpp"
#include "share_work.hpp"
#include "signorini/atlas_database.hpp"

namespace signorini::python {

SIGNORINI_MEMBERS(FamilySection, &T::dimension, &T::isConnected);

/// A set of orbits; its motions of one energy, where one was asked for.
struct FamilyRow {
    AtlasFamily value;
    Bar bar;
    std::optional<FamilySection> section = {};
};
template <>
struct Members<FamilyRow> {
    static constexpr auto list =
        std::tuple{&FamilyRow::value, &FamilyRow::bar, &FamilyRow::section};
};

namespace {

using FamilyOf = FamilyRow;
using EntryOf = Of<AtlasEntry>;

/// A database that is asked by one thread at a time.
struct Atlas {
    AtlasDatabase database;
    Bar bar;
    std::mutex mutex;

    Atlas(const std::string& path, const Bar& units)
        : database(AtlasDatabase::open(path)), bar(units)
    {
    }
};

using Shared = std::shared_ptr<Atlas>;
using Cells = std::optional<std::int64_t>;

/// Keys that say when motions repeat: T [L/c] and omega/omega_1 by functions of the library.
template <typename Row>
void addPeriod(Record<Row>& record)
{
    record
        .key(
            "period", [](const Row& f) { return period(f.value) * scales(f.bar).time; }, "T [s].")
        .key(
            "period_ratio", [](const Row& f) { return period(f.value); }, "T [L/c].")
        .key(
            "frequency", [](const Row& f) { return 1.0 / (period(f.value) * scales(f.bar).time); },
            "[Hz]")
        .key(
            "frequency_ratio", [](const Row& f) { return frequencyRatio(f.value); },
            "omega/omega_1.");
}

void addFamily(py::module_& module)
{
    Record<FamilyOf> record(module, "AtlasFamily", R"(A set of orbits on a grid, a row of an atlas.

Either a family, or all grazing motions of one period: those have no (order, nu, contact_blocks).
)");
    const auto number = [](auto member) {
        return [member](const FamilyOf& f) {
            return orNone(f.value.family,
                          [member](const Family& family) { return py::cast(family.*member); });
        };
    };
    record
        .key(
            "id", [](const FamilyOf& f) { return f.value.id; }, "Of its row.")
        .key(
            "cells", [](const FamilyOf& f) { return f.value.cells; }, "N.")
        .key("order", number(&Family::order), "w.")
        .key("nu", number(&Family::blocks), "nu.")
        .key("contact_blocks", number(&Family::contactBlocks), "k.")
        .key(
            "schedule",
            [](const FamilyOf& f) {
                return Schedule{f.value.cells, {f.value.top}};
            },
            "That has the whole set.");
    addPeriod(record);
    record
        .key(
            "contact", [](const FamilyOf& f) { return nameOf(f.value.contact()); },
            "\"pressing\" or \"grazing\".")
        .key(
            "kind", [](const FamilyOf& f) { return nameOf(f.value.kind); }, "Of the set.")
        .key(
            "dimension", [](const FamilyOf& f) { return f.value.dimension; }, "Of the set.")
        .key(
            "energy_range",
            [](const FamilyOf& f) { return boundsOf(f.value.energy, scales(f.bar).energy); },
            "(least, most) [J].")
        .key(
            "energy_ratio_range", [](const FamilyOf& f) { return boundsOf(f.value.energy); },
            "(least, most) E/E_1, on this grid.")
        .key(
            "schedules", [](const FamilyOf& f) { return f.value.schedules; },
            "How many of the range show some of its motions.")
        .keyIfAny(
            "dimension_at_energy",
            [](const FamilyOf& f) {
                return orNone(f.section,
                              [](const FamilySection& s) { return py::cast(s.dimension); });
            },
            "Of its motions of the energy that was asked for, or the nearest it has.")
        .keyUnless(
            "connected_at_energy",
            [](const FamilyOf& f) {
                return f.section ? orNone(f.section->isConnected) : py::object(py::none());
            },
            [](const FamilyOf& f) { return !f.section; },
            "Are those connected? None: not known, or no energy was asked for.");
}

void addEntry(py::module_& module)
{
    Record<EntryOf> record(module, "AtlasSchedule", "A schedule that an atlas keeps.");
    const auto ifFound = [](auto get) {
        return [get](const EntryOf& e) -> py::object {
            return e.value.row.status == Status::found ? asObject(get(e)) : py::none();
        };
    };
    record
        .key(
            "cells", [](const EntryOf& e) { return e.value.schedule.cells; }, "N.")
        .key(
            "schedule", [](const EntryOf& e) { return e.value.schedule; }, "What it is of.")
        .key(
            "family", [](const EntryOf& e) { return orNone(e.value.family); },
            "id of its AtlasFamily.");
    addPeriod(record);
    record
        .key(
            "status", [](const EntryOf& e) { return nameOf(e.value.row.status); }, "Decided.")
        .key(
            "reason",
            [](const EntryOf& e) {
                return orNone(e.value.row.reason, [](Reason r) { return nameOf(r); });
            },
            "Why there is no motion.")
        .key(
            "kernel_dimension",
            [](const EntryOf& e) {
                const std::int64_t dimension = e.value.row.kernelDimension;
                return dimension >= 0 ? py::cast(dimension) : py::object(py::none());
            },
            "dim ker(W - 1).")
        .keyIfAny("kind", ifFound([](const EntryOf& e) { return nameOf(e.value.row.kind); }),
                  "Of the set.")
        .keyIfAny("dimension", ifFound([](const EntryOf& e) { return e.value.row.dimension; }),
                  "Of the set.")
        .keyIfAny("contact", ifFound([](const EntryOf& e) { return nameOf(e.value.row.contact); }),
                  "\"pressing\" or \"grazing\".")
        .keyIfAny("canonical", ifFound([](const EntryOf& e) { return e.value.row.isCanonical; }),
                  "Does its motion of least energy press at every contact step?")
        .keyIfAny("energy_range", ifFound([](const EntryOf& e) {
                      return boundsOf(e.value.row.energy, scales(e.bar).energy);
                  }),
                  "(least, most) [J].")
        .keyIfAny("energy_ratio_range",
                  ifFound([](const EntryOf& e) { return boundsOf(e.value.row.energy); }),
                  "(least, most) E/E_1.");
}

void addRun(py::module_& module)
{
    Record<AtlasRun>(module, "AtlasRun", "A range of schedules, and how far it is decided.")
        .key(
            "cells", [](const AtlasRun& r) { return r.range.cells; }, "N.")
        .key(
            "max_contact", [](const AtlasRun& r) { return r.range.maxContact; }, "[steps]")
        .key(
            "max_free", [](const AtlasRun& r) { return r.range.maxFree; }, "[steps]")
        .key(
            "phases", [](const AtlasRun& r) { return r.range.maxPhases; }, "At most.")
        .key(
            "max_energy_ratio", [](const AtlasRun& r) { return r.range.maxEnergyRatio; },
            "Kept up to it [E_1]; infinite: all.")
        .key(
            "families_only", [](const AtlasRun& r) { return r.range.familiesOnly; },
            "Were no schedules kept?")
        .key("finished", &AtlasRun::isFinished, "Is all of it decided?")
        .key(
            "decided", [](const AtlasRun& r) { return r.tally.decided; }, "Schedules.")
        .key(
            "found", [](const AtlasRun& r) { return r.tally.pressing + r.tally.grazing; },
            "Of them with motions.")
        .key(
            "pressing", [](const AtlasRun& r) { return r.tally.pressing; }, "With force.")
        .key(
            "grazing", [](const AtlasRun& r) { return r.tally.grazing; }, "Without.")
        .key(
            "family_count", [](const AtlasRun& r) { return r.tally.families; },
            "Sets of orbits they belong to.")
        .key(
            "refuted", [](const AtlasRun& r) { return r.tally.refuted; }, "Proved to have none.")
        .key(
            "undecided", [](const AtlasRun& r) { return r.tally.undecided; },
            "Beyond the limits of exact arithmetic.")
        .key(
            "batches", [](const AtlasRun& r) { return py::make_tuple(r.nextBatch, r.batches); },
            "(decided, all).")
        .key(
            "seconds", [](const AtlasRun& r) { return r.seconds; }, "[s] spent.");
}

/// Rows with their units.
template <typename Row, typename Given>
std::vector<Row> withUnits(std::vector<Given> given, const Bar& bar)
{
    std::vector<Row> rows;
    rows.reserve(given.size());
    for (Given& one : given) {
        rows.push_back({std::move(one), bar});
    }
    return rows;
}

std::vector<FamilyOf> familiesNear(const Atlas& a, double w, double e, double within, Cells cells)
{
    auto rows = withUnits<FamilyOf>(a.database.familiesNear(w, e, within, cells), a.bar);
    for (FamilyOf& row : rows) {
        row.section = sectionOf(row.value, e);
    }
    return rows;
}

/// What a question to the database returns, asked in a thread of its own.
template <typename Question>
auto asked(const Shared& atlas, Question question)
{
    return patiently([atlas, question](const Wires& wires) {
        const std::lock_guard lock(atlas->mutex);
        if constexpr (std::is_invocable_v<Question, const Atlas&, const Wires&>) {
            return question(*atlas, wires);
        } else {
            return question(*atlas);
        }
    });
}

/// Visits each row that `visit` shows, until the call is cancelled.
template <typename Row, typename Given, typename Visit>
std::vector<Row> allRows(const Wires& wires, const Bar& bar, Visit visit)
{
    struct Cancelled {};
    std::vector<Row> rows;
    try {
        visit([&](const Given& one) {
            if (wires.cancel()) {
                throw Cancelled();
            }
            rows.push_back({one, bar});
        });
    } catch (const Cancelled&) {
        rows.clear();  // nobody waits for them
    }
    return rows;
}

void addAtlasFile(py::module_& module)
{
    py::class_<Atlas, Shared>(module, "AtlasFile", "A database opened for asking.")
        .def(py::init<const std::string&, const Bar&>())
        .def("runs",
             [](const Shared& atlas) {
                 return asked(atlas, [](const Atlas& a) { return a.database.runs(); });
             })
        .def("families",
             [](const Shared& atlas, Cells cells) {
                 return asked(atlas, [cells](const Atlas& a, const Wires& wires) {
                     return allRows<FamilyOf, AtlasFamily>(wires, a.bar, [&](const auto& keep) {
                         a.database.forEachFamily(cells, keep);
                     });
                 });
             })
        .def("schedules",
             [](const Shared& atlas, Cells cells) {
                 return asked(atlas, [cells](const Atlas& a, const Wires& wires) {
                     return allRows<EntryOf, AtlasEntry>(wires, a.bar, [&](const auto& keep) {
                         a.database.forEachFound(cells, keep);
                     });
                 });
             })
        .def("families_near",
             [](const Shared& atlas, double w, double e, double within, Cells cells) {
                 return asked(atlas,
                              [=](const Atlas& a) { return familiesNear(a, w, e, within, cells); });
             })
        .def("schedules_near",
             [](const Shared& atlas, double w, double e, double within, Cells cells) {
                 return asked(atlas, [=](const Atlas& a) {
                     return withUnits<EntryOf>(a.database.schedulesNear(w, e, within, cells),
                                               a.bar);
                 });
             })
        .def("families_of_period",
             [](const Shared& atlas, std::int64_t p, std::int64_t q, Cells cells) {
                 return asked(atlas, [=](const Atlas& a) {
                     return withUnits<FamilyOf>(
                         a.database.familiesOfPeriod(exactPeriod(p, q), cells), a.bar);
                 });
             })
        .def("schedules_of_period",
             [](const Shared& atlas, std::int64_t p, std::int64_t q, Cells cells) {
                 return asked(atlas, [=](const Atlas& a) {
                     return withUnits<EntryOf>(
                         a.database.schedulesOfPeriod(exactPeriod(p, q), cells), a.bar);
                 });
             })
        .def("twins", [](const Shared& atlas, Cells cells) {
            const std::vector<Twins> groups =
                asked(atlas, [cells](const Atlas& a) { return a.database.twins(cells); });
            py::list list;
            for (const Twins& twins : groups) {
                list.append(py::make_tuple(withUnits<FamilyOf>(twins.families, atlas->bar),
                                           withUnits<EntryOf>(twins.schedules, atlas->bar)));
            }
            return list;
        });
}

AtlasRun build(const std::string& path, std::int64_t cells, Cells maxContact, Cells maxFree,
               std::int64_t phases, std::optional<double> maxEnergyRatio, bool all,
               bool familiesOnly, bool resume, std::int64_t threads, const Bar& bar,
               const py::object& progress)
{
    AtlasRange range = usualRange(cells);
    range.maxContact = maxContact.value_or(range.maxContact);
    range.maxFree = maxFree.value_or(range.maxFree);
    range.maxPhases = phases;
    range.maxEnergyRatio = maxEnergyRatio.value_or(range.maxEnergyRatio);
    range.keepsRefuted = all;
    range.familiesOnly = familiesOnly;
    range.gapSign = stopsOf(bar).right;
    validate(range);
    Faults faults;
    faults.requireWhole("threads", threads, maxThreads);
    faults.throwIfAny();
    return patiently(
        [=](const Wires& wires) {
            AtlasOptions options;
            options.threads = threads;
            options.resume = resume;
            options.cancel = wires.cancel;
            options.options = "Python";
            options.progress = [&wires](const AtlasRun& run) {
                wires.progress(static_cast<double>(run.nextBatch),
                               static_cast<double>(run.batches));
            };
            AtlasDatabase database = AtlasDatabase::create(path, options.cancel);
            return buildAtlas(database, range, options);
        },
        progress, false);
}

}  // namespace

void addAtlas(py::module_& module)
{
    addFamily(module);
    addEntry(module);
    addRun(module);
    addAtlasFile(module);
    module.def("build_atlas", &build);
}

}  // namespace signorini::python
