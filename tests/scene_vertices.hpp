#pragma once
/// \file
/// All motions of a schedule as a polytope in the 2N waves that arrive first, by its vertices:
/// cddlib lists them from the rows of scene_oracle.hpp, and no code of the library.

#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "cddlib.hpp"
#include "scene_oracle.hpp"
#include "signorini/motion.hpp"

namespace signorini::test {

using Waves2N = std::vector<double>;

/// a from the wall to the clamp, then -b back: a wave that runs to and fro.
inline Waves2N waves2NOf(const State& state)
{
    Waves2N waves;
    for (Eigen::Index i = state.cells(); i-- > 0;) {
        waves.push_back(state.a[i]);
    }
    for (const double value : state.b) {
        waves.push_back(-value);
    }
    return waves;
}

/// Which waves arrive in a period, and with which signs.
inline std::set<std::pair<std::size_t, int>> arrivalsOf(const Schedule& schedule)
{
    std::vector<SignedIndex> line;
    for (std::size_t m = 0; m < static_cast<std::size_t>(2 * schedule.cells); ++m) {
        line.push_back({m, 1});
    }
    std::set<std::pair<std::size_t, int>> arrivals;
    for (const Phase& phase : schedule.phases) {
        for (std::int64_t step = 0; step < phase.contact + phase.free; ++step) {
            const SignedIndex now = line.front();
            arrivals.emplace(now.index, now.sign);
            line.erase(line.begin());
            line.push_back({now.index, step < phase.contact ? now.sign : -now.sign});
        }
    }
    return arrivals;
}

/// The vertices of all motions none of whose waves exceeds the cap. \pre they are bounded.
inline std::vector<Waves2N> verticesOf(const Schedule& schedule,
                                       double cap = std::numeric_limits<double>::infinity())
{
    std::vector<OracleRows::Row> rows = OracleRows(schedule).rows();
    const auto unknowns = rows.front().values.size();
    if (std::isfinite(cap)) {
        for (const auto& [index, sign] : arrivalsOf(schedule)) {
            Waves2N values(unknowns, 0.0);
            values[index] = sign;
            rows.push_back({std::move(values), GLP_UP, cap});
        }
    }
    const CddMatrix input = cddRows(rows.size(), unknowns);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const double sign = rows[k].kind == GLP_UP ? -1.0 : 1.0;
        mpq_set_d(input->matrix[k][0], -sign * rows[k].rhs);
        for (std::size_t i = 0; i < unknowns; ++i) {
            mpq_set_d(input->matrix[k][i + 1], sign * rows[k].values[i]);
        }
        if (rows[k].kind == GLP_FX) {
            set_addelem(input->linset, static_cast<long>(k) + 1);
        }
    }
    const CddMatrix output = cddGenerators(input);
    REQUIRE(set_card(output->linset) == 0);
    std::vector<Waves2N> vertices;
    for (dd_rowrange k = 0; k < output->rowsize; ++k) {
        REQUIRE(mpq_sgn(output->matrix[k][0]) != 0);  // the set is bounded
        Waves2N& vertex = vertices.emplace_back();
        for (std::size_t i = 1; i <= unknowns; ++i) {
            vertex.push_back(mpq_get_d(output->matrix[k][i]));
        }
    }
    return vertices;
}

}  // namespace signorini::test
