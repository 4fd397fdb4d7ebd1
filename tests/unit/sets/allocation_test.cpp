// The verdict uses no heap once its workspace is large enough. This file replaces operator new.

#include <atomic>
#include <cstdlib>
#include <new>

#include "catch.hpp"
#include "signorini/one_phase_set.hpp"
#include "support.hpp"

namespace {

std::atomic<long> allocations{0};

}  // namespace

void* operator new(std::size_t size)
{
    ++allocations;
    if (void* memory = std::malloc(size == 0 ? 1 : size)) {
        return memory;
    }
    throw std::bad_alloc();
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
    ++allocations;
    return std::malloc(size == 0 ? 1 : size);
}

void operator delete(void* memory) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
    std::free(memory);
}

using namespace signorini;

TEST_CASE("allocation: deciding 20,000 schedules with one workspace allocates nothing")
{
    Schedule schedule = test::onePhase(300, 1, 1);
    OnePhaseSet workspace;
    onePhaseSet(test::onePhase(300, 599, 2400), workspace);
    workspace.signs.reserve(3600);
    long found = 0;
    const long before = allocations;
    for (std::int64_t contact = 1; contact <= 200; ++contact) {
        for (std::int64_t free = 1000; free < 1100; ++free) {
            schedule.phases[0] = {contact, free};
            onePhaseSet(schedule, workspace);
            found += workspace.reason ? 0 : 1;
        }
    }
    const long after = allocations;
    CHECK(after - before == 0);
    CHECK(found > 0);
}
