// The same answers from a program: a question a line in, a digest a line out, to compare with those
// of the browser. With a word after its name it prints the JSON as well.

#include <cstdio>
#include <iostream>
#include <string>

#include "bridge.hpp"

int main(int count, char**)
{
    for (std::string question; std::getline(std::cin, question);) {
        const signorini::web::Reply reply = signorini::web::answer(question);
        std::cout << reply.digest();
        if (count > 1) {
            std::cout << ' ' << reply.json.dump();
            for (const double value : reply.numbers()) {
                std::printf(" %a", value);
            }
        }
        std::cout << '\n';
    }
    return 0;
}
