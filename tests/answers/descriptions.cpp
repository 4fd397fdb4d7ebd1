// Prints what is described of answers, as JSON: each record with its keys, and which record each
// command answers with. tools/describe makes schemas and stubs of it.

#include <iostream>
#include <nlohmann/json.hpp>

#include "atlas_answer.hpp"
#include "continuum_answer.hpp"
#include "exact_answer.hpp"
#include "forced_answer.hpp"
#include "harmonic_answer.hpp"
#include "modes_answer.hpp"
#include "question_answer.hpp"
#include "response_answer.hpp"
#include "scene_continuum_answer.hpp"
#include "scene_find_answer.hpp"
#include "scene_forced_answer.hpp"
#include "scene_harmonic_answer.hpp"
#include "scene_question_answer.hpp"
#include "scene_response_answer.hpp"
#include "scene_simulation_answer.hpp"
#include "simulation_answer.hpp"
#include "study_answer.hpp"
#include "sweep_answer.hpp"

namespace signorini::answers {

namespace {

using Json = nlohmann::ordered_json;

/// The records that were met, by name.
Json& records()
{
    static Json all = Json::object();
    return all;
}

template <typename T>
Json typeOf();

/// Lists the keys of a record, and with them the records that they hold.
template <typename T>
struct Lister {
    std::string name = {};

    void record(const char* word, const char* sentence)
    {
        name = word;
        records()[name] = {{"sentence", sentence}, {"dictionary", isDictionary<T>}};
        records()[name]["keys"] = Json::array();
    }
    template <typename Get>
    void key(const char* word, const char* unit, const char* sentence, Get,
             When when = When::always)
    {
        constexpr std::array names{"always",    "found",   "none",   "any",
                                   "undecided", "program", "python", "attribute"};
        using Value = std::remove_cvref_t<std::invoke_result_t<Get, const T&>>;
        Json type = typeOf<Value>();
        if (mayBeLeftOut(when) && type.contains("optional")) {
            type = Json(type["optional"]);
        }
        records()[name]["keys"].push_back({{"name", word},
                                           {"unit", unit},
                                           {"sentence", sentence},
                                           {"when", names[static_cast<std::size_t>(when)]},
                                           {"type", type}});
    }
};

/// Reads the name of a record.
struct OnlyName {
    std::string name = {};
    void record(const char* word, const char*) { name = word; }
    template <typename... Words>
    void key(const Words&...)
    {
    }
};

template <typename T>
std::string nameOf()
{
    OnlyName asked;
    describe(asked, Type<T>());
    if (!records().contains(asked.name)) {
        Lister<T> lister;
        describe(lister, Type<T>());
    }
    return asked.name;
}

/// Of an enumeration: those that have a name.
template <typename Enum>
Json namesOf()
{
    constexpr int most = 32;
    Json list = Json::array();
    for (int k = 0; k < most; ++k) {
        try {
            if (const auto word = name(static_cast<Enum>(k)); !word.empty()) {
                list.push_back(word);
            }
        } catch (const std::logic_error&) {
            continue;
        }
    }
    return list;
}

template <typename... Ts>
Json typesOf(const std::tuple<Ts...>*)
{
    return Json::array({typeOf<Ts>()...});
}
template <typename... Ts>
Json typesOf(const std::variant<Ts...>*)
{
    return Json::array({typeOf<Ts>()...});
}

template <typename T>
Json typeOf()
{
    if constexpr (std::is_enum_v<T>) {
        return {{"enum", namesOf<T>()}};
    } else if constexpr (std::is_same_v<T, bool>) {
        return {{"json", "boolean"}};
    } else if constexpr (std::is_arithmetic_v<T>) {
        return {{"json", std::is_integral_v<T> ? "integer" : "number"}};
    } else if constexpr (std::is_convertible_v<T, std::string>) {
        return {{"json", "string"}};
    } else if constexpr (isA<T, std::reference_wrapper>) {
        return {{"answer", nameOf<std::remove_const_t<typename T::type>>()}};
    } else if constexpr (isA<T, std::optional>) {
        return {{"optional", typeOf<typename T::value_type>()}};
    } else if constexpr (isA<T, std::vector>) {
        return {{"list", typeOf<typename T::value_type>()}};
    } else if constexpr (isA<T, std::tuple>) {
        return {{"tuple", typesOf(static_cast<const T*>(nullptr))}};
    } else if constexpr (isA<T, std::variant>) {
        return {{"any", typesOf(static_cast<const T*>(nullptr))}};
    } else if constexpr (std::is_same_v<T, Schedule>) {
        return {{"schedule", typeOf<std::vector<Phase>>()}};
    } else if constexpr (Listed<T>) {
        return typeOf<std::remove_cvref_t<decltype(listed(std::declval<const T&>()))>>();
    } else {
        return {{"record", nameOf<T>()}};
    }
}

}  // namespace

}  // namespace signorini::answers

int main()
{
    using namespace signorini::answers;
    Json files{{"find", nameOf<FindAnswer>()},
               {"find-question", nameOf<QuestionAnswer>()},
               {"find-forced", nameOf<ForcedAnswer>()},
               {"find-scene", nameOf<SceneFindAnswer>()},
               {"find-scene-forced", nameOf<SceneForcedAnswer>()},
               {"find-scene-question", nameOf<SceneQuestionAnswer>()},
               {"continuum", nameOf<ContinuumAnswer>()},
               {"continuum-scene", nameOf<SceneContinuumAnswer>()},
               {"families", nameOf<FamilyList>()},
               {"modes", nameOf<ModeList>()},
               {"modes-phases", nameOf<PolytopeList>()},
               {"mode", nameOf<ModeAnswer>()},
               {"response", nameOf<ResponseAnswer>()},
               {"simulate", nameOf<SimulationAnswer>()},
               {"simulate-scene", nameOf<SceneSimulationAnswer>()},
               {"sweep", nameOf<SweepAnswer>()},
               {"atlas", nameOf<AtlasBuilt>()},
               {"atlas-query", nameOf<AtlasAnswer>()},
               {"find-harmonic", nameOf<HarmonicAnswer>()},
               {"find-harmonic-bars", nameOf<SceneHarmonicAnswer>()},
               {"response-bars", nameOf<SceneResponse>()},
               {"response-exact", nameOf<ExactAnswer>()},
               {"study", nameOf<StudyAnswer>()},
               {"simulate-reach", nameOf<ForceRange>()}};
    (void)nameOf<PolytopeAnswer>();  // of Python alone
    std::cout << Json{{"files", files}, {"records", records()}}.dump(1) << '\n';
}
