#include <cmath>

#include "faults.hpp"
#include "network.hpp"
#include "statics.hpp"

namespace signorini {

namespace {

/// Reads the words from left to right.
class Builder {
public:
    explicit Builder(const Assembly& assembly) : assembly_(assembly) {}

    Network build()
    {
        validate(assembly_);
        setScales();
        network_.nodes.push_back({});
        network_.bars.push_back({});
        for (number_ = 1; number_ <= assembly_.parts.size(); ++number_) {
            take(assembly_.parts[number_ - 1]);
        }
        closeBar();
        checkFaces();
        setRest();
        validate(network_);
        return std::move(network_);
    }

private:
    void setScales()
    {
        double crossing = 0.0;  // of all bars [h]
        double cells = 0.0;
        double gap = 0.0;
        for (const AssemblyPart& part : assembly_.parts) {
            const auto count = static_cast<double>(part.cells);
            cells += count;
            crossing += count * part.speed;
            const bool isContact = part.kind == PartKind::gap || part.kind == PartKind::rightStop ||
                                   part.kind == PartKind::leftStop;
            if (isContact && gap == 0.0) {
                gap = std::abs(part.value);
            }
        }
        cells_ = cells;
        unit_ = gap == 0.0 ? assembly_.length : gap;
        network_.scales = {.time = assembly_.length / (assembly_.waveSpeed * crossing),
                           .displacement = unit_ / cells,
                           .impedance = assembly_.axialStiffness / assembly_.waveSpeed};
    }

    /// g/delta: quotients first, so that equal gaps are N exactly.
    [[nodiscard]] double inUnits(double displacement) const
    {
        return displacement / unit_ * cells_;
    }

    void addContact(ContactKind kind, double gap)
    {
        network_.contacts.push_back({kind, network_.nodes.size() - 1, inUnits(gap)});
    }

    void addStub(StubKind kind, double impedance)
    {
        network_.stubs.push_back({kind, impedance, network_.nodes.size() - 1});
        network_.bars.back().springs += kind == StubKind::spring ? 1 : 0;
        network_.bars.back().masses += kind == StubKind::mass ? 1 : 0;
    }

    void take(const AssemblyPart& part)
    {
        NetworkNode& node = network_.nodes.back();
        const NetworkScales& scales = network_.scales;
        switch (part.kind) {
            case PartKind::free:
                return;
            case PartKind::clamp:
                node.isClamped = true;
                ++network_.bars.back().clamps;
                return;
            case PartKind::shaken:
                node.isShaken = true;
                return;
            case PartKind::driven:
                node.isDriven = true;
                return;
            case PartKind::dash:
                node.dashpot = part.value;
                return;
            case PartKind::force:
                node.force = part.value / scales.force();
                return;
            case PartKind::spring:
                addStub(StubKind::spring, 0.5 * part.value * scales.time / scales.impedance);
                return;
            case PartKind::mass:
                addStub(StubKind::mass, 2.0 * part.value / (scales.time * scales.impedance));
                return;
            case PartKind::rightStop:
                addContact(ContactKind::stopRight, part.value);
                return;
            case PartKind::leftStop:
                addContact(ContactKind::stopLeft, part.value);
                return;
            case PartKind::gap:
                addContact(ContactKind::gap, part.value);
                closeBar();
                network_.bars.push_back({.firstNode = network_.nodes.size()});
                network_.nodes.push_back({.bar = network_.bars.size() - 1});
                return;
            case PartKind::cells:
                network_.rows.push_back({part.cells, part.impedance, part.speed,
                                         network_.nodes.size() - 1, network_.nodes.size()});
                network_.nodes.push_back({.bar = network_.bars.size() - 1});
                return;
        }
    }

    void closeBar() { network_.bars.back().lastNode = network_.nodes.size() - 1; }

    /// What stands behind a gap without cells stops in a step, at the least.
    void checkFaces() const
    {
        for (const NetworkBar& bar : network_.bars) {
            if (bar.firstNode < bar.lastNode) {
                continue;
            }
            for (const Stub& stub : network_.stubs) {
                const double dashpot = network_.nodes[stub.node].dashpot;
                if (stub.node == bar.firstNode && dashpot < stub.impedance) {
                    throwFault("dash", dashpot,
                               fmt::format("D >= K h/2 = {} behind a gap with a spring alone: with "
                                           "less its open face would ring",
                                           stub.impedance));
                }
            }
        }
    }

    /// The shape under weight, and what carries a bar that is clamped nowhere.
    void setRest()
    {
        const NetworkScales& scales = network_.scales;
        const double gravity = assembly_.gravity * scales.time * scales.time / scales.displacement;
        if (gravity == 0.0) {
            return;
        }
        network_.gravity = gravity;
        const std::vector<double> weights = weightsOf(network_, gravity);
        for (std::size_t bar = 0; bar < network_.bars.size(); ++bar) {
            std::optional<std::size_t> support;
            if (network_.bars[bar].drifts()) {
                support = supportOf(bar);
                network_.nodes[*support].force += weightOf(network_, bar, weights);
            }
            addShapeUnder(network_, bar, weights, support);
        }
        for (NetworkContact& contact : network_.contacts) {
            contact.gap +=
                openingOf(contact, [this](std::size_t node) { return network_.nodes[node].rest; });
        }
    }

    /// The node at which a bar that drifts meets what its weight pulls it to; any will do.
    [[nodiscard]] std::size_t supportOf(std::size_t bar) const
    {
        const bool isRight = assembly_.gravity > 0.0;
        for (const NetworkContact& contact : network_.contacts) {
            const bool isGap = contact.kind == ContactKind::gap;
            const std::size_t node = contact.node + (isGap && !isRight ? 1 : 0);
            const bool faces = isGap || (contact.kind == ContactKind::stopRight) == isRight;
            if (faces && node < network_.nodes.size() && network_.nodes[node].bar == bar) {
                return node;
            }
        }
        return isRight ? network_.bars[bar].lastNode : network_.bars[bar].firstNode;
    }

    const Assembly& assembly_;
    Network network_;
    std::size_t number_ = 0;
    double cells_ = 0.0;
    double unit_ = 1.0;
};

}  // namespace

Network networkOf(const Assembly& assembly)
{
    return Builder(assembly).build();
}

}  // namespace signorini
