#include "statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace signorini::bench {

Table where(const Table& table, const std::function<bool(const Record&)>& condition)
{
    Table chosen;
    std::copy_if(table.begin(), table.end(), std::back_inserter(chosen), condition);
    return chosen;
}

std::vector<std::string> distinct(const Table& table, std::string Record::*column)
{
    std::vector<std::string> values;
    for (const Record& record : table) {
        if (std::find(values.begin(), values.end(), record.*column) == values.end()) {
            values.push_back(record.*column);
        }
    }
    return values;
}

bool wasTried(const Record& record)
{
    return record.outcome != "absent" && record.outcome != "refused" &&
           record.outcome != "reference";
}

bool isOurs(const Record& record)
{
    return record.backEnd == "signorini" || record.backEnd == "closed-form";
}

bool isClaim(const Record& record)
{
    return record.claim == "found" || record.claim == "none";
}

bool isRightWithin(const Record& record, double error)
{
    if (record.claim == "none") {
        return record.outcome == "right";
    }
    return record.claim == "found" && record.outcome != "wrong" &&
           !(record.figure("error") > error);
}

PowerLaw fitPowerLaw(const std::vector<std::pair<double, double>>& points)
{
    double count = 0.0;
    double sumX = 0.0;
    double sumY = 0.0;
    double sumXX = 0.0;
    double sumXY = 0.0;
    for (const auto& [x, y] : points) {
        if (x > 0.0 && y > 0.0) {
            count += 1.0;
            sumX += std::log(x);
            sumY += std::log(y);
            sumXX += std::log(x) * std::log(x);
            sumXY += std::log(x) * std::log(y);
        }
    }
    PowerLaw law;
    law.points = static_cast<std::size_t>(count);
    const double spread = count * sumXX - sumX * sumX;
    if (count < 2.0 || !(spread > 0.0)) {
        law.exponent = std::numeric_limits<double>::quiet_NaN();
        return law;
    }
    law.exponent = (count * sumXY - sumX * sumY) / spread;
    law.factor = std::exp((sumY - law.exponent * sumX) / count);
    return law;
}

std::vector<std::pair<std::string, std::vector<ProfilePoint>>> performanceProfiles(
    const Table& table, const std::function<std::string(const Record&)>& label)
{
    std::map<std::string, double> best;
    std::map<std::string, std::vector<const Record*>> bySolver;
    std::vector<std::string> order;
    for (const Record& record : table) {
        const std::string solver = label(record);
        if (!bySolver.contains(solver)) {
            order.push_back(solver);
        }
        bySolver[solver].push_back(&record);
        best.try_emplace(record.problem, std::numeric_limits<double>::infinity());
        if (record.outcome == "right") {
            best[record.problem] = std::min(best[record.problem], record.figure("seconds_median"));
        }
    }
    std::vector<std::pair<std::string, std::vector<ProfilePoint>>> profiles;
    for (const std::string& solver : order) {
        std::vector<double> ratios;
        for (const Record* record : bySolver[solver]) {
            if (record->outcome == "right") {
                ratios.push_back(record->figure("seconds_median") / best[record->problem]);
            }
        }
        std::sort(ratios.begin(), ratios.end());
        std::vector<ProfilePoint> curve;
        for (std::size_t k = 0; k < ratios.size(); ++k) {
            curve.push_back(
                {ratios[k], static_cast<double>(k + 1) / static_cast<double>(best.size())});
        }
        profiles.emplace_back(solver, std::move(curve));
    }
    return profiles;
}

}  // namespace signorini::bench
