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
                 Result (*question)(const Atlas&, const Watch&, Given...))
{
    const auto asking = [question](const SharedAtlas& atlas, Given... given) {
        return patiently(py::none(), [=](const Watch& watch) {
            const std::lock_guard lock(atlas->mutex);
            return question(*atlas, watch, given...);
        });
    };
    std::apply([&](auto... word) { shown.def(name, asking, py::arg(word)...); }, names);
}

using Near = std::optional<std::array<double, 3>>;  ///< omega/omega_1, E/E_1, within
using Period = std::optional<std::tuple<std::int64_t, std::int64_t>>;  ///< a fraction

constexpr auto fraction = [](std::int64_t p, std::int64_t q) { return exactPeriod(p, q); };

/// Visits each row that `visit` shows, until the call is cancelled.
template <typename Row, typename Visit>
std::vector<Row> allRows(const Watch& watch, const AtlasUnits& units, Visit visit)
{
    struct Cancelled {};
    std::vector<Row> rows;
    try {
        visit([&](const auto& one) {
            if (watch.cancel()) {
                throw Cancelled();
            }
            rows.push_back({one, units});
        });
    } catch (const Cancelled&) {
        rows.clear();  // nobody waits for them
    }
    return rows;
}

std::vector<AtlasFamilyOf> familiesOf(const Atlas& a, const Watch& watch, Cells cells,
                                      const Near& near, const Period& period)
{
    const AtlasDatabase& all = a.database;
    if (near) {
        const auto [w, e, within] = *near;
        return withUnits(all.familiesNear(a.onGrid(w), e, within, cells), a.units, e);
    }
    return period ? withUnits(all.familiesOfPeriod(std::apply(fraction, *period), cells), a.units)
                  : allRows<AtlasFamilyOf>(
                        watch, a.units, [&](const auto& keep) { all.forEachFamily(cells, keep); });
}

std::vector<AtlasEntryOf> schedulesOf(const Atlas& a, const Watch& watch, Cells cells,
                                      const Near& near, const Period& period)
{
    const AtlasDatabase& all = a.database;
    if (near) {
        const auto [w, e, within] = *near;
        return withUnits(all.schedulesNear(a.onGrid(w), e, within, cells), a.units);
    }
    return period ? withUnits(all.schedulesOfPeriod(std::apply(fraction, *period), cells), a.units)
                  : allRows<AtlasEntryOf>(watch, a.units,
                                          [&](const auto& keep) { all.forEachFound(cells, keep); });
}

void addAtlasFile(py::module_& module)
{
    py::class_<Atlas, SharedAtlas> shown(module, "AtlasFile", "A database opened for asking.");
    shown.def(py::init<const std::string&, const Bar&>(), py::arg("database"), py::arg("bar"));
    addQuestion(
        shown, "runs", {}, +[](const Atlas& a, const Watch&) { return a.database.runs(); });
    addQuestion(
        shown, "has_families", {},
        +[](const Atlas& a, const Watch&) { return hasFamilies(a.database.runs()); });
    addQuestion(shown, "families", {"cells", "near", "period"}, &familiesOf);
    addQuestion(shown, "schedules", {"cells", "near", "period"}, &schedulesOf);
    addQuestion(
        shown, "frequency_energy_figure", {"cells", "left", "right", "top", "max_order"},
        +[](const Atlas& a, const Watch&, Cells cells, End left, End right, End top,
            std::int64_t order) {
            return frequencyEnergyFigure(a.database, cells,
                                         {.maxFrequencyRatio = right,
                                          .maxEnergyRatio = top,
                                          .bar = a.bar,
                                          .leastFrequencyRatio = left,
                                          .maxOrder = order});
        });
    addQuestion(
        shown, "existence_figure", {"cells"}, +[](const Atlas& a, const Watch&, Cells cells) {
            return existenceFigure(a.database, cells);
        });
    addQuestion(
        shown, "twins", {"cells"}, +[](const Atlas& a, const Watch&, Cells cells) {
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
    const auto job = [=](const Watch& watch) mutable {
        options.cancel = watch.cancel;
        options.progress = [&watch](const AtlasRun& run) {
            watch.show(static_cast<double>(run.nextBatch), static_cast<double>(run.batches));
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
