// Constant forces on bars that nothing holds: what rests, and what goes for ever.

#include "statics.hpp"

#include <fmt/format.h>

#include <random>
#include <stdexcept>
#include <string>

#include "catch.hpp"
#include "sanitized.hpp"
#include "scene_words.hpp"

using namespace signorini;

namespace {

/// One to three bars with stops on either side of any end, few of them clamped.
std::string drawnWords(std::mt19937& random)
{
    const auto draw = [&](int most) { return std::uniform_int_distribution<>(0, most)(random); };
    std::string words = draw(3) == 0 ? "clamp" : draw(1) == 0 ? "stop=-1e-3" : "";
    for (int bar = draw(2); bar >= 0; --bar) {
        words += fmt::format(" {}", 2 + draw(3));
        words += draw(2) == 0 ? "" : fmt::format(" force={}", 0.1 * (draw(6) - 3));
        words += draw(3) == 0 ? " stop=1e-3" : draw(3) == 0 ? " stop=-1e-3" : "";
        words += bar > 0 ? fmt::format(" gap=1e-3 {}", 1 + draw(2)) : "";
    }
    return words + (draw(5) == 0 ? " clamp" : "");
}

bool canRest(const Network& network)
{
    try {
        (void)restOf(network);
        return true;
    } catch (const std::invalid_argument&) {
        return false;
    }
}

}  // namespace

TEST_CASE("statics: bars go for ever exactly where no contacts hold them at rest")
{
    std::mt19937 random(4);
    int away = 0;
    int held = 0;
    for (int i = 0; i < 2000; ++i) {
        const std::string words = drawnWords(random);
        Network network;
        try {
            network = sceneOf(words);
        } catch (const std::invalid_argument&) {
            continue;  // no contact
        }
        INFO(words);
        CHECK(driftsAway(network) != canRest(network));
        ++(driftsAway(network) ? away : held);
    }
    CHECK(away > 200);
    CHECK(held > 200);
}
