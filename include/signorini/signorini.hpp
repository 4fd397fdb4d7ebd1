#pragma once
/// \file
/// Everything a user of the library needs, in the order in which data flows.

#include "signorini/amplitude_set.hpp"
#include "signorini/bar.hpp"
#include "signorini/certificate.hpp"
#include "signorini/closed_form.hpp"
#include "signorini/config.hpp"
#include "signorini/equations.hpp"
#include "signorini/figure.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/formulation.hpp"
#include "signorini/motion.hpp"
#include "signorini/output.hpp"
#include "signorini/program.hpp"
#include "signorini/propagation.hpp"
#include "signorini/reduction.hpp"
#include "signorini/schedule.hpp"
#include "signorini/solver.hpp"
#include "signorini/state.hpp"
#include "signorini/verification.hpp"
