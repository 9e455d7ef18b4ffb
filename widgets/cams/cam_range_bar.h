// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <optional>

class QLabel;
class QPushButton;

namespace codewheel {

class PositionInput;

// Shown while the number of positions of the encoder is not known: read it, or enter it.
class CamRangeBar : public QWidget
{
    Q_OBJECT

public:
    explicit CamRangeBar(QWidget *parent = nullptr);

    // For another encoder: discards what was typed for the previous one.
    void begin(std::optional<std::int64_t> toldLargest);
    void ask(bool canRead, std::optional<std::int64_t> toldLargest);

Q_SIGNALS:
    void readRequested();
    void told(qint64 largest);
    void inputChecked(const QString &wrong);

private:
    void tell();

    QLabel *m_text;
    QPushButton *m_read;
    PositionInput *m_largest;
    QPushButton *m_tell;
};

} // namespace codewheel
