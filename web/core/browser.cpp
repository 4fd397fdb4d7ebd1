// What the browser calls: a question in, a length out; the reply stays until the next question.

#include <cstdint>
#include <string>

#include "bridge.hpp"

namespace {

signorini::web::Reply reply;
std::string text;

}  // namespace

extern "C" {

const char* signoriniAnswer(const char* question)
{
    reply = signorini::web::answer(question);
    text = signorini::cli::asLine(reply.json);
    return text.c_str();
}

const double* signoriniNumbers()
{
    return reply.numbers().data();
}

std::int32_t signoriniCount()
{
    return static_cast<std::int32_t>(reply.numbers().size());
}

const char* signoriniDigest()
{
    text = std::to_string(reply.digest());
    return text.c_str();
}
}
