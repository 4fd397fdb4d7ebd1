// State files as others write them: what is not a whole, clear table is refused.

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "catch.hpp"
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
    [[nodiscard]] State state() const { return readStateCsv(path_, Bar{}, 100); }

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
    CHECK_THROWS_AS(readStateCsv("/", Bar{}), FileError);
    CHECK_THROWS_AS(readStateCsv("/no/such/file.csv", Bar{}), FileError);
    CHECK_THROWS_WITH(readStateCsv("/dev/null", Bar{}), containsText("a regular file or a pipe"));
}
