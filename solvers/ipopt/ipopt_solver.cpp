#include <fmt/format.h>
#include <sys/mman.h>

#include <IpIpoptApplication.hpp>
#include <IpJournalist.hpp>
#include <IpSolveStatistics.hpp>
#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <mutex>
#include <new>
#include <thread>

#include "common/condensed.hpp"
#include "common/meaning.hpp"
#include "ipopt/ipopt.hpp"
#include "ipopt/program_nlp.hpp"
#include "stopwatch.hpp"

namespace signorini::ipopt {

namespace {

/// Optimality error aimed at, and the one that will do where rounding ends the search earlier:
/// minima of quadratic programs then agree with the exact ones to 1e-8.
constexpr double optimality = 1e-9;
constexpr double acceptableOptimality = 1e-8;
/// Ipopt's measure of a row is absolute, ours relative, and a bound may be relaxed on top.
constexpr double violationShare = 0.1;
/// Bounds are relaxed by this share of the tolerance: grazing schedules leave no interior without
/// it, and a tenth of Ipopt's own 1e-8 keeps minima of linear programs within 1e-6.
constexpr double relaxationShare = 0.01;
/// How MUMPS orders rows. Its own choice is Scotch, up to six times as fast on the state
/// formulation; but Scotch crashes when memory is short, where this one reports it.
constexpr int quasiDenseMinimumDegree = 6;
/// What Scotch is given room for: memory for each entry of the program, about four times what was
/// measured, and for each thread that it starts a stack and the address space malloc takes for it.
constexpr std::size_t bytesPerEntry = 1024;
constexpr std::size_t bytesPerThread = 144 << 20;
/// How far a given start is pushed off its bounds: far enough to have an interior, near enough to
/// be worth having.
constexpr double startPush = 1e-6;
/// Barrier parameter of a given start; a cold one begins at 0.1.
constexpr double startBarrier = 1e-4;

class Settings {
public:
    explicit Settings(Ipopt::IpoptApplication& application) : options_(*application.Options()) {}

    void set(const char* option, const char* value)
    {
        require(options_.SetStringValue(option, value), option);
    }
    void set(const char* option, double value)
    {
        require(options_.SetNumericValue(option, value), option);
    }
    void set(const char* option, int value)
    {
        require(options_.SetIntegerValue(option, value), option);
    }

private:
    /// Ipopt answers an unknown option or a value out of range with false, and goes on.
    static void require(bool accepted, const char* option)
    {
        if (!accepted) {
            throw std::logic_error(fmt::format("Ipopt does not accept the option {}", option));
        }
    }

