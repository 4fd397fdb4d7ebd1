#include <fmt/format.h>

#include <Eigen/SVD>
#include <cmath>

#include "equations.hpp"
#include "problems.hpp"
#include "rival_cases.hpp"
#include "signorini/one_phase_set.hpp"
#include "suites.hpp"
#include "timing.hpp"

namespace signorini::bench {

namespace {

/// The first step of the paper: a null space of the dense W - 1.
void findNullSpace(std::int64_t cells, Record& record)
{
    const Schedule schedule = familyA(cells).schedule;
    const Eigen::MatrixXd matrix =
        Eigen::MatrixXd(periodMap(schedule)) - Eigen::MatrixXd::Identity(2 * cells, 2 * cells);
    Eigen::Index dimension = 0;
    bench::record(timeOf([&] {
                      const Eigen::BDCSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeFullV);
                      dimension = 2 * cells - svd.rank();
                  }),
                  record);
    const std::int64_t exact = onePhaseSet(schedule).kernelDimension;
    record.figures["checked"] = static_cast<double>(exact);
    record.figures["wrong"] = std::abs(static_cast<double>(dimension - exact));
    record.claim = "found";
    record.outcome = dimension == exact ? "right" : "wrong";
    record.detail = fmt::format("null space of {} dimensions, no motion yet", dimension);
}

constexpr int marched = 100;  // periods
constexpr int judged = 5;     // of them, for tip and force

/// Every case by every scheme and by us.
void addMarches(bool isFull, std::vector<Case>& cases)
{
    const std::vector<int> sizes =
        isFull ? std::vector<int>{10, 20, 50, 100, 200, 400, 800} : std::vector<int>{20};
    for (std::size_t k = 0; k < rivalCases().size(); ++k) {
        const RivalCase& one = rivalCases()[k];
        for (const int cells : sizes) {
            const std::string setting = fmt::format("{} cells {} periods", cells, marched);
            for (const std::string_view scheme : schemeNames()) {
                Record rival = identified("rivals", one.name, std::string(scheme), "-", setting);
                rival.figures["cells"] = cells;
                cases.push_back(
                    {rival, fmt::format("{} {}", scheme, one.name),
                     [&one, scheme, cells](Record& row) {
                         judgeMarch(one, march(scheme, one.bar, cells, one.period, marched, judged),
                                    row);
                     }});
            }
            Record ours = identified("rivals", one.name, "signorini", "-", setting);
            ours.figures["cells"] = cells;
            cases.push_back({ours, "", [&one, cells](Record& row) {
                                 judgeMarch(one, one.ours(marched, judged, cells), row);
                             }});
        }
    }
}

}  // namespace

std::vector<Case> rivalsSuite(Extent extent)
{
    const bool isFull = extent == Extent::full;
    std::vector<Case> cases;
    for (const std::int64_t cells :
         isFull ? std::vector<std::int64_t>{30, 100, 300, 1000} : std::vector<std::int64_t>{30}) {
        Record record = identified("rivals", "null space of W - 1: A", "Eigen BDCSVD", "-",
                                   fmt::format("N={}", cells));
        record.figures["cells"] = static_cast<double>(cells);
        cases.push_back({record, "svd", [cells](Record& row) { findNullSpace(cells, row); }});
    }
    addMarches(isFull, cases);
    return cases;
}

}  // namespace signorini::bench
