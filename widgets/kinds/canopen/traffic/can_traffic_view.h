// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/place.h"
#include "widgets/kinds/canopen/traffic/can_traffic_rows.h"

#include <QPointer>
#include <QWidget>

#include <memory>

class QAction;
class QLabel;
class QStackedWidget;
class QToolBar;

namespace codewheel {

class CanopenSession;
class GoToPlace;
class InlineMessage;
class SendFrameBar;
class TrafficModel;
class TrafficTable;

// What passes on a CAN bus, with its meaning, a transfer as one row; frames are sent by hand. What was
// collected outlives the connection.
class CanTrafficView : public QWidget
{
    Q_OBJECT

public:
    explicit CanTrafficView(QWidget *parent = nullptr);
    ~CanTrafficView() override;

    void setBus(codewheel::CanopenSession *bus); // null: none
    void setRecordingChosen(bool isChosen);      // then nothing is sent
    void setMostRows(int rows);

    // What was collected, for the view in another language.
    std::shared_ptr<const TrafficModel> takeRows(); // it is about to go
    void goOn(const TrafficModel &before);

    // The rows shown: UTF-8, tabs between the columns. Reports on the spot what went wrong.
    bool exportTo(const QString &path);

Q_SIGNALS:
    void goToWanted(codewheel::Place place); // the chosen row's

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void makeTools(QToolBar &bar);
    void add(const TrafficRow &row);
    void takeOverdue();
    void showCounts();
    void askExport();

    QPointer<CanopenSession> m_bus;
    CanTrafficRows m_whole;
    TrafficModel *m_rows;
    TrafficTable *m_table;
    QStackedWidget *m_content;
    QLabel *m_counts;
    QAction *m_follow = nullptr;
    QAction *m_bringBack = nullptr;
    GoToPlace *m_goTo;
    InlineMessage *m_message;
    SendFrameBar *m_sending;
};

} // namespace codewheel
