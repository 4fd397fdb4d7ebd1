#pragma once
/// \file
/// Everything a user of the library needs.

#include "signorini/amplitude_set.hpp"
#include "signorini/atlas.hpp"
#include "signorini/atlas_database.hpp"
#include "signorini/bar.hpp"
#include "signorini/certificate.hpp"
#include "signorini/config.hpp"
#include "signorini/continuum.hpp"
#include "signorini/control.hpp"
#include "signorini/demands.hpp"
#include "signorini/figures.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/lumped_set.hpp"
#include "signorini/modes.hpp"
#include "signorini/motion.hpp"
#include "signorini/one_phase_set.hpp"
#include "signorini/output.hpp"
#include "signorini/response.hpp"
#include "signorini/schedule.hpp"
#include "signorini/simulation.hpp"
#include "signorini/verification.hpp"
