#include "cvode_scheme.hpp"

#include "solver.hpp"

#if SIGNORINI_HAS_CVODE
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_band.h>
#include <sunmatrix/sunmatrix_band.h>

#include <algorithm>
#include <stdexcept>

#include "elements.hpp"
#endif

namespace signorini::bench {

#if SIGNORINI_HAS_CVODE

namespace {

constexpr double relativeTolerance = 1e-6;
constexpr double absoluteTolerance = 1e-9;
constexpr long mostSteps = 1'000'000;

void require(int code, const char* what)
{
    if (code < 0) {
        throw std::runtime_error(std::string("CVODE: ") + what + ": " + std::to_string(code));
    }
}

/// Unknowns u_0, v_0, u_1, v_1, ..., and the impulse of the wall.
class Cvode final : public Scheme {
public:
    Cvode(const MarchedBar& bar, int elements)
        : model_(bar, elements, Mass::lumped), penalty_(penaltyOf(elements))
    {
        const auto unknowns = static_cast<sunindextype>(2 * model_.u.size() + 1);
        require(SUNContext_Create(nullptr, &context_), "context");
        y_ = N_VNew_Serial(unknowns, context_);
        put();
        memory_ = CVodeCreate(CV_BDF, context_);
        require(CVodeInit(memory_, derivatives, 0.0, y_), "start");
        require(CVodeSStolerances(memory_, relativeTolerance, absoluteTolerance), "tolerances");
        require(CVodeSetUserData(memory_, this), "user data");
        require(CVodeSetMaxNumSteps(memory_, mostSteps), "steps");
        require(CVodeRootInit(memory_, 1, distance), "events");
        matrix_ = SUNBandMatrix(unknowns, 1, 3, context_);
        solver_ = SUNLinSol_Band(y_, matrix_, context_);
        require(CVodeSetLinearSolver(memory_, solver_, matrix_), "linear solver");
    }
    Cvode(const Cvode&) = delete;
    Cvode& operator=(const Cvode&) = delete;
    ~Cvode() override
    {
        CVodeFree(&memory_);
        SUNLinSolFree(solver_);
        SUNMatDestroy(matrix_);
        N_VDestroy(y_);
        SUNContext_Free(&context_);
    }

    void step(double time, double h) override
    {
        const double before = impulse();
        double now = time;
        while (now < time + h) {
            const int code = CVode(memory_, time + h, y_, &now, CV_NORMAL);
            require(code, "step");
            if (code == CV_ROOT_RETURN) {
                require(CVodeReInit(memory_, now, y_), "new start");
            }
        }
        take(model_, y_);
        force_ = (impulse() - before) / h;
    }

    [[nodiscard]] double tip() const override { return model_.tip(); }
    [[nodiscard]] double force() const override { return force_; }
    [[nodiscard]] double energy() const override
    {
        const double depth = std::max(0.0, model_.tip() - model_.bar.wall);
        return model_.energy() + 0.5 * penalty_ * depth * depth;
    }

private:
    using Strided = Eigen::Map<Eigen::VectorXd, 0, Eigen::InnerStride<2>>;

    [[nodiscard]] double impulse() const { return N_VGetArrayPointer(y_)[2 * model_.u.size()]; }

    void put()
    {
        double* const y = N_VGetArrayPointer(y_);
        Strided(y, model_.u.size()) = model_.u;
        Strided(y + 1, model_.v.size()) = model_.v;
        y[2 * model_.u.size()] = 0.0;
    }

    static void take(ElementModel& model, N_Vector y)
    {
        double* const values = N_VGetArrayPointer(y);
        model.u = Strided(values, model.u.size());
        model.v = Strided(values + 1, model.v.size());
    }

    static int derivatives(double time, N_Vector y, N_Vector rate, void* self)
    {
        auto& own = *static_cast<Cvode*>(self);
        ElementModel& model = own.model_;
        take(model, y);
        const double reaction = own.penalty_ * std::max(0.0, model.tip() - model.bar.wall);
        Eigen::VectorXd pull = model.pull(model.u, model.v, time);
        pull[model.last()] -= reaction;
        double* const values = N_VGetArrayPointer(rate);
        Strided(values, model.u.size()) = model.v;
        Strided(values + 1, model.u.size()) = pull.cwiseQuotient(model.mass.diagonal);
        values[2 * model.u.size()] = reaction;
        return 0;
    }

    static int distance(double /*time*/, N_Vector y, double* value, void* self)
    {
        const ElementModel& model = static_cast<Cvode*>(self)->model_;
        *value = model.bar.wall - N_VGetArrayPointer(y)[2 * model.last()];
        return 0;
    }

    ElementModel model_;
    double penalty_;
    double force_ = 0.0;
    SUNContext context_ = nullptr;
    N_Vector y_ = nullptr;
    void* memory_ = nullptr;
    SUNMatrix matrix_ = nullptr;
    SUNLinearSolver solver_ = nullptr;
};

}  // namespace

std::unique_ptr<Scheme> cvodeScheme(const MarchedBar& bar, int elements)
{
    return std::make_unique<Cvode>(bar, elements);
}

#else

std::unique_ptr<Scheme> cvodeScheme(const MarchedBar& /*bar*/, int /*elements*/)
{
    throw BackendUnavailable("this build does not contain CVODE: install libsundials-dev");
}

#endif

}  // namespace signorini::bench
