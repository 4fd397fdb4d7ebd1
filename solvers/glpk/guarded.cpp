#include "glpk/guarded.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdlib>
#include <cstring>
#include <memory_resource>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string_view>

/// GMP under GLPK's exact method ends the process as well. Its documented functions, under the
/// names that gmp.h gives them; weak, because a GLPK without GMP brings none.
extern "C" {
// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming)
using GmpAllocate = void* (*)(std::size_t);
using GmpReallocate = void* (*)(void*, std::size_t, std::size_t);
using GmpFree = void (*)(void*, std::size_t);
[[gnu::weak]] void* __gmp_default_allocate(std::size_t size);
[[gnu::weak]] void __gmp_get_memory_functions(GmpAllocate*, GmpReallocate*, GmpFree*);
[[gnu::weak]] void __gmp_set_memory_functions(GmpAllocate, GmpReallocate, GmpFree);
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)
}

namespace signorini::glpk {

namespace {

/// Where to go on when GLPK gives up, and its words. Plain data: it lives across the jump.
struct Rescue {
    std::jmp_buf place;
    std::array<char, 400> words;
    std::size_t size;
    const Cancel* cancel;
    std::pmr::memory_resource* numbers;  ///< where GMP's come from during the call
    int blocks;                          ///< of GMP, since the last look at `cancel`
    bool isCancelled;
};

/// Keeps the last words.
void keep(Rescue& rescue, const char* text)
{
    if (rescue.size + std::string_view(text).size() >= rescue.words.size()) {
        rescue.size = 0;
    }
    for (; *text != '\0' && rescue.size + 1 < rescue.words.size(); ++text) {
        rescue.words[rescue.size++] = *text == '\n' ? ' ' : *text;
    }
    rescue.words[rescue.size] = '\0';
}

extern "C" void leave(void* data)
{
    std::longjmp(static_cast<Rescue*>(data)->place, 1);  // NOLINT(cert-err52-cpp): see the header
}

/// Of the call of this thread that is under way.
thread_local Rescue* current = nullptr;

void leaveIfCancelled(Rescue& rescue)
{
    if (rescue.cancel == nullptr) {
        return;
    }
    current = nullptr;  // what the caller's function does is not of this call
    rescue.isCancelled = isRequested(*rescue.cancel);
    current = &rescue;
    if (rescue.isCancelled) {
        leave(&rescue);
    }
}

/// GLPK speaks of errors, and while it works if there is somebody who may want it to end.
extern "C" int hearGlpk(void* data, const char* text)
{
    Rescue& rescue = *static_cast<Rescue*>(data);
    keep(rescue, text);
    leaveIfCancelled(rescue);
    return 1;  // nothing goes to the terminal
}

/// GMP's own way, but for a call of ours.
[[noreturn]] void endGmp()
{
    if (current != nullptr) {
        keep(*current, "GMP: no memory");
        leave(current);
    }
    std::abort();
}

/// Memory of the call under way: GLPK holds rationals only while its exact method runs, so those
/// that a jump leaves behind go with the call. Null if there is none.
void* allocateForCall(std::size_t size)
{
    try {
        return current->numbers->allocate(size);
    } catch (const std::bad_alloc&) {
        return nullptr;  // a jump out of the handler would leave the exception behind
    }
}

/// GLPK's exact method says nothing for seconds; blocks for its rationals are asked for all the
/// time.
extern "C" void* allocateForGmp(std::size_t size)
{
    constexpr int blocksOfALook = 4096;
    if (current != nullptr && ++current->blocks == blocksOfALook) {
        current->blocks = 0;
        leaveIfCancelled(*current);
    }
    void* block = current != nullptr ? allocateForCall(size) : std::malloc(size);
    return block != nullptr ? block : (endGmp(), nullptr);
}

extern "C" void freeForGmp(void* block, std::size_t size)
{
    if (current != nullptr) {
        current->numbers->deallocate(block, size);
    } else {
        std::free(block);
    }
}

extern "C" void* reallocateForGmp(void* old, std::size_t oldSize, std::size_t size)
{
    void* block = current != nullptr ? allocateForCall(size) : std::realloc(old, size);
    if (block == nullptr) {
        endGmp();
    }
    if (current != nullptr) {
        std::memcpy(block, old, std::min(oldSize, size));
        freeForGmp(old, oldSize);
    }
    return block;
}

/// Outside of a call blocks still come from malloc and go to free, so it does not matter when this
/// happens. A program that has given GMP functions of its own keeps them.
void watchGmp()
{
    if (__gmp_default_allocate == nullptr || __gmp_get_memory_functions == nullptr ||
        __gmp_set_memory_functions == nullptr) {
        return;
    }
    GmpAllocate allocate = nullptr;
    __gmp_get_memory_functions(&allocate, nullptr, nullptr);
    if (allocate == __gmp_default_allocate) {
        __gmp_set_memory_functions(allocateForGmp, reallocateForGmp, freeForGmp);
    }
}

/// GLPK keeps an environment for each thread that calls it; this one goes with its thread.
struct Environment {
    Environment() = default;
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;
    ~Environment() { glp_free_env(); }
};

void setHooks(Rescue* rescue)
{
    [[maybe_unused]] static thread_local const Environment environment;
    static std::once_flag once;
    std::call_once(once, watchGmp);
    current = rescue;
    glp_term_hook(rescue == nullptr ? nullptr : hearGlpk, rescue);
    glp_error_hook(rescue == nullptr ? nullptr : leave, rescue);
}

/// False if GLPK gave up. Nothing in this frame changes between the two returns of setjmp.
bool comesBack(void (*call)(void*, glp_prob*), void* data, glp_prob* problem, Rescue& rescue)
{
    if (setjmp(rescue.place) != 0) {  // NOLINT(cert-err52-cpp): see the header
        return false;
    }
    call(data, problem);
    return true;
}

}  // namespace

Problem::Problem(const Cancel& cancel) : cancel_(cancel ? &cancel : nullptr)
{
    constexpr int outOfMemory = 2;
    if (const int code = glp_init_env(); code >= outOfMemory) {
        throw std::bad_alloc();
    }
    glp_term_out(GLP_OFF);
    int blocks = 0;
    glp_mem_usage(&blocks, nullptr, nullptr, nullptr);
    isAlone_ = blocks == 0;
    attempt([](void* data, glp_prob*) { *static_cast<glp_prob**>(data) = glp_create_prob(); },
            static_cast<void*>(&handle_));
}

Problem::~Problem()
{
    if (handle_ != nullptr) {
        glp_delete_prob(handle_);
    }
}

void Problem::attempt(void (*call)(void*, glp_prob*), void* data)
{
    std::pmr::unsynchronized_pool_resource numbers;
    Rescue rescue;
    rescue.size = 0;
    rescue.words[0] = '\0';
    rescue.cancel = cancel_;
    rescue.numbers = &numbers;
    rescue.blocks = 0;
    rescue.isCancelled = false;
    setHooks(&rescue);
    glp_term_out(cancel_ != nullptr ? GLP_ON : GLP_OFF);
    const bool isDone = comesBack(call, data, handle_, rescue);
    setHooks(nullptr);
    glp_term_out(GLP_OFF);
    if (rescue.isCancelled) {
        freeAll();
        throw Cancelled();
    }
    if (!isDone) {
        giveUp(rescue.words.data());
    }
}

void Problem::freeAll()
{
    handle_ = nullptr;  // GLPK's manual: after an error nothing of the environment may be used
    if (isAlone_) {
        glp_free_env();
    }
}

void Problem::giveUp(const char* words)
{
    freeAll();
    const std::string_view text = words;
    const auto says = [text](std::string_view part) {
        return text.find(part) != std::string_view::npos;
    };
    if (says("memory") || says("block too large")) {
        throw std::bad_alloc();
    }
    throw std::runtime_error(fmt::format("GLPK gave up: {}", text));
}

}  // namespace signorini::glpk
