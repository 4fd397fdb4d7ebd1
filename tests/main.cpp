// Catch2 v2 needs a main of ours; v3 brings its own (see CMakeLists.txt).
#define CATCH_CONFIG_MAIN
#include "catch.hpp"
