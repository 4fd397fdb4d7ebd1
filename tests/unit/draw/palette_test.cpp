// Colours as colour-blind readers see them, by matrices that stand here and nowhere else.

#include "palette.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "catch.hpp"
#include "signorini/figures.hpp"

using namespace signorini;

namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

struct Vision {
    const char* name;
    Matrix matrix;
};

/// Machado, Oliveira, Fernandes (2009), severity 1, on linear RGB.
constexpr std::array visions{Vision{"usual", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
                             Vision{"protanopia",
                                    {{{0.152286, 1.052583, -0.204868},
                                      {0.114503, 0.786281, 0.099216},
                                      {-0.003882, -0.048116, 1.051998}}}},
                             Vision{"deuteranopia",
                                    {{{0.367322, 0.860646, -0.227968},
                                      {0.280085, 0.672501, 0.047413},
                                      {-0.011820, 0.042940, 0.968881}}}},
                             Vision{"tritanopia",
                                    {{{1.255528, -0.076749, -0.178779},
                                      {-0.078411, 0.930809, 0.147602},
                                      {0.004733, 0.691367, 0.303900}}}}};

Triple product(const Matrix& matrix, const Triple& x)
{
    Triple y{};
    for (std::size_t i = 0; i < 3; ++i) {
        y.at(i) = matrix.at(i)[0] * x[0] + matrix.at(i)[1] * x[1] + matrix.at(i)[2] * x[2];
    }
    return y;
}

Triple linear(const std::string& hex)
{
    Triple rgb{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double value = static_cast<double>(std::stoi(hex.substr(1 + 2 * i, 2), nullptr, 16));
        const double x = value / 255.0;
        rgb.at(i) = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    }
    return rgb;
}

/// CIE L*a*b*, white point D65.
Triple lab(const std::string& hex, const Vision& vision)
{
    Triple rgb = product(vision.matrix, linear(hex));
    for (double& value : rgb) {
        value = std::clamp(value, 0.0, 1.0);
    }
    constexpr Matrix toXyz{{{0.4124564, 0.3575761, 0.1804375},
                            {0.2126729, 0.7151522, 0.0721750},
                            {0.0193339, 0.1191920, 0.9503041}}};
    const Triple xyz = product(toXyz, rgb);
    const auto f = [](double t) {
        return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
    };
    const double x = f(xyz[0] / 0.95047);
    const double y = f(xyz[1]);
    const double z = f(xyz[2] / 1.08883);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

/// Delta E of 1976: 2.3 is just noticeable side by side.
double distance(const std::string& one, const std::string& other, const Vision& vision)
{
    const Triple x = lab(one, vision);
    const Triple y = lab(other, vision);
    return std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
}

/// Steps of a map are apart, and each is lighter than the one before, for everybody.
template <typename Map>
void checkMap(const Map& map, double least)
{
    for (const Vision& vision : visions) {
        for (std::size_t k = 1; k < map.size(); ++k) {
            INFO(vision.name << ": " << map.at(k - 1) << " " << map.at(k));
            CHECK(distance(map.at(k - 1), map.at(k), vision) > least);
            CHECK(lab(map.at(k), vision)[0] > lab(map.at(k - 1), vision)[0] + 5.0);
        }
    }
}

/// Every colour named in an SVG picture.
std::set<std::string> coloursOf(const std::string& svg)
{
    std::set<std::string> colours;
    for (auto at = svg.find("rgb("); at != std::string::npos; at = svg.find("rgb(", at + 1)) {
        std::array<int, 3> rgb{};
        if (std::sscanf(svg.c_str() + at, "rgb(%d,%d,%d)", rgb.data(), &rgb[1], &rgb[2]) == 3) {
            std::array<char, 8> hex{};
            (void)std::snprintf(
                hex.data(), hex.size(), "#%02x%02x%02x", static_cast<unsigned>(rgb[0]) & 255U,
                static_cast<unsigned>(rgb[1]) & 255U, static_cast<unsigned>(rgb[2]) & 255U);
            colours.insert(hex.data());
        }
    }
    return colours;
}

}  // namespace

TEST_CASE("palette: a green and a pink that merge for many are told to be near")
{
    CHECK(distance("#009e73", "#cc79a7", visions[0]) > 60.0);
    CHECK(distance("#009e73", "#cc79a7", visions[2]) < 20.0);
}

TEST_CASE("palette: any two colours, and white, stay apart for colour-blind readers")
{
    std::vector<std::string> colours(palette::all.begin(), palette::all.end());
    colours.emplace_back("#ffffff");
    for (const Vision& vision : visions) {
        for (std::size_t i = 0; i < colours.size(); ++i) {
            for (std::size_t k = 0; k < i; ++k) {
                INFO(vision.name << ": " << colours[i] << " " << colours[k]);
                CHECK(distance(colours[i], colours[k], vision) > 24.0);
            }
        }
    }
}

TEST_CASE("palette: maps grow lighter step by step, for everybody")
{
    checkMap(palette::sequence, 8.0);
    checkMap(palette::fading, 8.0);
}

TEST_CASE("palette: compression, nothing and tension stay apart for everybody")
{
    for (const Vision& vision : visions) {
        INFO(vision.name);
        CHECK(distance(palette::diverging[0], palette::diverging[1], vision) > 24.0);
        CHECK(distance(palette::diverging[1], palette::diverging[2], vision) > 24.0);
        CHECK(distance(palette::diverging[2], palette::diverging[0], vision) > 24.0);
    }
}

TEST_CASE("palette: the frequency-energy figure has no colour from elsewhere")
{
    const std::string path =
        (std::filesystem::temp_directory_path() / (std::to_string(getpid()) + "palette.svg"))
            .string();
    const std::vector<Mode> modes = findModes();
    const std::vector<Family> families = findFamilies(60);
    const std::vector<EnergyBar> bars{{8.0 / 7.0, 4.0, 600.0, Contact::pressing},
                                      {1.0, 1.0, 2.0, Contact::grazing}};
    drawFigure(frequencyEnergyFigure(
                   {.modes = modes, .families = families, .onGrid = families, .bars = bars}),
               FigureFormat::svg, path);
    std::ifstream file(path, std::ios::binary);
    const std::string svg{std::istreambuf_iterator<char>(file), {}};
    std::filesystem::remove(path);
    std::set<std::string> known(palette::all.begin(), palette::all.end());
    known.insert(palette::fading.begin(), palette::fading.end());
    known.insert({palette::grid, "#ffffff"});
    const std::set<std::string> used = coloursOf(svg);
    CHECK(used.contains(palette::contact));
    CHECK(used.contains(palette::fading[3]));
    for (const std::string& colour : used) {
        INFO(colour);
        CHECK(known.contains(colour));
    }
}
