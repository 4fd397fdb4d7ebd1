#include "vertex_graph.hpp"

#include <algorithm>
#include <limits>

namespace signorini {

namespace {

constexpr std::size_t outside = std::numeric_limits<std::size_t>::max();

/// The least |x|^2 on the segment between two points.
double leastBetween(const std::vector<double>& from, const std::vector<double>& to)
{
    double along = 0.0;
    double length = 0.0;
    for (std::size_t i = 0; i < from.size(); ++i) {
        along += from[i] * (from[i] - to[i]);
        length += (from[i] - to[i]) * (from[i] - to[i]);
    }
    const double part = length > 0.0 ? std::clamp(along / length, 0.0, 1.0) : 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const double value = from[i] + part * (to[i] - from[i]);
        squares += value * value;
    }
    return squares;
}

}  // namespace

VertexGraph::VertexGraph(const LumpedSet& set, std::vector<std::vector<double>> vertices,
                         double squares)
    : vertices_(std::move(vertices))
{
    for (const std::size_t t : set.live) {
        counts_.push_back(static_cast<double>(set.classes.types[t].count));
    }
    const double level = squares * (1.0 - vertexRounding);
    for (const std::vector<double>& vertex : vertices_) {
        groups_.push_back(squaresOf(vertex) >= level ? groups_.size() : outside);
    }
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            if (isAbove(i) && isAbove(k) && groups_[i] != groups_[k] &&
                leastBetween(vertices_[i], vertices_[k]) >= level) {
                const std::size_t first = std::min(groups_[i], groups_[k]);
                const std::size_t second = std::max(groups_[i], groups_[k]);
                std::replace(groups_.begin(), groups_.end(), second, first);
            }
        }
    }
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
        locks_.push_back(i == groups_[i] ? locksOf(i, level) : std::vector<bool>());
    }
}

bool VertexGraph::isAbove(std::size_t vertex) const
{
    return groups_[vertex] != outside;
}

double VertexGraph::components() const
{
    double all = 0.0;
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
        double here = 1.0;
        for (std::size_t t = 0; t < locks_[i].size(); ++t) {
            here *= locks_[i][t] ? counts_[t] : 1.0;
        }
        all += groups_[i] == i ? here : 0.0;
    }
    return all;
}

std::vector<bool> VertexGraph::locksOf(std::size_t group, double level) const
{
    std::vector<bool> locks(counts_.size());
    for (std::size_t t = 0; t < locks.size(); ++t) {
        locks[t] = counts_[t] > 1.0;
        for (std::size_t i = 0; i < vertices_.size(); ++i) {
            const double sum = vertices_[i][t];
            if (groups_[i] == group &&
                (sum == 0.0 || squaresOf(vertices_[i]) - 0.5 * sum * sum >= level)) {
                locks[t] = false;
            }
        }
    }
    return locks;
}

}  // namespace signorini