    Ipopt::OptionsList& options_;
};

/// Could this process, under its limits, still take what Scotch may need? Address space is taken
/// and given back, no memory touched.
bool hasRoomForScotch(const Program& program)
{
    const auto entries = static_cast<std::size_t>(
        program.equalities.nonZeros() + program.inequalities.nonZeros() + 2 * program.variables() +
        program.equalities.rows() + program.inequalities.rows());
    const std::size_t threads = std::max(1U, std::thread::hardware_concurrency());
    const std::size_t bytes = bytesPerEntry * entries + bytesPerThread * threads;
    void* room =
        mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    return room != MAP_FAILED && munmap(room, bytes) == 0;
}

void configure(Ipopt::IpoptApplication& application, const Program& program,
               const SolverOptions& options)
{
    Settings settings(application);
    settings.set("print_level", 0);
    settings.set("sb", "yes");
    settings.set("tol", std::min(optimality, violationShare * options.tolerance));
    settings.set("constr_viol_tol", violationShare * options.tolerance);
    settings.set("bound_relax_factor", relaxationShare * std::min(options.tolerance, 1e-7));
    settings.set("acceptable_tol", std::min(acceptableOptimality, options.tolerance));
    settings.set("acceptable_constr_viol_tol", violationShare * options.tolerance);
    settings.set("acceptable_iter", 0);  // only when nothing better can be had
    if (!hasRoomForScotch(program)) {
        settings.set("mumps_pivot_order", quasiDenseMinimumDegree);
    }
    settings.set("jac_d_constant", "yes");
    settings.set("jac_c_constant", program.energy ? "no" : "yes");
    settings.set("hessian_constant", program.energy ? "no" : "yes");
    const auto most = static_cast<std::int64_t>(std::numeric_limits<int>::max());
    settings.set("max_iter", static_cast<int>(options.iterationLimit > 0
                                                  ? std::min(options.iterationLimit, most)
                                                  : most));
    if (options.start) {
        settings.set("bound_push", startPush);
        settings.set("bound_frac", startPush);
        settings.set("slack_bound_push", startPush);
        settings.set("slack_bound_frac", startPush);
        settings.set("mu_init", startBarrier);
    }
}

/// Every status of Ipopt but User_Requested_Stop, which is ours.
constexpr auto statuses = std::to_array<Meaning>({
    {Ipopt::Solve_Succeeded, SolverStatus::optimal, "Solve_Succeeded"},
    {Ipopt::Solved_To_Acceptable_Level, SolverStatus::optimal,
     "Solved_To_Acceptable_Level: to 1e-8"},
    {Ipopt::Infeasible_Problem_Detected, SolverStatus::failed,
     "Infeasible_Problem_Detected: no better point nearby, which proves nothing"},
    {Ipopt::Search_Direction_Becomes_Too_Small, SolverStatus::failed,
     "Search_Direction_Becomes_Too_Small"},
    {Ipopt::Diverging_Iterates, SolverStatus::failed,
     "Diverging_Iterates: the program may be unbounded"},
    {Ipopt::Feasible_Point_Found, SolverStatus::optimal,
     "Feasible_Point_Found: as many rows as variables"},
    {Ipopt::Maximum_Iterations_Exceeded, SolverStatus::limit, "Maximum_Iterations_Exceeded"},
    {Ipopt::Restoration_Failed, SolverStatus::failed, "Restoration_Failed"},
    {Ipopt::Error_In_Step_Computation, SolverStatus::failed, "Error_In_Step_Computation"},
    {Ipopt::Maximum_CpuTime_Exceeded, SolverStatus::limit, "Maximum_CpuTime_Exceeded"},
    {Ipopt::Not_Enough_Degrees_Of_Freedom, SolverStatus::failed, "Not_Enough_Degrees_Of_Freedom"},
    {Ipopt::Invalid_Problem_Definition, SolverStatus::failed, "Invalid_Problem_Definition"},
    {Ipopt::Invalid_Option, SolverStatus::failed, "Invalid_Option"},
    {Ipopt::Invalid_Number_Detected, SolverStatus::failed, "Invalid_Number_Detected"},
    {Ipopt::Unrecoverable_Exception, SolverStatus::failed, "Unrecoverable_Exception"},
    {Ipopt::NonIpopt_Exception_Thrown, SolverStatus::failed, "NonIpopt_Exception_Thrown"},
    {Ipopt::Insufficient_Memory, SolverStatus::failed, "Insufficient_Memory"},
    {Ipopt::Internal_Error, SolverStatus::failed, "Internal_Error"},
});

/// `stop` says which limit it was.
Meaning meaningOf(Ipopt::ApplicationReturnStatus status, const Meaning& stop)
{
#if IPOPT_VERSION_MAJOR > 3 || IPOPT_VERSION_MINOR >= 14
    if (status == Ipopt::Maximum_WallTime_Exceeded) {
        return {status, SolverStatus::limit, "Maximum_WallTime_Exceeded"};
    }
#endif
    return status == Ipopt::User_Requested_Stop
               ? stop
               : signorini::meaningOf(status, statuses, "unknown status of Ipopt");
}

/// Hears that MUMPS was out of memory. Ipopt only says so in its journal, then tries other ways and
/// ends with a status that blames the program.
class MemoryListener final : public Ipopt::Journal {
public:
    MemoryListener() : Journal("memory", Ipopt::J_WARNING) {}

