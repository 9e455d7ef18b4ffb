// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/position_scale.h"
#include "widgets/input/number_fields.h"

#include <QWidget>

namespace codewheel {

class CodeDisc;

// What the shaft will read with the wanted values: here, and so many turns further on.
class ScalePreview : public QWidget
{
    Q_OBJECT

public:
    explicit ScalePreview(QWidget *parent = nullptr);

    // `start`: the position right after the handshake; nothing if it cannot be predicted.
    void setScale(const std::optional<PositionScale> &scale, std::optional<std::int64_t> start,
                  const QString &whyNot);

private:
    void draw();

    CodeDisc *m_dial;
    DecimalField *m_turns;
    std::optional<PositionScale> m_scale;
    std::optional<std::int64_t> m_start;
    QString m_whyNot;
};

} // namespace codewheel
