// The documents agree with what is there.

#include "command_line.hpp"

using namespace signorini;
using namespace signorini::test;

TEST_CASE("documents: every picture that a page shows is there")
{
    const fs::path root = SIGNORINI_SOURCE_DIR;
    std::vector<fs::path> pages{root / "README.md"};
    for (const fs::directory_entry& entry : fs::directory_iterator(root / "docs")) {
        if (entry.path().extension() == ".md") {
            pages.push_back(entry.path());
        }
    }
    int pictures = 0;
    for (const fs::path& page : pages) {
        const std::string text = contentOf(page);
        // ![words](path)
        for (std::size_t at = text.find("!["); at != std::string::npos; at = text.find("![", at)) {
            const std::size_t begin = text.find("](", at) + 2;
            at = text.find(')', begin);
            REQUIRE(at != std::string::npos);
            const std::string picture = text.substr(begin, at - begin);
            if (picture.rfind("octave/", 0) == 0) {
                continue;  // drawn when the site is built
            }
            INFO(page << " shows " << picture);
            CHECK(fs::exists(page.parent_path() / picture));
            ++pictures;
        }
    }
    CHECK(pictures > 5);
}
