// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QToolButton;

namespace codewheel {

class MeaningLine;

// Over the dial: whose it is, and the pin that keeps it.
class DialHead : public QWidget
{
    Q_OBJECT

public:
    explicit DialHead(QWidget *parent = nullptr);

    void
    setTitle(const QString &title); // "2.0  Hoist  FRABA OCD-IB K3"; empty: of nobody, who cannot be pinned
    void setPinned(bool pinned);
    bool isPinned() const;

Q_SIGNALS:
    void pinToggled(bool pinned); // by the user

private:
    MeaningLine *m_title;
    QToolButton *m_pin;
};

} // namespace codewheel
