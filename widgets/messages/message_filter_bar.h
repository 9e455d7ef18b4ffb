// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/message_filter.h"

#include <QWidget>

class QAction;
class QComboBox;
class QDateTimeEdit;
class QHBoxLayout;
class QLineEdit;

namespace codewheel {

// Which messages are wanted: text, severity, place and time. Part of the messages' view, which adds its
// commands after it.
class MessageFilterBar : public QWidget
{
    Q_OBJECT

public:
    explicit MessageFilterBar(QWidget *parent = nullptr);

    MessageFilter filter() const;
    void setPlaces(const std::vector<Place> &places); // that can be chosen
    void showAll();
    QAction *findAction() const { return m_find; }
    QHBoxLayout &row() { return *m_row; }

Q_SIGNALS:
    void changed();

private:
    enum class Period { all, sinceStart, lastHour, today, lastWeek, between };

    void makeSearch();
    void makeChoices();
    void makeSpan();
    void choosePeriod();

    const QDateTime m_start; // of the program, near enough
    QHBoxLayout *m_row;
    QWidget *m_span; // from ... to ...
    QLineEdit *m_search;
    QComboBox *m_severity;
    QComboBox *m_place;
    QComboBox *m_period;
    QDateTimeEdit *m_from;
    QDateTimeEdit *m_until;
    QAction *m_find;
    std::optional<QDateTime> m_since; // start of the chosen period
};

} // namespace codewheel
