// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/kinds/canopen/traffic/can_services.h"

#include <QWidget>

#include <functional>
#include <set>

class QAction;
class QLineEdit;
class QMenu;

namespace codewheel {

class TrafficTable;
struct TrafficRow;

// Which rows of a CAN bus a table shows: by service, by a text in them, without what is asked again and
// again, and transfers as a whole or frame by frame.
class CanTrafficFilter : public QWidget
{
    Q_OBJECT

public:
    explicit CanTrafficFilter(TrafficTable &table, QWidget *parent = nullptr);

Q_SIGNALS:
    void changed();

private:
    QAction *addChoice(QMenu &menu, const QString &text, bool isOn, const std::function<void(bool)> &choose);
    void apply();
    bool isWanted(const TrafficRow &row) const;
    bool hasText(const TrafficRow &row) const;

    TrafficTable &m_table;
    QLineEdit *m_text;
    std::set<CanService> m_hidden;
    bool m_asTransfers = true;
};

} // namespace codewheel
