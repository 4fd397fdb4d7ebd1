// The documents agree with what is there.

#include <regex>

#include "program.hpp"

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
    const std::regex picture(R"(!\[[^\]]*\]\(([^):]+)\))");
    int pictures = 0;
    for (const fs::path& page : pages) {
        const std::string text = contentOf(page);
        for (std::sregex_iterator at(text.begin(), text.end(), picture), end; at != end; ++at) {
            INFO(page << " shows " << (*at)[1].str());
            CHECK(fs::exists(page.parent_path() / (*at)[1].str()));
            ++pictures;
        }
    }
    CHECK(pictures > 5);
}
