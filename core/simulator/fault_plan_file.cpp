// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/fault_plan_file.h"

#include <QFile>

namespace codewheel {
namespace {

constexpr qint64 megabyte = 1 << 20;
constexpr qint64 largest = megabyte; // far more than any lesson

} // namespace

Result<FaultPlan> loadFaultPlan(const QString &path, const std::vector<TrainingPlace> &ring)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return refuse(RefusalKind::badInput, RefusalId::fileNotReadable, {path, file.errorString()});
    if (file.size() > largest)
        return refuse(RefusalKind::badInput, RefusalId::fileTooLarge,
                      {path, std::int64_t{file.size() / megabyte}, std::int64_t{largest / megabyte}});
    return faultPlanFromJson(file.read(largest), path, ring);
}

} // namespace codewheel
