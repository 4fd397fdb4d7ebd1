#include "atlas.hpp"

#include <pybind11/stl.h>

#include <mutex>

#include "atlas_answer.hpp"
#include "described.hpp"
#include "faults.hpp"
#include "patience.hpp"
#include "scene.hpp"
#include "share_work.hpp"
#include "signorini/atlas_database.hpp"
#include "signorini/figures.hpp"

namespace signorini::python {

using FamilyOf = answers::AtlasFamilyOf;
using EntryOf = answers::AtlasEntryOf;
using answers::withUnits;
SIGNORINI_MEMBERS(FamilySection, &T::dimension, &T::isConnected);
SIGNORINI_MEMBERS(FamilyOf, &T::value, &T::bar, &T::section);

namespace {

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
        .def("frequency_energy_figure",
             [](const Shared& atlas, Cells cells, double left, double right, double top,
                std::int64_t order) {
                 return asked(atlas, [=](const Atlas& a) {
                     return asJson(frequencyEnergyFigure(a.database, cells,
                                                         {.maxFrequencyRatio = right,
                                                          .maxEnergyRatio = top,
                                                          .bar = a.bar,
                                                          .leastFrequencyRatio = left,
                                                          .maxOrder = order}));
                 });
             })
        .def("existence_figure",
             [](const Shared& atlas, Cells cells) {
                 return asked(atlas, [cells](const Atlas& a) {
                     return asJson(existenceFigure(a.database, cells));
                 });
             })
        .def("families_near",
             [](const Shared& atlas, double w, double e, double within, Cells cells) {
                 return asked(atlas, [=](const Atlas& a) {
                     return withUnits(a.database.familiesNear(w, e, within, cells), a.bar, e);
                 });
             })
        .def("schedules_near",
             [](const Shared& atlas, double w, double e, double within, Cells cells) {
                 return asked(atlas, [=](const Atlas& a) {
                     return withUnits(a.database.schedulesNear(w, e, within, cells), a.bar);
                 });
             })
        .def("families_of_period",
             [](const Shared& atlas, std::int64_t p, std::int64_t q, Cells cells) {
                 return asked(atlas, [=](const Atlas& a) {
                     return withUnits(a.database.familiesOfPeriod(exactPeriod(p, q), cells), a.bar);
                 });
             })
        .def("schedules_of_period",
             [](const Shared& atlas, std::int64_t p, std::int64_t q, Cells cells) {
                 return asked(atlas, [=](const Atlas& a) {
                     return withUnits(a.database.schedulesOfPeriod(exactPeriod(p, q), cells),
                                      a.bar);
                 });
             })
        .def("twins", [](const Shared& atlas, Cells cells) {
            const std::vector<Twins> groups =
                asked(atlas, [cells](const Atlas& a) { return a.database.twins(cells); });
            py::list list;
            for (const Twins& twins : groups) {
                list.append(py::make_tuple(withUnits(twins.families, atlas->bar),
                                           withUnits(twins.schedules, atlas->bar)));
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
    classOf<FamilyOf>(module);
    classOf<EntryOf>(module);
    classOf<AtlasRun>(module);
    addAtlasFile(module);
    module.def("build_atlas", &build);
}

}  // namespace signorini::python
