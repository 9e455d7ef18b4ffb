// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <optional>

class QLabel;
class QPushButton;

namespace codewheel {

class PositionInput;

// Shown while nobody knows how many positions the encoder has: "Read it", or say it.
class CamRangeBar : public QWidget
{
    Q_OBJECT

public:
    explicit CamRangeBar(QWidget *parent = nullptr);

    // Another encoder: what was typed for the one before is gone.
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
