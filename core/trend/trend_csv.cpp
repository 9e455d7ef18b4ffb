// SPDX-License-Identifier: GPL-3.0-or-later
#include "trend/trend_csv.h"

#include <QIODevice>

namespace codewheel {

TrendCsv::TrendCsv(QIODevice &device, const TrendExtract &extract, HistoryOf historyOf, const CsvStyle &style)
    : m_device(device)
    , m_style(style)
    , m_shift(extract.commonShift())
    , m_rows(extract, std::move(historyOf))
{
    for (const TrendColumn &column : extract.columns)
        m_cells.emplace_back(column);
    appendTitles(extract);
}

bool TrendCsv::writeSome()
{
    const bool isMore = m_rows.next([this](Instant at, RowMerge::Cells cells) { appendRow(at, cells); });
    return put() && isMore;
}

void TrendCsv::appendTitles(const TrendExtract &extract)
{
    m_text = m_style.begin() + m_style.timeTitle();
    if (const std::string title = m_style.dateTitle(); !title.empty())
        m_text += m_style.separator + title;
    for (const TrendColumn &column : extract.columns)
        m_text += m_style.separator + m_style.field(extract.title(column));
    m_text += "\r\n";
}

void TrendCsv::appendRow(Instant at, RowMerge::Cells cells)
{
    m_times.append(m_text, at - m_shift);
    for (std::size_t column = 0; column < cells.size(); ++column) {
        m_cells[column].show(at, cells[column], m_style.decimalSign);
        m_text += m_style.separator;
        m_text += m_cells[column].text;
    }
    m_text += "\r\n";
    ++m_count;
}

TrendCsv::Cell::Cell(const TrendColumn &column)
    : track(column.track)
{
    const auto numbers = [&](double perStep) {
        return CsvNumbers(TrackScale{column.scale.unit, perStep}.factor(track.channel));
    };
    for (const TrackScale::Earlier &earlier : column.scale.earlier)
        scales.push_back({earlier.until, numbers(earlier.perStep)});
    scales.push_back({Instant::max(), numbers(column.scale.perStep)});
}

void TrendCsv::Cell::show(Instant at, const std::optional<std::int64_t> &sample,
                          const std::string &decimalSign)
{
    const auto shown = sample ? std::optional(track.of(*sample)) : std::nullopt;
    const std::size_t before = scale;
    while (scales[scale].until <= at && scale + 1 < scales.size())
        ++scale;
    if (shown == value && scale == before)
        return;
    value = shown;
    text.clear();
    if (shown)
        scales[scale].numbers.append(text, *shown, decimalSign);
}

bool TrendCsv::put()
{
    const auto size = static_cast<qint64>(m_text.size());
    const bool isWritten = m_device.write(m_text.data(), size) == size;
    m_text.clear();
    return isWritten;
}

} // namespace codewheel
