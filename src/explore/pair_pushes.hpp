#pragma once
/// \file
/// The pushes of two contacts in a period of a damped network, at any two of its contacts or twice
/// at the same one, one closed at a time.
///
/// Pushes R take S R from the rates v of the open network (growing_contact.hpp), v - S R = 0 where
/// a contact is closed, and W R from how far a distance has shrunk. The first contact is eliminated
/// step by step from all other rows; what is left of S for the second one, which begins in step s,
/// is factored row by row while it grows, L U R = v. That both distances are 0 where their contacts
/// begin is two equations, a point (C, S), at which pushes and distances are looked at one by one.
/// docs/theory.md, section 19.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "growing_contact.hpp"

namespace signorini {

class Directions;

class PairPushes {
public:
    /// Neither contact has a step yet. \param periods by contact, what each of them answers
    PairPushes(std::span<const ContactPeriod> periods, std::size_t first, std::size_t second);

    /// The first contact, from step 0, is one step longer. O(n^2).
    void growFirst();
    /// The second one begins in this step, and has none.
    void begin(std::int64_t start);
    /// One step more of it. O(n_2^2).
    void growSecond();

    /// Do conditions exclude each other, by more than rounding? O(n_2^2), and O(n n_c) for each
    /// contact where pushes do not. If not, there may be motions.
    [[nodiscard]] bool isRefuted() const;

private:
    /// Pushes and what they are in: numbers at a place, or forms in (C, S).
    template <typename Value>
    struct Pushed {
        std::vector<Value> first;   ///< from step 0
        std::vector<Value> second;  ///< from step `start_`
    };

    [[nodiscard]] std::size_t columnOf(std::int64_t step) const;  ///< of the second contact
    [[nodiscard]] double at(std::size_t row, std::size_t column) const
    {
        return matrix_[row * columns_ + column];
    }
    void addContact(std::size_t contact);
    void fillRow(std::size_t row, std::int64_t step, const std::array<std::vector<double>, 2>& by);
    void eliminate(std::size_t pivot);
    [[nodiscard]] std::size_t residueOf(bool isSecond, std::int64_t step) const;
    [[nodiscard]] double alone(bool isSecond) const;
    [[nodiscard]] double gapOf(std::size_t contact) const;
    /// \return do all pushes hold?
    template <typename Value>
    bool solve(Pushed<Value>& pushes, auto read, auto holds) const;
    template <typename Value>
    [[nodiscard]] Value taken(const std::array<std::vector<double>, 2>& by, std::int64_t step,
                              const Pushed<Value>& pushes) const;
    [[nodiscard]] bool isRefutedAt(Plane place) const;
    [[nodiscard]] bool isRefutedByDirections() const;
    [[nodiscard]] bool staysAway(const Pushed<Plane>& pushes, Directions& left) const;
    /// Of a row of a place, of the first contact or of the second one, and of a column.
    [[nodiscard]] double placeBy(std::size_t which, std::size_t column) const;
    [[nodiscard]] bool penetrates(const Pushed<Plane>& pushes, bool isSecond, std::int64_t from,
                                  std::int64_t to, Directions& left, bool& opens) const;

    std::span<const ContactPeriod> periods_;
    std::array<std::size_t, 2> contacts_;  ///< the first and the second
    bool isSame_;
    std::int64_t steps_;
    std::size_t columns_;
    /// By contact: its rates and places by pushes at the first contact and at the second one.
    std::vector<std::array<std::vector<double>, 2>> rates_;
    std::vector<std::array<std::vector<double>, 2>> ways_;
    std::vector<std::vector<Plane>> driven_;  ///< v by the drive alone, by contact and step
    std::vector<Plane> start_;                ///< shrunk by it at the beginning of step 0
    /// Rates of the columns, the place of the first contact, places of the second one.
    std::vector<double> matrix_;
    std::vector<Plane> right_;
    std::int64_t contact_ = 0;       ///< steps of the first contact
    std::vector<bool> heldByFirst_;  ///< residues with pushes that move nothing
    std::vector<bool> heldByBoth_;
    std::vector<bool> isFree_;  ///< steps of the first contact with such a push
    bool isFirstClear_ = true;
    bool isClear_ = true;
    std::int64_t begin_ = 0;                       ///< of the second contact
    std::int64_t second_ = 0;                      ///< its steps
    std::vector<std::size_t> pivots_;              ///< columns of it that are factored
    std::vector<std::vector<double>> lower_;       ///< by row
    std::vector<std::vector<double>> upper_;       ///< by column
    std::vector<Plane> forward_;                   ///< L^-1 v
    std::array<Plane, 2> places_;                  ///< of both contacts where they begin
    std::array<std::vector<double>, 2> placesBy_;  ///< W U^-1
};

}  // namespace signorini
