// The peers of the benchmarks: general integrators, each with its own way to find an impact. All follow the
// same motion to the same tolerance and ask energy when the pulse is over; GSL, if it is to, as early as the
// kernels do. A block that an impact leaves slow they take for safe.
#pragma once

#include <gsl/gsl_odeiv2.h>

#include <boost/numeric/odeint.hpp>

#include "peer_motion.hpp"

#ifdef REDERIVE_SUNDIALS
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>
#endif

namespace rederive::benchmarks {

/// GSL's eighth-order Prince-Dormand; an impact by Newton's iteration on the step that crossed, taken again.
class Gsl : public Integrator {
 public:
  Gsl(double alpha, double tolerance)
      : step_(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, 2)),
        control_(gsl_odeiv2_control_y_new(alpha * tolerance, tolerance)),
        evolve_(gsl_odeiv2_evolve_alloc(2)) {}
  Gsl(const Gsl&) = delete;
  ~Gsl() override {
    gsl_odeiv2_evolve_free(evolve_), gsl_odeiv2_control_free(control_), gsl_odeiv2_step_free(step_);
  }

  void follow(const Motion& motion, double& t, State& y, double end) override {
    const auto rates = [](double time, const double state[], double rate[], void* self) {
      static_cast<const Motion*>(self)->rates(time, state, rate);
      return 0;
    };
    gsl_odeiv2_system system{rates, nullptr, 2, const_cast<Motion*>(&motion)};
    gsl_odeiv2_evolve_reset(evolve_), gsl_odeiv2_step_reset(step_);
    for (double h = 0.1; t < end;) {
      const double before = t;
      const State start = y;
      gsl_odeiv2_evolve_apply(evolve_, control_, step_, &system, &t, end, &h, y.data());
      if (motion.model == numerics::Model::nonlinear && motion.side * y[0] >= std::numbers::pi / 2) return;
      if (motion.side * y[0] > 0) {
        if (decides_early && early_code(motion, t, y, end)) return;
        continue;
      }
      double length = t - before, moved = 1, error[2];
      for (int i = 0; i < 20 && std::fabs(moved) > 1e-9 * length; ++i) {
        moved = -y[0] / y[1];
        length += moved;
        y = start;
        gsl_odeiv2_step_reset(step_);
        gsl_odeiv2_step_apply(step_, before, length, y.data(), error, nullptr, nullptr, &system);
      }
      t = before + length;
      return;
    }
  }

 private:
  gsl_odeiv2_step* step_;
  gsl_odeiv2_control* control_;
  gsl_odeiv2_evolve* evolve_;
};

/// Boost.odeint's fifth-order Dormand-Prince with dense output, on which an impact is found by Newton's
/// iteration.
class Odeint : public Integrator {
 public:
  Odeint(double alpha, double tolerance) : absolute_(alpha * tolerance), relative_(tolerance) {}

  void follow(const Motion& motion, double& t, State& y, double end) override {
    namespace odeint = boost::numeric::odeint;
    const auto rates = [&](const State& state, State& rate, double time) {
      motion.rates(time, state.data(), rate.data());
    };
    auto stepper = odeint::make_dense_output(absolute_, relative_, odeint::runge_kutta_dopri5<State>());
    stepper.initialize(y, t, std::min(0.01, end - t));
    while (true) {
      stepper.do_step(rates);
      t = std::min(end, stepper.current_time());
      stepper.calc_state(t, y);
      if (motion.model == numerics::Model::nonlinear && motion.side * y[0] >= std::numbers::pi / 2) return;
      if (motion.side * y[0] <= 0) break;
      if (t >= end) return;
    }
    for (int i = 0; i < 20; ++i) {
      const double moved = -y[0] / y[1];
      t = std::min(t + moved, end);
      stepper.calc_state(t, y);
      if (std::fabs(moved) < 1e-10) break;
    }
  }

 private:
  double absolute_, relative_;
};

/// Equations (56) by the classical fourth-order method with steps of its own size, as fast as may be: no
/// control of the step, ground from a rotation, cubic interpolation of an impact.
class LinearRungeKutta : public Integrator {
 public:
  explicit LinearRungeKutta(double step) : step_(step) {}

