// State files as others write them: what is not a whole, clear table is refused.

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "catch.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/one_phase_set.hpp"
#include "signorini/output.hpp"
#include "support.hpp"

using namespace signorini;

namespace {

/// A file that vanishes with the test.
class StateFile {
public:
    explicit StateFile(const std::string& text) { write(text); }
    StateFile(const StateFile&) = delete;
    StateFile& operator=(const StateFile&) = delete;
    ~StateFile() { std::filesystem::remove(path_); }

    void write(const std::string& text) const { std::ofstream(path_, std::ios::binary) << text; }
    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] State state() const { return readState(path_, Bar{}, 100).state; }

private:
    std::string path_ = (std::filesystem::temp_directory_path() /
                         ("signorini-state-" + std::to_string(getpid()) + ".csv"))
                            .string();
};

}  // namespace

TEST_CASE("state file: columns in any order, blanks around fields and foreign line ends are read")
{
    const double unit = scales(Bar{}).strain;
    for (const char* text : {"x,a,b\n0.5,1,-2\n1,3e-2,4\n", "b , note,\ta\n-2, word ,1\n4,,0.03 \n",
                             "a,b\r\n1,-2\r\n 3e-2 ,4\r\n"}) {
        INFO(text);
        const State state = StateFile(text).state();
        REQUIRE(state.cells() == 2);
        CHECK(state.a == Eigen::Vector2d(1.0 / unit, 0.03 / unit));
        CHECK(state.b == Eigen::Vector2d(-2.0 / unit, 4.0 / unit));
    }
}

TEST_CASE("state file: what is not one number per field is refused with line and column")
{
    struct Wrong {
        const char* text;
        const char* line;
        const char* fault;
    };
    for (const Wrong& wrong : {
             Wrong{"x,a,b\n1,2,3\n1,1 2,3\n", "line 3", "column a (field 2): '1 2'"},
             Wrong{"x,a,b\n1,2,3\n1,2,- 3\n", "line 3", "column b (field 3): '- 3'"},
             Wrong{"x,a,b\n1,2,\n", "line 2", "column b (field 3): ''"},
             Wrong{"x,a,b\n1,2,1.5.2\n", "line 2", "column b (field 3): '1.5.2'"},
             Wrong{"x,a,b\n1,2,inf\n", "line 2", "column b"},
             Wrong{"x,a,b\n0,5,1,5,2\n", "line 2", "field 4 is too many: allowed 3"},
             Wrong{"a,b\n1,2\n1,5,2\n", "line 3", "field 3 is too many: allowed 2"},
             Wrong{"x,a,b\n1,2,3,\n", "line 2", "field 4 is too many: allowed 3"},
             Wrong{"x,a,b\n1,2,3\n1,2\n", "line 3", "field 3 is missing: allowed 3"},
             Wrong{"a,b,x\n1,2,3\n1,2\n", "line 3", "field 3 is missing: allowed 3"},
             Wrong{"x,a,b\n1,2,3\n\n", "line 3", "field 2 is missing: allowed 3"},
             Wrong{"x,a,b\n1,2,3\n1,2,3", "line 3", "newline"},
             Wrong{"x,a,b", "line 1", "newline"},
             Wrong{"", "line 1", "no column a"},
             Wrong{"x,a\n1,2\n", "line 1", "no column b"},
             Wrong{"a,b,a\n1,2,3\n", "line 1", "more than one column a"},
             Wrong{"x,a,b\n", "", "no rows"},
             Wrong{"# x,a,b\n1,2,3\n", "line 2", "no column a"},
             Wrong{"a;b\n1,5;2\n", "line 2", "column a (field 1): '1,5'"},
             Wrong{"a;b\n1,2\n", "line 2", "field 2 is missing: allowed 2 fields"},
             Wrong{"a,b\n1,2#3\n", "line 2", "column b (field 2): '2#3'"},
             Wrong{"x,velocity\n0,1\n", "line 1", "no column strain"},
             Wrong{"x,v,v,s\n0,1,1,1\n", "line 1", "more than one column v"},
             Wrong{"x,velocity,strain\n0.5,1,2\n", "line 2", "one row"},
             Wrong{"x,v,velocity,s\n0,1,1,2\n1,1,1,2\n", "line 1", "velocity and v"},
             Wrong{"x,v,strain,s\n0,1,1,2\n1,1,1,2\n", "line 1", "strain and s"},
             Wrong{"x,v,u,displacement\n0,1,0,0\n1,1,1,2\n", "line 1", "displacement and u"},
             Wrong{"x,velocity,strain\n", "line 1", "no rows"},
             Wrong{"x,velocity,strain\n0,1,2\n1.1,1,2\n", "line 3", "column x (field 1): '1.1'"},
             Wrong{"x,velocity,strain\n-0.1,1,2\n1,1,2\n", "line 2", "column x"},
             Wrong{"x,v,u\n0.5,1,2\n0.5,1,2\n", "line 3", "ascend"},
             Wrong{"x,v,u\n0.2,1,2\n# gone\n0.5,1,x\n", "line 4", "column u (field 3): 'x'"},
             Wrong{"velocity,strain\n1,2\n1,2\n", "line 1", "no column a"},
         }) {
        const StateFile file(wrong.text);
        INFO(wrong.text);
        CHECK_THROWS_AS(file.state(), std::invalid_argument);
        CHECK_THROWS_WITH(file.state(), containsText(file.path()) && containsText(wrong.line) &&
                                            containsText(wrong.fault));
    }
}

