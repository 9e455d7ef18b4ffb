// SPDX-License-Identifier: GPL-3.0-or-later
#include "trend/trend_files.h"

#include "project/file_access.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace codewheel {
namespace {

constexpr QLatin1String tableSuffix(".csv");
constexpr QLatin1String descriptionSuffix(".json");
constexpr qint64 largestDescription = 64'000'000;

// Somebody's project or cams may have the same name as the trend.
Result<void> checkDescription(const QString &path)
{
    if (auto can = checkReplaceable(path); !can)
        return can;
    if (!QFileInfo::exists(path))
        return {};
    const auto there = readWholeFile(path, largestDescription);
    if (there && isTrendJson(*there))
        return {};
    return refuse(
        RefusalKind::badInput, RefusalId::fileNotWritten,
        {path, QCoreApplication::translate("codewheel::TrendFiles",
                                           "It does not belong to a trend. Give the trend another name.")});
}

} // namespace

TrendFiles::TrendFiles(const QString &path, const TrendExtract &extract, HistoryOf historyOf,
                       const CsvStyle &style)
    : m_extract(extract)
    , m_historyOf(std::move(historyOf))
    , m_style(style)
    , m_file(path)
    , m_csv(m_file, m_extract, m_historyOf, m_style)
{}

QString TrendFiles::descriptionPath(const QString &path)
{
    const bool isTable = path.endsWith(tableSuffix, Qt::CaseInsensitive);
    return (isTable ? path.chopped(tableSuffix.size()) : path) + descriptionSuffix;
}

Result<void> TrendFiles::begin()
{
    if (auto can = checkDescription(descriptionPath(path())); !can)
        return can;
    return m_file.begin();
}

Result<void> TrendFiles::finish(const TrendOrigin &origin)
{
    if (auto isThere = m_file.bringToDisk(); !isThere)
        return isThere;
    const TrendTable table{QFileInfo(path()).fileName(), m_extract, m_style, rows()};
    if (auto described =
            replaceFile(descriptionPath(path()), trendJson(table, m_historyOf, origin), OldFile::goes);
        !described)
        return described;
    return m_file.replace();
}

} // namespace codewheel
