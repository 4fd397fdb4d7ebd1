#include "calls.hpp"

#include <array>
#include <mutex>

#include "atlas_answer.hpp"
#include "share_work.hpp"
#include "signorini/atlas_database.hpp"

namespace signorini::python {

namespace {

/// A database that is asked by one thread at a time.
struct Atlas {
    AtlasDatabase database;
    Bar bar;
    AtlasUnits units;
    std::mutex mutex;

    Atlas(const std::string& path, const Bar& ofOne)
        : database(AtlasDatabase::open(path)), bar(ofOne)
    {
        const std::optional<Assembly> bars = barsOf(database.runs());
        units = bars ? atlasUnitsOf(*bars) : atlasUnitsOf(bar);
    }

    /// A point of the plot as its rows have it: 4N/n.
    [[nodiscard]] double onGrid(double frequencyRatio) const
    {
        const AtlasPoint at{.frequencyRatio = frequencyRatio, .units = units};
        validate(at);
        return at.onGrid();
    }
};

using SharedAtlas = std::shared_ptr<Atlas>;
using Cells = std::optional<std::int64_t>;
using End = std::optional<double>;  ///< of an axis

/// A question to the database, asked in a thread of its own.
template <typename Result, typename... Given>
void addQuestion(py::class_<Atlas, SharedAtlas>& shown, const char* name,
                 const std::array<const char*, sizeof...(Given)>& names,
                 Result (*question)(const Atlas&, const Wires&, Given...))
{
    const auto asking = [question](const SharedAtlas& atlas, Given... given) {
        return patiently(py::none(), [=](const Wires& wires) {
            const std::lock_guard lock(atlas->mutex);
            return question(*atlas, wires, given...);
        });
    };
    std::apply([&](auto... word) { shown.def(name, asking, py::arg(word)...); }, names);
}

/// Visits each row that `visit` shows, until the call is cancelled.
template <typename Row, typename Visit>
std::vector<Row> allRows(const Wires& wires, const AtlasUnits& units, Visit visit)
{
    struct Cancelled {};
    std::vector<Row> rows;
    try {
        visit([&](const auto& one) {
            if (wires.cancel()) {
                throw Cancelled();
            }
            rows.push_back({one, units});
        });
    } catch (const Cancelled&) {
        rows.clear();  // nobody waits for them
    }
    return rows;
}

void addAtlasFile(py::module_& module)
{
    py::class_<Atlas, SharedAtlas> shown(module, "AtlasFile", "A database opened for asking.");
    shown.def(py::init<const std::string&, const Bar&>(), py::arg("database"), py::arg("bar"));
    addQuestion(
        shown, "runs", {}, +[](const Atlas& a, const Wires&) { return a.database.runs(); });
    addQuestion(
        shown, "has_families", {},
        +[](const Atlas& a, const Wires&) { return hasFamilies(a.database.runs()); });
    addQuestion(
        shown, "families", {"cells"}, +[](const Atlas& a, const Wires& wires, Cells cells) {
            return allRows<AtlasFamilyOf>(
                wires, a.units, [&](const auto& keep) { a.database.forEachFamily(cells, keep); });
        });
    addQuestion(
        shown, "schedules", {"cells"}, +[](const Atlas& a, const Wires& wires, Cells cells) {
            return allRows<AtlasEntryOf>(
                wires, a.units, [&](const auto& keep) { a.database.forEachFound(cells, keep); });
        });
    addQuestion(
        shown, "frequency_energy_figure", {"cells", "left", "right", "top", "max_order"},
        +[](const Atlas& a, const Wires&, Cells cells, End left, End right, End top,
            std::int64_t order) {
            return frequencyEnergyFigure(a.database, cells,
                                         {.maxFrequencyRatio = right,
                                          .maxEnergyRatio = top,
                                          .bar = a.bar,
                                          .leastFrequencyRatio = left,
                                          .maxOrder = order});
        });
    addQuestion(
        shown, "existence_figure", {"cells"}, +[](const Atlas& a, const Wires&, Cells cells) {
            return existenceFigure(a.database, cells);
        });
    addQuestion(
        shown, "families_near", {"frequency_ratio", "energy_ratio", "within", "cells"},
        +[](const Atlas& a, const Wires&, double w, double e, double within, Cells cells) {
            return withUnits(a.database.familiesNear(a.onGrid(w), e, within, cells), a.units, e);
        });
    addQuestion(
        shown, "schedules_near", {"frequency_ratio", "energy_ratio", "within", "cells"},
        +[](const Atlas& a, const Wires&, double w, double e, double within, Cells cells) {
            return withUnits(a.database.schedulesNear(a.onGrid(w), e, within, cells), a.units);
        });
    addQuestion(
        shown, "families_of_period", {"period", "denominator", "cells"},
        +[](const Atlas& a, const Wires&, std::int64_t p, std::int64_t q, Cells cells) {
            return withUnits(a.database.familiesOfPeriod(exactPeriod(p, q), cells), a.units);
        });
    addQuestion(
        shown, "schedules_of_period", {"period", "denominator", "cells"},
        +[](const Atlas& a, const Wires&, std::int64_t p, std::int64_t q, Cells cells) {
            return withUnits(a.database.schedulesOfPeriod(exactPeriod(p, q), cells), a.units);
        });
    addQuestion(
        shown, "twins", {"cells"}, +[](const Atlas& a, const Wires&, Cells cells) {
            std::vector<std::tuple<std::vector<AtlasFamilyOf>, std::vector<AtlasEntryOf>>> groups;
            for (const Twins& twins : a.database.twins(cells)) {
                groups.emplace_back(withUnits(twins.families, a.units),
                                    withUnits(twins.schedules, a.units));
            }
            return groups;
        });
}

AtlasRun build(const Asked& asked)
{
    const AtlasRange range =
        atlasAsked(asked, asked.has("words") ? atlasRangeOf(asked.assembly())
                                             : atlasRangeOf(asked.scene(), asked.cells()));
    const auto path = asked.get<std::string>("path");
    AtlasOptions options{.threads = asked.get<std::int64_t>("threads"),
                         .resume = asked.get<bool>("resume"),
                         .options = "Python"};
    const auto job = [=](const Wires& wires) mutable {
        options.cancel = wires.cancel;
        options.progress = [&wires](const AtlasRun& run) {
            wires.progress(static_cast<double>(run.nextBatch), static_cast<double>(run.batches));
        };
        AtlasDatabase database = AtlasDatabase::create(path, options.cancel);
        return buildAtlas(database, range, options);
    };
    return patiently(asked.object("progress"), job, false);
}

}  // namespace

void addAtlas(py::module_& module)
{
    addClasses<AtlasFamilyOf, AtlasEntryOf, AtlasRun>(module);
    addAtlasFile(module);
    module.def("build_atlas", &build);
}

}  // namespace signorini::python