TEST_CASE("state file: cut anywhere but between two rows it is refused")
{
    const StateFile file("");
    writeStateCsv(file.path(), test::randomState(4), Bar{});
    std::string whole;
    std::getline(std::ifstream(file.path()), whole, '\0');
    REQUIRE(whole.size() > 200);
    for (std::size_t length = 0; length < whole.size(); ++length) {
        const std::string part = whole.substr(0, length);
        const auto rows = std::count(part.begin(), part.end(), '\n') - 1;
        file.write(part);
        INFO(part);
        if (part.ends_with('\n') && rows > 0) {
            CHECK(file.state().cells() == rows);
        } else {
            CHECK_THROWS_AS(file.state(), std::invalid_argument);
        }
    }
}

TEST_CASE("state file: long lines, long fields and too many rows are refused in few words")
{
    const std::string digits(60'000, '1');
    const StateFile field("a,b\n1," + digits + "x\n");
    CHECK_THROWS_WITH(field.state(), containsText("line 2: column b (field 2): '1111"));
    try {
        (void)field.state();
    } catch (const std::invalid_argument& error) {
        CHECK(std::string(error.what()).size() < 300);
    }
    CHECK_THROWS_WITH(StateFile("a,b\n1," + digits + digits + "\n").state(),
                      containsText("line 2: allowed at most 65536 characters"));
    std::string rows = "a,b\n";
    for (int k = 0; k < 100; ++k) {
        rows += "1,2\n";
    }
    CHECK(StateFile(rows).state().cells() == 100);
    CHECK_THROWS_WITH(StateFile(rows + "1,2\n").state(),
                      containsText("line 102: allowed at most 100 rows"));
}

TEST_CASE("state file: folders, devices and missing files are no state files")
{
    CHECK_THROWS_AS(readState("/", Bar{}, 100), FileError);
    CHECK_THROWS_AS(readState("/no/such/file.csv", Bar{}, 100), FileError);
    CHECK_THROWS_WITH(readState("/dev/null", Bar{}, 100), containsText("a regular file or a pipe"));
}

TEST_CASE("state file: marks, comments, semicolons and foreign line ends are not data")
{
    const double unit = scales(Bar{}).strain;
    for (const char* text :
         {"\xef\xbb\xbfx;a;b\r\n0.5;1;-2\r\n1;3;4\r\n",
          "# measured on a Monday\na,b\n  # between\n1,-2\n#\n3,4\n# end, 1, 2, 3\n",
          "note;b;a\nx, y;-2;1\n;4;3\n"}) {
        INFO(text);
        const StateReading read = readState(StateFile(text).path(), Bar{}, 10);
        REQUIRE(read.rows == 2);
        CHECK(read.state.a == Eigen::Vector2d(1.0 / unit, 3.0 / unit));
        CHECK(read.state.b == Eigen::Vector2d(-2.0 / unit, 4.0 / unit));
    }
}

namespace {

constexpr Bar steel{2.0, 5000.0, 2e7, 1e-6};

/// A table of a state that was measured at some places, in SI units.
template <typename Velocity, typename Other>
std::string measured(const char* header, const std::vector<double>& places, Velocity velocity,
                     Other other)
{
    std::ostringstream text;
    text.precision(17);
    text << header << "\n";
    for (const double x : places) {
        text << x * steel.length << "," << velocity(x) << "," << other(x) << "\n";
    }
    return text.str();
}

std::vector<double> evenly(int count, double first, double last)
{
    std::vector<double> places;
    for (int k = 0; k < count; ++k) {
        places.push_back(first + (last - first) * k / (count - 1));
    }
    return places;
}

/// The largest error of velocity and strain on the cells, against means by the midpoint rule.
template <typename Velocity, typename Strain>
double errorOf(const State& state, Velocity v, Strain s)
{
    const Scales unit = scales(steel);
    constexpr int points = 1000;
    double worst = 0.0;
    const auto cells = static_cast<double>(state.cells());
    for (Eigen::Index i = 0; i < state.cells(); ++i) {
        double meanV = 0.0;
        double meanS = 0.0;
        for (int k = 0; k < points; ++k) {
            const double x = (static_cast<double>(i) + (k + 0.5) / points) / cells;
            meanV += v(x) / points;
            meanS += s(x) / points;
        }
        worst = std::max({worst, std::abs(velocity(state)[i] - meanV / unit.velocity),
                          std::abs(strain(state)[i] - meanS / unit.strain)});
    }
    return worst;
}

}  // namespace

TEST_CASE("state file: measurements of smooth fields come onto any grid with second order")
{
    const Scales unit = scales(steel);
    const auto v = [&](double x) { return unit.velocity * std::sin(3.0 * x); };
    const auto s = [&](double x) { return unit.strain * std::cos(5.0 * x); };
    const auto u = [&](double x) { return unit.displacement * std::sin(5.0 * x) / 5.0; };
    for (const int rows : {50, 200, 800}) {
        const std::vector<double> places = evenly(rows, 0.0, 1.0);
        const double bound = 25.0 / (rows * rows);  // h^2 f''/8 and some
        for (const std::int64_t cells : {7, 60, 300}) {
            INFO(rows << " rows, " << cells << " cells");
            const StateFile strains(measured("x,velocity,strain", places, v, s));
            const StateReading read = readState(strains.path(), steel, cells);
            CHECK(read.state.cells() == cells);
            CHECK(read.rows == rows);
            CHECK(errorOf(read.state, v, s) < bound);
            CHECK_THAT(read.how, containsText(rows > cells ? "averaged" : "interpolated"));
            // Means of the slope of the lines through u: of first order where cells are finer.
            const StateFile displacements(measured("x,v,u", places, v, u));
            CHECK(errorOf(readState(displacements.path(), steel, cells).state, v, s) <
                  bound + 3.0 / rows);
        }
    }
}

TEST_CASE("state file: velocity and strain as our own files have them are the state itself")
{
    const State state = test::randomState(9);
    const Eigen::VectorXd v = velocity(state) * scales(steel).velocity;
    const Eigen::VectorXd s = strain(state) * scales(steel).strain;
    const auto on = [](const Eigen::VectorXd& values) {
        return [&values](double x) { return values[std::lround(x * 9.0) - 1]; };
    };
    const StateFile file(measured("x,velocity,strain", evenly(9, 1.0 / 9.0, 1.0), on(v), on(s)));
    const StateReading read = readState(file.path(), steel, 9);
    CHECK_THAT(read.how, containsText("one per cell"));
    CHECK(amplitude({read.state.a - state.a, read.state.b - state.b}) < 1e-14 * amplitude(state));
    // The displacement at the ends of cells holds the strain, too.
    const Eigen::VectorXd u = displacement(state) * scales(steel).displacement;
    const StateFile ends(measured("x,velocity,u", evenly(9, 1.0 / 9.0, 1.0), on(v), on(u)));
    const State again = readState(ends.path(), steel, 9).state;
    CHECK(amplitude({again.a - state.a, again.b - state.b}) < 1e-12 * amplitude(state));
}

TEST_CASE("state file: many noisy measurements of a motion average out")
{
    const Schedule schedule = test::onePhase(20, 10, 60);
    const State motion = leastEnergyMotion(onePhaseSet(schedule));
    const Eigen::VectorXd v = velocity(motion) * scales(steel).velocity;
    const Eigen::VectorXd s = strain(motion) * scales(steel).strain;
    std::mt19937 generator(3);
    std::normal_distribution<double> noise(0.0, 0.3);
    const auto on = [&](const Eigen::VectorXd& values, double unit) {
        return [&values, &noise, &generator, unit](double x) {
            return values[std::min(19L, std::lround(std::floor(x * 20.0)))] +
                   unit * noise(generator);
        };
    };
    const StateFile file(measured("x,velocity,strain", evenly(20'000, 0.0, 1.0),
                                  on(v, scales(steel).velocity), on(s, scales(steel).strain)));
    const State read = readState(file.path(), steel, 20).state;
    // 1000 rows a cell: 0.3/sqrt(1000) = 0.0095, four times that, and rows at a jump.
    CHECK(amplitude({read.a - motion.a, read.b - motion.b}) < 0.045);
    FindOptions options;
    options.objective = Objective::nearest;
    options.target = read;
    const PeriodicResult nearest = findPeriodic(schedule, options);
    REQUIRE(nearest.motion);
    const State& found = nearest.motion->state;
    CHECK(energyRatio({found.a - motion.a, found.b - motion.b}) <
          energyRatio({read.a - motion.a, read.b - motion.b}));
}