    [[nodiscard]] bool hasHeard() const { return hasHeard_; }

private:
    void PrintImpl(Ipopt::EJournalCategory, Ipopt::EJournalLevel, const char* text) override
    {
        hasHeard_ = hasHeard_ || std::strstr(text, "out of memory") != nullptr ||
                    std::strstr(text, "enough memory") != nullptr;
    }
    void PrintfImpl(Ipopt::EJournalCategory category, Ipopt::EJournalLevel level,
                    const char* format, va_list) override
    {
        PrintImpl(category, level, format);  // the words are in the format itself
    }
    void FlushBufferImpl() override {}

    bool hasHeard_ = false;
};

/// Zero, and for an energy equality a point that has this energy: there its gradient is not zero.
Eigen::VectorXd coldStart(const Program& program)
{
    Eigen::VectorXd start = Eigen::VectorXd::Zero(program.variables());
    if (program.energy) {
        start.setConstant(std::sqrt(program.energy->value / program.energy->weights.sum()));
    }
    return start;
}

class IpoptSolver final : public Solver {
public:
    using Solver::Solver;

private:
    [[nodiscard]] SolverResult run(const Program& program,
                                   const SolverOptions& options) const override
    {
        Stopwatch watch;
        const Condensed condensed = condense(program, options.tolerance);
        if (condensed.decided) {
            return *condensed.decided;
        }
        // MUMPS keeps state of its own that threads would share.
        static std::mutex oneAtATime;
        const std::lock_guard lock(oneAtATime);

        Meaning stop{Ipopt::User_Requested_Stop, SolverStatus::failed, "User_Requested_Stop"};
        const auto goOn = [&] {
            if (isRequested(options.cancel)) {
                stop = {Ipopt::User_Requested_Stop, SolverStatus::cancelled, "cancelled"};
                return false;
            }
            if (watch.seconds() > options.timeLimit) {
                stop = {Ipopt::User_Requested_Stop, SolverStatus::limit, "time limit"};
                return false;
            }
            return true;
        };
        const Ipopt::SmartPtr<ProgramNlp> nlp = new ProgramNlp(
            condensed.program,
            options.start ? condensed.restrict(*options.start) : coldStart(condensed.program),
            goOn);
        const Ipopt::SmartPtr<Ipopt::IpoptApplication> application =
            new Ipopt::IpoptApplication(false);
        application->RethrowNonIpoptException(true);
        const Ipopt::SmartPtr<MemoryListener> memory = new MemoryListener();
        application->Jnlst()->AddJournal(Ipopt::GetRawPtr(memory));
        configure(*application, condensed.program, options);

        SolverResult result;
        Meaning meaning = meaningOf(application->Initialize(std::string()), stop);
        result.setupSeconds = watch.seconds();
        if (meaning.status == SolverStatus::optimal) {
            const auto status = application->OptimizeTNLP(Ipopt::GetRawPtr(nlp));
            meaning = meaningOf(status, stop);
            if (status == Ipopt::Insufficient_Memory ||
                (meaning.status == SolverStatus::failed && memory->hasHeard())) {
                throw std::bad_alloc();
            }
        }
        result.solveSeconds = watch.seconds() - result.setupSeconds;
        meaning.enter(result);
        if (Ipopt::IsValid(application->Statistics())) {
            result.iterations = application->Statistics()->IterationCount();
        }
        if (nlp->point().size() > 0) {
            result.x = condensed.expand(nlp->point());
            if (result.status == SolverStatus::failed && !hasObjective(program) &&
                violation(program, result.x) <= violationShare * options.tolerance) {
                result.status = SolverStatus::optimal;
                result.detail += ", but the last point meets all rows, and there is no objective";
            }
        }
        return result;
    }
};

}  // namespace

std::string version()
{
    return IPOPT_VERSION;
}

std::unique_ptr<Solver> makeIpopt(const Backend& row)
{
    return std::make_unique<IpoptSolver>(row);
}

}  // namespace signorini::ipopt
