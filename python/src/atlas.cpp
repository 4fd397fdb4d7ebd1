#include "atlas.hpp"

#include <pybind11/stl.h>

#include <mutex>

#include "asked.hpp"
#include "atlas_answer.hpp"
#include "described.hpp"
#include "patience.hpp"
#include "share_work.hpp"
#include "signorini/atlas_database.hpp"
#include "signorini/figures.hpp"

namespace signorini::python {

using FamilyOf = answers::AtlasFamilyOf;
using EntryOf = answers::AtlasEntryOf;
using answers::withUnits;

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
        .def(py::init<const std::string&, const Bar&>(), py::arg("database"), py::arg("bar"))
        .def("runs",
             [](const Shared& atlas) {
                 return asked(atlas, [](const Atlas& a) { return a.database.runs(); });
             })
        .def(
            "families",
            [](const Shared& atlas, Cells cells) {
                return asked(atlas, [cells](const Atlas& a, const Wires& wires) {
                    return allRows<FamilyOf, AtlasFamily>(wires, a.bar, [&](const auto& keep) {
                        a.database.forEachFamily(cells, keep);
                    });
                });
            },
            py::arg("cells"))
        .def(
            "schedules",
            [](const Shared& atlas, Cells cells) {
                return asked(atlas, [cells](const Atlas& a, const Wires& wires) {
                    return allRows<EntryOf, AtlasEntry>(wires, a.bar, [&](const auto& keep) {
                        a.database.forEachFound(cells, keep);
                    });
                });
            },
            py::arg("cells"))
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
        .def(
            "families_near",
            [](const Shared& atlas, double w, double e, double within, Cells cells) {
                return asked(atlas, [=](const Atlas& a) {
                    return withUnits(a.database.familiesNear(w, e, within, cells), a.bar, e);
                });
            },
            py::arg("frequency_ratio"), py::arg("energy_ratio"), py::arg("within"),
            py::arg("cells"))
        .def(
            "schedules_near",
            [](const Shared& atlas, double w, double e, double within, Cells cells) {
                return asked(atlas, [=](const Atlas& a) {
                    return withUnits(a.database.schedulesNear(w, e, within, cells), a.bar);
                });
            },
            py::arg("frequency_ratio"), py::arg("energy_ratio"), py::arg("within"),
            py::arg("cells"))
        .def(
            "families_of_period",
            [](const Shared& atlas, std::int64_t p, std::int64_t q, Cells cells) {
                return asked(atlas, [=](const Atlas& a) {
                    return withUnits(a.database.familiesOfPeriod(exactPeriod(p, q), cells), a.bar);
                });
            },
            py::arg("period"), py::arg("denominator"), py::arg("cells"))
        .def(
            "schedules_of_period",
            [](const Shared& atlas, std::int64_t p, std::int64_t q, Cells cells) {
                return asked(atlas, [=](const Atlas& a) {
                    return withUnits(a.database.schedulesOfPeriod(exactPeriod(p, q), cells), a.bar);
                });
            },
            py::arg("period"), py::arg("denominator"), py::arg("cells"))
        .def(
            "twins",
            [](const Shared& atlas, Cells cells) {
                const std::vector<Twins> groups =
                    asked(atlas, [cells](const Atlas& a) { return a.database.twins(cells); });
                py::list list;
                for (const Twins& twins : groups) {
                    list.append(py::make_tuple(withUnits(twins.families, atlas->bar),
                                               withUnits(twins.schedules, atlas->bar)));
                }
                return list;
            },
            py::arg("cells"));
}

AtlasRun build(const Asked& asked)
{
    AtlasRange range = usualRange(asked.get<std::int64_t>("cells"));
    range.maxContact = asked.maybe<std::int64_t>("max_contact").value_or(range.maxContact);
    range.maxFree = asked.maybe<std::int64_t>("max_free").value_or(range.maxFree);
    range.maxPhases = asked.get<std::int64_t>("phases");
    range.maxEnergyRatio = asked.maybe<double>("max_energy_ratio").value_or(range.maxEnergyRatio);
    range.keepsRefuted = asked.get<bool>("all");
    range.familiesOnly = asked.get<bool>("families_only");
    range.gapSign = stopsOf(asked.bar()).right;
    validate(range);
    const auto path = asked.get<std::string>("path");
    const auto threads = asked.threads();
    const bool resume = asked.get<bool>("resume");
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
        asked.progress(), false);
}

}  // namespace

void addAtlas(py::module_& module)
{
    classOf<FamilyOf>(module);
    classOf<EntryOf>(module);
    classOf<AtlasRun>(module);
    addAtlasFile(module);
    addCall(module, "build_atlas", &build);
}

}  // namespace signorini::python
