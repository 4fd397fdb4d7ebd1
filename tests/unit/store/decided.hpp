#pragma once
/// \file
/// Ranges of an atlas decided without a database.

#include "atlas_batches.hpp"
#include "catch.hpp"

namespace signorini::test {

/// All batches as one, in their order.
inline AtlasBatch decideAll(const AtlasRange& range, std::int64_t threads = 1)
{
    LocalBatches source(range, threads);
    AtlasBatch whole;
    std::int64_t number = 0;
    const auto append = [](auto& all, const auto& some) {
        all.insert(all.end(), some.begin(), some.end());
    };
    while (const auto batch = source.next()) {
        REQUIRE(batch->number == number++);
        whole.tally += batch->tally;
        append(whole.families, batch->families);
        append(whole.rows, batch->rows);
        append(whole.proofs, batch->proofs);
    }
    REQUIRE(number == batchesOf(range));
    return whole;
}

}  // namespace signorini::test