  void follow(const Motion& m, double& t, State& y, double end) override {
    const int count = std::max(1, static_cast<int>(std::ceil((end - t) / (step_ / std::max(1.0, m.omega)))));
    const double h = (end - t) / count, s = std::sin(m.omega * h / 2), c = std::cos(m.omega * h / 2);
    double sine = m.amplitude * std::sin(m.omega * t + m.psi),
           cosine = m.amplitude * std::cos(m.omega * t + m.psi);
    const double rest = m.side * m.alpha;
    for (int i = 0; i < count; ++i) {
      const double middle = sine * c + cosine * s, middle_cosine = cosine * c - sine * s,
                   last = middle * c + middle_cosine * s, last_cosine = middle_cosine * c - middle * s;
      const double a1 = y[0] - rest - sine, v2 = y[1] + h / 2 * a1, a2 = y[0] + h / 2 * y[1] - rest - middle,
                   v3 = y[1] + h / 2 * a2, a3 = y[0] + h / 2 * v2 - rest - middle, v4 = y[1] + h * a3,
                   a4 = y[0] + h * v3 - rest - last;
      const State before = y;
      y = {y[0] + h / 6 * (y[1] + 2 * v2 + 2 * v3 + v4), y[1] + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)};
      sine = last, cosine = last_cosine;
      if (m.side * y[0] <= 0) {
        impact(before, y, t, h);
        return;
      }
      t += h;
    }
    t = end;
  }

 private:
  /// The zero of the cubic through both ends of the step, by Newton's iteration.
  static void impact(const State& from, State& y, double& t, double h) {
    const double d = y[0] - from[0], c2 = 3 * d - h * (2 * from[1] + y[1]), c3 = h * (from[1] + y[1]) - 2 * d;
    double x = 1;
    for (int i = 0; i < 8; ++i)
      x -= (from[0] + x * (h * from[1] + x * (c2 + x * c3))) / (h * from[1] + x * (2 * c2 + 3 * x * c3));
    t += x * h;
    y[1] = (h * from[1] + x * (2 * c2 + 3 * x * c3)) / h;
  }

  double step_;
};

#ifdef REDERIVE_SUNDIALS
/// CVODE of SUNDIALS by Adams' methods, with its own root finding.
class Sundials : public Integrator {
 public:
  Sundials(double alpha, double tolerance) : absolute_(alpha * tolerance), relative_(tolerance) {
    SUNContext_Create(nullptr, &context_);
    y_ = N_VNew_Serial(2, context_);
  }
  Sundials(const Sundials&) = delete;
  ~Sundials() override {
    if (cvode_ != nullptr) CVodeFree(&cvode_);
    if (solver_ != nullptr) SUNNonlinSolFree(solver_);
    N_VDestroy(y_), SUNContext_Free(&context_);
  }

  void follow(const Motion& motion, double& t, State& y, double end) override {
    motion_ = motion;
    double* state = N_VGetArrayPointer(y_);
    state[0] = y[0], state[1] = y[1];
    const double start = t;
    integrate(start, t, end);
    y = {state[0], state[1]};
  }

 private:
  static int rates(double t, N_Vector y, N_Vector rate, void* self) {
    static_cast<Sundials*>(self)->motion_.rates(t, N_VGetArrayPointer(y), N_VGetArrayPointer(rate));
    return 0;
  }
  static int events(double, N_Vector y, double* g, void* self) {
    const double theta = N_VGetArrayPointer(y)[0];
    const Motion& motion = static_cast<Sundials*>(self)->motion_;
    g[0] = theta,
    g[1] = motion.model == numerics::Model::linear ? 1 : std::numbers::pi / 2 - motion.side * theta;
    return 0;
  }

  void integrate(double start, double& t, double end) {
    if (cvode_ == nullptr) {
      cvode_ = CVodeCreate(CV_ADAMS, context_);
      CVodeInit(cvode_, rates, start, y_);
      CVodeSStolerances(cvode_, relative_, absolute_);
      solver_ = SUNNonlinSol_FixedPoint(y_, 0, context_);
      CVodeSetNonlinearSolver(cvode_, solver_);
      CVodeSetUserData(cvode_, this), CVodeRootInit(cvode_, 2, events), CVodeSetNoInactiveRootWarn(cvode_);
      CVodeSetMaxNumSteps(cvode_, 1'000'000);
    }
    CVodeReInit(cvode_, start, y_), CVodeSetStopTime(cvode_, end);
    CVode(cvode_, end, y_, &t, CV_NORMAL);
  }

  double absolute_, relative_;
  SUNContext context_ = nullptr;
  N_Vector y_ = nullptr;
  void* cvode_ = nullptr;
  SUNNonlinearSolver solver_ = nullptr;
  Motion motion_{};
};
#endif

}  // namespace rederive::benchmarks
