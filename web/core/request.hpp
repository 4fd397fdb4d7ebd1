#pragma once
/// \file
/// A question of the page, and the reply: JSON for what has names, and one array for all numbers
/// that are drawn.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "json.hpp"
#include "signorini/bar.hpp"
#include "signorini/schedule.hpp"

namespace signorini::web {

using cli::Json;

/// The bar of the page, that of the command line unless told otherwise: L = c = 1, g = 1 mm.
inline constexpr Bar bar{};

/// Values by name, with one line of text when they are wrong.
/// \throws std::invalid_argument naming value and allowed range.
class Request {
public:
    explicit Request(Json values) : values_(std::move(values)) {}

    [[nodiscard]] bool has(const char* name) const
    {
        return values_.contains(name) && !values_[name].is_null();
    }
    [[nodiscard]] std::int64_t whole(const char* name, std::int64_t low, std::int64_t high) const;
    [[nodiscard]] double number(const char* name, double low, double high) const;
    [[nodiscard]] std::optional<double> positive(const char* name) const;
    [[nodiscard]] std::string word(const char* name) const;
    [[nodiscard]] bool isOn(const char* name) const;
    /// "gap" [m] of any sign and "second_stop" [m], if they are not those of `bar`.
    [[nodiscard]] Scene scene() const;
    /// cells and phases, [[n_c, n_f], ...]; [n_c, n_f, "L"] touches the second stop.
    [[nodiscard]] Schedule schedule() const;
    /// [[a, b, c], ...], at most ten rows of whole numbers 0..high.
    [[nodiscard]] std::vector<std::array<std::int64_t, 3>> triples(const char* name,
                                                                   std::int64_t high) const;
    /// A list of numbers; none where it is missing.
    [[nodiscard]] std::vector<double> numbers(const char* name, double low, double high) const;
    [[nodiscard]] Request part(const char* name) const;
    /// The values as text, to see whether two questions are the same.
    [[nodiscard]] std::string key() const { return values_.dump(); }

private:
    [[nodiscard]] const Json& at(const char* name) const;

    Json values_;
};

/// \throws std::invalid_argument if the text is no JSON, or nested deeper than any question.
[[nodiscard]] Request requestOf(const std::string& question);

/// What is said and shown. "arrays" of the JSON tells where in `numbers` each array begins, and how
/// long it is.
class Reply {
public:
    Json json = Json::object();

    void add(const char* name, std::span<const double> values);
    [[nodiscard]] const std::vector<double>& numbers() const { return numbers_; }
    /// FNV-1a over the JSON and every bit of the numbers.
    [[nodiscard]] std::uint64_t digest() const;

private:
    std::vector<double> numbers_;
};

/// Cells that the page works on at most; a finer bar is a matter for the command line.
inline constexpr std::int64_t mostCells = 5000;

}  // namespace signorini::web
