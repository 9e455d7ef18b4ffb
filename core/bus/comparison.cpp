// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/comparison.h"

#include "vocabulary/enumeration_rows.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

struct ComparisonKinds
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::Comparison)
    using enum ComparisonKind;

public:
    static constexpr auto all = std::to_array<KeyedText<ComparisonKind>>({
        {same, "same", QT_TR_NOOP("same")},
        {differs, "differs", QT_TR_NOOP("differs")},
        {missing, "missing", QT_TR_NOOP("missing")},
        {additional, "additional", QT_TR_NOOP("additional")},
        {moved, "moved", QT_TR_NOOP("moved")},
    });
};
static_assert(areInOrder(ComparisonKinds::all, &KeyedText<ComparisonKind>::id, ComparisonKind::moved));

} // namespace

int differences(const Comparison &comparison)
{
    return static_cast<int>(std::ranges::count_if(
        comparison, [](const ComparisonLine &line) { return line.kind != ComparisonKind::same; }));
}

QString comparisonKindName(ComparisonKind kind)
{
    return ComparisonKinds::tr(rowOf(ComparisonKinds::all, kind).text);
}

QString comparisonKindKey(ComparisonKind kind)
{
    return QLatin1String(rowOf(ComparisonKinds::all, kind).key);
}

} // namespace codewheel
