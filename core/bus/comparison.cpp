// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/comparison.h"

#include <QCoreApplication>

#include <algorithm>

namespace codewheel {
namespace {

// The translation context of these texts.
struct ComparisonKinds
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::Comparison)
};

} // namespace

int differences(const Comparison &comparison)
{
    return static_cast<int>(std::ranges::count_if(
        comparison, [](const ComparisonLine &line) { return line.kind != ComparisonKind::same; }));
}

QString comparisonKindName(ComparisonKind kind)
{
    switch (kind) {
    case ComparisonKind::same:
        break;
    case ComparisonKind::differs:
        return ComparisonKinds::tr("differs");
    case ComparisonKind::missing:
        return ComparisonKinds::tr("missing");
    case ComparisonKind::additional:
        return ComparisonKinds::tr("additional");
    case ComparisonKind::moved:
        return ComparisonKinds::tr("moved");
    }
    return ComparisonKinds::tr("same");
}

QString comparisonKindKey(ComparisonKind kind)
{
    switch (kind) {
    case ComparisonKind::same:
        break;
    case ComparisonKind::differs:
        return QStringLiteral("differs");
    case ComparisonKind::missing:
        return QStringLiteral("missing");
    case ComparisonKind::additional:
        return QStringLiteral("additional");
    case ComparisonKind::moved:
        return QStringLiteral("moved");
    }
    return QStringLiteral("same");
}

} // namespace codewheel
