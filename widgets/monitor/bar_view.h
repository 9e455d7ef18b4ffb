// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/value_widget.h"

#include <optional>

namespace codewheel {

// A value as a bar over its range, with quarters marked. Used by monitors below the IN word.
class BarView : public ValueWidget
{
    Q_OBJECT

public:
    explicit BarView(QWidget *parent = nullptr);

    void setPlace(const QString &place); // "IN 1.0": for screen readers
    // last > first, e.g. 0 and total range - 1.
    void setRange(qint64 first, qint64 last);
    // Nothing: not known; an empty bar. A value outside the range fills the bar or leaves it empty. An old
    // one is outlined.
    void setValue(std::optional<qint64> value, bool isOld = false);

    QString valueText() const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    std::optional<int> filledWidth() const;

    qint64 m_first = 0;
    qint64 m_last = 1;
    std::optional<qint64> m_value;
    bool m_isOld = false;
};

} // namespace codewheel
