#include "units.hpp"

#include <optional>
#include <string>

#include "catch.hpp"

using signorini::numberIn;

TEST_CASE("units: a power of ten moves the decimal point, and rounds once")
{
    CHECK(numberIn("0.1mm", "m") == 0.1e-3);
    CHECK(numberIn("0.3 µm", "m") == 0.3e-6);
    CHECK(numberIn("2.3e-1mm", "m") == 2.3e-4);
    CHECK(numberIn("1e+2GPa", "Pa") == 1e11);
    CHECK(numberIn("-7%", "-") == -0.07);
    CHECK(numberIn("0e999999999999kHz", "Hz").value_or(0.0) == 0.0);
    CHECK(numberIn("12", "Pa") == 12.0);
}

TEST_CASE("units: of another kind, without a number, too large: nothing")
{
    for (const char* text : {"", "%", " %", "mm", "2%%", "2  mm", "2mm ", "+2mm", "nanmm", "0x1mm",
                             "1e308GPa", "1e999GPa", "2GPa", "2kg", "1e", "1emm"}) {
        INFO(text);
        CHECK(numberIn(text, text == std::string("2%%") ? "-" : "m") == std::nullopt);
    }
    CHECK(numberIn("1e308GPa", "Pa") == std::nullopt);
}
