// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/models/table_model_base.h"
#include "widgets/trend/trend_scene.h"

#include <QLocale>

namespace codewheel {

class EncoderScales;

// One curve of a trend in words.
struct TrendRow
{
    QString name;
    QColor color;
    QString now;
    std::array<QString, 2> atCursors{};
    QString difference{};
    QString degrees{};
    QString rate{};
    QString least{};
    QString greatest{};
    QString mean{};
    QString deviation{};

    friend bool operator==(const TrendRow &, const TrendRow &) = default;
};

// The curves of a trend as a table: what they are now, at the cursors, and between them. The legend of the
// chart, and all of it that a screen reader gets.
class TrendValuesModel : public TableModelBase<TrendRow>
{
    Q_OBJECT

public:
    enum Column {
        name,
        now,
        cursorA,
        cursorB,
        difference,
        degrees,
        rate,
        least,
        greatest,
        mean,
        deviation,
        count
    };

    using TableModelBase::TableModelBase;

    // What stands at the cursors and now. Between them, where `withStatistics`: that goes through all
    // samples.
    void show(const TrendScene &scene, const EncoderScales &scales, bool withStatistics);
    // Of the same curves.
    void showNow(const TrendScene &scene);

private:
    std::span<const ColumnHead> heads() const override;
    QString text(const TrendRow &row, int column) const override;
    bool isNumber(int column) const override { return column != name; }
    QVariant cell(const TrendRow &row, int column, int role) const override;
    TrendRow rowOf(const TrendCurve &curve, const TrendScene &scene,
                   const std::optional<TrackScale> &turns) const;
    void addStatistics(TrendRow &row, const TrendCurve &curve, const TimeSpan &span) const;
    void update(std::vector<TrendRow> rows);

    QLocale m_locale;
};

} // namespace codewheel
