// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/simulator/fault_plan.h"
#include "project/file_access.h"

namespace codewheel {
namespace {

constexpr qint64 largest = 1'000'000; // bytes, far more than any lesson

} // namespace

Result<FaultPlan> loadFaultPlan(const QString &path, const std::vector<TrainingPlace> &ring)
{
    return readWholeFile(path, largest).and_then([&](const QByteArray &json) {
        return faultPlanFromJson(json, path, ring);
    });
}

} // namespace codewheel
